// Every model of models.def with several sets of parameters: what the tests of reflectance walk
// over. The renderer's own models are walked through their widths; a model of the library through
// the rows of bsdf_library_cases.h, and its defaults without any.
#pragma once

#include <cmath>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "shading/shading.h"
#include "scene/bsdf_settings.h"
#include "statistics/bsdf_library_cases.h"
#include "statistics/measured_example.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;

struct ModelRow {
    uint number;
    const char* name;
    uint flags;
    bool library;
};

const ModelRow modelRows[] = {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    {number, #name, flags, false},
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    {number, #name, flags, true},
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
};

struct BsdfCase {
    std::string name;
    BsdfParams params;
    uint flags = 0;
    bool white = true;   // energy is tested with a base_color of 1
    bool solid = false;  // wo below the surface is inside of another medium
    bool transmits() const {
        const bool maybe = params.model == MODEL_GLTF || params.model == MODEL_GLINT;
        return (flags & BSDF_TRANSMISSIVE) != 0u && (!maybe || params.transmission > 0.0f);
    }
    bool isTilted() const {
        return params.model == MODEL_GLINT && glint_mean(params) != vec2(0.0f);
    }
    // Signed cosine of w with the plane that has an inside and an outside, per horizontal area.
    float sideOf(vec3 w) const {
        return isTilted() ? slope_facing(glint_mean(params), w) : w.z;
    }
    // Planes at which a density can jump, beside the horizon: that of a coat, of the mean slope.
    std::vector<dvec3> edges() const {
        std::vector<dvec3> normals;
        if (params.coat > 0.0f) normals.push_back(dvec3(params.coat_normal));
        if (isTilted()) normals.push_back(normalize(dvec3(mesosurface_normal(glint_mean(params)))));
        return normals;
    }
    // The medium's index on the side of w.
    float iorAt(vec3 w) const {
        return solid && sideOf(w) < 0.0f ? relative_ior(params.ior, 1.0f) : 1.0f;
    }
};

// For gtest, which would print the bytes.
inline void PrintTo(const BsdfCase& c, std::ostream* out) { *out << c.name; }

class CaseList {
public:
    BsdfCase& add(const ModelRow& row, const std::string& name, float alphaX, float alphaY) {
        BsdfCase c;
        c.name = fmt::format("{}_{}", row.name, name);
        c.flags = row.flags;
        c.params = bsdf_params_of(row.number);
        c.params.base_color = vec3(0.8f, 0.5f, 0.3f);
        c.params.alpha_x = alphaX;
        c.params.alpha_y = alphaY;
        c.params.sheen_color = vec3(row.number == MODEL_SHEEN ? 0.9f : 0.0f);
        c.params.sheen_alpha = alphaX;
        c.solid = row.number == MODEL_GGX_DIELECTRIC;
        cases_.push_back(c);
        return cases_.back();
    }
    // `words` as in bsdf_library_cases.h.
    BsdfCase& add(const ModelRow& row, const std::string& name, const std::string& words) {
        BsdfSettings settings(findBsdfModel(row.name));
        // Three channels that differ tell when two are mixed up.
        for (const BsdfParameterInfo& p : settings.model->parameters) {
            if (p.name == "base_color") settings.set("base_color", "0.8,0.5,0.3");
        }
        if (row.number == MODEL_MEASURED) settings.measured = measuredExample();
        std::istringstream stream(words);
        for (std::string word; stream >> word;) {
            const std::size_t sign = word.find('=');
            settings.set(word.substr(0, sign), word.substr(sign + 1));
        }
        BsdfCase c;
        c.name = fmt::format("{}_{}", row.name, name);
        c.flags = row.flags;
        // Where the model does not conserve energy as such, the case does with its own colors.
        c.white = (row.flags & BSDF_CONSERVING) != 0u;
        c.params = bsdfParamsFrom(settings);
        c.solid = (row.number == MODEL_DISNEY_BSDF || row.number == MODEL_GLINT)
               && c.params.thin == 0u;
        cases_.push_back(c);
        return cases_.back();
    }
    std::vector<BsdfCase> take() { return std::move(cases_); }

private:
    std::vector<BsdfCase> cases_;
};

inline void addGltfLayerCases(CaseList& list, const ModelRow& row) {
    list.add(row, "metal", 0.15f, 0.15f).params.metallic = 1.0f;
    list.add(row, "half_metal", 0.3f, 0.1f).params.metallic = 0.5f;
    BsdfParams* m = &list.add(row, "coat", 0.5f, 0.5f).params;
    m->coat = 1.0f;
    m->coat_alpha = 0.05f;
    BsdfCase* tilted = &list.add(row, "tilted_coat", 0.5f, 0.5f);
    tilted->params.coat = 0.8f;
    tilted->params.coat_alpha = 0.2f;
    tilted->params.coat_normal = normalize(vec3(0.3f, -0.1f, 1.0f));
    tilted->flags &= ~BSDF_RECIPROCAL;  // no shading normal of another direction is
    m = &list.add(row, "sheen", 0.4f, 0.4f).params;
    m->sheen_color = vec3(0.9f, 0.4f, 0.7f);
    m->sheen_alpha = 0.25f;
    m = &list.add(row, "coat_and_sheen_on_metal", 0.2f, 0.2f).params;
    m->metallic = 1.0f;
    m->coat = 0.7f;
    m->coat_alpha = 0.1f;
    m->sheen_color = vec3(0.5f);
    m->sheen_alpha = 0.6f;
    m = &list.add(row, "film", 0.25f, 0.25f).params;
    m->iridescence = 1.0f;
    m = &list.add(row, "film_on_metal", 0.25f, 0.25f).params;
    m->iridescence = 0.8f;
    m->metallic = 1.0f;
    m = &list.add(row, "specular_colour", 0.3f, 0.3f).params;
    m->specular = 0.7f;
    m->specular_color = vec3(2.0f, 1.0f, 0.3f);
    list.add(row, "no_specular", 0.5f, 0.5f).params.specular = 0.0f;
    list.add(row, "infinite_ior", 0.5f, 0.5f).params.ior = 0.0f;
}

inline void addGltfTransmissionCases(CaseList& list, const ModelRow& row) {
    for (const float alpha : {0.05f, 0.4f}) {
        list.add(row, fmt::format("thin_{:g}", alpha), alpha, alpha).params.transmission = 1.0f;
        BsdfCase& solid = list.add(row, fmt::format("solid_{:g}", alpha), alpha, alpha);
        solid.solid = true;
        solid.params.transmission = 1.0f;
        solid.params.thin = 0u;
    }
    BsdfCase& mixed = list.add(row, "solid_with_all_layers", 0.3f, 0.15f);
    mixed.solid = true;
    mixed.params.transmission = 0.6f;
    mixed.params.thin = 0u;
    mixed.params.metallic = 0.2f;
    mixed.params.coat = 0.6f;
    mixed.params.coat_alpha = 0.1f;
    mixed.params.sheen_color = vec3(0.3f, 0.2f, 0.4f);
    mixed.params.sheen_alpha = 0.3f;
    BsdfCase& thin = list.add(row, "thin_with_all_layers", 0.3f, 0.15f);
    thin.params = mixed.params;
    thin.params.thin = 1u;
    BsdfCase& same = list.add(row, "solid_of_index_1", 0.3f, 0.3f);
    same.solid = true;
    same.params.transmission = 1.0f;
    same.params.thin = 0u;
    same.params.ior = 1.0f;
}

inline void addLibraryCases(CaseList& list, const ModelRow& row) {
    // Its facets take too long for these quadratures; tests/water has tests of their own.
    list.add(row, "defaults", row.number == MODEL_GLINT ? "method=smooth" : "");
    for (const LibraryCase& c : libraryCases) {
        if (std::string(c.model) != row.name || (c.onlyLong && !longTests())) continue;
        list.add(row, c.name, c.settings).flags |= c.flags;
    }
}

inline std::vector<BsdfCase> bsdfCases() {
    CaseList list;
    for (const ModelRow& row : modelRows) {
        if (row.library) {
            addLibraryCases(list, row);
            continue;
        }
        list.add(row, "wide", 1.0f, 1.0f);
        if (row.number == MODEL_LAMBERT) continue;
        list.add(row, "medium", 0.3f, 0.3f);
        list.add(row, "narrow", 0.02f, 0.02f);
        if (row.number == MODEL_SHEEN) continue;
        list.add(row, "narrowest", BSDF_MIN_ALPHA, BSDF_MIN_ALPHA);
        list.add(row, "anisotropic", 0.6f, 0.1f);
        if (longTests()) {
            for (const float alpha : {0.001f, 0.005f, 0.1f, 0.5f, 0.75f}) {
                list.add(row, fmt::format("alpha_{:g}", alpha), alpha, alpha);
                list.add(row, fmt::format("across_{:g}", alpha), alpha * 0.3f, alpha);
            }
        }
        if (row.number != MODEL_GLTF) continue;
        addGltfLayerCases(list, row);
        addGltfTransmissionCases(list, row);
    }
    return list.take();
}

// Views: near the normal, oblique, grazing; from below too where light goes through. 30 degrees
// and 60 degrees below are on the two sides of the critical angle of index 1.5.
inline std::vector<vec3> viewsOf(const BsdfCase& c) {
    std::vector<float> cosines = {0.999f, 0.6f, 0.12f};
    if (c.transmits()) cosines.insert(cosines.end(), {-0.87f, -0.5f});
    if (longTests()) cosines.insert(cosines.end(), {0.9f, 0.35f, 0.03f});
    std::vector<vec3> views;
    float phi = 0.4f;
    for (const float z : cosines) {
        const float r = std::sqrt(1.0f - z * z);
        views.push_back(vec3(r * std::cos(phi), r * std::sin(phi), z));
        phi += 1.1f;
    }
    return views;
}

inline BsdfSample drawSample(const BsdfParams& m, vec3 wo, Random& random) {
    const float lobe = random.uniform();
    const float x = random.uniform();
    return bsdf_sample(m, wo, lobe, vec2(x, random.uniform()));
}

// The hemispheres to be tested: the side of the view and, if light goes through or one side of the
// surface reaches into both, the other.
inline std::vector<int> hemispheresOf(const BsdfCase& c, vec3 wo) {
    const int side = wo.z > 0.0f ? 1 : -1;
    return c.transmits() || c.isTilted() ? std::vector<int>{side, -side} : std::vector<int>{side};
}

}  // namespace
}  // namespace gp::test
