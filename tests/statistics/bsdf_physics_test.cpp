// Every model of models.def: reciprocity, conservation of energy, and the albedo by two ways.
#include <gtest/gtest.h>

#include "statistics/bsdf_cases.h"
#include "statistics/chi2.h"

namespace gp::test {
namespace {

class BsdfPhysics : public testing::TestWithParam<BsdfCase> {};

// f(wo, wi) / eta_o^2, the quantity that does not change when light goes the other way.
double reciprocalValue(const BsdfCase& c, vec3 wo, vec3 wi) {
    const double eta = c.iorAt(wo);
    return static_cast<double>(bsdf_eval(c.params, wo, wi).f_cos.y)
         / (std::abs(static_cast<double>(c.sideOf(wi))) * eta * eta);
}

TEST_P(BsdfPhysics, IsReciprocal) {
    const BsdfCase& c = GetParam();
    if ((c.flags & BSDF_RECIPROCAL) == 0u) GTEST_SKIP() << "not claimed for this case";
    Random random(5);
    int compared = 0;
    for (int i = 0; i < 40'000; ++i) {
        const float x = random.uniform();
        vec3 wo = square_to_uniform_sphere(vec2(x, random.uniform()));
        if (!c.transmits()) wo.z = std::abs(wo.z);
        // Half of the pairs are samples, as random ones never meet a narrow lobe.
        vec3 wi = drawSample(c.params, wo, random).wi;
        const float y = random.uniform();
        if (i % 2 == 0) wi = square_to_uniform_sphere(vec2(y, random.uniform()));
        if (std::abs(c.sideOf(wi)) < 0.01f || std::abs(c.sideOf(wo)) < 0.01f) continue;
        const double forwards = reciprocalValue(c, wo, wi);
        const double backwards = reciprocalValue(c, wi, wo);
        // The half vector of a refraction is a difference: it has fewer digits, the more so the
        // nearer the index is to 1 and the narrower the lobe. Inside, the Fresnel term rises like a
        // square root towards the critical angle: an error of 1e-7 there is one of 1e-3.
        const double step = std::abs(c.iorAt(vec3(0, 0, -1)) - 1.0);
        const bool refracts = c.solid && (c.sideOf(wi) > 0.0f) != (c.sideOf(wo) > 0.0f);
        const double alpha = std::min(c.params.alpha_x, c.params.alpha_y);
        const double tolerance = (c.solid ? 2e-3 : 1e-4) + 1e-6 / alpha
                               + (refracts ? 4e-6 / (alpha * step) : 0.0);
        // 1 - F ends at the rounding error of 1, hence the absolute part.
        ASSERT_NEAR(forwards, backwards, tolerance * std::max(forwards, backwards) + 3e-7)
            << c.name << " wo.z " << wo.z << " wi.z " << wi.z;
        if (forwards > 0.0) ++compared;
    }
    EXPECT_GT(compared, 5'000);
}

// Share of the energy that leaves again: radiance that crossed the boundary is brought back from
// (eta_o / eta_i)^2 to power.
double energyFactor(const BsdfCase& c, vec3 wo, vec3 wi) {
    const double ratio = double(c.iorAt(wi)) / double(c.iorAt(wo));
    return ratio * ratio;
}

struct Estimate {
    dvec3 mean{0.0};
    dvec3 error{0.0};
};

Estimate albedoBySampling(const BsdfCase& c, vec3 wo, int samples) {
    Random random(99);
    dvec3 sum(0.0), squares(0.0);
    for (int i = 0; i < samples; ++i) {
        const BsdfSample s = drawSample(c.params, wo, random);
        const dvec3 w = dvec3(s.weight) * energyFactor(c, wo, s.wi);
        sum += w;
        squares += w * w;
    }
    Estimate e;
    e.mean = sum / double(samples);
    e.error = sqrt(max(squares / double(samples) - e.mean * e.mean, dvec3(0.0)) / double(samples));
    return e;
}

double albedoByQuadrature(const BsdfCase& c, vec3 wo) {
    double sum = 0.0;
    for (const int hemisphere : hemispheresOf(c, wo)) {
        SphereDomain domain;
        domain.hemisphere = hemisphere;
        domain.edges = c.edges();
        Chi2Options options;
        options.seed = 3;
        auto sample = [&](Random& random) {
            const BsdfSample s = drawSample(c.params, wo, random);
            return s.pdf > 0.0f ? s.wi : vec3(0.0f);
        };
        auto pdf = [&](vec3 wi) { return bsdf_eval(c.params, wo, wi).pdf; };
        const SphereGrid grid = pilotGrid(options, domain, sample, pdf);
        for (std::size_t i = 0; i < grid.cellCount(); ++i) {
            sum += grid.cellProbability(i, [&](vec3 wi) {
                return bsdf_eval(c.params, wo, wi).f_cos.x * energyFactor(c, wo, wi);
            });
        }
    }
    return sum;
}

TEST_P(BsdfPhysics, AlbedoBySamplingIsThatByQuadrature) {
    const BsdfCase& c = GetParam();
    for (const vec3& wo : viewsOf(c)) {
        const Estimate sampled = albedoBySampling(c, wo, 200'000);
        EXPECT_NEAR(sampled.mean.x, albedoByQuadrature(c, wo), 5.0 * sampled.error.x + 2e-3)
            << c.name << " wo.z " << wo.z;
        // Sampling that is any good has weights near the albedo.
        EXPECT_LT(sampled.error.x, 0.005) << c.name << " wo.z " << wo.z;
    }
}

TEST_P(BsdfPhysics, ReturnsNoMoreLightThanItGets) {
    BsdfCase c = GetParam();
    if ((c.flags & BSDF_CONSERVING) == 0u) GTEST_SKIP() << "not claimed for this case";
    // White everything: what is lost then is lost by the model.
    if (c.white) c.params.base_color = vec3(1.0f);
    std::vector<vec3> views = viewsOf(c);
    for (const float z : {0.3f, 0.05f, 0.02f}) {
        views.push_back(vec3(std::sqrt(1.0f - z * z), 0.0f, z));
    }
    for (const vec3& wo : views) {
        const Estimate e = albedoBySampling(c, wo, 60'000);
        const double largest = std::max({e.mean.x, e.mean.y, e.mean.z});
        const double error = std::max({e.error.x, e.error.y, e.error.z});
        // The fits of albedos that split the light among layers are off by up to 0.007.
        EXPECT_LT(largest, 1.0 + 0.008 + 4.0 * error) << c.name << " wo.z " << wo.z;
        // GP_PRINT_ALBEDO=1 gives the table of albedo per angle, with the estimate for guides.
        if (std::getenv("GP_PRINT_ALBEDO") != nullptr) {
            fmt::print("albedo {:40} {:7.3f} {:.4f} +- {:.4f} guide {:.4f}\n", c.name, wo.z,
                       largest, error, bsdf_albedo(c.params, wo.z).x);
        }
    }
}

std::string caseName(const testing::TestParamInfo<BsdfCase>& info) {
    std::string name = info.param.name;
    for (char& ch : name) {
        if (std::isalnum(static_cast<unsigned char>(ch)) == 0) ch = '_';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Models, BsdfPhysics, testing::ValuesIn(bsdfCases()), caseName);

}  // namespace
}  // namespace gp::test
