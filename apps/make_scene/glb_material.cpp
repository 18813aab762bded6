// Materials as glTF writes them: the core values and one JSON object an extension.
#include "glb.h"

#include <algorithm>

namespace gp::make_scene {
namespace {

using nlohmann::json;

json toJson(glm::vec3 v) { return json::array({v.x, v.y, v.z}); }

}  // namespace

json GlbBuilder::textureInfo(int texture) const { return {{"index", texture}}; }

json GlbBuilder::materialExtensions(const Material& m)
{
    json list = json::object();
    const auto put = [&](const char* name, json value) {
        use(name);
        list[name] = std::move(value);
    };
    if (const float peak = glm::max(m.emission.x, glm::max(m.emission.y, m.emission.z)); peak > 1)
        put("KHR_materials_emissive_strength", {{"emissiveStrength", peak}});
    if (m.clearcoat > 0)
        put("KHR_materials_clearcoat", {{"clearcoatFactor", m.clearcoat},
                                        {"clearcoatRoughnessFactor", m.clearcoatRoughness}});
    if (m.sheenColor != glm::vec3(0.0f))
        put("KHR_materials_sheen", {{"sheenColorFactor", toJson(m.sheenColor)},
                                    {"sheenRoughnessFactor", m.sheenRoughness}});
    if (m.transmission > 0)
        put("KHR_materials_transmission", {{"transmissionFactor", m.transmission}});
    if (m.thickness > 0) {
        json volume = {{"thicknessFactor", m.thickness}};
        if (m.attenuationDistance > 0) {
            volume["attenuationDistance"] = m.attenuationDistance;
            volume["attenuationColor"] = toJson(m.attenuationColor);
        }
        put("KHR_materials_volume", volume);
    }
    if (m.ior != 1.5f)
        put("KHR_materials_ior", {{"ior", m.ior}});
    if (m.specular != 1.0f)
        put("KHR_materials_specular", {{"specularFactor", m.specular}});
    if (m.anisotropy > 0)
        put("KHR_materials_anisotropy", {{"anisotropyStrength", m.anisotropy},
                                         {"anisotropyRotation", m.anisotropyRotation}});
    if (m.iridescence > 0) {
        json film = {{"iridescenceFactor", m.iridescence},
                     {"iridescenceIor", m.iridescenceIor},
                     {"iridescenceThicknessMinimum", m.filmThicknessMinNm},
                     {"iridescenceThicknessMaximum", m.filmThicknessMaxNm}};
        if (m.filmThicknessTexture >= 0)
            film["iridescenceThicknessTexture"] = textureInfo(m.filmThicknessTexture);
        put("KHR_materials_iridescence", film);
    }
    return list;
}

int GlbBuilder::addMaterial(const Material& m)
{
    json core = {{"baseColorFactor", {m.color.x, m.color.y, m.color.z, m.alpha}},
                 {"metallicFactor", m.metallic},
                 {"roughnessFactor", m.roughness}};
    if (m.colorTexture >= 0)
        core["baseColorTexture"] = textureInfo(m.colorTexture);
    if (m.metallicRoughnessTexture >= 0)
        core["metallicRoughnessTexture"] = textureInfo(m.metallicRoughnessTexture);
    json out = {{"name", m.name}, {"pbrMetallicRoughness", core}};
    if (m.normalTexture >= 0) {
        out["normalTexture"] = textureInfo(m.normalTexture);
        out["normalTexture"]["scale"] = m.normalScale;
    }
    if (m.emission != glm::vec3(0.0f)) {
        // emissiveFactor ends at 1; what lies above goes into the strength of the extension
        const float peak = glm::max(m.emission.x, glm::max(m.emission.y, m.emission.z));
        out["emissiveFactor"] = toJson(m.emission / std::max(1.0f, peak));
    }
    if (m.emissionTexture >= 0)
        out["emissiveTexture"] = textureInfo(m.emissionTexture);
    if (std::string(m.alphaMode) != "OPAQUE")
        out["alphaMode"] = m.alphaMode;
    if (m.doubleSided)
        out["doubleSided"] = true;
    if (json extensions = materialExtensions(m); !extensions.empty())
        out["extensions"] = std::move(extensions);
    m_gltf["materials"].push_back(std::move(out));
    return static_cast<int>(m_gltf["materials"].size()) - 1;
}

}  // namespace gp::make_scene
