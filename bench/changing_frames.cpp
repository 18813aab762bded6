// gp_bench_changing: real-time frames in which much changes each time, through the public
// interface: many lights that all move, or a mesh of many triangles with new vertices. Prints
// medians as JSON: what the calls took, what brought the scene up to date, the rest of the frame,
// and what all threads computed for a frame, which hardly notices other programs.
#include <cmath>
#include <cstdio>
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

struct Settings {
    uint32_t lights = 0, triangles = 0, width = 320, height = 180, frames = 12, threads = 0;
    uint32_t corners = 0;  // of lights that are polygons; 0: spheres
    std::string image;
};

// The fraction of `n` times an irrational number: the same places in each run.
float spread(uint32_t n, double step) {
    const double x = double(n) * step;
    return float(x - std::floor(x));
}

class Changing {
public:
    explicit Changing(const Settings& s) : s_(s) {
        const GpDeviceDesc d{GP_BACKEND_CPU, s.threads, nullptr, nullptr, nullptr};
        device_ = made<GpDevice>(nullptr, gpNewDevice(&d));
        scene_ = made(device_, gpNewScene(device_));
        addMesh(waves(2, 0), GP_MESH_STATIC);
        if (s.triangles) {
            side_ = uint32_t(std::lround(std::sqrt(double(s.triangles) / 2)));
            mesh_ = addMesh(waves(side_, 0), GP_MESH_DYNAMIC);
        }
        for (uint32_t i = 0; i < std::max(s.lights, 1u); ++i) {
            const GpLightDesc light = lamp(i, 0);
            lights_.push_back(made(device_, gpNewLight(scene_, &light)));
        }
        const GpFrameDesc frame{s.width, s.height, GP_MODE_REALTIME};
        frame_ = made(device_, gpNewFrame(device_, &frame));
    }
    ~Changing() { gpReleaseDevice(device_); }

    Json run() {
        Spread calls, build, render, core;
        for (uint32_t i = 0; i < s_.frames + 2; ++i) {
            if (mesh_) waves_ = waves(side_, i + 1);
            const Stopwatch watch;
            change(i + 1);
            const double changed = 1e3 * watch.wall();
            const Stopwatch drawing;
            draw();
            const double computed = 1e3 * drawing.core();
            GpFrameStatistics now{};
            check(device_, gpGetFrameStatistics(frame_, &now));
            if (i < 2) continue;  // memory is taken for the first time
            calls.add(changed), build.add(1e3 * now.secondsBuild);
            render.add(1e3 * now.secondsRender), core.add(computed);
        }
        if (!s_.image.empty()) check(device_, gpSaveFrame(frame_, s_.image.c_str(), nullptr));
        Json passes;
        uint32_t count = 0;
        GpPassTime times[32];
        check(device_, gpGetPassTimes(frame_, times, 32, &count));
        for (uint32_t i = 0; i < count; ++i) passes[times[i].name] = times[i].milliseconds;
        return {{"device", gpGetDeviceName(device_)}, {"lights", s_.lights},
                {"corners", s_.corners}, {"triangles", uint64_t(side_) * side_ * 2},
                {"calls_ms", calls.json()}, {"build_ms", build.json()},
                {"render_ms", render.json()}, {"frame_core_ms", core.json()},
                {"last_passes_ms", passes}};
    }

private:
    struct Waves {
        std::vector<float> positions;
        std::vector<uint32_t> indices;
    };

    static Waves waves(uint32_t side, uint32_t frame) {
        Waves w;
        for (uint32_t z = 0; z <= side; ++z)
            for (uint32_t x = 0; x <= side; ++x) {
                const float u = 10 * float(x) / float(side), v = 10 * float(z) / float(side);
                const float height =
                    0.3f * std::sin(3 * u + 0.1f * float(frame)) * std::cos(2 * v);
                w.positions.insert(w.positions.end(), {u - 5, height, v - 5});
            }
        for (uint32_t z = 0; z < side; ++z)
            for (uint32_t x = 0; x < side; ++x) {
                const uint32_t a = z * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
                w.indices.insert(w.indices.end(), {a, c, b, b, c, d});
            }
        return w;
    }

    static GpMeshDesc describe(const Waves& w, GpMeshKind kind) {
        GpMeshDesc d{};
        d.kind = kind, d.id = 1;
        d.vertexCount = uint32_t(w.positions.size() / 3), d.positions = w.positions.data();
        d.indexCount = uint32_t(w.indices.size()), d.indices = w.indices.data();
        return d;
    }

    GpMesh addMesh(const Waves& w, GpMeshKind kind) {
        const GpMeshDesc desc = describe(w, kind);
        const GpMesh mesh = made(device_, gpNewMesh(device_, &desc));
        GpInstanceDesc instance{};
        instance.mesh = mesh;
        made(device_, gpNewInstance(scene_, &instance));
        return mesh;
    }

    // Lamps over a square of 10 m, each on a small circle of its own.
    GpLightDesc lamp(uint32_t i, uint32_t frame) {
        constexpr float pi = std::numbers::pi_v<float>;
        const float turn = 2 * pi * spread(i, 0.38196601125) + 0.2f * float(frame);
        const float x = 10 * spread(i, 0.7548776662466927) - 5 + 0.1f * std::cos(turn);
        const float y = 0.4f + 2 * spread(i, 0.4142135624);
        const float z = 10 * spread(i, 0.5698402909980532) - 5 + 0.1f * std::sin(turn);
        GpLightDesc d{};
        d.kind = GP_LIGHT_SPHERE, d.id = i + 1;
        d.intensity = 60.0f / float(std::max(s_.lights, 1u)) * (1.5f + std::sin(turn));
        d.position[0] = x, d.position[1] = y, d.position[2] = z, d.radius = 0.01f;
        if (s_.corners == 0 || s_.lights == 0) return d;
        d.kind = GP_LIGHT_POLYGON, d.intensity *= 1e3f;
        corners_.resize(size_t(s_.corners) * 3);
        for (uint32_t c = 0; c < s_.corners; ++c) {
            const float angle = 2 * pi * float(c) / float(s_.corners);
            corners_[3 * c] = x + 0.01f * std::cos(angle), corners_[3 * c + 1] = y;
            corners_[3 * c + 2] = z + 0.01f * std::sin(angle);
        }
        d.corners = corners_.data(), d.cornerCount = s_.corners;
        return d;
    }

    void change(uint32_t frame) {
        if (s_.lights)
            for (uint32_t i = 0; i < s_.lights; ++i) {
                const GpLightDesc light = lamp(i, frame);
                check(device_, gpSetLight(lights_[i], &light));
            }
        if (!mesh_) return;
        const GpMeshDesc desc = describe(waves_, GP_MESH_DYNAMIC);
        check(device_, gpUpdateMesh(mesh_, &desc));
    }

    void draw() {
        GpCameraDesc camera{};
        camera.position[0] = 5, camera.position[1] = 4, camera.position[2] = 7;
        camera.verticalFov = 0.8f;
        check(device_, gpRender(frame_, scene_, &camera, nullptr));
    }

    Settings s_;
    GpDevice device_ = nullptr;
    GpScene scene_ = nullptr;
    GpFrame frame_ = nullptr;
    GpMesh mesh_ = nullptr;
    uint32_t side_ = 0;
    Waves waves_;
    std::vector<GpLight> lights_;
    std::vector<float> corners_;
};

}  // namespace
}  // namespace gp::bench

int main(int argc, char** argv) {
    gp::bench::Settings s;
    CLI::App app("Real-time frames in which much changes each time, as JSON");
    app.add_option("--lights", s.lights, "that all change in each frame")
        ->check(CLI::Range(0u, 1000000u));
    app.add_option("--corners", s.corners, "of lights that are polygons (0: spheres)")
        ->check(CLI::Range(3u, 1024u));
    app.add_option("--triangles", s.triangles, "of a mesh with new vertices in each frame")
        ->check(CLI::Range(2u, 10000000u));
    app.add_option("--width", s.width)->check(CLI::Range(1u, 16384u));
    app.add_option("--height", s.height)->check(CLI::Range(1u, 16384u));
    app.add_option("--frames", s.frames, "that are measured")->check(CLI::Range(1u, 10000u));
    app.add_option("--threads", s.threads, "0: all processors");
    app.add_option("--image", s.image, "the last frame, to look at");
    CLI11_PARSE(app, argc, argv);
    try {
        std::cout << gp::bench::Changing(s).run().dump(2) << '\n';
    } catch (const std::exception& e) {
        std::cerr << "gp_bench_changing: " << e.what() << '\n';
        return 1;
    }
    return 0;
}
