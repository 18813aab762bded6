// gp_bench_sea: how far the sea of GP_MODE_REALTIME is from the path-traced one, through the public
// interface: with waves and camera that stand or move, with and without glints. Prints a table for
// docs/water.md: errors of the picture as it is shown, how they flicker, how many frames the
// histories of the water have, and what its light costs; or the same as JSON, for bench/sea.py.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <glitterpath/glitterpath.h>

#include "checked.h"
#include "metrics/color.h"
#include "metrics/noisy_reference.h"
#include "metrics/temporal.h"
#include "spread.h"

namespace gp::bench {
namespace {

using metrics::Picture;
using metrics::Plane;
using metrics::ReferencePair;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFramesPerSecond = 24;
// Pixels: real time without anti-aliasing has its rays through the centres.
constexpr float kCentreRadius = 1e-4f;

struct Settings {
    uint32_t width = 192, height = 108, frames = 24, last = 4, samples = 32;
    double ev = -4.2, elevation = 20;
    std::string references, pictures, tune, only;
    bool json = false;
};

struct Case {
    const char* name;
    double speed;   // of the camera, m/s, looking along -Z; it turns by as many degrees a second
    double pace;    // of the waves, seconds a second
    GpOceanGlints glints;
};

constexpr Case kCases[] = {{"nothing moves", 0, 0, GP_GLINTS_OFF},
                           {"camera", 3, 0, GP_GLINTS_OFF},
                           {"waves", 0, 1, GP_GLINTS_OFF},
                           {"camera and waves", 3, 1, GP_GLINTS_OFF},
                           {"camera and waves, glints", 3, 1, GP_GLINTS_ON}};

GpCameraDesc cameraOf(const Case& c, double seconds) {
    const double heading = c.speed * seconds * kDegree;
    GpCameraDesc camera{};
    camera.position[1] = 3, camera.position[2] = float(-c.speed * seconds);
    camera.target[0] = float(std::sin(heading));
    camera.target[1] = float(3 + std::sin(-6 * kDegree));
    camera.target[2] = float(camera.position[2] - std::cos(heading));
    return camera;
}

// What the real-time frame says beside its picture, means over the water.
struct Histories {
    double direct = 0, specular = 0, change = 0;
};

struct Quality {
    double mse = 0, flip = 0, flicker = 0;
    Histories histories;
    Spread lighting;  // milliseconds of that pass, by the wall's clock
};

class SeaQuality {
public:
    explicit SeaQuality(const Settings& s) : s_(s) {
        const GpDeviceDesc d{GP_BACKEND_CPU, 0, nullptr, nullptr, nullptr};
        device_ = made<GpDevice>(nullptr, gpNewDevice(&d));
        readTune();
    }
    ~SeaQuality() { gpReleaseDevice(device_); }

    Quality measure(const Case& c, int number) {
        const GpScene scene = made(device_, gpNewScene(device_));
        GpOceanDesc sea{};
        sea.glints = c.glints;
        check(device_, gpSetOcean(scene, &sea));
        check(device_, gpSetSky(scene, 0, float(s_.elevation * kDegree), 0));
        const GpFrameDesc realtime{s_.width, s_.height, GP_MODE_REALTIME};
        const GpFrameDesc path{s_.width, s_.height, GP_MODE_REFERENCE};
        const GpFrame frame = made(device_, gpNewFrame(device_, &realtime));
        const GpFrame reference = made(device_, gpNewFrame(device_, &path));
        Quality q;
        uint32_t flickers = 0;
        error_ = {};
        for (uint32_t i = 0; i < s_.frames; ++i) {
            const double seconds = i / kFramesPerSecond;
            check(device_, gpSetOceanTime(scene, 10 + c.pace * seconds));
            const GpCameraDesc camera = cameraOf(c, seconds);
            GpRenderOptions o = options();
            check(device_, gpRender(frame, scene, &camera, &o));
            if (i > 0) q.lighting.add(lightingOf(frame));
            if (i + s_.last < s_.frames) continue;
            const Picture shown = shownBy(frame);
            const ReferencePair pair = referenceOf(reference, scene, camera, number, i);
            const metrics::NoisyComparison n = metrics::compareWithPair(shown, pair);
            q.mse += n.mse / s_.last, q.flip += n.flip.mean / s_.last;
            addHistories(frame, q.histories);
            flickers += addFlicker(frame, shown, pair, q);
        }
        q.flicker /= std::max(flickers, 1u);
        if (!s_.pictures.empty()) save(frame, reference, number);
        gpReleaseFrame(reference), gpReleaseFrame(frame), gpReleaseScene(scene);
        return q;
    }

private:
    GpRenderOptions options() const {
        GpRenderOptions o{};
        o.exposureEv = float(s_.ev);
        o.realtime.antiAliasing = GP_AA_NONE;
        o.realtime.parameters = tune_.data(), o.realtime.parameterCount = uint32_t(tune_.size());
        return o;
    }

    // Words as NAME=VALUE,NAME=VALUE.
    void readTune() {
        for (size_t at = 0; at < s_.tune.size();) {
            const size_t end = std::min(s_.tune.find(',', at), s_.tune.size());
            const std::string word = s_.tune.substr(at, end - at);
            const size_t equals = word.find('=');
            if (equals == std::string::npos) throw std::runtime_error("--tune: " + word);
            names_.push_back(word.substr(0, equals));
            values_.push_back(std::stof(word.substr(equals + 1)));
            at = end + 1;
        }
        for (size_t i = 0; i < names_.size(); ++i)
            tune_.push_back({names_[i].c_str(), values_[i]});
    }

    Picture shownBy(GpFrame frame) {
        Picture picture(int(s_.width), int(s_.height));
        std::vector<unsigned char> rgba(4 * picture.pixels.size());
        check(device_, gpReadFrameImage(frame, GP_IMAGE_DISPLAY, rgba.data(), rgba.size()));
        for (size_t i = 0; i < picture.pixels.size(); ++i) {
            const glm::vec3 encoded(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]);
            picture.pixels[i] = metrics::linearFromSrgb(encoded / 255.0f);
        }
        return picture;
    }

    std::vector<glm::vec4> layer(GpFrame frame, const char* name) {
        std::vector<glm::vec4> pixels(size_t(s_.width) * s_.height);
        check(device_, gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * 16));
        return pixels;
    }

    double lightingOf(GpFrame frame) {
        GpPassTime times[64];
        uint32_t count = 0;
        check(device_, gpGetPassTimes(frame, times, 64, &count));
        for (uint32_t i = 0; i < count; ++i)
            if (std::string("lighting") == times[i].name) return times[i].milliseconds;
        throw std::runtime_error("the frame has no pass \"lighting\"");
    }

    // References are the same for every build of the library: a folder keeps them.
    ReferencePair referenceOf(GpFrame frame, GpScene scene, const GpCameraDesc& camera, int number,
                              uint32_t i) {
        const std::string name = fmt::format("{}/sea-{}-{}-{}x{}-{}-{}.bin", s_.references, number,
                                             i, s_.width, s_.height, s_.samples, s_.elevation);
        ReferencePair pair{Picture(int(s_.width), int(s_.height)),
                           Picture(int(s_.width), int(s_.height))};
        const auto bytes = std::streamsize(pair.a.pixels.size() * sizeof(glm::vec3));
        if (std::ifstream in(name, std::ios::binary); !s_.references.empty() && in) {
            in.read(reinterpret_cast<char*>(pair.a.pixels.data()), bytes);
            in.read(reinterpret_cast<char*>(pair.b.pixels.data()), bytes);
            return pair;
        }
        for (uint32_t half = 0; half < 2; ++half) {
            GpRenderOptions o = options();
            o.realtime = {};
            o.samplesPerPixel = (s_.samples + 1) / 2, o.maxBounces = 1;
            o.pixelFilter = GP_PIXEL_BOX, o.pixelFilterRadius = kCentreRadius;
            o.seed = 2 * i + half;
            check(device_, gpRender(frame, scene, &camera, &o));
            (half == 0 ? pair.a : pair.b) = shownBy(frame);
        }
        if (s_.references.empty()) return pair;
        std::ofstream out(name, std::ios::binary);
        out.write(reinterpret_cast<const char*>(pair.a.pixels.data()), bytes);
        out.write(reinterpret_cast<const char*>(pair.b.pixels.data()), bytes);
        return pair;
    }

    void addHistories(GpFrame frame, Histories& h) {
        const std::vector<glm::vec4> length = layer(frame, "history_length");
        const std::vector<glm::vec4> gradient = layer(frame, "gradient");
        const std::vector<glm::vec4> depth = layer(frame, "depth");
        Histories sum;
        double count = 0;
        for (size_t i = 0; i < depth.size(); ++i) {
            if (depth[i].x > 1e29f) continue;
            sum.direct += 255 * double(length[i].x), sum.specular += 255 * double(length[i].y);
            sum.change += double(gradient[i].z);
            ++count;
        }
        count *= s_.last;
        h.direct += sum.direct / count, h.specular += sum.specular / count;
        h.change += sum.change / count;
    }

    uint32_t addFlicker(GpFrame frame, const Picture& shown, const ReferencePair& pair,
                        Quality& q) {
        metrics::ErrorPair error = metrics::errorsOf(shown, pair, metrics::shownLuma);
        const std::vector<glm::vec4> motion = layer(frame, "motion");
        const std::vector<glm::vec4> depth = layer(frame, "depth");
        const int w = int(s_.width), h = int(s_.height);
        metrics::Motion m{metrics::Offsets(w, h), Plane(w, h), Plane(w, h)};
        Plane now(w, h);
        for (size_t i = 0; i < motion.size(); ++i) {
            m.toPrevious.pixels[i] = glm::vec2(motion[i]);
            m.slope.pixels[i] = motion[i].w;
            m.previousDepth.pixels[i] = depth[i].x + motion[i].z;
            now.pixels[i] = depth[i].x;
        }
        const bool first = error_.a.pixels.empty();
        if (!first) q.flicker += metrics::squaredFlicker(error, error_, &m, &depth_);
        error_ = std::move(error), depth_ = std::move(now);
        return first ? 0 : 1;
    }

    void save(GpFrame frame, GpFrame reference, int number) {
        std::filesystem::create_directories(s_.pictures);
        const auto name = [&](const char* what) {
            return fmt::format("{}/{}-{}.png", s_.pictures, number, what);
        };
        check(device_, gpSaveFrame(frame, name("realtime").c_str(), nullptr));
        GpFrameStatistics statistics{};
        check(device_, gpGetFrameStatistics(reference, &statistics));
        if (statistics.samplesPerPixel > 0)  // else it was read
            check(device_, gpSaveFrame(reference, name("reference").c_str(), nullptr));
    }

    Settings s_;
    GpDevice device_ = nullptr;
    std::vector<std::string> names_;
    std::vector<float> values_;
    std::vector<GpDenoiserParameter> tune_;
    metrics::ErrorPair error_;
    Plane depth_;
};

void printHead() {
    std::cout << "| what moves | RMSE | FLIP | flicker | frames: direct | specular | change "
                 "| lighting, ms |\n|---|---|---|---|---|---|---|---|\n";
}

void printRow(const char* name, const Quality& q) {
    std::cout << fmt::format("| {} | {:.4f} | {:.4f} | {:.4f} | {:.1f} | {:.1f} | {:.4f} "
                             "| {:.1f} |\n",
                             name, metrics::rootOf(q.mse), q.flip, metrics::rootOf(q.flicker),
                             q.histories.direct, q.histories.specular, q.histories.change,
                             median(q.lighting.values))
              << std::flush;
}

nlohmann::ordered_json jsonOf(const Quality& q) {
    return {{"rmse", metrics::rootOf(q.mse)},
            {"flip", q.flip},
            {"flicker", metrics::rootOf(q.flicker)},
            {"specular_frames", q.histories.specular},
            {"change", q.histories.change},
            {"lighting_ms", q.lighting.json()}};
}

}  // namespace
}  // namespace gp::bench

int main(int argc, char** argv) {
    using namespace gp::bench;
    Settings s;
    CLI::App app("The sea in real time against path-traced references");
    app.add_option("--width", s.width)->check(CLI::Range(16u, 4096u));
    app.add_option("--height", s.height)->check(CLI::Range(16u, 4096u));
    app.add_option("--frames", s.frames, "that are rendered")->check(CLI::Range(1u, 10000u));
    app.add_option("--last", s.last, "of them, at the end, are measured");
    app.add_option("--spp", s.samples, "paths a pixel of references");
    app.add_option("--ev", s.ev, "exposure");
    app.add_option("--sun", s.elevation, "degrees above the horizon")->check(CLI::Range(0.0, 90.0));
    app.add_option("--tune", s.tune, "parameters of the denoiser: NAME=VALUE,...");
    app.add_option("--references", s.references, "a folder that keeps the references");
    app.add_option("--pictures", s.pictures, "a folder for the last pictures");
    app.add_option("--only", s.only, "digits: numbers of cases");
    app.add_flag("--json", s.json, "print JSON");
    CLI11_PARSE(app, argc, argv);
    try {
        if (s.last == 0 || s.last > s.frames) throw std::runtime_error("--last: 1 to --frames");
        if (!s.references.empty()) std::filesystem::create_directories(s.references);
        SeaQuality quality(s);
        nlohmann::ordered_json all;
        if (!s.json) printHead();
        for (int i = 0; i < int(std::size(kCases)); ++i) {
            if (!s.only.empty() && s.only.find(char('0' + i)) == std::string::npos) continue;
            const Quality q = quality.measure(kCases[i], i);
            if (s.json) all["cases"][kCases[i].name] = jsonOf(q);
            else printRow(kCases[i].name, q);
        }
        all["size"] = {s.width, s.height}, all["frames"] = s.frames, all["last"] = s.last;
        all["samples"] = s.samples;
        if (s.json) std::cout << all.dump(2) << '\n';
    } catch (const std::exception& e) {
        std::cerr << "gp_bench_sea: " << e.what() << '\n';
        return 1;
    }
    return 0;
}
