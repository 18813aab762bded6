// Glints of a glTF material: its member extras.glitterpath.glints, which makes of the material the
// library's model `glint` with the material's own factors.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/gltf_material.h"
#include "scene/bsdf_registry.h"

namespace gp::io {

namespace {

// What glints say themselves; all else of the model comes from the material.
constexpr const char* glintMembers[] = {"density", "area",   "jitter",      "seed",
                                        "method",  "masking", "correlation"};

void set(BsdfSettings& s, const char* name, double value) {
    s.set(name, fmt::format("{:.9g}", value));
}

// A member by its parameter: within the range, which is not clamped to: a file says what it means.
void setMember(BsdfSettings& s, const Value& glints, const char* name) {
    const auto value = glints.find(name);
    if (!value) return;
    const BsdfParameterInfo& p = findBsdfParameter(*s.model, name);
    if (p.type == BsdfParameterType::choice) {
        const std::string word = value->asText();
        if (std::find(p.choices.begin(), p.choices.end(), word) == p.choices.end())
            value->fail(fmt::format("must be one of {}", fmt::join(p.choices, ", ")));
        s.set(name, word);
        return;
    }
    const double number = value->asNumber();
    if (!(number >= p.minimum && number <= p.maximum))
        value->fail(fmt::format("is {:g}, but must be {:g} to {:g}", number, p.minimum, p.maximum));
    set(s, name, number);
}

void setFromMaterial(BsdfSettings& s, const Material& m) {
    const double alpha = double(m.roughness) * double(m.roughness);
    const double strength = double(m.anisotropy) * double(m.anisotropy);
    const double least = findBsdfParameter(*s.model, "alpha_x").minimum;
    set(s, "alpha_x", std::max(alpha + (1.0 - alpha) * strength, least));
    set(s, "alpha_y", std::max(alpha, least));
    set(s, "metallic", double(m.metallic));
    set(s, "ior", std::clamp(double(m.ior), 1.0, 4.0));
    set(s, "transmission", double(m.transmission));
    set(s, "thin", m.thinWalled ? 1.0 : 0.0);
}

// Roughness squared, as all widths of glTF.
void setAlpha(BsdfSettings& s, const char* name, float roughness) {
    const double least = findBsdfParameter(*s.model, name).minimum;
    set(s, name, std::max(double(roughness) * double(roughness), least));
}

void setLayers(BsdfSettings& s, const Material& m) {
    set(s, "coat", double(m.coat));
    setAlpha(s, "coat_alpha", m.coatRoughness);
    const glm::vec3& c = m.sheenColor;
    s.set("sheen_color", fmt::format("{:.9g},{:.9g},{:.9g}", c.x, c.y, c.z));
    setAlpha(s, "sheen_alpha", m.sheenRoughness);
    set(s, "iridescence", double(m.iridescence));
    set(s, "iridescence_ior", double(m.iridescenceIor));
    set(s, "iridescence_thickness_nm", double(m.iridescenceThicknessMaxNm));
}

}  // namespace

void Materials::readGlints(const Value& value, Material& m) {
    const auto extras = value.find("extras");
    if (!extras || !extras->isObject()) return;  // other programs' extras may be anything
    const auto ours = extras->find("glitterpath");
    if (!ours) return;
    const auto glints = ours->find("glints");
    if (!glints) return;
    for (const std::string& key : glints->keys()) {
        if (std::find(std::begin(glintMembers), std::end(glintMembers), key) ==
            std::end(glintMembers))
            glints->fail(fmt::format("'{}' is none of {}", key.substr(0, 40),
                                     fmt::join(glintMembers, ", ")));
    }
    (*glints)["density"];  // there is none that would suit any size of texture coordinates
    BsdfSettings s(findBsdfModel("glint"));
    setFromMaterial(s, m);
    setLayers(s, m);
    for (const char* name : glintMembers) setMember(s, *glints, name);
    if (m.specular != 1 || m.specularColor != glm::vec3(1))
        m_document.warn(glints->where() + ": the material's specular is left out");
    MaterialLayer layer;
    layer.bsdf = std::make_shared<const BsdfSettings>(std::move(s));
    m.layers = {layer};
}

}  // namespace gp::io
