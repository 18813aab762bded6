// GGX and Beckmann: normalisation, masking, visible normals, and albedos against golden values.
#include <gtest/gtest.h>

#include "shading/shading.h"
#include "statistics/chi2.h"
#include "statistics/golden.h"

namespace gp::test {
namespace {

using namespace gp::shading;

struct Distribution {
    const char* name;
    float (*d)(vec3, float, float);
    float (*g1)(vec3, float, float);
    float (*g2Separable)(vec3, vec3, float, float);
    float (*g2Correlated)(vec3, vec3, float, float);
    float (*pdf)(vec3, vec3, float, float);
    vec3 (*sample)(vec3, float, float, vec2);
};
const Distribution distributions[] = {
    {"ggx", ggx_d, ggx_g1, ggx_g2_separable, ggx_g2_correlated, ggx_vndf_pdf, ggx_sample_vndf},
    {"beckmann", beckmann_d, beckmann_g1, beckmann_g2_separable, beckmann_g2_correlated,
     beckmann_vndf_pdf, beckmann_sample_vndf}};

struct Width {
    float x, y;
};
const Width widths[] = {{1e-4f, 1e-4f}, {0.01f, 0.01f}, {0.2f, 0.2f}, {1.0f, 1.0f}, {0.5f, 0.05f}};
const float cosines[] = {1.0f, 0.6f, 0.05f};

vec3 viewAt(float cosine) {
    const float r = std::sqrt(1.0f - cosine * cosine);
    return vec3(r * 0.8f, r * 0.6f, cosine);
}

vec2 uniform2(Random& random) {
    const float x = random.uniform();
    return vec2(x, random.uniform());
}

// The integral over the visible normals is also the weak white furnace: G1 keeps the projected
// area, for every width, angle and both distributions. [Heitz 2014, JCGT 3(2), section 4.2]
TEST(Microfacet, VisibleNormalsFollowTheirDensity) {
    Chi2Options options;
    options.testCount = std::size(distributions) * std::size(widths) * std::size(cosines);
    for (const Distribution& f : distributions) {
        for (const Width w : widths) {
            for (const float cosine : cosines) {
                const vec3 wo = viewAt(cosine);
                options.name = fmt::format("vndf {} {} {} cos {}", f.name, w.x, w.y, cosine);
                options.seed += 1;
                SphereDomain domain;
                domain.edges.push_back(dvec3(wo));  // nothing is visible beyond 90 degrees
                const Chi2Result result = chi2Sphere(
                    options, domain,
                    [&](Random& random) { return f.sample(wo, w.x, w.y, uniform2(random)); },
                    [&](vec3 wm) { return f.pdf(wo, wm, w.x, w.y); });
                EXPECT_TRUE(result.passed) << result.message;
                EXPECT_NEAR(result.pdfIntegral, 1.0, 2e-3) << options.name;
            }
        }
    }
}

// Integral over the hemisphere in slopes scaled by alpha, which suits every width.
template <class F>
double overNormals(const F& f, Width w) {
    return integrate([&](double t) {
        const double r = t / (1.0 - t);  // the whole plane
        return integrate([&](double phi) {
            const double x = double(w.x) * r * std::cos(phi), y = double(w.y) * r * std::sin(phi);
            const double z = 1.0 / std::sqrt(1.0 + x * x + y * y);
            const double plane = double(w.x) * double(w.y) * r / ((1.0 - t) * (1.0 - t));
            return f(vec3(dvec3(x * z, y * z, z))) * plane * z * z * z;
        }, 0.0, 2.0 * M_PI, {1e-6, 1e-9}, 6);
    }, 0.0, 1.0 - 1e-7, {1e-6, 1e-9}, 10);
}

TEST(Microfacet, AreaProjectsToOne) {
    for (const Distribution& f : distributions) {
        for (const Width w : widths) {
            const double area = overNormals([&](vec3 wm) {
                return double(f.d(wm, w.x, w.y)) * double(wm.z);
            }, w);
            EXPECT_NEAR(area, 1.0, 1e-4) << f.name << " " << w.x << " " << w.y;
        }
    }
}

// The weak white furnace of every masking function by itself: what is visible projects to cos.
TEST(Microfacet, MaskingPassesTheWeakWhiteFurnace) {
    struct Masking {
        const char* name;
        float (*d)(vec3, float, float);
        float (*lambda)(vec3, float, float);
        double tolerance;
    };
    const Masking maskings[] = {
        {"ggx", ggx_d, ggx_lambda, 1e-4},
        {"beckmann", beckmann_d, beckmann_lambda, 1e-4},
        {"beckmann rational", beckmann_d, beckmann_lambda_rational, 5e-3}};  // the fit's own error
    for (const Masking& m : maskings) {
        for (const Width w : widths) {
            for (const float cosine : cosines) {
                const vec3 wo = viewAt(cosine);
                const double g1 = 1.0 / (1.0 + double(m.lambda(wo, w.x, w.y)));
                const double visible = overNormals([&](vec3 wm) {
                    return std::max(double(dot(wo, wm)), 0.0) * double(m.d(wm, w.x, w.y));
                }, w);
                EXPECT_NEAR(visible * g1 / double(cosine), 1.0, m.tolerance)
                    << m.name << " " << w.x << " " << w.y << " cos " << cosine;
            }
        }
    }
}

TEST(Microfacet, MaskingFormsAgree) {
    Random random(8);
    for (int i = 0; i < 20'000; ++i) {
        const vec3 wo = square_to_uniform_hemisphere(uniform2(random));
        const vec3 wi = square_to_uniform_hemisphere(uniform2(random));
        if (wo.z < 1e-3f || wi.z < 1e-3f) continue;
        const float ax = std::exp2(-10.0f * random.uniform());
        const float ay = std::exp2(-10.0f * random.uniform());
        const float lo = ggx_lambda(wo, ax, ay), li = ggx_lambda(wi, ax, ay);
        ASSERT_NEAR(ggx_g1(wo, ax, ay), 1.0f / (1.0f + lo), 2e-6f);
        ASSERT_NEAR(ggx_g2_correlated(wo, wi, ax, ay), 1.0f / (1.0f + lo + li), 2e-6f);
        ASSERT_LE(ggx_g2_separable(wo, wi, ax, ay), ggx_g2_correlated(wo, wi, ax, ay) + 1e-6f);
        ASSERT_NEAR(beckmann_lambda(wo, ax, ay), beckmann_lambda_rational(wo, ax, ay),
                    0.02f * beckmann_lambda(wo, ax, ay) + 0.005f);
    }
}

TEST(Microfacet, SpecialFunctionsAreAccurate) {
    for (float x = 0.0f; x < 6.0f; x += 0.001f) {
        const double exact = std::exp(double(x) * x) * std::erfc(double(x));
        ASSERT_NEAR(erfcx_positive(x), exact, 1e-6 * exact) << x;
        ASSERT_NEAR(erf_approximation(-x), -std::erf(x), 1e-6f) << x;
    }
    for (float y = -0.9999f; y < 1.0f; y += 1e-4f) {
        ASSERT_NEAR(std::erf(double(erf_inverse(y))), double(y), 1e-6) << y;
    }
}

// Mean of G2 / G1 over the visible normals: the albedo of a white surface. The points are
// Hammersley's, as the integrand jumps at the horizon, which a grid would meet row by row.
double albedoOf(const Distribution& f, bool correlated, float alpha, float cosine) {
    const int n = longTests() ? 1 << 18 : 1 << 15;
    const vec3 wo(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        float inverse = 0.0f;
        for (int bits = i, digit = 1; bits > 0; bits /= 2, ++digit) {
            inverse += std::ldexp(static_cast<float>(bits % 2), -digit);
        }
        const vec2 u(inverse, (static_cast<float>(i) + 0.5f) / static_cast<float>(n));
        const vec3 wi = reflect(-wo, f.sample(wo, alpha, alpha, u));
        if (wi.z <= 0.0f) continue;
        const float g2 = correlated ? f.g2Correlated(wo, wi, alpha, alpha)
                                    : f.g2Separable(wo, wi, alpha, alpha);
        sum += double(g2 / f.g1(wo, alpha, alpha));
    }
    return sum / double(n);
}

TEST(Microfacet, AlbedoMatchesGoldenValues) {
    const std::vector<GoldenRow> rows = readGolden("golden_albedo.csv");
    GP_SKIP_WITHOUT(rows, "golden_albedo.csv");
    for (const GoldenRow& row : rows) {
        const Distribution& f = distributions[row.at("ndf") == "ggx" ? 0 : 1];
        const double e = albedoOf(f, row.at("g2") == "heightcorr", number(row, "alpha"),
                                  number(row, "mu"));
        EXPECT_NEAR(e, double(number(row, "E")), 5e-4)
            << row.at("ndf") << " " << row.at("g2") << " " << row.at("alpha") << " "
            << row.at("mu");
    }
    EXPECT_NEAR(albedoOf(distributions[0], true, 1.0f, 1.0f), 1.0 - std::log(2.0), 2e-4);
}

// f = D F G2 / (4 cos cos) with the exact dielectric F, term by term from our functions.
TEST(Microfacet, ReflectionMatchesGoldenValues) {
    const std::vector<GoldenRow> rows = readGolden("golden_bbm.csv");
    GP_SKIP_WITHOUT(rows, "golden_bbm.csv");
    int compared = 0;
    for (const GoldenRow& row : rows) {
        const std::string& model = row.at("model");
        const bool ggx = model.starts_with("ggx_iso_smith");
        if (!ggx && model.find("smithrational") == std::string::npos) continue;
        const vec3 l(number(row, "lx"), number(row, "ly"), number(row, "lz"));
        const vec3 v(number(row, "vx"), number(row, "vy"), number(row, "vz"));
        const float ax = jsonNumber(row.at("params"), "alpha_x");
        const float ay = jsonNumber(row.at("params"), "alpha_y");
        const vec3 h = normalize(l + v);
        const auto lambda = ggx ? ggx_lambda : beckmann_lambda_rational;
        const float lo = lambda(v, ax, ay), li = lambda(l, ax, ay);
        const bool correlated = model.find("heightcorr") != std::string::npos;
        const float g2 = correlated ? 1.0f / (1.0f + lo + li) : 1.0f / ((1.0f + lo) * (1.0f + li));
        const float d = ggx ? ggx_d(h, ax, ay) : beckmann_d(h, ax, ay);
        const float f = fresnel_dielectric(dot(v, h), jsonNumber(row.at("params"), "ior"));
        const double value = double(d * f * g2 / (4.0f * l.z * v.z));
        const double golden = std::strtod(row.at("r").c_str(), nullptr);
        const bool hard = std::min(ax, ay) < 0.01f || std::min(l.z, v.z) < 0.01f;
        // Out in a Gaussian's tail an error of the slope counts tan^2 / alpha^2 fold.
        const float slope2 = (h.x * h.x / (ax * ax) + h.y * h.y / (ay * ay)) / (h.z * h.z);
        const double tail = ggx ? 0.0 : 2e-6 * double(slope2);
        ASSERT_NEAR(value, golden, (hard ? 1e-2 : 1e-3 + tail) * golden + 1e-5)
            << model << " row " << compared;
        ++compared;
    }
    EXPECT_EQ(compared, 1000);
}

// The errors that ggx_albedo.glsl and sheen.glsl state.
TEST(Microfacet, AlbedoFitsKeepTheirErrors) {
    double white = 0.0, average = 0.0;
    for (const float alpha : {0.01f, 0.05f, 0.12f, 0.3f, 0.45f, 0.6f, 0.9f, 1.0f}) {
        double sum = 0.0;
        for (int i = 0; i < 20; ++i) {
            const float cosine = (static_cast<float>(i) + 0.5f) / 20.0f;
            const double e = albedoOf(distributions[0], true, alpha, cosine);
            white = std::max(white, std::abs(double(ggx_albedo(cosine, alpha).white) - e));
            sum += 2.0 * double(cosine) * e / 20.0;
        }
        average = std::max(average, std::abs(double(ggx_albedo_average(alpha).white) - sum));
    }
    EXPECT_LT(white, 0.0064);
    EXPECT_LT(average, 0.0025);
    double sheen = 0.0;
    for (const float alpha : {0.07f, 0.15f, 0.33f, 0.6f, 1.0f}) {
        for (const float cosine : {0.01f, 0.1f, 0.35f, 0.6f, 0.9f, 1.0f}) {
            const double e = integrate([&](double z) {
                return integrate([&](double phi) {
                    const double r = std::sqrt(1.0 - z * z);
                    const vec3 wi(dvec3(r * std::cos(phi), r * std::sin(phi), z));
                    const vec3 wo(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
                    return double(sheen_f_cos(wo, wi, alpha));
                }, 0.0, 2.0 * M_PI, {1e-4, 1e-6}, 6);
            }, 1e-6, 1.0, {1e-4, 1e-6}, 8);
            sheen = std::max(sheen, std::abs(double(sheen_albedo_white(cosine, alpha)) - e));
            EXPECT_LT(e, 1.0 + 1e-3) << alpha << " " << cosine;
        }
    }
    EXPECT_LT(sheen, 0.009);
}

}  // namespace
}  // namespace gp::test
