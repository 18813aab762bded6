// The glint model where its answer is known: limits in which it is another model, and furnaces.
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "scene/glint_dictionary.h"
#include "shading/shading.h"
#include "statistics/chi2.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;

BsdfParams glintMetal(float alphaX, float alphaY) {
    BsdfParams m = bsdf_params_of(MODEL_GLINT);
    m.base_color = vec3(0.9f, 0.6f, 0.3f);
    m.metallic = 1.0f;
    m.alpha_x = alphaX;
    m.alpha_y = alphaY;
    return bsdf_prepared(m);
}

// One sample.
BsdfSample drawn(const BsdfParams& m, vec3 wo, Random& random) {
    const float lobe = random.uniform();
    const float x = random.uniform();
    return bsdf_sample(m, wo, lobe, vec2(x, random.uniform()));
}

// Share of the energy that leaves again; light that crossed the boundary is brought back from
// radiance to power.
double furnace(const BsdfParams& m, vec3 wo, double eta, int samples = 60'000) {
    Random random(31);
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const BsdfSample s = drawn(m, wo, random);
        const bool crosses = (s.lobe & LOBE_TRANSMISSION) != 0u && m.thin == 0u;
        sum += double(s.weight.y) * (crosses ? eta * eta : 1.0);
    }
    return sum / samples;
}

vec3 viewAt(float z) {
    return vec3(std::sqrt(1.0f - z * z), 0.0f, z);
}

TEST(GlintModel, SmoothCentredMetalIsBeckmannWithCavities) {
    Random random(7);
    for (const float alpha : {0.05f, 0.3f, 1.0f}) {
        const BsdfParams glint = glintMetal(alpha, 0.5f * alpha);
        BsdfParams m = bsdf_params_of(MODEL_MICROFACET);
        m.base_color = glint.base_color;
        m.alpha_x = glint.alpha_x;
        m.alpha_y = glint.alpha_y;
        m.slot_a.x = float(DISTRIBUTION_BECKMANN);
        m.slot_a.y = float(MASKING_V_CAVITY);
        m = bsdf_prepared(m);
        int compared = 0;
        for (int i = 0; i < 20'000; ++i) {
            const float x = random.uniform();
            const vec3 wo = square_to_uniform_hemisphere(vec2(x, random.uniform()));
            const vec3 wi = drawn(m, wo, random).wi;
            const BsdfValue a = bsdf_eval(glint, wo, wi);
            const BsdfValue b = bsdf_eval(m, wo, wi);
            if (!(b.pdf > 1e-6f) || wi.z < 1e-3f || wo.z < 1e-3f) continue;
            ++compared;
            // The exponent of the distribution is large in its tail.
            ASSERT_NEAR(a.f_cos.x, b.f_cos.x, 2e-3f * b.f_cos.x) << alpha;
            ASSERT_NEAR(a.pdf, b.pdf, 2e-3f * b.pdf) << alpha;
        }
        EXPECT_GT(compared, 10'000);
    }
}

// The matte base gets what the facets leave, however rough they are; noise is below 0.004.
TEST(GlintModel, WhitePaintReturnsEverything) {
    BsdfParams m = bsdf_params_of(MODEL_GLINT);
    for (const float alpha : {0.001f, 0.1f, 0.4f, 1.0f}) {
        m.alpha_x = m.alpha_y = alpha;
        const BsdfParams prepared = bsdf_prepared(m);
        for (const float z : {1.0f, 0.5f, 0.2f, 0.05f}) {
            EXPECT_NEAR(furnace(prepared, viewAt(z), 1.0), 1.0, 0.006) << alpha << " " << z;
        }
    }
}

// What V-cavities do not hide of a calm sea: nothing is lost at the normal, little at an angle.
TEST(GlintModel, ClearWaterLosesNothing) {
    BsdfParams m = bsdf_params_of(MODEL_GLINT);
    m.ior = 1.33f;
    m.alpha_x = m.alpha_y = 0.01f;
    m.transmission = 1.0f;
    m.thin = 0u;
    m = bsdf_prepared(m);
    for (const float z : {1.0f, 0.5f, 0.2f, -0.2f, -0.5f, -1.0f}) {
        const double eta = double(relative_ior(m.ior, z));
        EXPECT_NEAR(furnace(m, viewAt(z), eta), 1.0, 3e-3) << z;
    }
}

// Which side a direction is on is the mesosurface's to say: light from below the horizon of the
// geometry meets a wave that faces it.
TEST(GlintModel, WavesSeeBelowTheHorizonOfTheGeometry) {
    BsdfParams m = glintMetal(0.2f, 0.2f);
    m.slot_a.x = -1.0f;  // falls towards +x: its normal leans there
    const vec3 below = normalize(vec3(1.0f, 0.0f, -0.2f));
    ASSERT_GT(slope_facing(glint_mean(m), below), 0.0f);
    Random random(3);
    double sum = 0.0;
    for (int i = 0; i < 20'000; ++i) sum += double(drawn(m, below, random).weight.x);
    EXPECT_GT(sum / 20'000, 0.7);
    const vec3 behind = normalize(vec3(-1.0f, 0.0f, 0.2f));
    ASSERT_LT(slope_facing(glint_mean(m), behind), 0.0f);
    EXPECT_EQ(bsdf_eval(m, behind, vec3(0, 0, 1)).f_cos, vec3(0.0f));
    EXPECT_EQ(bsdf_sample(m, behind, 0.5f, vec2(0.5f)).weight, vec3(0.0f));
}

BsdfParams withFacets(BsdfParams m, float method, float density) {
    m.slot_a.w = density;
    m.slot_b.x = method;
    m.table = glintDictionary();
    return m;
}

// What leaves of a pixel's facets, by samples of them and by samples of the smooth surface: the
// same light by two densities. A wrong density, or one that misses facets, shows.
TEST(GlintModel, FacetsByTheirOwnSamplesAndByThoseOfTheSmoothSurface) {
    const BsdfParams smooth = glintMetal(0.3f, 0.2f);
    const std::pair<uint, float> cases[] = {{GLINT_DICTIONARY, 1e5f}, {GLINT_DICTIONARY, 1e7f},
                                            {GLINT_COUNTING, 1e7f}, {GLINT_ZIRR, 1e7f}};
    for (const auto& [method, density] : cases) {
        const BsdfParams m = withFacets(smooth, float(method), density);
        for (const float z : {0.95f, 0.4f}) {
            Random random(13);
            double own = 0.0, other = 0.0, squares = 0.0;
            constexpr int n = 40'000;
            for (int i = 0; i < n; ++i) {
                own += double(drawn(m, viewAt(z), random).weight.x) / n;
                const BsdfSample s = drawn(smooth, viewAt(z), random);
                const double w = s.pdf > 0.0f
                    ? double(bsdf_eval(m, viewAt(z), s.wi).f_cos.x) / double(s.pdf) : 0.0;
                other += w / n;
                squares += w * w / n;
            }
            const double error = std::sqrt((squares - other * other) / n);
            EXPECT_NEAR(own, other, 5.0 * error + 2e-3) << method << " " << density << " " << z;
            EXPECT_LT(own, 1.0);
        }
    }
}

// White paint whose facets are few: where a pixel has none of them the base is still lit aright.
TEST(GlintModel, PaintWithFewFacetsIsWhiteOnAverage) {
    BsdfParams paint = bsdf_params_of(MODEL_GLINT);
    paint.alpha_x = paint.alpha_y = 0.3f;
    for (const uint method : {GLINT_COUNTING, GLINT_ZIRR}) {
        BsdfParams m = withFacets(bsdf_prepared(paint), float(method), 3e4f);
        Random random(37);
        double sum = 0.0, squares = 0.0;
        constexpr int n = 100'000;
        for (int i = 0; i < n; ++i) {
            m.slot_c.x = 100.0f * random.uniform();
            m.slot_c.y = 100.0f * random.uniform();
            const double w = double(drawn(m, viewAt(0.5f), random).weight.y);
            sum += w / n, squares += w * w / n;
        }
        EXPECT_NEAR(sum, 1.0, 4.0 * std::sqrt((squares - sum * sum) / n) + 2e-3) << method;
    }
}

// Some seconds: single facets take a quadrature many points.
TEST(GlintModel, FacetsAreDrawnByTheirDensity) {
    BsdfParams m = withFacets(glintMetal(0.3f, 0.3f), float(GLINT_DICTIONARY), 1e6f);
    m.slot_d = vec4(0.1f, 0.0f, 0.0f, 0.1f);
    const vec3 wo = normalize(vec3(0.3f, 0.2f, 0.8f));
    Chi2Options options;
    options.name = "facets";
    options.samples = 50'000;
    SphereDomain domain;
    domain.hemisphere = 1;
    const Chi2Result result = chi2Sphere(
        options, domain,
        [&](Random& random) {
            const BsdfSample s = drawn(m, wo, random);
            return s.pdf > 0.0f ? s.wi : vec3(0.0f);
        },
        [&](vec3 wi) { return bsdf_eval(m, wo, wi).pdf; });
    EXPECT_TRUE(result.passed) << result.message;
    EXPECT_NEAR(result.pdfIntegral, result.acceptedFraction, 5e-3);
}

// Every sample's weight is its value over its density, at most the reflectance.
TEST(GlintModel, FacetsKeepWeightsBounded) {
    const uint methods[] = {GLINT_DICTIONARY, GLINT_COUNTING, GLINT_ZIRR};
    Random random(17);
    for (int i = 0; i < 9'000; ++i) {
        // A pixel of 1,000 facets, which are within 5 % of that.
        const BsdfParams m = withFacets(glintMetal(0.4f, 0.1f), float(methods[i % 3]), 1e7f);
        const float x = random.uniform();
        const vec3 wo = square_to_uniform_hemisphere(vec2(x, random.uniform()));
        const BsdfSample s = drawn(m, wo, random);
        ASSERT_LE(s.weight.x, i % 3 == 0 ? 1.0001f : 1.05f);
        if (!(s.pdf > 0.0f)) continue;
        const BsdfValue v = bsdf_eval(m, wo, s.wi);
        ASSERT_NEAR(v.pdf, s.pdf, 1e-5f * s.pdf);
        ASSERT_NEAR(v.f_cos.x, s.weight.x * s.pdf, 1e-4f * v.f_cos.x + 1e-9f);
    }
}

// Over many places the facets add up to the smooth surface.
TEST(GlintModel, TheMeanOfManyPlacesIsTheSmoothSurface) {
    const BsdfParams smooth = glintMetal(0.3f, 0.3f);
    const vec3 wo = viewAt(0.8f);
    const vec3 wi = normalize(vec3(-0.5f, 0.1f, 0.75f));
    const double expected = double(bsdf_eval(smooth, wo, wi).f_cos.x);
    for (const uint method : {GLINT_DICTIONARY, GLINT_COUNTING, GLINT_ZIRR}) {
        BsdfParams m = withFacets(smooth, float(method), 1e6f);
        Random random(23);
        double sum = 0.0, squares = 0.0;
        constexpr int n = 40'000;
        for (int i = 0; i < n; ++i) {
            m.slot_c.x = 100.0f * random.uniform();
            m.slot_c.y = 100.0f * random.uniform();
            const double f = double(bsdf_eval(m, wo, wi).f_cos.x) / expected;
            sum += f;
            squares += f * f;
        }
        const double error = std::sqrt(squares - sum * sum / n) / n;
        EXPECT_GT(error, 4e-4) << "no glints";  // a contrast of 0.08
        EXPECT_NEAR(sum / n, 1.0, 4.0 * error + 0.01) << method;
    }
}

TEST(GlintModel, HostileParametersGiveNoNan) {
    const float values[] = {0.0f, -1.0f, 1e-30f, 1e30f, INFINITY, -INFINITY, NAN};
    Random random(29);
    for (const uint method : {GLINT_SMOOTH, GLINT_DICTIONARY, GLINT_COUNTING, GLINT_ZIRR}) {
        for (int i = 0; i < 3'000; ++i) {
            BsdfParams m = withFacets(glintMetal(0.3f, 0.3f), float(method), 1e6f);
            const auto any = [&] { return values[int(random.uniform() * 7.0f)]; };
            const int which = i % 5;
            if (which == 0) m.slot_a.w = any();
            if (which == 1) m.slot_b.y = any(), m.slot_b.z = any();
            if (which == 2) m.slot_c.x = any(), m.slot_c.y = any();
            if (which == 3) m.slot_d = vec4(any(), any(), any(), any());
            if (which == 4) m.slot_e = vec4(any(), any(), any(), any());
            const BsdfSample s = drawn(m, viewAt(0.5f), random);
            ASSERT_TRUE(std::isfinite(s.pdf + s.weight.x)) << method << " " << which;
            const BsdfValue v = bsdf_eval(m, viewAt(0.5f), viewAt(0.9f));
            ASSERT_TRUE(std::isfinite(v.pdf + v.f_cos.x)) << method << " " << which;
        }
    }
}

}  // namespace
}  // namespace gp::test
