// Samples of glints have the density that they say.
#include <gtest/gtest.h>

#include "statistics/chi2.h"
#include "water/glint_cases.h"

namespace {

using namespace gp::shading;
using gp::test::NamedGlint;
using gp::test::Random;

TEST(GlintSampling, HasTheDensityOfP22) {
    const std::vector<NamedGlint> cases = gp::test::glintCases();
    for (size_t i = 0; i < cases.size(); ++i) {
        // The quadrature of a case takes two seconds.
        if (!gp::test::longTests() && i != 0 && i != 2 && i != 4 && i != 7) continue;
        const NamedGlint& c = cases[i];
        const Glint& g = c.glint;
        gp::test::Chi2Options options;
        options.name = "glint " + c.name;
        options.samples = gp::test::longTests() ? 4'000'000 : 300'000;
        options.testCount = cases.size();
        const dvec2 reach = 2.5 * sqrt(dvec2(g.slopes.var_x, g.slopes.var_y));
        const gp::Chi2Result r = gp::chi2Rectangle(
            options, dvec2(g.slopes.mean) - reach, dvec2(g.slopes.mean) + reach,
            [&](Random& random) {
                const float x = random.uniform(), y = random.uniform();
                return glint_sample(g, vec2(x, y), random.uniform());
            },
            [&](vec2 s) { return glint_p22(g, s); });
        EXPECT_TRUE(r.passed) << r.message;
        EXPECT_NEAR(r.pdfIntegral, r.acceptedFraction, 4e-3) << c.name;
    }
}

}  // namespace
