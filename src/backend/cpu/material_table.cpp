#include "backend/cpu/material_table.h"

#include <algorithm>

#include "shading/shading.h"

#include "backend/cpu/texture_view.h"
#include "scene/bsdf_settings.h"
#include "scene/hash.h"

namespace gp::cpu {

using namespace gp::shared;

struct MaterialTable::Bsdfs {
    std::vector<shading::BsdfParams> all;

    uint32_t add(const shading::BsdfParams& bsdf) {
        all.push_back(bsdf);
        return uint32_t(all.size()) - 1;
    }
};

MaterialTable::MaterialTable() : bsdfs_(std::make_unique<Bsdfs>()) {}
MaterialTable::~MaterialTable() = default;

void MaterialTable::show(SceneView& view) const {
    view.materials = records_.data();
    view.textures = textures_.data();
    view.slopeMaps = slopes_.views();
    view.materialSlopes = slopes_.records().data();
    view.bsdfs = bsdfs_->all.data();
    view.bsdfLayers = layers_.data();
    view.textureLayers = textureLayers_.data();
}

// ------------------------------------------------------------------------------- textures

void MaterialTable::fillUse(TextureSlot& slot, const TextureUse& use) {
    const auto [it, fresh] =
        textureIndex_.try_emplace(use.texture.get(), uint32_t(textures_.size()));
    if (fresh) textures_.push_back(textureView(*use.texture));
    slot.texture_index = it->second;
    slot.tex_coord = use.texCoord;
    const glm::mat3x2& m = use.uvTransform;
    slot.row_u = {m[0][0], m[1][0], m[2][0], 0};
    slot.row_v = {m[0][1], m[1][1], m[2][1], 0};
}

void MaterialTable::fillSlot(MaterialRecord& r, TextureSlot& slot, uint32_t bit,
                             const TextureUse& use) {
    if (!use.texture) return;
    fillUse(slot, use);
    r.textures |= bit;
}

// All maps of slopes together. Facets take the normal map as slopes too; other models bend by it as
// it is.
void MaterialTable::fillSlopes(MaterialRecord& r, const Material& m) {
    const bool normalMap = r.model == MODEL_GLINT && m.normalTexture.texture;
    if (!normalMap && m.slopeMaps.empty()) return;
    if (normalMap) r.textures &= ~SLOT_NORMAL;
    r.textures |= SLOT_SLOPES;
    r.first_slopes = uint32_t(slopes_.records().size());
    const auto add = [&](const SlopeMapUse& use, bool turned) {
        fillUse(slopes_.add(use, turned).slot, use.texture);
    };
    if (normalMap) add({m.normalTexture, SlopeMapKind::normal, m.normalScale, {}}, false);
    for (const SlopeMapUse& use : m.slopeMaps) add(use, true);
    slopes_.records().back().is_last = 1;
}

void MaterialTable::fillSlots(MaterialRecord& r, const Material& m) {
    fillSlot(r, r.base_color_slot, SLOT_BASE_COLOR, m.baseColorTexture);
    fillSlot(r, r.metallic_roughness_slot, SLOT_METALLIC_ROUGHNESS, m.metallicRoughnessTexture);
    fillSlot(r, r.normal_slot, SLOT_NORMAL, m.normalTexture);
    fillSlot(r, r.emission_slot, SLOT_EMISSION, m.emissionTexture);
    fillSlot(r, r.specular_slot, SLOT_SPECULAR, m.specularTexture);
    fillSlot(r, r.specular_color_slot, SLOT_SPECULAR_COLOR, m.specularColorTexture);
    fillSlot(r, r.coat_slot, SLOT_COAT, m.coatTexture);
    fillSlot(r, r.coat_roughness_slot, SLOT_COAT_ROUGHNESS, m.coatRoughnessTexture);
    fillSlot(r, r.coat_normal_slot, SLOT_COAT_NORMAL, m.coatNormalTexture);
    fillSlot(r, r.sheen_color_slot, SLOT_SHEEN_COLOR, m.sheenColorTexture);
    fillSlot(r, r.sheen_roughness_slot, SLOT_SHEEN_ROUGHNESS, m.sheenRoughnessTexture);
    fillSlot(r, r.transmission_slot, SLOT_TRANSMISSION, m.transmissionTexture);
    fillSlot(r, r.anisotropy_slot, SLOT_ANISOTROPY, m.anisotropyTexture);
    fillSlot(r, r.iridescence_slot, SLOT_IRIDESCENCE, m.iridescenceTexture);
    fillSlot(r, r.iridescence_thickness_slot, SLOT_IRIDESCENCE_THICKNESS,
             m.iridescenceThicknessTexture);
}

// ------------------------------------------------------------------------------- records

static uint32_t commonFlags(const Material& m) {
    uint32_t flags = 0;
    if (m.doubleSided) flags |= MATERIAL_DOUBLE_SIDED;
    if (m.unlit) flags |= MATERIAL_UNLIT;
    if (shading::luminance(m.emission) > 0) flags |= MATERIAL_EMISSIVE;
    if (m.alphaMode == AlphaMode::mask) flags |= MATERIAL_ALPHA_MASK;
    if (m.alphaMode == AlphaMode::blend) flags |= MATERIAL_ALPHA_BLEND;
    return flags;
}

static uint32_t gltfFlags(const Material& m) {
    uint32_t flags = 0;
    if (m.transmission > 0) flags |= MATERIAL_TRANSMISSIVE;
    if (m.transmission > 0 && !m.thinWalled) flags |= MATERIAL_SOLID;
    if (m.anisotropy > 0) flags |= MATERIAL_NEEDS_UV;
    const bool layers = m.coat > 0 || m.sheenColor != glm::vec3(0) || m.transmission > 0 ||
                        m.iridescence > 0;
    if (m.metallic == 0 && m.specular == 0 && !layers) flags |= MATERIAL_MATTE;
    if (m.specularTexture.texture || m.specularColorTexture.texture || layers)
        flags |= MATERIAL_LAYERED;
    return flags;
}

// The stack: what does not vary over the surface is blended and prepared here, once. `colored`:
// something else than m.baseColor multiplies its base colours.
void MaterialTable::fillLayers(MaterialRecord& r, const Material& m, bool colored) {
    const bool masked = std::any_of(m.layers.begin(), m.layers.end(),
                                    [](const MaterialLayer& l) { return l.mask.texture; });
    shading::BsdfParams bottom = bareBsdfParams(*m.layers[0].bsdf);
    r.first_layer = uint32_t(layers_.size());
    for (size_t i = 1; i < m.layers.size(); ++i) {
        const MaterialLayer& source = m.layers[i];
        const shading::BsdfParams params = bareBsdfParams(*source.bsdf);
        if (!masked) {
            bottom = shading::bsdf_blended(bottom, params, source.weight);
            continue;
        }
        BsdfLayerRecord layer{};
        layer.weight = source.weight;
        layer.channel = source.mask.texture ? source.channel : NO_INDEX;
        layer.squared = source.squared;
        if (source.mask.texture) fillUse(layer.mask_slot, source.mask);
        layer.bsdf = bsdfs_->add(params);
        layers_.push_back(layer);
    }
    r.layer_count = uint32_t(layers_.size()) - r.first_layer;
    const shading::BsdfParams prepared = shading::bsdf_prepared(bottom);
    // Preparation may depend on what a texture varies; glints are prepared for what a pixel sees.
    const bool glints = bottom.model == MODEL_GLINT;
    const bool later =
        !glints && (masked || (colored && shading::bsdf_needs_preparation(bottom.model)));
    r.bsdf = bsdfs_->add(later ? bottom : prepared);
    r.model = bottom.model;
    r.flags |= MATERIAL_LIBRARY | (later ? MATERIAL_PREPARE : 0u) |
               (glints ? MATERIAL_GLINT : 0u);
    if (m.layers[0].bsdf->model->transmissive)
        r.flags |= MATERIAL_TRANSMISSIVE | (prepared.thin == 0u ? MATERIAL_SOLID : 0u);
    r.attenuation = prepared.thin != 0u ? glm::vec3(0)
        : shading::medium_absorption(m.attenuationColor, m.attenuationDistance);
    if (masked) r.flags |= MATERIAL_NEEDS_UV;
    if (m.sea != SeaWater::none) r.flags |= MATERIAL_SEA | MATERIAL_NEEDS_UV;
    if (m.sea == SeaWater::deep) r.flags &= ~MATERIAL_SOLID;
    r.anisotropy = 1;  // any model may ask for tangents
}

static_assert(LAYER_OPAQUE == uint32_t(LayerBlend::opaque) &&
              LAYER_ALPHA == uint32_t(LayerBlend::alpha) &&
              LAYER_ADD == uint32_t(LayerBlend::add) &&
              LAYER_SHADE == uint32_t(LayerBlend::shade));

// The instance's colour tints what comes out of the layers, so it leaves the base alone; but its
// alpha stays there, where rays look for it.
void MaterialTable::fillTextureLayers(MaterialRecord& r, const Material& m, glm::vec4 color) {
    if (m.textureLayers.empty()) return;
    r.base_color = glm::vec4(glm::vec3(m.baseColor), r.base_color.w);
    r.textures |= SLOT_LAYERS, r.flags |= MATERIAL_VERTEX_COLOR;
    r.first_texture_layer = uint32_t(textureLayers_.size());
    for (const TextureLayer& source : m.textureLayers) {
        TextureLayerRecord layer{};
        if (source.texture.texture) fillUse(layer.slot, source.texture);
        layer.has_texture = source.texture.texture ? 1u : 0u;
        layer.color = source.color, layer.blend = uint32_t(source.blend);
        layer.is_last = &source == &m.textureLayers.back() ? 1u : 0u;
        layer.tint = glm::vec3(color);
        textureLayers_.push_back(layer);
    }
}

MaterialRecord MaterialTable::recordOf(const Material& m, glm::vec4 color) {
    MaterialRecord r{};
    r.base_color = m.baseColor * color, r.emission = m.emission, r.metallic = m.metallic;
    r.specular_color = m.specularColor, r.roughness = m.roughness;
    r.sheen_color = m.sheenColor, r.sheen_roughness = m.sheenRoughness;
    r.attenuation = m.thinWalled ? glm::vec3(0)
        : shading::medium_absorption(m.attenuationColor, m.attenuationDistance);
    r.ior = m.ior, r.specular = m.specular, r.coat = m.coat, r.coat_roughness = m.coatRoughness;
    r.normal_scale = m.normalScale, r.coat_normal_scale = m.coatNormalScale;
    r.transmission = m.transmission;
    r.anisotropy = m.anisotropy, r.anisotropy_rotation = m.anisotropyRotation;
    r.iridescence = m.iridescence, r.iridescence_ior = m.iridescenceIor;
    r.iridescence_thickness_min_nm = m.iridescenceThicknessMinNm;
    r.iridescence_thickness_max_nm = m.iridescenceThicknessMaxNm;
    r.alpha_cutoff = m.alphaCutoff;
    r.flags = commonFlags(m);
    r.model = MODEL_GLTF;
    fillSlots(r, m);
    fillTextureLayers(r, m, color);
    return r;
}

size_t MaterialTable::KeyHash::operator()(const Key& key) const {
    if (key.color == glm::vec4(1)) return std::hash<const Material*>()(key.material);
    return hashBytes(&key, sizeof key);
}

void MaterialTable::fill(const Scene& scene) {
    records_.clear(), index_.clear(), owners_.clear();
    textures_.clear(), textureIndex_.clear();
    layers_.clear(), bsdfs_->all.clear(), textureLayers_.clear();
    slopes_.beginFill();
    hasSlopes_ = false;
    // Colours of vertices count where any mesh of a material has them.
    std::unordered_map<const Material*, bool> vertexColors;
    for (const auto& instance : scene.instances)
        vertexColors[&instance->surface()] |= !instance->mesh->colors.empty();
    for (const auto& instance : scene.instances) {
        const Material& m = instance->surface();
        if (!index_.try_emplace(keyOf(*instance), uint32_t(records_.size())).second) continue;
        owners_.push_back(instance->surfacePtr());
        MaterialRecord r = recordOf(m, instance->color);
        if (vertexColors[&m]) r.flags |= MATERIAL_VERTEX_COLOR | MATERIAL_NEEDS_UV;
        if (m.layers.empty()) r.flags |= gltfFlags(m);
        else fillLayers(r, m, vertexColors[&m] || m.baseColorTexture.texture ||
                                  !m.textureLayers.empty() || instance->color != glm::vec4(1));
        fillSlopes(r, m);
        hasSlopes_ |= r.model == MODEL_GLINT;
        records_.push_back(r);
    }
    slopes_.endFill();
}

}  // namespace gp::cpu
