// Facets that are counted and facets that are drawn: one density, for counting and for Zirr and
// Kaplanyan's cells; how much of it there is in all.
#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/glint/zirr.glsl"
GP_SHADING_END

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "statistics/chi2.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;

struct Method {
    const char* name;
    CountedFacets (*facets)(const Glint&, vec2);
    vec2 (*sample)(const Glint&, vec2, float);
};
const Method methods[] = {{"counting", glint_counting, glint_counting_sample},
                          {"zirr", glint_zirr, glint_zirr_sample}};

// A pixel with this many facets, twice as long as wide.
Glint pixelOf(float facets) {
    Glint g{};
    g.slopes.mean = vec2(0.1f, -0.05f);
    g.slopes.var_x = 0.04f, g.slopes.var_y = 0.02f, g.slopes.cov = 0.012f;
    g.uv = vec2(0.3f, 0.7f);
    g.d0 = vec2(0.02f, 0.006f), g.d1 = vec2(-0.003f, 0.01f);
    g.log_density = std::log(facets / 2.18e-4f);
    g.area = 1;
    g.seed = 5;
    return g;
}

struct Case {
    std::string name;
    Glint glint;
};

std::vector<Case> cases() {
    std::vector<Case> all{{"many facets", pixelOf(20000)}, {"some", pixelOf(300)},
                          {"few", pixelOf(5)},             {"shared", pixelOf(1000)},
                          {"kernel", pixelOf(1000)},       {"jitter", pixelOf(1000)},
                          {"smooth", pixelOf(1e12f)}};
    all[3].glint.area = 0.3f;
    all[4].glint.k0 = vec2(0.1f, 0.02f), all[4].glint.k1 = vec2(-0.03f, 0.08f);
    all[5].glint.jitter = 1.5f;
    return all;
}

Glint elsewhere(Glint g, Random& random) {
    g.uv = vec2(random.uniform(), random.uniform()) * 1000.0f;
    return g;
}

// Over a square of slopes, by so many midpoints each way of a cell: adaptive quadrature is slow
// where densities have steps.
Chi2Result testOf(const Method& m, const Glint& g, const Chi2Options& options, int points) {
    constexpr int side = 20;
    const dvec2 reach = 2.5 * sqrt(dvec2(g.slopes.var_x, g.slopes.var_y));
    const dvec2 corner = dvec2(g.slopes.mean) - reach, step = 2.0 * reach / double(side);
    Chi2Table table;
    table.observed.assign(side * side + 1, 0.0);
    table.expected = table.observed;
    Random random(options.seed);
    for (size_t i = 0; i < options.samples; ++i) {
        const float x = random.uniform(), y = random.uniform();
        const dvec2 at = (dvec2(m.sample(g, vec2(x, y), random.uniform())) - corner) / step;
        const bool inside = at.x >= 0 && at.y >= 0 && at.x < side && at.y < side;
        table.observed[inside ? size_t(at.x) * side + size_t(at.y) : side * side] += 1;
    }
    double total = 0;
    const double part = step.x * step.y / (points * points);
    for (int x = 0; x < side * points; ++x)
        for (int y = 0; y < side * points; ++y) {
            const dvec2 s = corner + step * (dvec2(x, y) + 0.5) / double(points);
            const CountedFacets found = m.facets(g, vec2(s));
            const double probability = double(found.p22 / found.whole) * part;
            table.expected[size_t(x / points * side + y / points)] +=
                double(options.samples) * probability;
            total += probability;
        }
    table.expected.back() = double(options.samples) * std::max(0.0, 1 - total);
    EXPECT_NEAR(total, 1 - table.observed.back() / double(options.samples), 4e-3) << options.name;
    return chi2Test(options, table);
}

TEST(CountingSampling, HasTheDensityThatIsCounted) {
    const std::vector<Case> all = cases();
    for (const Method& m : methods)
        for (size_t i = 0; i < all.size(); ++i) {
            // Both methods draw by the same trees, and a quadrature takes seconds.
            if (!longTests() && i != 2 && (&m == &methods[1] || (i != 1 && i != 4))) continue;
            Random random(3);
            Glint g = all[i].glint;
            // A place that has facets.
            while (!(m.facets(g, g.slopes.mean).whole > 0.1f)) g = elsewhere(g, random);
            Chi2Options options;
            options.name = std::string(m.name) + ", " + all[i].name;
            options.samples = longTests() ? 400'000 : 25'000;
            options.testCount = 14;
            const int points = (longTests() ? 24 : 10) * (all[i].name == "few" ? 3 : 1);
            const Chi2Result r = testOf(m, g, options, points);
            EXPECT_TRUE(r.passed) << r.message;
        }
}

// The integral over all slopes is `whole`, by samples of the smooth surface.
TEST(CountingSampling, WholeIsTheIntegralOverSlopes) {
    for (const Method& m : methods)
        for (const float facets : {20000.0f, 300.0f, 20.0f}) {
            Random random(7);
            for (int place = 0; place < 3; ++place) {
                const Glint g = elsewhere(pixelOf(facets), random);
                double sum = 0, squares = 0, whole = 0;
                const int n = longTests() ? 60000 : 12000;
                for (int i = 0; i < n; ++i) {
                    const float x = random.uniform();
                    const vec2 s = slopes_sample(g.slopes, vec2(x, random.uniform()));
                    const CountedFacets found = m.facets(g, s);
                    const double w = double(found.p22 / slopes_p22(g.slopes, s));
                    sum += w / n, squares += w * w / n, whole = double(found.whole);
                }
                const double error = std::sqrt((squares - sum * sum) / n);
                EXPECT_NEAR(sum, whole, 5 * error + 2e-3) << m.name << ' ' << facets;
            }
        }
}

// Pixels with facets enough reflect what they get; with few of them it is 1 on average.
TEST(CountingSampling, EnergyIsKeptWhereThereAreFacetsEnough) {
    for (const Method& m : methods)
        for (const float facets : {1.0f, 10.0f, 100.0f, 1000.0f}) {
            Random random(11);
            double sum = 0, squares = 0;
            constexpr int n = 20000;
            for (int i = 0; i < n; ++i) {
                const Glint g = elsewhere(pixelOf(facets), random);
                const double whole = double(m.facets(g, g.slopes.mean).whole);
                sum += whole / n, squares += whole * whole / n;
                ASSERT_NEAR(whole, 1, facets < 1000 ? 30 : 0.05);
            }
            const double variance = std::max(squares - sum * sum, 0.0);
            EXPECT_NEAR(sum, 1, 4 * std::sqrt(variance / n) + 1e-3) << m.name << ' ' << facets;
            // Of a binomial number of facets, four mirrored ones together.
            EXPECT_LT(variance, 4 / double(facets)) << m.name << ' ' << facets;
            EXPECT_LT(variance, facets < 100 ? 4.0 : 0.01) << m.name << ' ' << facets;
        }
}

TEST(CountingSampling, AnyNumbersGiveASlope) {
    const float values[] = {0.0f, -3.7f, 1e-20f, 1e20f, NAN, INFINITY, -INFINITY};
    Random random(4);
    const auto any = [&] { return values[size_t(random.uniform() * 7)]; };
    for (int i = 0; i < 50000; ++i) {
        Glint g = pixelOf(100);
        if (i % 5 == 0) g.log_density = any();
        if (i % 5 == 1) g.d0 = vec2(any(), any()), g.d1 = vec2(any(), any());
        if (i % 5 == 2) g.uv = vec2(any(), any());
        if (i % 5 == 3) g.jitter = any(), g.area = any();
        if (i % 5 == 4) g.k0 = vec2(any(), any()), g.k1 = vec2(any(), any());
        for (const Method& m : methods) {
            const vec2 s = m.sample(g, vec2(random.uniform(), random.uniform()),
                                    i % 2 == 0 ? random.uniform() : 0.99999994f);
            ASSERT_TRUE(std::isfinite(s.x + s.y)) << m.name << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace gp::test
