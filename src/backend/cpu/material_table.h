// The materials of a scene as the kernels read them: records, textures, and the parameters of those
// that are made of the library's models.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "backend/cpu/scene_view.h"
#include "backend/cpu/slope_table.h"
#include "scene/scene.h"

namespace gp::cpu {

class MaterialTable {
public:
    MaterialTable();
    ~MaterialTable();

    // All materials of the scene's instances, anew.
    void fill(const Scene& scene);
    uint32_t indexOf(const Instance& instance) const { return index_.at(keyOf(instance)); }
    bool hasSlopes() const { return hasSlopes_; }  // one of them is of the model `glint`
    // Pointers that hold until the next fill.
    void show(SceneView& view) const;

private:
    struct Bsdfs;  // shading::BsdfParams, a type that every translation unit has its own of
    // An instance's colour makes another material of its own, which costs the kernels nothing.
    struct Key {
        const Material* material;
        glm::vec4 color;
        bool operator==(const Key&) const = default;
    };
    struct KeyHash {
        size_t operator()(const Key& key) const;
    };
    static Key keyOf(const Instance& i) { return {&i.surface(), i.color}; }

    shared::MaterialRecord recordOf(const Material& m, glm::vec4 color);
    void fillSlots(shared::MaterialRecord& r, const Material& m);
    void fillSlot(shared::MaterialRecord& r, shared::TextureSlot& slot, uint32_t bit,
                  const TextureUse& use);
    void fillUse(shared::TextureSlot& slot, const TextureUse& use);
    void fillSlopes(shared::MaterialRecord& r, const Material& m);
    void fillLayers(shared::MaterialRecord& r, const Material& m, bool colored);
    void fillTextureLayers(shared::MaterialRecord& r, const Material& m, glm::vec4 color);

    std::vector<shared::MaterialRecord> records_;
    std::unordered_map<Key, uint32_t, KeyHash> index_;
    std::vector<std::shared_ptr<const Material>> owners_;
    std::vector<TextureView> textures_;
    std::unordered_map<const Texture*, uint32_t> textureIndex_;
    SlopeTable slopes_;
    std::vector<shared::BsdfLayerRecord> layers_;
    std::vector<shared::TextureLayerRecord> textureLayers_;
    std::unique_ptr<Bsdfs> bsdfs_;
    bool hasSlopes_ = false;
};

}  // namespace gp::cpu
