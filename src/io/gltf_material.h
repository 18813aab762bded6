// Materials and textures of a glTF file.
#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "io/gltf_document.h"
#include "scene/material.h"
#include "scene/mesh.h"

namespace gp::io {

class Materials {
public:
    Materials(Document& document, uint64_t maxImagePixels)
        : m_document(document), m_maxPixels(maxImagePixels) {}

    // Material `index` (none: glTF's default one), read when first asked for. Its textures are
    // there after loadTextures().
    std::shared_ptr<const Material> get(std::optional<uint32_t> index);
    // What meshes of this material need.
    MeshOptions meshOptions(std::optional<uint32_t> index);

    // Decodes every image that the materials asked for, in parallel, and makes the textures.
    void loadTextures();

private:
    struct Entry {
        std::shared_ptr<Material> material;
        MeshOptions options;
    };
    // One texture: image, sampler (or none) and how its numbers are meant.
    using Key = std::tuple<uint32_t, int64_t, ColorSpace>;

    Entry& entry(std::optional<uint32_t> index);
    Entry read(const Value& value);
    void readBase(const Value& value, Material& m);
    void readCoats(const Value& value, Material& m);
    void readInside(const Value& value, Material& m);
    void readGlints(const Value& value, Material& m);  // gltf_glints.cpp
    void readSlopeMaps(const Value& value, Material& m);  // gltf_slope_maps.cpp
    void checkSlopeMaps() const;                          // when their textures are there
    bool use(const Value& value, const char* key, ColorSpace space, TextureUse& target);
    void decodeImages(const std::vector<uint32_t>& images, std::vector<Image>& decoded);
    TextureDesc describe(const Key& key) const;

    Document& m_document;
    uint64_t m_maxPixels;
    std::map<int64_t, Entry> m_entries;  // -1: the default material
    std::map<Key, std::vector<TextureUse*>> m_wanted;
};

}  // namespace gp::io
