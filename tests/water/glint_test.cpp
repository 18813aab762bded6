// Glints as densities of slopes: they integrate to 1, their mean is the Gaussian, and no input
// makes them anything but finite.
#include <limits>

#include <gtest/gtest.h>

#include "water/glint_cases.h"

namespace {

using namespace gp::shading;
using gp::test::exampleGlint;
using gp::test::glintCases;
using gp::test::moveGlint;
using gp::test::NamedGlint;
using gp::test::Random;
using gp::test::slopeIntegral;

struct Moments {
    double mean = 0.0;       // of P22 over the Gaussian's
    double deviation = 0.0;  // of the same
    double error = 0.0;      // of the mean
};

// Over places of the surface, at slopes `radius` standard deviations from the mean.
Moments momentsAt(Glint g, float radius, int count) {
    Random random(11);
    const Slopes d = glint_slopes_within(g);
    const Whitening w = whitening_of(d);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < count; ++i) {
        moveGlint(g, random);
        const float phi = 6.2831853f * random.uniform();
        const vec2 s = d.mean + unwhitened(w, radius * vec2(std::cos(phi), std::sin(phi)));
        const double p = double(glint_p22(g, s)) / double(slopes_p22(d, s));
        sum += p, squares += p * p;
    }
    Moments m;
    m.mean = sum / count;
    m.deviation = std::sqrt(squares / count - m.mean * m.mean);
    m.error = m.deviation / std::sqrt(double(count));
    return m;
}

TEST(Glint, IntegratesToOneForEveryFootprint) {
    for (NamedGlint& c : glintCases()) {
        Random random(3);
        for (int place = 0; place < 3; ++place) {
            EXPECT_NEAR(slopeIntegral(c.glint, 32, [](vec2) { return 1.0f; }), 1.0, 1e-3) << c.name;
            moveGlint(c.glint, random);
            const float angle = 6.2831853f * random.uniform(), size = random.uniform();
            c.glint.d0 = 0.004f * size * vec2(std::cos(angle), std::sin(angle));
        }
    }
}

// Cells choose any two entries and any angle: this is their mean, without noise.
TEST(Glint, MeanOfAllCellsIsTheGaussianAtEveryLevel) {
    const uvec2 table = gp::glintDictionary();
    for (uint level = 0; level < uint(GLINT_LEVELS); ++level) {
        const auto meanAt = [&](float x) {
            GlintWidth w;
            w.width = 0;
            w.share = 0.0f;
            double sum = 0.0;
            for (uint i = 0; i < glint_entries(level); ++i)
                sum += double(glint_marginal(table, glint_row(level, i), w, std::abs(x)));
            return sum / double(glint_entries(level));
        };
        for (const float radius : {0.0f, 0.5f, 1.0f, 1.5f, 2.0f, 2.5f}) {
            double sum = 0.0;
            for (int i = 0; i < 64; ++i) {
                const float angle = (float(i) + 0.5f) / 64.0f * 1.57079633f;
                sum += meanAt(radius * std::cos(angle)) * meanAt(radius * std::sin(angle)) / 64.0;
            }
            const double gaussian = std::exp(-0.5 * double(radius * radius)) / (2.0 * M_PI);
            EXPECT_NEAR(sum / gaussian, 1.0, 0.02) << "level " << level << ", " << radius;
        }
    }
}

TEST(Glint, MeanOverPlacesIsTheGaussian) {
    for (const NamedGlint& c : glintCases()) {
        for (const float radius : {0.3f, 1.3f}) {
            const Moments m = momentsAt(c.glint, radius, 120'000);
            EXPECT_NEAR(m.mean, 1.0, 0.01 + 3.0 * m.error) << c.name << ' ' << radius;
            EXPECT_LT(m.error, 0.025) << c.name << ' ' << radius;
        }
    }
}

// The more facets a pixel holds, the closer it is to the smooth surface, down to equality.
TEST(Glint, FarAwayIsSmooth) {
    Glint g = exampleGlint();
    double last = 1e9;
    for (const float scale : {1.0f, 16.0f, 256.0f, 4096.0f}) {
        g.d0 = scale * exampleGlint().d0;
        g.d1 = scale * exampleGlint().d1;
        const double deviation = momentsAt(g, 0.7f, 4000).deviation;
        EXPECT_LT(deviation, 0.6 * last) << scale;
        last = deviation;
    }
    EXPECT_LT(last, 0.05);
    g.d0 *= 100.0f, g.d1 *= 100.0f;
    EXPECT_EQ(momentsAt(g, 0.7f, 100).deviation, 0.0);
}

TEST(Glint, SymmetricAboutTheMean) {
    for (NamedGlint& c : glintCases()) {
        Random random(5);
        for (int i = 0; i < 200; ++i) {
            moveGlint(c.glint, random);
            const vec2 s = c.glint.slopes.mean
                         + vec2(random.uniform() - 0.5f, random.uniform() - 0.5f);
            const float there = glint_p22(c.glint, 2.0f * c.glint.slopes.mean - s);
            const float here = glint_p22(c.glint, s);
            // Rounding of the slope moves it on the flank of a lobe.
            EXPECT_NEAR(here, there, 1e-3f * here + 1e-4f) << c.name;
        }
    }
}

// What the masking function lets through of the facets is what the mesosurface shows, for single
// glints as for the mean: they are symmetric. The sum is over pairs, so that it is as exact as P22.
TEST(Glint, VisibleAreaIsThatOfTheMesosurface) {
    for (const NamedGlint& c : glintCases()) {
        for (const float degrees : {0.0f, 40.0f, 70.0f, 85.0f}) {
            const float theta = degrees / 57.29578f;
            const vec3 w(-0.8f * std::sin(theta), 0.6f * std::sin(theta), std::cos(theta));
            const vec2 mean = c.glint.slopes.mean;
            const float facing = slope_facing(mean, w);
            const double visible = slopeIntegral(c.glint, 12, [&](vec2 s) {
                return sheared_cavity_g1(mean, s, w) * std::max(slope_facing(s, w), 0.0f);
            });
            const double all = slopeIntegral(c.glint, 12, [](vec2) { return 1.0f; });
            EXPECT_NEAR(visible / (double(facing) * all), 1.0, 1e-3) << c.name << ' ' << degrees;
        }
    }
}

// A kernel spreads the glints out: as much light, less contrast. Without it they keep theirs.
TEST(Glint, KernelTakesContrastAway) {
    Glint g = exampleGlint();
    g.log_density = std::log(1e8f);
    const double sharp = momentsAt(g, 0.5f, 20'000).deviation;
    g.k0 = {0.15f, 0.05f};
    g.k1 = {0.02f, -0.1f};
    const double half = momentsAt(g, 0.5f, 20'000).deviation;
    EXPECT_LT(half, 0.6 * sharp);
    // All of the slopes are the kernel's.
    g.k0 = {2.0f, 0.0f};
    g.k1 = {0.0f, 2.0f};
    EXPECT_LT(momentsAt(g, 0.5f, 1000).deviation, 1e-3 + 0.005);
}

// A cell has its entries and its axes in common with the one at its lower left corner on every
// level below.
TEST(Glint, CellsOfAllLevelsShareTheirNumbers) {
    Random random(21);
    GlintLevel high{}, low{};
    high.facets = low.facets = 3.0f;
    high.occupied = low.occupied = high.share = low.share = 1.0f;
    high.seed = low.seed = 77u;
    for (int i = 0; i < 1000; ++i) {
        high.shift = 1u + random.next() % 12u;
        low.shift = random.next() % high.shift;
        const int x = int(random.next() % 2001u) - 1000, y = int(random.next() % 2001u) - 1000;
        const int times = 1 << (high.shift - low.shift);
        const GlintCell a = glint_cell(high, x, y), b = glint_cell(low, x * times, y * times);
        EXPECT_EQ(a.row_x, b.row_x);
        EXPECT_EQ(a.row_y, b.row_y);
        EXPECT_EQ(a.turn.s, b.turn.s);
        EXPECT_NE(a.turn.s, glint_cell(high, x + 1, y).turn.s);
    }
}

// The part at a cell's corner has a child of each of its rows: facets that the cell has.
TEST(Glint, CornersOfCellsHaveFacetsOfTheirs) {
    Random random(22);
    GlintLevel high{}, low{};
    high.occupied = low.occupied = high.share = low.share = 1.0f;
    high.seed = low.seed = 78u;
    for (int i = 0; i < 1000; ++i) {
        high.facets = float(1 + random.next() % uint(GLINT_LEVELS - 2));
        low.facets = high.facets - 1.0f;
        high.shift = 1u + random.next() % 12u;
        low.shift = high.shift - 1u;
        const int x = int(random.next() % 2001u) - 1000, y = int(random.next() % 2001u) - 1000;
        const GlintCell whole = glint_cell(high, x, y), part = glint_cell(low, 2 * x, 2 * y);
        // A cell may take the level above its own.
        uint level = uint(high.facets);
        if (whole.row_x >= glint_row(level + 1, 0)) ++level;
        const uint entry_x = (whole.row_x - glint_row(level, 0)) / GLINT_ROW;
        const uint entry_y = (whole.row_y - glint_row(level, 0)) / GLINT_ROW;
        const uint entries = glint_entries(level);
        EXPECT_EQ((part.row_x - glint_row(level - 1, 0)) / GLINT_ROW % entries, entry_x);
        EXPECT_EQ((part.row_y - glint_row(level - 1, 0)) / GLINT_ROW % entries, entry_y);
        EXPECT_EQ(part.turn.s, whole.turn.s);
    }
}

// What carries no facets reflects as the smooth surface: a share of every pixel where cells hold
// several facets, whole cells where they hold less than one.
TEST(Glint, TheRestOfTheAreaIsSmooth) {
    Random random(8);
    Glint g = exampleGlint();
    g.area = 0.3f;
    g.log_density = std::log(1e8f);
    const vec2 s = g.slopes.mean + vec2(0.1f, 0.1f);
    const float gaussian = slopes_p22(g.slopes, s);
    float least = 1e9f;
    for (int i = 0; i < 5000; ++i) {
        moveGlint(g, random);
        least = std::min(least, glint_p22(g, s) / gaussian);
    }
    EXPECT_GT(least, 0.6999f);
    EXPECT_LT(least, 0.8f);
    g.area = 0.01f;
    g.log_density = std::log(1e6f);
    int untouched = 0;
    for (int i = 0; i < 5000; ++i) {
        moveGlint(g, random);
        untouched += std::abs(glint_p22(g, s) / gaussian - 1.0f) < 1e-6f ? 1 : 0;
    }
    // 5 to 15 cells under a footprint, one of a hundred with facets.
    EXPECT_GT(untouched, 4000);
    EXPECT_LT(untouched, 4900);
}

// Half of the footprint's width away, most of the cells are the same ones; the same holds for
// another level: glints do not jump while the camera moves.
TEST(Glint, StaysWhileTheFootprintChanges) {
    Random random(9);
    Glint g = exampleGlint();
    double product = 0.0, squares = 0.0, mean = 0.0;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
        moveGlint(g, random);
        const vec2 s = g.slopes.mean + vec2(0.02f, 0.05f);
        Glint other = g;
        other.d0 *= 1.3f, other.d1 *= 1.3f;
        const double a = glint_p22(g, s), b = glint_p22(other, s);
        product += a * b, squares += 0.5 * (a * a + b * b), mean += 0.5 * (a + b);
    }
    mean /= count;
    const double correlation = (product / count - mean * mean) / (squares / count - mean * mean);
    EXPECT_GT(correlation, 0.75);
}

TEST(Glint, FiniteWhateverTheInput) {
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> values = {0.0f,   -1.0f, 1.0f, 1e-30f, 1e30f, -1e30f, 3e38f,
                                       -3e38f, inf,   -inf, nan,    1e-3f, 20.0f};
    Random random(1);
    const auto any = [&] { return values[random.next() % values.size()]; };
    for (int i = 0; i < 200'000; ++i) {
        Glint g = exampleGlint();
        float* members[] = {&g.slopes.mean.x, &g.slopes.mean.y, &g.slopes.var_x, &g.slopes.var_y,
                            &g.slopes.cov, &g.uv.x, &g.uv.y, &g.d0.x, &g.d0.y, &g.d1.x, &g.d1.y,
                            &g.log_density, &g.area, &g.jitter, &g.k0.x, &g.k0.y, &g.k1.x,
                            &g.k1.y};
        // One to four of them are wrong.
        for (uint n = 1 + random.next() % 4; n > 0; --n) *members[random.next() % 18] = any();
        vec2 s(random.uniform() - 0.5f, random.uniform() - 0.5f);
        if (i % 8 == 0) s.x = any();
        const float p = glint_p22(g, s);
        ASSERT_TRUE(p >= 0.0f && p < inf) << i << ": " << p;
        const vec2 sample = glint_sample(g, vec2(random.uniform(), random.uniform()),
                                         random.uniform());
        const bool meanKnown = std::isfinite(g.slopes.mean.x) && std::isfinite(g.slopes.mean.y);
        ASSERT_TRUE(!meanKnown || (std::isfinite(sample.x) && std::isfinite(sample.y))) << i;
    }
}

TEST(Glint, CorrelationOfOneIsReadAsTheNearestAllowed) {
    for (const float sign : {-1.0f, 1.0f}) {
        Glint g = exampleGlint();
        g.slopes.cov = sign * std::sqrt(g.slopes.var_x * g.slopes.var_y);
        EXPECT_NEAR(slopeIntegral(g, 24, [](vec2) { return 1.0f; }), 1.0, 2e-3);
    }
}

TEST(Glint, WithoutDictionaryItIsTheGaussian) {
    Glint g = exampleGlint();
    g.dictionary = uvec2(0u, 0u);
    const vec2 s(0.2f, 0.1f);
    EXPECT_FLOAT_EQ(glint_p22(g, s), slopes_p22(g.slopes, s));
}

}  // namespace
