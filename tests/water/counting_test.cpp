// Glints by counting, and Zirr and Kaplanyan's for comparison: the binomial's mean and variance,
// whatever the footprint; no jumps between its grids; symmetry; any input.
#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/glint/zirr.glsl"
GP_SHADING_END

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "statistics/random.h"

namespace gp {
namespace {

using namespace gp::shading;

Glint glintOf(float logDensity, vec2 d0, vec2 d1) {
    Glint g{};
    g.slopes.mean = vec2(0.1f, -0.05f);
    g.slopes.var_x = 0.02f, g.slopes.var_y = 0.01f, g.slopes.cov = 0.006f;
    g.d0 = d0, g.d1 = d1;
    g.log_density = logDensity, g.area = 1;
    g.seed = 5;
    return g;
}

// A slope at this many deviations from the mean.
vec2 slopeAt(const Glint& g, vec2 z) {
    const float x = std::sqrt(g.slopes.var_x), xy = g.slopes.cov / x;
    return g.slopes.mean +
           vec2(x * z.x, xy * z.x + std::sqrt(g.slopes.var_y - xy * xy) * z.y);
}

struct Statistics {
    double mean = 0, variance = 0, error = 0;  // over Beckmann; error: of the mean, standard
};

// Over pixels anywhere, directions of their footprints included, and slopes near s: averaged over
// where grids and slope cells lie.
Statistics statisticsOf(Glint g, vec2 z, bool turned, int count,
                        CountedFacets (*method)(const Glint&, vec2) = glint_counting) {
    test::Random random(11);
    double sum = 0, squares = 0;
    const vec2 d0 = g.d0, d1 = g.d1;
    for (int i = 0; i < count; ++i) {
        g.uv = vec2(random.uniform(), random.uniform()) * 1000.0f;
        if (turned) {
            const float a = TWO_PI * random.uniform(), c = std::cos(a), s = std::sin(a);
            g.d0 = vec2(c * d0.x - s * d0.y, s * d0.x + c * d0.y);
            g.d1 = vec2(c * d1.x - s * d1.y, s * d1.x + c * d1.y);
        }
        const vec2 s = slopeAt(g, z);
        const double ratio = double(method(g, s).p22) / double(slopes_p22(g.slopes, s));
        sum += ratio, squares += ratio * ratio;
    }
    Statistics r;
    r.mean = sum / count;
    r.variance = squares / count - r.mean * r.mean;
    r.error = std::sqrt(r.variance / count);
    return r;
}

// The variance over the squared mean of a binomial number of n facets.
double binomialVariance(const Glint& g, vec2 z, double n, double slopeArea) {
    const double p = double(slopes_p22(g.slopes, slopeAt(g, z))) * slopeArea;
    return (1 - p) / (n * p);
}

double facetSlopeArea(const Glint& g) {
    const double cov = g.slopes.cov, det = double(g.slopes.var_x) * g.slopes.var_y - cov * cov;
    return 4 * 3.14159265 * 0.0566 * 0.0566 * std::sqrt(det);
}

TEST(Counting, MeanIsBeckmannAndVarianceThatOfTheBinomial) {
    const struct { vec2 d0, d1; } shapes[] = {
        {{0.1f, 0}, {0, 0.1f}},          // a square
        {{0.13f, 0.02f}, {0.05f, 0.09f}},
        {{0.8f, 0.3f}, {-0.01f, 0.05f}}, // 17 to 1
    };
    for (const auto& shape : shapes)
        for (const float facets : {3.0f, 100.0f, 3000.0f, 100000.0f})
            for (const vec2 z : {vec2(0), vec2(1, 0.5f), vec2(-1.5f, 1)}) {
                const float area = std::abs(shape.d0.x * shape.d1.y - shape.d0.y * shape.d1.x);
                const Glint g = glintOf(std::log(facets / area), shape.d0, shape.d1);
                // Nothing is narrower than a facet.
                const FootprintEllipse e = footprint_ellipse(shape.d0, shape.d1);
                const float spacing = std::sqrt(area / facets);
                const double seen = double(facets / area * std::max(e.major, spacing) *
                                           std::max(e.minor, spacing));
                // Sparse glints are rare and bright: as many pixels as 1 % needs.
                const double expected = binomialVariance(g, z, seen, facetSlopeArea(g));
                const int count = int(std::clamp(expected / 1e-4, 3000.0, 150000.0));
                const Statistics r = statisticsOf(g, z, true, count);
                EXPECT_NEAR(r.mean, 1, std::max(0.02, 4 * r.error)) << facets << " facets";
                // The soft edge of facets takes up to an eighth of the variance.
                EXPECT_NEAR(r.variance / expected, 0.95, 0.12 + 8 / std::sqrt(count))
                    << facets << " facets at " << z.x;
            }
}

TEST(Counting, WiderKernelsFewerThanOneFacetAndJitterKeepTheMean) {
    Glint kernel = glintOf(std::log(1e5f), vec2(0.1f, 0), vec2(0, 0.1f));
    kernel.k0 = vec2(0.08f, 0.01f), kernel.k1 = vec2(-0.01f, 0.05f);
    const Statistics wide = statisticsOf(kernel, vec2(0.5f), true, 20000);
    EXPECT_NEAR(wide.mean, 1, 0.02);
    kernel.k0 = kernel.k1 = vec2(0);
    const Statistics narrow = statisticsOf(kernel, vec2(0.5f), true, 100000);
    EXPECT_LT(wide.variance, 0.5 * narrow.variance);

    // A pixel inside of a facet sees that one: as if it were as large as the facet.
    const Glint close = glintOf(std::log(1e4f), vec2(1e-5f, 0), vec2(0, 1e-5f));
    const Statistics one = statisticsOf(close, vec2(0.3f), true, 400000);
    EXPECT_NEAR(one.mean, 1, 4 * one.error);
    EXPECT_NEAR(one.variance / binomialVariance(close, vec2(0.3f), 1, facetSlopeArea(close)), 0.95,
                0.15);

    Glint uneven = glintOf(std::log(1e6f), vec2(0.1f, 0), vec2(0, 0.1f));
    uneven.jitter = 1;
    const Statistics jittered = statisticsOf(uneven, vec2(0.5f), true, 60000);
    EXPECT_NEAR(jittered.mean, 1, std::max(0.02, 4 * jittered.error));
    uneven.area = 0.25f;
    const Statistics part = statisticsOf(uneven, vec2(0.5f), true, 60000);
    EXPECT_NEAR(part.mean, 1, 0.02);
}

TEST(Counting, FarAwayItIsBeckmann) {
    for (const float logDensity : {20.0f, 26.0f, 40.0f, 1000.0f}) {
        const Glint g = glintOf(logDensity, vec2(30, 0), vec2(0, 20));
        const Statistics r = statisticsOf(g, vec2(1), true, 200);
        EXPECT_NEAR(r.mean, 1, 2e-3);
        EXPECT_LT(std::sqrt(r.variance), 5e-3);
    }
}

// The table of docs/water.md: what the comparison keeps and what it does not.
TEST(Zirr, MeanIsNearBeckmannAndVarianceBelowTheBinomial) {
    for (const float facets : {3.0f, 100.0f, 300.0f, 1000.0f, 100000.0f}) {
        const Glint g =
            glintOf(std::log(facets / 0.0107f), vec2(0.13f, 0.02f), vec2(0.05f, 0.09f));
        const double expected = binomialVariance(g, vec2(0.5f), facets, facetSlopeArea(g));
        const int count = int(std::clamp(expected / 1e-4, 5000.0, 150000.0));
        const Statistics ours = statisticsOf(g, vec2(0.5f), true, count);
        const Statistics zirr = statisticsOf(g, vec2(0.5f), true, count, glint_zirr);
        fmt::print("{} facets: mean {:.3f} and {:.3f}, variance {:.2f} and {:.2f}\n", facets,
                   ours.mean, zirr.mean, ours.variance / expected, zirr.variance / expected);
        EXPECT_GT(zirr.mean, 1 - std::max(0.02, 4 * zirr.error));
        EXPECT_LT(zirr.mean, 1.03 + std::max(0.02, 4 * zirr.error));
        EXPECT_LT(zirr.variance, 0.6 * expected);
        EXPECT_GT(zirr.variance, 0.02 * expected);
    }
}

// Between neighbouring grids no jump: the triangulations agree on their common faces.
TEST(Counting, FootprintsChangeSmoothly) {
    // 1e5 facets in the smallest footprint, 600 of which reflect: their number is good to 4 %, and
    // 0.2 % of it is one facet.
    Glint g = glintOf(std::log(1e8f), vec2(0.1f, 0), vec2(0, 0.1f));
    g.uv = vec2(3.3f, 7.7f);
    const vec2 s = slopeAt(g, vec2(0.4f, -0.3f));
    double largest = 0, whole = 0;
    float before = -1;
    // Around with ratios from 1 to 40 and sizes over four levels, in many small steps.
    const int steps = 300000;
    for (int i = 0; i <= steps; ++i) {
        const float t = float(double(i) / steps);
        const float a = TWO_PI * 6 * t, size = 0.03f * std::exp2(4 * t);
        const float ratio = std::exp2(2.7f - 2.7f * std::cos(TWO_PI * 37 * t));
        const vec2 axis(std::cos(a), std::sin(a));
        g.d0 = axis * size * ratio, g.d1 = vec2(-axis.y, axis.x) * size;
        const float value = glint_counting(g, s).p22;
        if (before >= 0) {
            largest = std::max(largest, double(std::abs(value - before)));
            whole += double(std::abs(value - before));
        }
        before = value;
    }
    EXPECT_GT(whole, 0) << largest;
    // Where weights jump, other numbers take the place of some: a good part of those 4 %.
    EXPECT_LT(largest, 0.006 * double(slopes_p22(g.slopes, s)));
}

TEST(Counting, IsSymmetricAboutTheMeanAndRepeatable) {
    test::Random random(2);
    Glint g = glintOf(std::log(1e5f), vec2(0.1f, 0.01f), vec2(0, 0.04f));
    int glinting = 0;
    for (int i = 0; i < 1000; ++i) {
        g.uv = vec2(random.uniform(), random.uniform()) * 10.0f;
        const vec2 s = slopeAt(g, vec2(random.uniform(), random.uniform()) * 4.0f - 2.0f);
        const float a = glint_counting(g, s).p22;
        EXPECT_EQ(a, glint_counting(g, s).p22);
        EXPECT_NEAR(a, glint_counting(g, 2.0f * g.slopes.mean - s).p22, 2e-3f * a + 1e-3f);
        const Glint other = [&] { Glint o = g; o.seed = 6; return o; }();
        glinting += a != glint_counting(other, s).p22;
    }
    EXPECT_GT(glinting, 500);
}

TEST(Counting, NoInputMakesWhatIsNotFinite) {
    const float values[] = {0.0f, 1.0f, -3.7f, 1e-20f, 1e20f, -1e30f, NAN, INFINITY, -INFINITY};
    test::Random random(4);
    const auto any = [&] { return values[size_t(random.uniform() * 9)]; };
    for (int i = 0; i < 200000; ++i) {
        Glint g = glintOf(any(), vec2(any(), any()), vec2(any(), any()));
        g.uv = vec2(any(), any());
        g.jitter = any(), g.area = any();
        g.k0 = vec2(any(), any()), g.k1 = vec2(any(), any());
        const vec2 s = i % 4 == 0 ? vec2(any(), any()) : slopeAt(g, vec2(random.uniform()));
        const float value = glint_counting(g, s).p22, zirr = glint_zirr(g, s).p22;
        ASSERT_TRUE(std::isfinite(value + zirr) && value >= 0 && zirr >= 0)
            << g.log_density << ' ' << g.d0.x << ' ' << g.d0.y << ' ' << g.d1.x << ' ' << g.d1.y
            << ' ' << g.uv.x << ' ' << g.area << ' ' << g.jitter << ' ' << g.k0.x << ' ' << s.x;
    }
}

}  // namespace
}  // namespace gp
