// What is new in one place and shows in others: the scenes whose revision grows by it.
#include <algorithm>
#include <unordered_map>

#include "api/describe.h"
#include "api/scenes.h"

namespace gp::api {

namespace {

template <class F>
void scenesChanged(DeviceObject& device, F&& concerns) {
    for (const std::weak_ptr<SceneObject>& weak : device.scenes)
        if (const auto scene = weak.lock()) {
            const auto& instances = scene->scene.instances;
            if (std::any_of(instances.begin(), instances.end(),
                            [&](const auto& instance) { return concerns(*instance); }))
                ++scene->scene.revision;
        }
}

// Of an animated material the frame that shows counts; the others are new when their turn comes.
bool uses(const Material& material, const Texture& texture) {
    bool found = false;
    forEachTexture(material, [&](const char*, const TextureUse& use) {
        found |= use.texture.get() == &texture;
    });
    for (const MaterialLayer& layer : material.layers)
        found |= layer.mask.texture.get() == &texture;
    return found;
}

}  // namespace

void texCoordsChanged(DeviceObject& device, const Mesh& mesh) {
    scenesChanged(device, [&](const Instance& i) { return i.mesh.get() == &mesh; });
}

void materialChanged(DeviceObject& device, const Material& material) {
    scenesChanged(device, [&](const Instance& i) { return i.given().get() == &material; });
}

void textureChanged(DeviceObject& device, const Texture& texture) {
    std::unordered_map<const Material*, bool> known;  // thousands of instances share a few
    scenesChanged(device, [&](const Instance& i) {
        const auto [entry, isNew] = known.try_emplace(&i.surface());
        if (isNew) entry->second = uses(i.surface(), texture);
        return entry->second;
    });
}

}  // namespace gp::api
