// Reflectance with known answers: furnaces, limits in which one model is another, conventions.
#include <gtest/gtest.h>

#include "statistics/bsdf_cases.h"
#include "statistics/golden.h"

namespace gp::test {
namespace {

// Share of the energy that leaves again, in white light.
double furnace(const BsdfParams& m, vec3 wo, bool solid, int samples = 100'000) {
    Random random(11);
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const BsdfSample s = drawSample(m, wo, random);
        const double eta = solid ? double(relative_ior(m.ior, wo.z)) : 1.0;
        const bool crosses = (s.wi.z > 0.0f) != (wo.z > 0.0f);
        sum += double(s.weight.y) * (crosses ? eta * eta : 1.0);
    }
    return sum / samples;
}

vec3 viewAt(float z) {
    return vec3(std::sqrt(1.0f - z * z), 0.0f, z);
}

TEST(BsdfKnown, WhiteLambertReturnsEverything) {
    EXPECT_EQ(bsdf_default().model, MODEL_LAMBERT);
    for (const float z : {1.0f, 0.4f, 0.01f}) {
        EXPECT_NEAR(furnace(bsdf_default(), viewAt(z), false), 1.0, 1e-6);
    }
}

// Interface and diffuse base share the light without loss, up to the errors of the fits.
TEST(BsdfKnown, WhitePlasticReturnsEverything) {
    BsdfParams m = bsdf_params_of(MODEL_GLTF);
    for (const float alpha : {0.001f, 0.05f, 0.3f, 1.0f}) {
        m.alpha_x = m.alpha_y = alpha;
        for (const float z : {1.0f, 0.6f, 0.2f, 0.05f}) {
            EXPECT_NEAR(furnace(m, viewAt(z), false), 1.0, 0.008) << alpha << " " << z;
        }
    }
}

TEST(BsdfKnown, WhiteMetalMatchesGoldenAlbedo) {
    const std::vector<GoldenRow> rows = readGolden("golden_albedo.csv");
    GP_SKIP_WITHOUT(rows, "golden_albedo.csv");
    for (const GoldenRow& row : rows) {
        if (row.at("g2") != "heightcorr") continue;
        const bool ggx = row.at("ndf") == "ggx";
        BsdfParams m = bsdf_params_of(ggx ? MODEL_GGX_CONDUCTOR : MODEL_BECKMANN_CONDUCTOR);
        m.alpha_x = m.alpha_y = number(row, "alpha");
        EXPECT_NEAR(furnace(m, viewAt(number(row, "mu")), false, 20'000), number(row, "E"), 0.012)
            << row.at("ndf") << " " << row.at("alpha") << " " << row.at("mu");
    }
}

TEST(BsdfKnown, AverageAlbedoMatchesGoldenValues) {
    const std::vector<GoldenRow> rows = readGolden("golden_eavg.csv");
    GP_SKIP_WITHOUT(rows, "golden_eavg.csv");
    for (const GoldenRow& row : rows) {
        if (row.at("ndf") != "ggx" || row.at("g2") != "heightcorr") continue;
        EXPECT_NEAR(ggx_albedo_average(number(row, "alpha")).white, number(row, "Eavg"), 0.002);
    }
}

// Power is conserved only if the weight of a camera path has 1 / eta^2 on entering and eta^2 on
// leaving.
TEST(BsdfKnown, ClearGlassLosesNothing) {
    for (const uint model : {MODEL_GGX_DIELECTRIC, MODEL_GLTF}) {
        BsdfParams m = bsdf_params_of(model);
        m.alpha_x = m.alpha_y = BSDF_MIN_ALPHA;
        m.transmission = 1.0f;
        m.thin = 0u;
        for (const float z : {1.0f, 0.5f, 0.1f, -0.1f, -0.5f, -0.8f, -1.0f}) {
            EXPECT_NEAR(furnace(m, viewAt(z), true, 20'000), 1.0, 2e-3) << model << " " << z;
        }
        const BsdfSample in = bsdf_sample(m, viewAt(1.0f), 0.99f, vec2(0.5f));
        EXPECT_EQ(in.lobe, LOBE_TRANSMISSION | LOBE_SPECULAR);
        EXPECT_NEAR(in.weight.x, 1.0f / (1.5f * 1.5f), 1e-4f);
        const BsdfSample out = bsdf_sample(m, viewAt(-1.0f), 0.99f, vec2(0.5f));
        EXPECT_NEAR(out.weight.x, 1.5f * 1.5f, 1e-3f);
        EXPECT_GT(out.wi.z, 0.99f);
        const BsdfSample total = bsdf_sample(m, viewAt(-0.5f), 0.99f, vec2(0.5f));
        EXPECT_LT(total.wi.z, 0.0f);  // past the critical angle
        EXPECT_NEAR(total.weight.x, 1.0f, 1e-4f);
    }
}

TEST(BsdfKnown, RefractionObeysSnell) {
    BsdfParams m = bsdf_params_of(MODEL_GGX_DIELECTRIC);
    m.alpha_x = m.alpha_y = BSDF_MIN_ALPHA;
    const vec3 wo = viewAt(0.6f);
    const BsdfSample s = bsdf_sample(m, wo, 0.99f, vec2(0.25f, 0.5f));
    EXPECT_NEAR(s.wi.x, -wo.x / 1.5f, 1e-3f);
    EXPECT_NEAR(s.wi.y, 0.0f, 1e-3f);
}

TEST(BsdfKnown, PaneReflectsTwice) {
    // F = 0.04 on both faces and all ways between them: 2 F / (1 + F).
    EXPECT_NEAR(thin_reflectance(1.0f, 1.5f), 0.08f / 1.04f, 1e-6f);
}

// The switches of the glTF material, each at the value at which another model is the answer.
TEST(BsdfKnown, GltfHasItsLimits) {
    Random random(21);
    BsdfParams metal = bsdf_params_of(MODEL_GLTF);
    metal.base_color = vec3(0.9f, 0.6f, 0.2f);
    metal.alpha_x = 0.3f;
    metal.alpha_y = 0.1f;
    metal.metallic = 1.0f;
    BsdfParams conductor = metal;
    conductor.model = MODEL_GGX_CONDUCTOR;
    BsdfParams chalk = bsdf_params_of(MODEL_GLTF);
    chalk.base_color = metal.base_color;
    chalk.specular = 0.0f;
    BsdfParams lambert = chalk;
    lambert.model = MODEL_LAMBERT;
    for (int i = 0; i < 1000; ++i) {
        const float a = random.uniform(), b = random.uniform(), c = random.uniform();
        const vec3 wo = square_to_cosine_hemisphere(vec2(a, b));
        const vec3 wi = square_to_cosine_hemisphere(vec2(c, random.uniform()));
        const BsdfValue v = bsdf_eval(metal, wo, wi), w = bsdf_eval(conductor, wo, wi);
        ASSERT_NEAR(v.pdf, w.pdf, 1e-5f * w.pdf);
        ASSERT_NEAR(v.f_cos.z, w.f_cos.z, 1e-5f * w.f_cos.z);
        const float f = bsdf_eval(chalk, wo, wi).f_cos.y;
        ASSERT_NEAR(f, bsdf_eval(lambert, wo, wi).f_cos.y, 1e-2f * f);
    }
}

// A smooth coat over black is a mirror of four per cent, and darkens what lies below by as much.
TEST(BsdfKnown, CoatCoversTheBase) {
    BsdfParams m = bsdf_params_of(MODEL_GLTF);
    m.specular = 0.0f;
    m.base_color = vec3(0.0f);
    m.coat = 1.0f;
    EXPECT_NEAR(furnace(m, viewAt(1.0f), false), 0.04, 2e-3);
    EXPECT_NEAR(furnace(m, viewAt(0.05f), false), 0.04 + 0.96 * std::pow(0.95, 5.0), 6e-3);
}

TEST(BsdfKnown, SpecularMeansEveryLobe) {
    BsdfParams m = bsdf_params_of(MODEL_GLTF);
    m.alpha_x = m.alpha_y = BSDF_MIN_ALPHA;
    EXPECT_FALSE(bsdf_is_specular(m));  // its base is diffuse
    m.metallic = 1.0f;
    EXPECT_TRUE(bsdf_is_specular(m));
    m.coat = 0.5f;
    m.coat_alpha = 0.1f;
    EXPECT_FALSE(bsdf_is_specular(m));
    m.coat = 0.0f;
    m.sheen_color = vec3(0.1f);
    EXPECT_FALSE(bsdf_is_specular(m));
    for (const ModelRow& row : modelRows) {
        BsdfParams wide = bsdf_params_of(row.number);
        EXPECT_FALSE(bsdf_is_specular(wide)) << row.name;
    }
}

}  // namespace
}  // namespace gp::test
