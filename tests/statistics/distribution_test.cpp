// Distributions of normals by number: area, sampling, and Smith's masking from its fits.
#include <gtest/gtest.h>

#include "shading/shading.h"
#include "statistics/chi2.h"

namespace gp::test {
namespace {

using namespace gp::shading;

struct Kind {
    const char* name;
    uint number;
    std::vector<float> shapes;
    float lowest, highest;  // shapes
};
const Kind kinds[] = {
    {"ggx", DISTRIBUTION_GGX, {0.0f}, 0.0f, 1.0f},
    {"beckmann", DISTRIBUTION_BECKMANN, {0.0f}, 0.0f, 1.0f},
    {"gtr", DISTRIBUTION_GTR, {0.1f, 0.7f, 1.0f, 1.0001f, 1.5f, 2.0f, 3.7f, 10.0f}, 0.1f, 10.0f},
    {"berry", DISTRIBUTION_BERRY, {0.0f}, 0.0f, 1.0f},
    {"blinn_phong", DISTRIBUTION_BLINN_PHONG, {0.0f}, 0.0f, 1.0f},
    {"exponential_power", DISTRIBUTION_EXPONENTIAL_POWER, {0.25f, 0.5f, 1.0f, 4.0f}, 0.25f, 4.0f},
    {"shifted_gamma", DISTRIBUTION_SHIFTED_GAMMA, {0.0f, 0.5f, 1.0f, 1.3f, 3.0f}, 0.0f, 3.0f},
    {"abc", DISTRIBUTION_ABC, {0.1f, 0.5f, 1.0f, 1.5f, 2.5f, 10.0f}, 0.1f, 10.0f},
};

Distribution distributionOf(uint kind, float alphaX, float alphaY, float shape) {
    Distribution d;
    d.kind = kind;
    d.alpha_x = alphaX;
    d.alpha_y = alphaY;
    d.shape = shape;
    d.fit = smith_fit_of(d);
    return d;
}

// The normal whose slope is e^s times the widths, at the azimuth phi.
vec3 normalAt(const Distribution& d, double s, double phi) {
    const double x = double(d.alpha_x) * std::exp(s) * std::cos(phi);
    const double y = double(d.alpha_y) * std::exp(s) * std::sin(phi);
    return vec3(dvec3(x, y, 1.0) / std::sqrt(1.0 + x * x + y * y));
}

// Integral of f over the hemisphere of normals, in the logarithm of the slope, which suits peaks
// and tails alike. `turns`: false for what does not depend on the azimuth.
template <class F>
double overNormals(const Distribution& d, const F& f, bool turns) {
    std::vector<double> breaks;
    for (double s = -20.0; s < 20.0; s += 1.0) breaks.push_back(s);
    return integratePieces([&](double s) {
        const auto ring = [&](double phi) {
            const vec3 wm = normalAt(d, s, phi);
            const double z = double(wm.z);
            const double plane = double(d.alpha_x) * double(d.alpha_y) * std::exp(2.0 * s);
            return f(wm) * plane * z * z * z;
        };
        return turns ? integrate(ring, 0.0, 2.0 * M_PI, {1e-6, 1e-9}, 5) : 2.0 * M_PI * ring(0.3);
    }, -20.0, 20.0, breaks, {1e-6, 1e-9}, 4);
}

const float widths[] = {1e-4f, 0.01f, 0.2f, 0.7f, 1.0f};

TEST(Distribution, AreaProjectsToOne) {
    for (const Kind& k : kinds) {
        for (const float shape : k.shapes) {
            for (const float alpha : widths) {
                const Distribution d = distributionOf(k.number, alpha, alpha, shape);
                const double area = overNormals(d, [&](vec3 wm) {
                    return double(distribution_d(d, wm)) * double(wm.z);
                }, false);
                EXPECT_NEAR(area, 1.0, 2e-4) << k.name << " " << shape << " " << alpha;
            }
            const Distribution d = distributionOf(k.number, 0.5f, 0.1f, shape);
            const double area = overNormals(d, [&](vec3 wm) {
                return double(distribution_d(d, wm)) * double(wm.z);
            }, true);
            EXPECT_NEAR(area, 1.0, 2e-4) << k.name << " " << shape << " anisotropic";
        }
    }
}

// The weak white furnace of V-cavities: what wo sees of them projects to its cosine, for any D.
TEST(Distribution, CavitiesPassTheWeakWhiteFurnace) {
    for (const Kind& k : kinds) {
        const float shape = k.shapes[k.shapes.size() / 2];
        for (const float cosine : {0.95f, 0.5f, 0.1f}) {
            const Distribution d = distributionOf(k.number, 0.3f, 0.15f, shape);
            const float r = std::sqrt(1.0f - cosine * cosine);
            const vec3 wo(r * 0.8f, r * 0.6f, cosine);
            const double visible = overNormals(d, [&](vec3 wm) {
                const float oh = dot(wo, wm);
                return oh <= 0.0f ? 0.0 : double(oh) * double(distribution_d(d, wm))
                                        * double(masking_v_cavity_g1(wo.z, wm.z, oh));
            }, true);
            EXPECT_NEAR(visible / double(cosine), 1.0, 2e-3) << k.name << " cos " << cosine;
        }
    }
}

// Special cases of one distribution are other ones.
TEST(Distribution, FamiliesMeet) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const float x = random.uniform();
        const vec3 wm = square_to_uniform_hemisphere(vec2(x, random.uniform()));
        const float alpha = std::exp2(-8.0f * random.uniform());
        const auto near = [&](float a, float b) { return std::abs(a - b) <= 2e-4f * b + 1e-20f; };
        ASSERT_TRUE(near(gtr_d(wm, alpha, 2.0f), ggx_d(wm, alpha, alpha)));
        ASSERT_TRUE(near(gtr_d(wm, alpha, 2.0f), gtr_d(wm, alpha, 2.00001f)));
        ASSERT_TRUE(near(gtr_d(wm, alpha, 1.0f), gtr_d(wm, alpha, 1.00001f)));
        ASSERT_TRUE(near(gtr_d(wm, alpha, 1.5f), gtr_d(wm, alpha, 1.50001f)));
        ASSERT_NEAR(gtr_d(wm, 1.0f, 0.3f), INV_PI, 1e-6f);  // alpha = 1 is a sphere
        if (wm.z > 0.05f) {
            const float tail = 1e-3f * beckmann_d(wm, alpha, alpha) + 1e-12f;
            ASSERT_NEAR(exponential_power_d(wm, alpha, 1.0f), beckmann_d(wm, alpha, alpha), tail);
        }
    }
    // [Burley 2012, "Physically Based Shading at Disney", appendix B.2]: gamma = 1 and 2.
    const double a2 = 0.09, c2 = 0.64;
    const vec3 wm(0.6f, 0.0f, 0.8f);
    const double y = 1 + (a2 - 1) * c2;
    EXPECT_NEAR(gtr_d(wm, 0.3f, 1.0f), (a2 - 1) / (M_PI * std::log(a2) * y), 1e-6);
    EXPECT_NEAR(gtr_d(wm, 0.3f, 2.0f), a2 / (M_PI * y * y), 1e-6);
    EXPECT_NEAR(blinn_phong_exponent(blinn_phong_alpha(37.0f)), 37.0f, 1e-4f);
}

// The anisotropic surface is the isotropic one stretched: GGX and Beckmann know both ways.
TEST(Distribution, StretchingIsExact) {
    Random random(4);
    for (const uint kind : {DISTRIBUTION_GGX, DISTRIBUTION_BECKMANN}) {
        for (int i = 0; i < 2000; ++i) {
            const float x = random.uniform();
            const vec3 w = square_to_uniform_hemisphere(vec2(x, random.uniform()));
            if (w.z < 0.01f) continue;
            const Distribution d = distributionOf(kind, 0.7f, 0.2f, 0.0f);
            const bool ggx = kind == DISTRIBUTION_GGX;
            const float exactD = ggx ? ggx_d(w, 0.7f, 0.2f) : beckmann_d(w, 0.7f, 0.2f);
            const float exactL = ggx ? ggx_lambda(w, 0.7f, 0.2f) : beckmann_lambda(w, 0.7f, 0.2f);
            ASSERT_NEAR(distribution_d(d, w), exactD, 5e-4f * exactD + 1e-10f);
            ASSERT_NEAR(distribution_lambda(d, w), exactL, 1e-4f * exactL + 1e-6f);
        }
    }
}

// 1 / (1 + Lambda) by adaptive quadrature of the facets that look away (smith_quadrature.glsl).
double exactG1(const Distribution& d, double cotangent) {
    const auto away = [&](double q) {
        const double t = cotangent * std::exp(q * q);
        const double z = 1.0 / std::sqrt(1.0 + t * t);
        const double p22 = double(isotropic_d(d, vec3(dvec3(t * z, 0.0, z)), d.alpha_x))
                         * z * z * z * z;
        const double area = std::sqrt(std::expm1(2.0 * q * q)) - std::acos(std::exp(-q * q));
        return 4.0 * q * p22 * t * t * area;
    };
    std::vector<double> breaks;
    for (double q = 0.25; q < 8.0; q += 0.25) breaks.push_back(q);
    const double last = std::sqrt(std::log(1e7 / cotangent));
    return 1.0 / (1.0 + integratePieces(away, 0.0, last, breaks, {1e-5, 1e-8}, 4));
}

// The error that smith_fit.glsl states, at random places.
TEST(Distribution, FittedMaskingKeepsItsError) {
    Random random(5);
    for (const Kind& k : kinds) {
        double worst = 0.0;
        std::string where;
        for (int i = 0; i < (longTests() ? 20'000 : 1'500); ++i) {
            const float shape = k.lowest * std::pow(k.highest / std::max(k.lowest, 1e-3f),
                                                    random.uniform());
            const float t = random.uniform();
            const float alpha = i % 2 == 0 ? std::pow(1e-4f, t) : std::max(t, 1e-4f);
            const Distribution d = distributionOf(k.number, alpha, alpha,
                k.number == DISTRIBUTION_SHIFTED_GAMMA ? 3.0f * random.uniform() : shape);
            const double c = double(alpha) * std::exp(8.0 * double(random.uniform()) - 5.0);
            const double z = c / std::sqrt(1.0 + c * c);
            const vec3 w(dvec3(std::sqrt(1.0 - z * z), 0.0, z));
            const double g1 = 1.0 / (1.0 + double(distribution_lambda(d, w)));
            const double error = std::abs(g1 - exactG1(d, double(cotangent(w))));
            if (error <= worst) continue;
            worst = error;
            where = fmt::format("shape {} alpha {} cotangent {}", d.shape, alpha, c);
        }
        fmt::print("  {:18} G1 is off by at most {:.5f} at {}\n", k.name, worst, where);
        const double stated = k.number < DISTRIBUTION_GTR ? 1e-4
                            : k.number == DISTRIBUTION_EXPONENTIAL_POWER ? 0.003 : 0.0015;
        EXPECT_LT(worst, stated) << k.name << " " << where;
    }
}

TEST(Distribution, SamplesFollowTheirDensity) {
    struct Width { float x, y; };
    std::vector<Width> some = {{0.02f, 0.02f}, {0.9f, 0.9f}, {0.6f, 0.15f}};
    if (longTests()) some.insert(some.end(), {{1e-4f, 1e-4f}, {0.25f, 0.25f}, {0.05f, 1.0f}});
    Chi2Options options;
    options.testCount = 28 * some.size();
    for (const Kind& k : kinds) {
        for (const float shape : k.shapes) {
            for (const Width w : some) {
                const Distribution d = distributionOf(k.number, w.x, w.y, shape);
                options.name = fmt::format("normals {} {} {} {}", k.name, shape, w.x, w.y);
                options.seed += 1;
                SphereDomain domain;
                const Chi2Result result = chi2Sphere(options, domain,
                    [&](Random& random) {
                        const float x = random.uniform();
                        return distribution_sample(d, vec2(x, random.uniform()));
                    },
                    [&](vec3 wm) { return distribution_sample_pdf(d, wm); });
                EXPECT_TRUE(result.passed) << result.message;
                EXPECT_NEAR(result.pdfIntegral, 1.0, 2e-3) << options.name;
            }
        }
    }
}

TEST(Distribution, SamplingSurvivesTheEnds) {
    const float ends[] = {0.0f, 1e-7f, 0.5f, ONE_MINUS_EPSILON};
    for (const Kind& k : kinds) {
        for (const float shape : k.shapes) {
            for (const float alpha : widths) {
                const Distribution d = distributionOf(k.number, alpha, 0.5f * alpha, shape);
                for (int i = 0; i < 16; ++i) {
                    const vec3 wm = distribution_sample(d, vec2(ends[i % 4], ends[i / 4]));
                    ASSERT_NEAR(length(wm), 1.0f, 2e-6f) << k.name << " " << shape << " " << alpha;
                    ASSERT_GT(wm.z, 0.0f) << k.name << " " << shape << " " << alpha;
                    const float pdf = distribution_sample_pdf(d, wm);
                    ASSERT_TRUE(std::isfinite(pdf) && pdf >= 0.0f) << k.name << " " << shape;
                }
            }
        }
    }
}

TEST(Special, FunctionsAreAccurate) {
    for (double x = -20.0; x < 20.0; x += 0.0137) {
        const double exact = std::expm1(x) / x;
        ASSERT_NEAR(expm1_over(float(x)), exact, 3e-6 * exact) << x;
        if (x <= -0.999) continue;
        const double logarithm = std::log1p(double(float(x))) / double(float(x));
        ASSERT_NEAR(log1p_over(float(x)), logarithm, 2e-6 * logarithm) << x;
    }
    for (double a = 0.1; a < 20.0; a *= 1.05) {
        ASSERT_NEAR(log_gamma(float(a)), std::lgamma(double(float(a))), 5e-6 * (1.0 + a)) << a;
        const float logGamma = log_gamma(float(a));
        for (double x = 1e-4; x < 60.0; x *= 1.3) {
            const double exact = 1.0 - gammaQ(double(float(a)), double(float(x)));
            ASSERT_NEAR(gamma_p(float(a), float(x), logGamma), exact, 1e-5) << a << " " << x;
        }
        for (float p = 0.001f; p < 1.0f; p += 0.0173f) {
            const double x = double(gamma_p_inverse(float(a), p));
            ASSERT_NEAR(1.0 - gammaQ(double(float(a)), x), double(p), 1e-5) << a << " " << p;
        }
    }
}

}  // namespace
}  // namespace gp::test
