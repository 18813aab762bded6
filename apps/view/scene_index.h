// From the number of an instance in a picture to what it is made of.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gp::tool::view {

using Row = std::pair<std::string, std::string>;  // a name and its value, for people

struct PickedThing {
    std::uint32_t instance = 0;  // position in the scene, from 0
    std::string instanceName, meshName, materialName;
    std::string model;           // "glTF", or the library's name
    std::vector<Row> parameters; // as gpDescribeScene tells them
};

// What the library tells about a scene, by number.
class SceneIndex {
public:
    SceneIndex() = default;
    // What gpDescribeScene wrote.
    explicit SceneIndex(nlohmann::ordered_json description);

    // id: a value of GP_IMAGE_INSTANCE; nothing for 0, and for numbers of no instance.
    std::optional<PickedThing> thingAt(std::uint32_t id) const;
    std::size_t instanceCount() const;
    std::vector<std::string> cameras() const;  // their names, "" for those without

private:
    nlohmann::ordered_json m_description = nlohmann::ordered_json::object();
};

}  // namespace gp::tool::view
