// Fresnel terms against the equations in complex double arithmetic, and against golden values.
#include <complex>

#include <gtest/gtest.h>

#include "shading/shading.h"
#include "statistics/golden.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;
using Complex = std::complex<double>;

// Fresnel's equations as every textbook has them, the index behind the boundary complex.
double exactReflectance(double cosO, Complex eta) {
    const Complex cosT = std::sqrt(1.0 - (1.0 - cosO * cosO) / (eta * eta));
    const Complex s = (cosO - eta * cosT) / (cosO + eta * cosT);
    const Complex p = (eta * cosO - cosT) / (eta * cosO + cosT);
    return 0.5 * (std::norm(s) + std::norm(p));
}

TEST(Fresnel, DielectricIsExact) {
    Random random(1);
    for (int i = 0; i < 100'000; ++i) {
        const float c = random.uniform();
        const float eta = std::exp2(4.0f * random.uniform() - 2.0f);
        const double exact = exactReflectance(c, {double(eta), 0.0});
        // At the critical angle the slope is infinite.
        const double near = std::abs(double(eta) * eta - 1.0 + double(c) * c);
        const double tolerance = 3e-6 + 3e-7 / std::sqrt(near + 1e-9);
        ASSERT_NEAR(fresnel_dielectric(c, eta), exact, tolerance) << c << " " << eta;
    }
    EXPECT_EQ(fresnel_dielectric(0.3f, 1.0f), 0.0f);
    EXPECT_EQ(fresnel_dielectric(0.0f, 1.5f), 1.0f);
    EXPECT_NEAR(fresnel_dielectric(1.0f, 1.5f), 0.04f, 1e-7f);
}

TEST(Fresnel, TransmittanceIsTheRest) {
    Random random(2);
    for (int i = 0; i < 100'000; ++i) {
        const float c = random.uniform();
        const float eta = std::exp2(4.0f * random.uniform() - 2.0f);
        const float g = fresnel_g(c, eta);
        if (g <= 0.0f) continue;
        const float t = fresnel_transmittance(c, g / eta, eta);
        ASSERT_NEAR(t + fresnel_dielectric(c, eta), 1.0f, 3e-6f) << c << " " << eta;
        // The same number for light that goes the other way.
        ASSERT_NEAR(t, fresnel_transmittance(g / eta, c, 1.0f / eta), 1e-6f * t + 1e-12f);
    }
}

TEST(Fresnel, ConductorIsExact) {
    Random random(3);
    for (int i = 0; i < 100'000; ++i) {
        const float c = random.uniform();
        const vec3 eta = vec3(0.1f) + 3.0f * vec3(random.uniform(), random.uniform(), 0.2f);
        const vec3 k = 0.01f + 6.0f * vec3(random.uniform(), 0.5f, random.uniform());
        const vec3 f = fresnel_conductor(c, eta, k);
        for (int channel = 0; channel < 3; ++channel) {
            const Complex index{double(eta[channel]), double(k[channel])};
            ASSERT_NEAR(f[channel], exactReflectance(c, index), 1e-5) << c;
        }
    }
}

TEST(Fresnel, SchlickHasItsEnds) {
    EXPECT_EQ(fresnel_schlick(0.04f, 0.9f, 1.0f), 0.04f);
    EXPECT_EQ(fresnel_schlick(0.04f, 0.9f, 0.0f), 0.9f);
    EXPECT_NEAR(fresnel_schlick(0.04f, 1.0f, 0.5f), 0.07f, 1e-6f);
    const vec3 f = fresnel_schlick_generalised(vec3(0.1f), vec3(0.8f), 5.0f, 0.3f);
    EXPECT_NEAR(f.x, fresnel_schlick(0.1f, 0.8f, 0.3f), 1e-6f);
}

TEST(Fresnel, IndexAndF0AreInverse) {
    for (const float ior : {1.0f, 1.1f, 1.33f, 1.5f, 2.4f, 10.0f}) {
        EXPECT_NEAR(ior_from_f0(f0_from_ior(ior)), ior, 2e-5f * ior * ior);
    }
    EXPECT_EQ(f0_from_ior(0.0f), 1.0f);  // KHR_materials_ior: stands for infinity
    EXPECT_TRUE(std::isfinite(ior_from_f0(1.0f)));
}

TEST(Fresnel, RefractedKeepsSnellsLaw) {
    Random random(4);
    for (int i = 0; i < 10'000; ++i) {
        const float z = random.uniform();
        const float phi = TWO_PI * random.uniform();
        const float r = std::sqrt(1.0f - z * z);
        const vec3 wo(r * std::cos(phi), r * std::sin(phi), z);
        const float eta = 0.5f + 2.0f * random.uniform();
        const float g = fresnel_g(z, eta);
        if (g <= 0.0f) continue;
        const vec3 wi = refracted(wo, vec3(0.0f, 0.0f, 1.0f), eta, g);
        ASSERT_NEAR(length(wi), 1.0f, 1e-6f);
        ASSERT_LT(wi.z, 0.0f);
        ASSERT_NEAR(wi.x * eta, -wo.x, 1e-6f);
        ASSERT_NEAR(wi.y * eta, -wo.y, 1e-6f);
    }
}

TEST(Fresnel, IridescenceMatchesGoldenValues) {
    const std::vector<GoldenRow> rows = readGolden("golden_iridescence.csv");
    GP_SKIP_WITHOUT(rows, "golden_iridescence.csv");
    int compared = 0;
    for (const GoldenRow& row : rows) {
        if (row.at("variant") != "gltf_schlick") continue;
        const vec3 f = fresnel_iridescence(1.0f, number(row, "eta2"), number(row, "cos1"),
                                           number(row, "thickness_nm"),
                                           vec3(number(row, "eta3_or_f0")));
        const vec3 golden(number(row, "r"), number(row, "g"), number(row, "b"));
        for (int channel = 0; channel < 3; ++channel) {
            ASSERT_NEAR(f[channel], golden[channel], 1e-3f * golden[channel] + 1e-5f)
                << "row " << compared << " channel " << channel;
        }
        ++compared;
    }
    EXPECT_EQ(compared, 150);
}

TEST(Fresnel, FilmOfNoThicknessIsNotThere) {
    const vec3 f0(0.04f, 0.3f, 0.9f);
    // From the front only: Schlick's term lets even a film without a difference in index reflect
    // at grazing angles. The series has a floor of 1e-5 under the square root: 2 * 0.0032 * 1.2.
    const vec3 f = fresnel_iridescence(1.0f, 1.8f, 1.0f, 0.0f, f0);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(f[channel], f0[channel], 0.008f);
}

}  // namespace
}  // namespace gp::test
