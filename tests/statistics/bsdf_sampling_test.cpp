// Every model of models.def: do its samples follow its density, and do sample and eval agree?
#include <gtest/gtest.h>

#include "statistics/bsdf_cases.h"
#include "statistics/chi2.h"

namespace gp::test {
namespace {

const std::vector<BsdfCase> allCases = bsdfCases();

std::size_t chi2TestCount() {
    std::size_t count = 0;
    for (const BsdfCase& c : allCases) {
        for (const vec3& wo : viewsOf(c)) count += hemispheresOf(c, wo).size();
    }
    return count;
}

class BsdfSampling : public testing::TestWithParam<BsdfCase> {};

SphereDomain domainOf(const BsdfCase& c, int hemisphere) {
    SphereDomain domain;
    domain.hemisphere = hemisphere;
    domain.edges = c.edges();
    return domain;
}

TEST_P(BsdfSampling, FollowsItsDensity) {
    const BsdfCase& c = GetParam();
    Chi2Options options;
    options.testCount = chi2TestCount();
    for (const vec3& wo : viewsOf(c)) {
        double integral = 0.0, accepted = 0.0;
        for (const int hemisphere : hemispheresOf(c, wo)) {
            options.name = fmt::format("{} wo.z {:.3f} side {}", c.name, wo.z, hemisphere);
            options.seed += 1;
            const Chi2Result result = chi2Sphere(
                options, domainOf(c, hemisphere),
                [&](Random& random) {
                    const BsdfSample s = drawSample(c.params, wo, random);
                    return s.pdf > 0.0f ? s.wi : vec3(0.0f);
                },
                [&](vec3 wi) { return bsdf_eval(c.params, wo, wi).pdf; });
            if (result.acceptedFraction < 1e-4) {
                // Practically nothing goes there, as through a narrow lobe past the critical angle.
                EXPECT_LT(result.pdfIntegral, 2e-4) << result.message;
            } else {
                EXPECT_TRUE(result.passed) << result.message;
            }
            integral += result.pdfIntegral;
            accepted += result.acceptedFraction;
        }
        const double n = static_cast<double>(options.samples);
        const double sigma = std::sqrt(std::max(accepted * (1.0 - accepted), 1e-6) / n);
        EXPECT_NEAR(integral, accepted, 5.0 * sigma + 1e-3) << c.name << " wo.z " << wo.z;
    }
}

// One evaluation must give what sample() promised, and no light may come from where no sample goes.
TEST_P(BsdfSampling, WeightIsValueOverDensity) {
    const BsdfCase& c = GetParam();
    Random random(17);
    for (const vec3& wo : viewsOf(c)) {
        for (int i = 0; i < 20'000; ++i) {
            const BsdfSample s = drawSample(c.params, wo, random);
            const vec3 w = s.weight;
            ASSERT_TRUE(std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z));
            ASSERT_TRUE(std::isfinite(s.pdf) && s.pdf >= 0.0f);
            ASSERT_TRUE(w.x >= 0.0f && w.y >= 0.0f && w.z >= 0.0f);
            if (s.pdf <= 0.0f) {
                ASSERT_EQ(w, vec3(0.0f));
                continue;
            }
            ASSERT_NEAR(length(s.wi), 1.0f, 2e-6f);
            ASSERT_NE(s.lobe, 0u);
            const bool crosses = (c.sideOf(s.wi) > 0.0f) != (c.sideOf(wo) > 0.0f);
            ASSERT_EQ((s.lobe & LOBE_TRANSMISSION) != 0u, crosses) << c.name;
            const BsdfValue v = bsdf_eval(c.params, wo, s.wi);
            ASSERT_NEAR(v.pdf, s.pdf, 1e-5f * s.pdf) << c.name;
            ASSERT_NEAR(v.f_cos.x, w.x * s.pdf, 1e-4f * v.f_cos.x + 1e-9f) << c.name;
        }
        for (int i = 0; i < 20'000; ++i) {
            const float x = random.uniform();
            const BsdfValue v = bsdf_eval(c.params, wo,
                                          square_to_uniform_sphere(vec2(x, random.uniform())));
            ASSERT_TRUE(v.pdf > 0.0f || v.f_cos == vec3(0.0f)) << c.name;
            ASSERT_TRUE(std::isfinite(v.pdf) && std::isfinite(v.f_cos.x + v.f_cos.y + v.f_cos.z));
        }
    }
}

// Views and random numbers at the ends of their ranges must not make a NaN.
TEST_P(BsdfSampling, SurvivesExtremes) {
    const BsdfCase& c = GetParam();
    const float ends[] = {0.0f, 1e-7f, 0.5f, ONE_MINUS_EPSILON};
    for (const float z : {1.0f, 1e-3f, 1e-6f, 1e-20f, 0.0f, -1e-20f, -1e-6f, -1e-3f, -1.0f}) {
        const vec3 wo(0.0f, std::sqrt(1.0f - z * z), z);
        for (int i = 0; i < 64; ++i) {
            const BsdfSample s = bsdf_sample(c.params, wo, ends[i % 4],
                                             vec2(ends[i / 4 % 4], ends[i / 16]));
            ASSERT_TRUE(std::isfinite(s.pdf) && s.pdf >= 0.0f) << c.name << " " << z << " " << i;
            // Published formulas that divide by a cosine alone are cut off at one of 1e-6.
            const bool bounded = (c.flags & BSDF_CONSERVING) != 0u;
            ASSERT_TRUE(s.weight.x >= 0.0f && s.weight.x < (bounded ? 1e3f : 1e8f))
                << c.name << " " << z << " " << i;
            const vec3 albedo = bsdf_albedo(c.params, z);
            ASSERT_TRUE(albedo.x >= 0.0f && albedo.x < (bounded ? 1.01f : 1e8f))
                << c.name << " " << z;
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

INSTANTIATE_TEST_SUITE_P(Models, BsdfSampling, testing::ValuesIn(allCases), caseName);

}  // namespace
}  // namespace gp::test
