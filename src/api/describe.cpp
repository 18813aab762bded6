#include "api/describe.h"

#include <unordered_map>

#include <nlohmann/json.hpp>

#include "scene/bsdf_registry.h"
#include "scene/environment_table.h"
#include "scene/measured_brdf.h"

namespace gp::api {

namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); }
Json jsonOf(const glm::vec4& v) { return Json::array({v.x, v.y, v.z, v.w}); }

const char* nameOf(LightKind kind) {
    constexpr const char* names[] = {"directional", "sphere", "spot", "rectangle", "polygon"};
    return names[size_t(kind)];
}
const char* nameOf(MeshKind kind) {
    constexpr const char* names[] = {"static", "movable", "dynamic"};
    return names[size_t(kind)];
}
const char* nameOf(LayerBlend blend) {
    constexpr const char* names[] = {"opaque", "alpha", "add", "shade"};
    return names[size_t(blend)];
}
const char* nameOf(AlphaMode mode) {
    constexpr const char* names[] = {"opaque", "mask", "blend"};
    return names[size_t(mode)];
}

// Gives each shared object a number, in the order of first appearance.
template <class T>
class Numbering {
public:
    size_t of(const T* object) {
        const auto [entry, isNew] = numbers_.try_emplace(object, order_.size());
        if (isNew) order_.push_back(object);
        return entry->second;
    }
    const std::vector<const T*>& order() const { return order_; }

private:
    std::unordered_map<const T*, size_t> numbers_;
    std::vector<const T*> order_;
};

// A model of the library and what is blended over it, with the parameters that differ from the
// model's defaults.
Json jsonOf(const MaterialLayer& layer, Numbering<Texture>& textures) {
    Json parameters = Json::object();
    const BsdfSettings& settings = *layer.bsdf;
    for (size_t i = 0; i < settings.values.size(); ++i) {
        const BsdfParameterInfo& p = settings.model->parameters[i];
        if (settings.values[i] != p.initial)
            parameters[p.name] = bsdfValueText(p, settings.values[i]);
    }
    Json j = {{"model", settings.model->name}, {"parameters", parameters}};
    if (settings.measured) j["file"] = settings.measured->name;
    if (layer.weight != 1) j["weight"] = layer.weight;
    if (layer.mask.texture) {
        j["mask"] = textures.of(layer.mask.texture.get());
        j["maskChannel"] = layer.channel;
    }
    return j;
}

Json jsonOf(const SlopeMapUse& map) {
    constexpr const char* kinds[] = {"normal", "height", "displacement"};
    Json j = {{"kind", kinds[size_t(map.kind)]}, {"scale", map.scale}};
    if (map.kind == SlopeMapKind::displacement)
        j["extent"] = Json::array({map.extent.x, map.extent.y});
    return j;
}

Json jsonOf(const Material& m, Numbering<Texture>& textures) {
    if (!m.frames.empty()) {  // an animated one: what shows, and which of how many that is
        Json j = jsonOf(m.shown(), textures);
        j["frame"] = m.frame;
        j["frames"] = m.frames.size();
        return j;
    }
    Json j = {{"name", m.name},
              {"baseColor", jsonOf(m.baseColor)},
              {"metallic", m.metallic},
              {"roughness", m.roughness},
              {"emission", jsonOf(m.emission)},
              {"alphaMode", nameOf(m.alphaMode)},
              {"ior", m.ior}};
    for (const MaterialLayer& layer : m.layers) j["layers"].push_back(jsonOf(layer, textures));
    for (const TextureLayer& layer : m.textureLayers)
        j["textureLayers"].push_back(
            {{"color", jsonOf(layer.color)}, {"blend", nameOf(layer.blend)}});
    for (const SlopeMapUse& map : m.slopeMaps) j["slopeMaps"].push_back(jsonOf(map));
    if (m.alphaMode == AlphaMode::mask) j["alphaCutoff"] = m.alphaCutoff;
    if (m.doubleSided) j["doubleSided"] = true;
    if (m.unlit) j["unlit"] = true;
    if (m.specular != 1) j["specular"] = m.specular;
    if (m.specularColor != glm::vec3(1)) j["specularColor"] = jsonOf(m.specularColor);
    if (m.coat > 0) j["coat"] = {{"strength", m.coat}, {"roughness", m.coatRoughness}};
    if (m.sheenColor != glm::vec3(0))
        j["sheen"] = {{"color", jsonOf(m.sheenColor)}, {"roughness", m.sheenRoughness}};
    if (m.transmission > 0) {
        j["transmission"] = {{"strength", m.transmission}, {"solid", !m.thinWalled}};
        if (std::isfinite(m.attenuationDistance))
            j["attenuation"] = {{"color", jsonOf(m.attenuationColor)},
                                {"distance", m.attenuationDistance}};
    }
    if (m.anisotropy > 0)
        j["anisotropy"] = {{"strength", m.anisotropy}, {"rotation", m.anisotropyRotation}};
    if (m.iridescence > 0)
        j["iridescence"] = {{"strength", m.iridescence},
                            {"ior", m.iridescenceIor},
                            {"thicknessNm", Json::array({m.iridescenceThicknessMinNm,
                                                         m.iridescenceThicknessMaxNm})}};
    Json used = Json::object();
    forEachTexture(m, [&](const char* name, const TextureUse& use) {
        if (use.texture) used[name] = textures.of(use.texture.get());
    });
    if (!used.empty()) j["textures"] = used;
    return j;
}

Json jsonOf(const Texture& t) {
    return {{"name", t.name},
            {"width", t.levels.empty() ? 0 : t.levels[0].width},
            {"height", t.levels.empty() ? 0 : t.levels[0].height},
            {"levels", t.levels.size()},
            {"format", t.format == PixelFormat::rgba8 ? "rgba8" : "rgba32f"},
            {"colorSpace", t.colorSpace == ColorSpace::srgb ? "sRGB" : "linear"},
            {"bytes", t.pixels.size()}};
}

Json jsonOf(const Mesh& m, Numbering<Material>& materials) {
    return {{"name", m.name},
            {"id", m.id},
            {"kind", nameOf(m.kind)},
            {"vertices", m.vertexCount()},
            {"triangles", m.triangles.size()},
            {"revision", m.revision},
            {"material", materials.of(m.material.get())}};
}

Json jsonOf(const Instance& i, Numbering<Mesh>& meshes, Numbering<Material>& materials) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) rows.push_back(i.worldFromObject[column][row]);
    Json j = {{"name", i.name}, {"id", i.id}, {"mesh", meshes.of(i.mesh.get())}};
    if (i.material) j["material"] = materials.of(i.material.get());
    j["worldFromObject"] = rows;
    j["visibility"] = i.visibility;
    if (i.color != glm::vec4(1)) j["color"] = jsonOf(i.color);
    return j;
}

Json jsonOf(const Light& l) {
    Json j = {{"name", l.name},
              {"id", l.id},
              {"kind", nameOf(l.kind)},
              {"emission", jsonOf(l.emission)}};
    const bool polygon = l.kind == LightKind::polygon;
    if (l.kind != LightKind::directional && !polygon) j["position"] = jsonOf(l.position);
    if (l.kind == LightKind::directional || l.kind == LightKind::spot)
        j["direction"] = jsonOf(l.direction);
    if (l.kind == LightKind::directional) j["angularRadius"] = l.angularRadius;
    if (l.kind == LightKind::sphere || l.kind == LightKind::spot) j["radius"] = l.radius;
    if (l.kind == LightKind::spot) {
        j["innerAngle"] = std::acos(l.cosInner);
        j["outerAngle"] = std::acos(l.cosOuter);
    }
    if (l.kind == LightKind::rectangle) {
        j["edgeU"] = jsonOf(l.edgeU);
        j["edgeV"] = jsonOf(l.edgeV);
    }
    for (const glm::vec3& corner : l.corners) j["corners"].push_back(jsonOf(corner));
    if (polygon || l.kind == LightKind::rectangle) j["twoSided"] = l.twoSided;
    if (!l.visible) j["visible"] = false;
    return j;
}

Json jsonOf(const Camera& c) {
    const bool perspective = c.kind == CameraKind::perspective;
    Json j = {{"name", c.name},
              {"kind", perspective ? "perspective" : "orthographic"},
              {"position", jsonOf(c.position)},
              {"target", jsonOf(c.target)},
              {"up", jsonOf(c.up)}};
    if (perspective)
        j["verticalFov"] = c.verticalFov;
    else
        j["orthographicHeight"] = c.orthographicHeight;
    if (c.apertureRadius > 0) {
        j["apertureRadius"] = c.apertureRadius;
        j["focusDistance"] = c.focusDistance;
    }
    return j;
}

Json jsonOf(const Environment& e) {
    if (!e.table && e.color == glm::vec3(0)) return nullptr;
    Json j = {{"color", jsonOf(e.color)}, {"rotation", e.rotation}};
    if (e.table) {
        j["width"] = e.table->width;
        j["height"] = e.table->height;
    }
    return j;
}

}  // namespace

std::string describeScene(const Scene& scene) {
    Numbering<Mesh> meshes;
    Numbering<Material> materials;
    Numbering<Texture> textures;
    Json instances = Json::array(), meshList = Json::array(), materialList = Json::array(),
         textureList = Json::array(), lights = Json::array(), cameras = Json::array();
    for (const auto& instance : scene.instances)
        instances.push_back(jsonOf(*instance, meshes, materials));
    // In this order, because each list numbers what the next one shows.
    for (const Mesh* mesh : meshes.order()) meshList.push_back(jsonOf(*mesh, materials));
    for (const Material* m : materials.order()) materialList.push_back(jsonOf(*m, textures));
    for (const Texture* texture : textures.order()) textureList.push_back(jsonOf(*texture));
    for (const auto& light : scene.lights) lights.push_back(jsonOf(*light));
    for (const Camera& camera : scene.cameras) cameras.push_back(jsonOf(camera));
    const Json all = {{"sources", scene.sources},     {"instances", instances},
                      {"meshes", meshList},           {"materials", materialList},
                      {"textures", textureList},      {"lights", lights},
                      {"environment", jsonOf(scene.environment)},
                      {"cameras", cameras},           {"animations", scene.animations},
                      {"warnings", scene.warnings}};
    // Names come from files and may not be UTF-8: such bytes are replaced.
    return all.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gp::api
