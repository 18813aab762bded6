// gp_bench_rays: how fast the whole renderer is, against bare Embree over the very same rays. Both
// run on the same structures and the same number of threads, in turns, in one process.
#include <fstream>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "backend/cpu/cpu_backend.h"
#include "build_times.h"
#include "ray_measure.h"

namespace gp::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
    SceneOptions scene;
    RaySettings rays;
    bool buildTimes = false;
    std::vector<size_t> generated;  // triangles of the meshes that are made to be built
    std::string json;
};

Json buildReport(Backend& backend, const Scene& scene, const Settings& s) {
    Json json;
    if (const Mesh* mesh = largestMesh(scene))
        json["largest_mesh"] = buildTimes(backend, *mesh, s.rays.runs);
    for (const size_t triangles : s.generated)
        json[fmt::format("waves_{}", triangles)] =
            buildTimes(backend, makeWaves(triangles), s.rays.runs);
    return json;
}

Json run(Settings& s) {
    if (s.rays.threads == 0) s.rays.threads = std::max(1u, std::thread::hardware_concurrency());
    const Scene scene = loadScene(s.scene);
    cpu::CpuBackend backend({s.rays.threads, ""});
    const auto target = backend.newScene();
    target->update(scene);
    Json json = {{"scene", s.scene.path},
                 {"width", s.scene.width},
                 {"height", s.scene.height},
                 {"spp", s.rays.samples},
                 {"recorded_spp", s.rays.recordedSamples},
                 {"bounces", s.rays.bounces},
                 {"shading", s.rays.diffuse ? "diffuse" : "full"},
                 {"threads", s.rays.threads},
                 {"device", backend.name()}};
    json.update(measureRays(backend, *target, scene, s.scene, s.rays));
    if (s.buildTimes) json["build_times"] = buildReport(backend, scene, s);
    return json;
}

void addOptions(CLI::App& app, Settings& s) {
    SceneOptions& scene = s.scene;
    RaySettings& rays = s.rays;
    app.add_option("scene", scene.path, "glTF file")->required();
    app.add_option("--env", scene.environment, "Radiance HDR or EXR around it");
    app.add_option("--env-rotation", scene.environmentRotationDeg, "degrees about the vertical");
    app.add_option("--sun", scene.sun, "azimuth, elevation (degrees), W/m^2")
        ->expected(3)->delimiter(',');
    app.add_option("--from", scene.from, "camera, metres")->expected(3)->delimiter(',');
    app.add_option("--look-at", scene.lookAt, "metres")->expected(3)->delimiter(',');
    app.add_option("--fov", scene.fovDeg, "vertical, degrees");
    app.add_option("--width", scene.width)->check(CLI::Range(1u, 16384u));
    app.add_option("--height", scene.height)->check(CLI::Range(1u, 16384u));
    app.add_option("--spp", rays.samples, "samples a pixel of each render")
        ->check(CLI::Range(1u, 65536u));
    app.add_option("--recorded-spp", rays.recordedSamples, "of the rays that Embree gets")
        ->check(CLI::Range(1u, 64u));
    app.add_option("--bounces", rays.bounces)->check(CLI::Range(0u, 64u));
    app.add_option("--threads", rays.threads, "0: all")->check(CLI::Range(0u, 1024u));
    app.add_option("--runs", rays.runs, "of each measurement; the median counts")
        ->check(CLI::Range(1, 99));
    app.add_flag("--diffuse", rays.diffuse, "all surfaces matte");
    app.add_flag("--build-times", s.buildTimes, "of the scene's largest mesh as well");
    app.add_option("--waves", s.generated, "and of generated meshes of so many triangles")
        ->delimiter(',')->check(CLI::Range(2u, 100000000u));
    app.add_option("--json", s.json, "write there instead of to the terminal");
}

}  // namespace
}  // namespace gp::bench

int main(int argc, char** argv) {
    gp::bench::Settings settings;
    CLI::App app("Rays a second of the whole renderer and of bare Embree over the same rays");
    gp::bench::addOptions(app, settings);
    CLI11_PARSE(app, argc, argv);
    try {
        const std::string text = gp::bench::run(settings).dump(2);
        if (settings.json.empty()) {
            fmt::print("{}\n", text);
        } else if (!(std::ofstream(settings.json) << text << '\n')) {
            throw std::runtime_error(settings.json + ": cannot be written");
        }
    } catch (const std::exception& e) {
        fmt::print(stderr, "gp_bench_rays: {}\n", e.what());
        return 1;
    }
    return 0;
}
