#include "io/gltf_material.h"

#include <cmath>

namespace gp::io {

namespace {

// uv' = T * R * S * uv; positive angles turn counter-clockwise as seen with v growing downwards.
// [KHR_texture_transform; the sign of the angle as in issue 1563 of the specification]
glm::mat3x2 uvTransform(const Value& t) {
    const glm::vec2 offset = t.vec<2>("offset", {0, 0}), scale = t.vec<2>("scale", {1, 1});
    const float angle = t.real("rotation", 0), c = std::cos(angle), s = std::sin(angle);
    return {glm::vec2(c, -s) * scale.x, glm::vec2(s, c) * scale.y, offset};
}

}  // namespace

// Notes what the material needs; false where it has no such texture.
bool Materials::use(const Value& value, const char* key, ColorSpace space, TextureUse& target) {
    const auto info = value.find(key);
    if (!info) return false;
    uint64_t set = info->count("texCoord", 0);
    if (const auto transform = info->extension("KHR_texture_transform")) {
        target.uvTransform = uvTransform(*transform);
        set = transform->count("texCoord", set);
    }
    if (set > 1) {
        m_document.warn(info->where() + ": TEXCOORD_" + std::to_string(set) +
                        " is not supported; TEXCOORD_0 is used");
        set = 0;
    }
    target.texCoord = static_cast<uint32_t>(set);
    const Value texture =
        m_document.element("textures", (*info)["index"].asIndexInto("textures"));
    const auto image = texture.index("source", "images");
    if (!image) {
        m_document.warn(texture.where() + ": has no image of a kind that can be read; left out");
        return false;
    }
    const auto sampler = texture.index("sampler", "samplers");
    m_wanted[Key(*image, sampler ? int64_t(*sampler) : -1, space)].push_back(&target);
    return true;
}

void Materials::readBase(const Value& value, Material& m) {
    static const nlohmann::json none = nlohmann::json::object();
    const Value pbr = value.find("pbrMetallicRoughness")
                          .value_or(Value(m_document.json(), none, value.where()));
    m.baseColor = pbr.vec<4>("baseColorFactor", glm::vec4(1));
    m.metallic = pbr.factor("metallicFactor", 1);
    m.roughness = pbr.factor("roughnessFactor", 1);
    use(pbr, "baseColorTexture", ColorSpace::srgb, m.baseColorTexture);
    use(pbr, "metallicRoughnessTexture", ColorSpace::linear, m.metallicRoughnessTexture);

    if (use(value, "normalTexture", ColorSpace::linear, m.normalTexture))
        m.normalScale = value["normalTexture"].real("scale", 1);
    m.emission = value.vec<3>("emissiveFactor", glm::vec3(0));
    if (const auto e = value.extension("KHR_materials_emissive_strength"))
        m.emission *= std::max(e->real("emissiveStrength", 1), 0.0f);
    use(value, "emissiveTexture", ColorSpace::srgb, m.emissionTexture);

    const std::string mode = value.text("alphaMode", "OPAQUE");
    if (mode == "MASK") m.alphaMode = AlphaMode::mask;
    else if (mode == "BLEND") m.alphaMode = AlphaMode::blend;
    else if (mode != "OPAQUE") value.fail("unknown alphaMode '" + mode.substr(0, 20) + "'");
    m.alphaCutoff = value.real("alphaCutoff", 0.5f);
    m.doubleSided = value.flag("doubleSided", false);
    m.unlit = value.extension("KHR_materials_unlit").has_value();
}

void Materials::readCoats(const Value& value, Material& m) {
    if (const auto e = value.extension("KHR_materials_specular")) {
        m.specular = e->factor("specularFactor", 1);
        m.specularColor = e->vec<3>("specularColorFactor", glm::vec3(1));
        use(*e, "specularTexture", ColorSpace::linear, m.specularTexture);
        use(*e, "specularColorTexture", ColorSpace::srgb, m.specularColorTexture);
    }
    if (const auto e = value.extension("KHR_materials_clearcoat")) {
        m.coat = e->factor("clearcoatFactor", 0);
        m.coatRoughness = e->factor("clearcoatRoughnessFactor", 0);
        use(*e, "clearcoatTexture", ColorSpace::linear, m.coatTexture);
        use(*e, "clearcoatRoughnessTexture", ColorSpace::linear, m.coatRoughnessTexture);
        if (use(*e, "clearcoatNormalTexture", ColorSpace::linear, m.coatNormalTexture))
            m.coatNormalScale = (*e)["clearcoatNormalTexture"].real("scale", 1);
    }
    if (const auto e = value.extension("KHR_materials_sheen")) {
        m.sheenColor = e->vec<3>("sheenColorFactor", glm::vec3(0));
        m.sheenRoughness = e->factor("sheenRoughnessFactor", 0);
        use(*e, "sheenColorTexture", ColorSpace::srgb, m.sheenColorTexture);
        use(*e, "sheenRoughnessTexture", ColorSpace::linear, m.sheenRoughnessTexture);
    }
    if (const auto e = value.extension("KHR_materials_iridescence")) {
        m.iridescence = e->factor("iridescenceFactor", 0);
        m.iridescenceIor = std::max(e->real("iridescenceIor", 1.3f), 1.0f);
        m.iridescenceThicknessMinNm = std::max(e->real("iridescenceThicknessMinimum", 100), 0.0f);
        m.iridescenceThicknessMaxNm = std::max(e->real("iridescenceThicknessMaximum", 400), 0.0f);
        use(*e, "iridescenceTexture", ColorSpace::linear, m.iridescenceTexture);
        use(*e, "iridescenceThicknessTexture", ColorSpace::linear, m.iridescenceThicknessTexture);
    }
}

// What light meets below the surface, and the direction of its grooves.
void Materials::readInside(const Value& value, Material& m) {
    if (const auto e = value.extension("KHR_materials_ior")) {
        m.ior = e->real("ior", 1.5f);
        if (m.ior != 0) m.ior = std::max(m.ior, 1.0f);  // 0: reflects everything (specified)
    }
    if (const auto e = value.extension("KHR_materials_transmission")) {
        m.transmission = e->factor("transmissionFactor", 0);
        use(*e, "transmissionTexture", ColorSpace::linear, m.transmissionTexture);
    }
    if (const auto e = value.extension("KHR_materials_volume")) {
        // The thickness is a hint for rasterisers; rays find the other side themselves.
        m.thinWalled = !(e->real("thicknessFactor", 0) > 0);
        m.attenuationColor = e->vec<3>("attenuationColor", glm::vec3(1));
        const float distance = e->real("attenuationDistance", 0);
        if (distance > 0) m.attenuationDistance = distance;
    }
    if (const auto e = value.extension("KHR_materials_anisotropy")) {
        m.anisotropy = e->factor("anisotropyStrength", 0);
        m.anisotropyRotation = e->real("anisotropyRotation", 0);
        use(*e, "anisotropyTexture", ColorSpace::linear, m.anisotropyTexture);
    }
}

// Tangents follow the normal map's coordinates; anisotropy and the coat ask only where the
// material has no normal map. [KHR_materials_anisotropy: "the tangent of the normal texture"]
Materials::Entry Materials::read(const Value& value) {
    Entry e;
    e.material = std::make_shared<Material>();
    Material& m = *e.material;
    m.name = value.text("name", "");
    readBase(value, m);
    readCoats(value, m);
    readInside(value, m);
    readGlints(value, m);
    readSlopeMaps(value, m);
    const auto coat = value.extension("KHR_materials_clearcoat");
    const auto aniso = value.extension("KHR_materials_anisotropy");
    const bool byNormal = value.has("normalTexture");
    const bool byAniso = !byNormal && aniso && aniso->has("anisotropyTexture");
    const bool byCoat = coat && coat->has("clearcoatNormalTexture");
    e.options.needsTangents = byNormal || byAniso || byCoat || m.anisotropy > 0;
    const TextureUse& leader = byNormal  ? m.normalTexture
                               : byAniso ? m.anisotropyTexture
                                         : m.coatNormalTexture;
    e.options.tangentUv = leader.texCoord;
    e.options.uvTransform = leader.uvTransform;
    if (e.options.needsTangents) return e;
    // Slope maps turn with their transforms by themselves; heights ask for no tangents.
    for (const SlopeMapUse& map : m.slopeMaps)
        if (map.kind == SlopeMapKind::normal) {
            e.options.needsTangents = true, e.options.tangentUv = map.texture.texCoord;
            break;
        }
    return e;
}

Materials::Entry& Materials::entry(std::optional<uint32_t> index) {
    const int64_t key = index ? int64_t(*index) : -1;
    const auto found = m_entries.find(key);
    if (found != m_entries.end()) return found->second;
    Entry e;
    if (index) {
        e = read(m_document.element("materials", *index));
        if (e.material->name.empty()) e.material->name = "material " + std::to_string(*index);
    } else {
        e.material = std::make_shared<Material>();
        e.material->name = "default";
        e.material->metallic = 1;  // glTF 2.0, 3.9.2; ours is 0
    }
    return m_entries.emplace(key, std::move(e)).first->second;
}

std::shared_ptr<const Material> Materials::get(std::optional<uint32_t> index) {
    return entry(index).material;
}

MeshOptions Materials::meshOptions(std::optional<uint32_t> index) { return entry(index).options; }

}  // namespace gp::io
