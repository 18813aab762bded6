// gp_bench_water: frames of the sea under one directional light in GP_MODE_LOCAL (a camera ray and
// the light of one lamp a pixel, as a rasteriser has it), through the public interface: without and
// with glints, by masking, and with more or less of the picture being water. Variants take turns.
// Prints medians as JSON: what all threads computed for a frame, and its time by the wall's clock.
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

#include <CLI/CLI.hpp>
#include <glitterpath/glitterpath.h>

#include "checked.h"
#include "spread.h"

namespace gp::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFov = 45 * std::numbers::pi / 180;

struct Settings {
    uint32_t width = 640, height = 360, frames = 12, threads = 0;
    std::string image, only;
};

struct Variant {
    const char* name;
    GpOceanGlints glints;
    GpOceanMasking masking;
    double share;  // of the picture that is water, 0..1
};

// The first is what glints are compared with.
constexpr std::array kVariants = {
    Variant{"smooth", GP_GLINTS_OFF, GP_MASKING_V_CAVITY, 1},
    Variant{"smooth, Smith", GP_GLINTS_OFF, GP_MASKING_SMITH, 1},
    Variant{"glints", GP_GLINTS_ON, GP_MASKING_V_CAVITY, 1},
    Variant{"glints, Smith", GP_GLINTS_ON, GP_MASKING_SMITH, 1},
    Variant{"glints by counting", GP_GLINTS_COUNTING, GP_MASKING_V_CAVITY, 1},
    Variant{"glints, 3/4 water", GP_GLINTS_ON, GP_MASKING_V_CAVITY, 0.75},
    Variant{"glints, 1/2 water", GP_GLINTS_ON, GP_MASKING_V_CAVITY, 0.5},
    Variant{"glints, 1/4 water", GP_GLINTS_ON, GP_MASKING_V_CAVITY, 0.25},
    Variant{"no water", GP_GLINTS_ON, GP_MASKING_V_CAVITY, 0},
};

constexpr size_t kShown = 2;  // in the image

// Looks so far down that the horizon leaves this share of the picture below it; all of it: 40
// degrees down, where no ripple of the horizon is left.
GpCameraDesc cameraOf(double share) {
    const double half = std::tan(0.5 * kFov);
    const double down = share >= 1  ? 40 * std::numbers::pi / 180
                        : share > 0 ? std::atan((2 * share - 1) * half)
                                    : -0.6 * kFov;
    GpCameraDesc camera{};
    camera.position[1] = 3;
    camera.target[1] = float(3 - std::sin(down));
    camera.target[2] = float(-std::cos(down));
    camera.verticalFov = float(kFov);
    return camera;
}

class Water {
public:
    explicit Water(const Settings& s) : s_(s) {
        const GpDeviceDesc d{GP_BACKEND_CPU, s.threads, nullptr, nullptr, nullptr};
        device_ = made<GpDevice>(nullptr, gpNewDevice(&d));
        for (size_t i = 0; i < kVariants.size(); ++i)
            if (measured(i) || (i == kShown && !s.image.empty())) addScene(i);
        const GpFrameDesc frame{s.width, s.height, GP_MODE_LOCAL};
        frame_ = made(device_, gpNewFrame(device_, &frame));
    }
    ~Water() { gpReleaseDevice(device_); }

    Json run() {
        std::array<Spread, kVariants.size()> core, wall;
        for (uint32_t round = 0; round < s_.frames + 1; ++round)
            for (size_t i = 0; i < kVariants.size(); ++i) {
                if (!measured(i)) continue;
                const Stopwatch watch;
                draw(i);
                if (round == 0) continue;  // triangles and dictionary are made for the first time
                core[i].add(1e3 * watch.core()), wall[i].add(1e3 * watch.wall());
            }
        Json variants;
        for (size_t i = 0; i < kVariants.size(); ++i)
            if (measured(i)) variants[kVariants[i].name] = {{"share", kVariants[i].share},
                                           {"frame_core_ms", core[i].json()},
                                           {"frame_wall_ms", wall[i].json()}};
        return {{"device", gpGetDeviceName(device_)}, {"width", s_.width}, {"height", s_.height},
                {"variants", variants}};
    }

    void save() {
        draw(kShown);
        check(device_, gpSaveFrame(frame_, s_.image.c_str(), nullptr));
    }

private:
    bool measured(size_t i) const { return s_.only.empty() || s_.only == kVariants[i].name; }

    void addScene(size_t i) {
        const GpScene scene = made(device_, gpNewScene(device_));
        GpOceanDesc sea{};
        sea.glints = kVariants[i].glints;
        sea.masking = kVariants[i].masking;
        check(device_, gpSetOcean(scene, &sea));
        GpLightDesc sun{};
        sun.kind = GP_LIGHT_DIRECTIONAL, sun.intensity = 3;
        sun.direction[1] = -1, sun.direction[2] = 1;  // from before the viewer, 45 degrees high
        sun.angularRadius = 0.00465f;
        made(device_, gpNewLight(scene, &sun));
        scenes_[i] = scene;
    }

    void draw(size_t i) {
        const GpCameraDesc camera = cameraOf(kVariants[i].share);
        GpRenderOptions options{};
        options.samplesPerPixel = 1;
        check(device_, gpRender(frame_, scenes_[i], &camera, &options));
    }

    Settings s_;
    GpDevice device_ = nullptr;
    std::array<GpScene, kVariants.size()> scenes_{};
    GpFrame frame_ = nullptr;
};

}  // namespace
}  // namespace gp::bench

int main(int argc, char** argv) {
    gp::bench::Settings s;
    CLI::App app("Frames of the sea under one light, as JSON");
    app.add_option("--width", s.width)->check(CLI::Range(1u, 16384u));
    app.add_option("--height", s.height)->check(CLI::Range(1u, 16384u));
    app.add_option("--frames", s.frames, "of each variant that are measured")
        ->check(CLI::Range(1u, 10000u));
    app.add_option("--threads", s.threads, "0: all processors");
    app.add_option("--only", s.only, "one variant by its name, for a profiler");
    app.add_option("--image", s.image, "one with glints, to look at");
    CLI11_PARSE(app, argc, argv);
    try {
        gp::bench::Water water(s);
        const auto result = water.run();
        if (!s.image.empty()) water.save();
        std::cout << result.dump(2) << '\n';
    } catch (const std::exception& e) {
        std::cerr << "gp_bench_water: " << e.what() << '\n';
        return 1;
    }
    return 0;
}
