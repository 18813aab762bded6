// Disney's principled BRDF against golden_brdf.csv, evaluated in double from the shader that came
// with the course notes. That shader raises the colour to the power 2.2; ours is linear.
#include <gtest/gtest.h>

#include "shading/shading.h"
#include "statistics/golden.h"

namespace gp::test {
namespace {

using namespace gp::shading;

vec3 jsonColor(const std::string& json, const std::string& key) {
    const std::size_t at = json.find('[', json.find('"' + key + '"'));
    std::istringstream in(json.substr(at + 1));
    vec3 color(0.0f);
    char comma = 0;
    in >> color.x >> comma >> color.y >> comma >> color.z;
    return color;
}

BsdfParams paramsOf(const std::string& json) {
    BsdfParams m = bsdf_params_of(MODEL_DISNEY);
    m.base_color = pow(jsonColor(json, "baseColor"), vec3(2.2f));
    m.metallic = jsonNumber(json, "metallic");
    m.slot_a = vec4(jsonNumber(json, "subsurface"), jsonNumber(json, "specular"),
                    jsonNumber(json, "roughness"), jsonNumber(json, "specularTint"));
    m.slot_b = vec4(jsonNumber(json, "anisotropic"), jsonNumber(json, "sheen"),
                    jsonNumber(json, "sheenTint"), jsonNumber(json, "clearcoat"));
    m.slot_c.x = jsonNumber(json, "clearcoatGloss");
    return m;
}

TEST(GoldenDisney, RowsAreMatched) {
    const std::vector<GoldenRow> rows = readGolden("golden_brdf.csv");
    GP_SKIP_WITHOUT(rows, "golden_brdf.csv");
    int compared = 0;
    for (const GoldenRow& row : rows) {
        if (row.at("model") != "disney") continue;
        const vec3 l(number(row, "lx"), number(row, "ly"), number(row, "lz"));
        const vec3 v(number(row, "vx"), number(row, "vy"), number(row, "vz"));
        const BsdfParams m = paramsOf(row.at("params"));
        const dvec3 f = dvec3(bsdf_eval(m, v, l).f_cos) / std::abs(double(l.z));
        // The narrowest lobe: a clearcoat's is from 0.001 to 0.1 wide.
        const DisneyWidths w = disney_widths(disney_roughness(m), disney_anisotropic(m));
        const float coat = disney_clearcoat(m) > 0.0f ? disney_coat_alpha(m) : 1.0f;
        const bool hard = std::min({w.x, w.y, coat}) < 0.01f
                       || std::min(std::abs(l.z), std::abs(v.z)) < 0.01f;
        for (int channel = 0; channel < 3; ++channel) {
            const char* const names[] = {"r", "g", "b"};
            const double golden = std::strtod(row.at(names[channel]).c_str(), nullptr);
            EXPECT_NEAR(f[channel], golden, (hard ? 1e-2 : 1e-3) * golden + 1e-5)
                << row.at("params") << " " << l.z << " " << v.z;
        }
        ++compared;
    }
    EXPECT_EQ(compared, 1000);
}

// A row of the table of known answers: one lobe at a time, by hand.
TEST(GoldenDisney, LobesHaveTheirValues) {
    BsdfParams m = bsdf_params_of(MODEL_DISNEY);
    const vec3 n(0.0f, 0.0f, 1.0f);
    m.base_color = vec3(0.5f);
    m.slot_a = vec4(0.0f, 0.0f, 0.5f, 0.0f);
    m.slot_b = vec4(0.0f);
    // Diffuse at normal incidence is Lambert's.
    EXPECT_NEAR(bsdf_eval(m, n, n).f_cos.x, 0.5f * INV_PI, 1e-6f);
    // Subsurface there: 1.25 ((1/2 - 1/2) + 1/2).
    m.slot_a.x = 1.0f;
    EXPECT_NEAR(bsdf_eval(m, n, n).f_cos.x, 0.5f * INV_PI * 0.625f, 1e-6f);
    // The specular lobe: F0 = 0.04, D = 1 / (pi alpha^2), over 4.
    m.base_color = vec3(0.0f);
    m.slot_a.y = 0.5f;
    EXPECT_NEAR(bsdf_eval(m, n, n).f_cos.x, 0.01f * INV_PI * 16.0f, 1e-5f);
    // Masking is 1 at normal incidence for both versions.
    m.slot_c.y = float(DISNEY_2012);
    EXPECT_NEAR(bsdf_eval(m, n, n).f_cos.x, 0.01f * INV_PI * 16.0f, 1e-5f);
    // A quarter of the coat: F0 = 0.04, GTR1 with alpha = 0.1.
    m.slot_a.y = 0.0f;
    m.slot_b.w = 1.0f;
    m.slot_c.x = 0.0f;
    const double peak = (0.01 - 1.0) / (M_PI * std::log(0.01) * 0.01);
    EXPECT_NEAR(bsdf_eval(m, n, n).f_cos.x, 0.25 * 0.25 * 0.04 * peak, 1e-5);
}

// The remapped masking of 2012 is wider than that of a smooth lobe: it darkens grazing angles.
TEST(GoldenDisney, VersionsDiffer) {
    BsdfParams m = bsdf_params_of(MODEL_DISNEY);
    m.metallic = 1.0f;
    m.slot_a.z = 0.3f;
    const vec3 wo(0.98f, 0.0f, 0.199f);
    const vec3 wi(-0.98f, 0.0f, 0.199f);
    const float after = bsdf_eval(m, wo, wi).f_cos.x;
    m.slot_c.y = float(DISNEY_2012);
    const float before = bsdf_eval(m, wo, wi).f_cos.x;
    const float alpha = 0.65f * 0.65f;
    const float ratio = ggx_g2_separable(wo, wi, alpha, alpha)
                      / ggx_g2_separable(wo, wi, 0.09f, 0.09f);
    EXPECT_NEAR(before / after, ratio, 1e-4f);
    EXPECT_LT(ratio, 0.6f);
}

}  // namespace
}  // namespace gp::test
