// Camera paths as JSON, read with suspicion: whatever is not understood is an error.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iterator>

#include "animate/camera_path.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::json;

class Reader {
public:
    Reader(std::string path, double fovDeg) : m_path(std::move(path)), m_fovDeg(fovDeg) {}

    CameraKeys read() {
        const Json root = parse();
        requireKeys(root, "the file", {"interpolation", "keys"});
        CameraKeys path;
        if (root.contains("interpolation")) {
            const Json& word = root["interpolation"];
            path.straight = word == "linear";
            if (!path.straight && word != "smooth") {
                fail("interpolation", "must be \"smooth\" or \"linear\"");
            }
        }
        if (!root.contains("keys") || !root["keys"].is_array() || root["keys"].empty()) {
            fail("keys", "must be a list with at least one key");
        }
        path.turns = root["keys"][0].is_object() && root["keys"][0].contains("rotation");
        for (const Json& key : root["keys"]) {
            readKey(key, path);
        }
        return path;
    }

private:
    [[noreturn]] void fail(const std::string& where, const std::string& what) const {
        throw RunError(fmt::format("{}: {}: {}", m_path, where, what));
    }

    Json parse() const {
        std::ifstream file(m_path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        if (!file && text.empty()) {
            throw RunError(fmt::format("{}: cannot be read", m_path));
        }
        const Json root = Json::parse(text, nullptr, false);
        if (root.is_discarded()) {
            throw RunError(fmt::format("{}: is not JSON", m_path));
        }
        return root;
    }

    void requireKeys(const Json& value, const std::string& where,
                     const std::vector<std::string>& known) const {
        if (!value.is_object()) {
            fail(where, "must be an object");
        }
        for (const auto& [name, unused] : value.items()) {
            if (std::find(known.begin(), known.end(), name) == known.end()) {
                fail(where, fmt::format("'{}' is not known; known are {}", name,
                                        fmt::join(known, ", ")));
            }
        }
    }

    double number(const Json& value, const std::string& where) const {
        // A float must hold it in the end.
        if (!value.is_number() || !(std::abs(value.get<double>()) < 1.0e18)) {
            fail(where, "must be a number, below 1e18");
        }
        return value.get<double>();
    }

    template <int N>
    glm::vec<N, double> vector(const Json& key, const char* name, const std::string& where) const {
        const std::string place = where + "." + name;
        const auto found = key.find(name);
        if (found == key.end() || !found->is_array() || found->size() != N) {
            fail(place, fmt::format("must be {} numbers", N));
        }
        glm::vec<N, double> result;
        for (int i = 0; i < N; ++i) {
            result[i] = number((*found)[static_cast<std::size_t>(i)], place);
        }
        return result;
    }

    void readKey(const Json& value, CameraKeys& path) const {
        const std::string where = fmt::format("keys[{}]", path.keys.size());
        requireKeys(value, where, {"time", "position", path.turns ? "rotation" : "target", "fov"});
        CameraKey key;
        key.fovDeg = path.keys.empty() ? m_fovDeg : path.keys.back().fovDeg;
        key.time = number(value.contains("time") ? value["time"] : Json(), where + ".time");
        if (!path.keys.empty() && !(key.time > path.keys.back().time)) {
            fail(where + ".time", "must be later than that of the key before");
        }
        key.position = vector<3>(value, "position", where);
        if (path.turns) {
            const glm::dvec4 q = vector<4>(value, "rotation", where);
            if (!(glm::length(q) > 0)) {
                fail(where + ".rotation", "must not be zero");
            }
            key.rotation = glm::normalize(glm::dquat(q.w, q.x, q.y, q.z));
        } else {
            key.target = vector<3>(value, "target", where);
            if (key.target == key.position) {
                fail(where + ".target", "is where the camera stands");
            }
        }
        if (value.contains("fov")) {
            key.fovDeg = number(value["fov"], where + ".fov");
            if (key.fovDeg < 0.01 || key.fovDeg > 179) {
                fail(where + ".fov", "must be 0.01..179 degrees");
            }
        }
        path.keys.push_back(key);
    }

    std::string m_path;
    double m_fovDeg;
};

}  // namespace

CameraKeys readCameraKeys(const std::string& path, double fovDeg) {
    return Reader(path, fovDeg).read();
}

}  // namespace gp::tool
