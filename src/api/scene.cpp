#include <climits>
#include <unordered_set>

#include "api/check.h"
#include "api/describe.h"
#include "api/scenes.h"
#include "io/gltf.h"

namespace gp::api {

void countUse(SceneObject& scene, const Mesh* mesh, int change) {
    if (change > 0) {
        ++scene.dynamicUses[mesh];
        return;
    }
    const auto use = scene.dynamicUses.find(mesh);
    if (use != scene.dynamicUses.end() && --use->second == 0) scene.dynamicUses.erase(use);
}

void meshChanged(DeviceObject& device, const Mesh& mesh) {
    for (const std::weak_ptr<SceneObject>& weak : device.scenes)
        if (const auto scene = weak.lock())
            if (scene->dynamicUses.contains(&mesh)) ++scene->scene.revision;
}

namespace {

io::GltfOptions loadOptions(const GpLoadOptions& options) {
    checkFinite(options.time, "options.time");
    const bool all = options.animation == GP_ALL_ANIMATIONS;
    if (options.animation > INT_MAX && !all)
        fail(GP_ERROR_OUT_OF_RANGE, "options.animation is {}", options.animation);
    if (options.scene > INT_MAX) fail(GP_ERROR_OUT_OF_RANGE, "options.scene is {}", options.scene);
    io::GltfOptions result;
    result.time = options.time;
    // 0, the default, becomes -1.
    result.animation = all ? io::allAnimations : int(options.animation) - 1;
    result.scene = int(options.scene) - 1;
    result.playable = options.playable != 0;
    return result;
}

uint64_t bytesOf(const Mesh& mesh) {
    return mesh.positions.size() * sizeof(mesh.positions[0]) +
           mesh.triangles.size() * sizeof(mesh.triangles[0]) +
           mesh.vertices.size() * sizeof(mesh.vertices[0]) + mesh.uv1.size() * sizeof(mesh.uv1[0]) +
           mesh.colors.size() * sizeof(mesh.colors[0]);
}

// Meshes, materials and textures are shared: each counts once.
struct Uniques {
    std::unordered_set<const Mesh*> meshes;
    std::unordered_set<const Material*> materials;
    std::unordered_set<const Texture*> textures;

    void add(const Instance& instance) {
        meshes.insert(instance.mesh.get());
        const Material& material = instance.surface();
        if (!materials.insert(&material).second) return;
        forEachTexture(material, [&](const char*, const TextureUse& use) {
            if (use.texture) textures.insert(use.texture.get());
        });
        for (const MaterialLayer& layer : material.layers)
            if (layer.mask.texture) textures.insert(layer.mask.texture.get());
    }
};

void describeBounds(const Scene& scene, GpSceneInfo& info) {
    const Bounds bounds = worldBounds(scene);
    if (bounds.empty()) return;
    for (int i = 0; i < 3; ++i) {
        info.boundsMin[i] = bounds.lo[i];
        info.boundsMax[i] = bounds.hi[i];
    }
}

GpSceneInfo infoOf(const Scene& scene) {
    GpSceneInfo info{};
    Uniques uniques;
    for (const auto& instance : scene.instances) {
        uniques.add(*instance);
        const uint64_t triangles = instance->mesh->triangles.size();
        info.instancedTriangles += triangles;
        if (instance->surface().emission != glm::vec3(0)) info.emissiveTriangles += triangles;
    }
    info.instances = scene.instances.size();
    info.meshes = uniques.meshes.size();
    info.materials = uniques.materials.size();
    info.textures = uniques.textures.size();
    for (const Mesh* mesh : uniques.meshes) {
        info.triangles += mesh->triangles.size();
        info.geometryBytes += bytesOf(*mesh);
    }
    for (const Texture* texture : uniques.textures) info.textureBytes += texture->pixels.size();
    info.lights = scene.lights.size();
    info.cameras = scene.cameras.size();
    info.hasEnvironment = scene.environment.table || scene.environment.color != glm::vec3(0);
    describeBounds(scene, info);
    return info;
}

GpScene newScene(DeviceObject& device) {
    auto object = std::make_shared<SceneObject>(device);
    std::erase_if(device.scenes, [](const auto& weak) { return weak.expired(); });
    device.scenes.push_back(object);
    return publish<GpScene>(object);
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpScene gpNewScene(GpDevice device) {
    return enter("gpNewScene", "device", device, [](DeviceObject& d) { return newScene(d); });
}

GpError gpReleaseScene(GpScene scene) {
    return enter("gpReleaseScene", "scene", scene,
                 [&](SceneObject&) { handles().remove(bitsOf(scene)); });
}

GpError gpLoadSceneFile(GpScene scene, const char* path, const GpLoadOptions* options) {
    return enter("gpLoadSceneFile", "scene", scene, [&](SceneObject& s) {
        checkPath(path);
        const gp::io::GltfOptions gltf = loadOptions(options ? *options : GpLoadOptions{});
        // Into a copy (of pointers, mostly), so that no failure whatsoever leaves half a file.
        gp::Scene loaded = s.scene;
        PlayingFile file;
        file.firstAnimation = loaded.animations.size();
        file.animation = gltf.animation;
        file.player = gp::io::loadGltf(path, gltf, loaded);
        if (file.player) s.playing.push_back(std::move(file));
        loaded.revision = s.scene.revision + 1;
        s.scene = std::move(loaded);
    });
}

GpError gpGetSceneInfo(GpScene scene, GpSceneInfo* info) {
    return enter("gpGetSceneInfo", "scene", scene, [&](SceneObject& s) {
        checkPointer(info, "info");
        *info = infoOf(s.scene);
    });
}

GpError gpDescribeScene(GpScene scene, char* text, size_t size, size_t* needed) {
    return enter("gpDescribeScene", "scene", scene, [&](SceneObject& s) {
        giveText(describeScene(s.scene), text, size, needed);
    });
}

}  // extern "C"
