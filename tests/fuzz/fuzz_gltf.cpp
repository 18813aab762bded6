// Any bytes must give a scene that can be traced, or a FileError that leaves the scene empty.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <tbb/global_control.h>
#include <unistd.h>

#include "io/gltf.h"
#include "io/gltf_player.h"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

void checkScene(const gp::Scene& scene) {
    for (const auto& instance : scene.instances) {
        const gp::Mesh& mesh = *instance->mesh;
        require(mesh.material != nullptr && !mesh.triangles.empty());
        require(mesh.positions.size() == mesh.vertexCount() + 1);
        require(mesh.uv1.empty() || mesh.uv1.size() == mesh.vertexCount());
        require(mesh.colors.empty() || mesh.colors.size() == mesh.vertexCount());
        for (const glm::uvec3 t : mesh.triangles)
            for (int c = 0; c < 3; ++c) require(t[c] < mesh.vertexCount());
    }
    const gp::Bounds b = gp::worldBounds(scene);
    require(b.empty() || (std::isfinite(b.lo.x) && std::isfinite(b.hi.x)));
}

// Any moment must be a scene too, or an error that leaves the one that was there.
void play(gp::io::GltfPlayer& player, gp::Scene& scene) {
    const size_t instances = scene.instances.size();
    for (const double time : {0.0, 1.3, -1e9})
        try {
            player.prepare({time, time > 0, gp::io::allAnimations});
            player.apply(scene);
        } catch (const gp::io::FileError&) {
        }
    require(scene.instances.size() == instances);
    checkScene(scene);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    // Threads would cost more than these small files take, and hide which input was slow.
    static const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    static const std::string path =
        (std::filesystem::temp_directory_path() / ("gp-fuzz-" + std::to_string(getpid()))).string();
    std::FILE* file = std::fopen(path.c_str(), "wb");
    require(file != nullptr);
    std::fwrite(data, 1, size, file);
    std::fclose(file);
    gp::Scene scene;
    try {
        gp::io::GltfOptions options;
        options.time = 0.7;
        options.maxImagePixels = uint64_t(1) << 20;
        options.playable = true;
        const auto player = gp::io::loadGltf(path, options, scene);
        checkScene(scene);
        play(*player, scene);
    } catch (const gp::io::FileError&) {
        require(scene.instances.empty() && scene.sources.empty() && scene.revision == 0);
    }
    return 0;
}
