#include "scene/kept_maps.h"

#include <algorithm>

#include "scene/bsdf_registry.h"

namespace gp {
namespace {

bool has(const TextureUse& use) { return use.texture != nullptr; }

uint32_t mapsOf(const Material& m) {
    uint32_t maps = 0;
    const auto note = [&](bool isThere, uint32_t map) { maps |= isThere ? map : 0u; };
    note(true, mapBaseColor);
    note(has(m.normalTexture), mapNormal);
    note(!m.slopeMaps.empty(), mapSlopes);
    note(m.alphaMode != AlphaMode::opaque, mapAlpha);
    note(m.emission != glm::vec3(0), mapEmission);
    const bool metalOrRough = has(m.metallicRoughnessTexture) && m.layers.empty();
    note(metalOrRough && m.roughness > 0, mapRoughness);
    note(metalOrRough && m.metallic > 0, mapMetallic);
    for (const TextureUse* use :
         {&m.specularTexture, &m.specularColorTexture, &m.coatTexture, &m.coatRoughnessTexture,
          &m.coatNormalTexture, &m.sheenColorTexture, &m.sheenRoughnessTexture,
          &m.transmissionTexture, &m.anisotropyTexture, &m.iridescenceTexture,
          &m.iridescenceThicknessTexture})
        note(has(*use), mapOthers);
    for (const MaterialLayer& layer : m.layers) note(has(layer.mask), mapOthers);
    return maps;
}

const BsdfParameterInfo* parameter(const BsdfModelInfo& model, const char* name) {
    const auto found = std::find_if(model.parameters.begin(), model.parameters.end(),
                                    [&](const BsdfParameterInfo& p) { return p.name == name; });
    return found == model.parameters.end() ? nullptr : &*found;
}

void setNumber(BsdfSettings& s, const BsdfParameterInfo& p, float value) {
    s.values[size_t(&p - s.model->parameters.data())] =
        glm::vec3(std::clamp(value, p.minimum, p.maximum));
}

// One set of parameters, for roughness 0, with a second one over it, for roughness 1 of the
// texture, which is the mask: what lies in between is linear in roughness, or in its square.
bool roughnessInLayers(Material& m, const Material& old) {
    if (m.layers.size() != 1) return false;
    const BsdfModelInfo& model = *m.layers[0].bsdf->model;
    // The width of counted facets is prepared once for a material, not at its points.
    if (model.name == "glint") return false;
    const BsdfParameterInfo* const roughness = parameter(model, "roughness");
    const BsdfParameterInfo* const alphas[] = {parameter(model, "alpha_x"),
                                               parameter(model, "alpha_y")};
    const bool isDisneys = roughness && roughness->minimum == 0 && roughness->maximum == 1;
    if (!isDisneys && !(alphas[0] && alphas[1])) return false;
    auto smooth = std::make_shared<BsdfSettings>(*m.layers[0].bsdf);
    auto rough = std::make_shared<BsdfSettings>(*m.layers[0].bsdf);
    if (isDisneys) {
        setNumber(*smooth, *roughness, 0);
        setNumber(*rough, *roughness, old.roughness);
    } else {
        for (const BsdfParameterInfo* alpha : alphas) {
            setNumber(*smooth, *alpha, 0);
            setNumber(*rough, *alpha, old.roughness * old.roughness);
        }
    }
    m.layers[0].bsdf = std::move(smooth);
    MaterialLayer over;
    over.bsdf = std::move(rough);
    over.mask = old.metallicRoughnessTexture;
    over.channel = 1;
    over.squared = !isDisneys;
    m.layers.push_back(std::move(over));
    return true;
}

// Of glTF's own material roughness and metal share a texture.
uint32_t keepMetalAndRoughness(Material& m, const Material& old, uint32_t maps) {
    if (maps == 0) return 0;
    if (!m.layers.empty())
        return (maps & mapRoughness) && roughnessInLayers(m, old) ? mapRoughness : 0u;
    if (has(m.metallicRoughnessTexture)) return 0;
    m.metallicRoughnessTexture = old.metallicRoughnessTexture;
    if (maps & mapRoughness) m.roughness = old.roughness;
    if (maps & mapMetallic) m.metallic = old.metallic;
    return maps;
}

// What a model has for its own base colour would tint that of the file.
bool keepBaseColor(Material& m, const Material& old) {
    const bool reads = m.layers.empty() || m.layers[0].bsdf->model->hasBaseColor();
    if (!reads || has(m.baseColorTexture) || !m.textureLayers.empty()) return false;
    for (MaterialLayer& layer : m.layers) {
        auto white = std::make_shared<BsdfSettings>(*layer.bsdf);
        setNumber(*white, *parameter(*white->model, "base_color"), 1);
        layer.bsdf = std::move(white);
    }
    m.baseColorTexture = old.baseColorTexture;
    m.baseColor *= glm::vec4(glm::vec3(old.baseColor), 1.0f);
    m.textureLayers = old.textureLayers;
    return true;
}

// Alpha is that of the base colour, so its texture comes along; under a layer that hides its
// colour where that is not kept.
bool keepAlpha(Material& m, const Material& old, bool colorKept) {
    if (m.alphaMode != AlphaMode::opaque) return false;
    const bool another = !colorKept && (has(m.baseColorTexture) || !m.textureLayers.empty());
    if (another && has(old.baseColorTexture)) return false;
    if (!colorKept && has(old.baseColorTexture)) {
        m.baseColorTexture = old.baseColorTexture;
        TextureLayer hides;
        hides.color = glm::vec4(glm::vec3(m.baseColor), 1.0f);
        m.textureLayers.push_back(hides);
    }
    m.baseColor.w = old.baseColor.w;
    m.alphaMode = old.alphaMode;
    m.alphaCutoff = old.alphaCutoff;
    return true;
}

bool keepNormal(Material& m, const Material& old) {
    if (has(m.normalTexture)) return false;
    m.normalTexture = old.normalTexture;
    m.normalScale = old.normalScale;
    return true;
}

bool keepSlopes(Material& m, const Material& old) {
    if (!m.slopeMaps.empty()) return false;
    m.slopeMaps = old.slopeMaps;
    return true;
}

bool keepEmission(Material& m, const Material& old) {
    if (m.emission != glm::vec3(0)) return false;
    m.emission = old.emission;
    m.emissionTexture = old.emissionTexture;
    m.doubleSided = old.doubleSided;
    return true;
}

}  // namespace

MaterialWithMaps withMapsOf(const Material& old, const Material& replacement, uint32_t keep) {
    MaterialWithMaps result{replacement, 0, 0};
    Material& m = result.material;
    m.name = old.name;
    const uint32_t maps = mapsOf(old);
    const uint32_t wanted = maps & keep;
    const auto kept = [&](uint32_t map, bool isKept) { result.kept |= isKept ? map : 0u; };
    if (wanted & mapBaseColor) kept(mapBaseColor, keepBaseColor(m, old));
    if (wanted & mapAlpha) kept(mapAlpha, keepAlpha(m, old, result.kept & mapBaseColor));
    if (wanted & mapNormal) kept(mapNormal, keepNormal(m, old));
    if (wanted & mapSlopes) kept(mapSlopes, keepSlopes(m, old));
    if (wanted & mapEmission) kept(mapEmission, keepEmission(m, old));
    result.kept |= keepMetalAndRoughness(m, old, wanted & (mapRoughness | mapMetallic));
    result.left = maps & ~result.kept;
    return result;
}

}  // namespace gp
