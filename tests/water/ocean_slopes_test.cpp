// Slopes over a footprint: the pyramid, the spectrum alone, and a brute-force average agree.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "ocean/ocean.h"
#include "ocean/slope_pyramid.h"
#include "water/wave_sum.h"

namespace gp {
namespace {

using glm::vec2;

OceanSettings sea(float choppiness) {
    OceanSettings s;
    s.size = 64;
    s.lengths = {301.0f, 41.3f, 5.23f, 0.0f};
    s.choppiness = choppiness;
    return s;
}

// Moments over a rectangle of sides along the axes, weighted by displaced area.
OceanSlopes bruteForce(const test::WaveSum& waves, vec2 centre, vec2 sides, int n) {
    std::vector<double> xs, ys;
    for (int i = 0; i < n; ++i) {
        const double f = (i + 0.5) / n - 0.5;
        xs.push_back(double(centre.x) + f * double(sides.x));
        ys.push_back(double(centre.y) + f * double(sides.y));
    }
    double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
    for (const OceanPoint& p : waves.derivatives(xs, ys)) {
        const double area = double(std::max(p.jacobian(), oceanLeastJacobian));
        const double sx = double(p.slope().x), sy = double(p.slope().y);
        w += area;
        x += area * sx;
        y += area * sy;
        xx += area * sx * sx;
        yy += area * sy * sy;
        xy += area * sx * sy;
    }
    OceanSlopes result;
    result.mean = {float(x / w), float(y / w)};
    result.varX = float(xx / w - x / w * x / w);
    result.varY = float(yy / w - y / w * y / w);
    result.cov = float(xy / w - x / w * y / w);
    return result;
}

TEST(OceanSlopes, OfAPointAreThoseOfThePoint) {
    const Ocean ocean(sea(1.0f));
    for (int i = 0; i < 50; ++i) {
        const vec2 rest(3.7f * float(i), -91.0f + 1.3f * float(i));
        const OceanSlopes s = ocean.slopes(rest, {1e-4f, 0.0f}, {0.0f, 1e-4f});
        const vec2 slope = ocean.at(rest).slope();
        EXPECT_NEAR(s.mean.x, slope.x, 1e-5f);
        EXPECT_NEAR(s.mean.y, slope.y, 1e-5f);
        EXPECT_LT(s.varX, 1e-9f);
        EXPECT_EQ(ocean.slopes(rest, vec2(0.0f), vec2(0.0f)).mean, s.mean);
    }
}

// Over the whole square nothing is left out but what the last grid does not resolve.
TEST(OceanSlopes, OfTheWholeSeaAreThoseOfTheSpectrum) {
    const Ocean ocean(sea(0.0f));
    const OceanMoments all = ocean.momentsAbove(0.0f), tail = ocean.tail();
    const OceanSlopes s = ocean.slopes({7.0f, 8.0f}, {5000.0f, 0.0f}, {0.0f, 5000.0f});
    EXPECT_NEAR(s.mean.x, 0.0f, 1e-4f);
    EXPECT_NEAR(s.mean.y, 0.0f, 1e-4f);
    // One sea and not the mean of all: waves of the coarsest square are few.
    EXPECT_NEAR(s.varX / (all.xx - tail.xx), 1.0f, 0.08f);
    EXPECT_NEAR(s.varY / (all.yy - tail.yy), 1.0f, 0.08f);
}

// Over many places, since a box is not the filter that a pyramid has: root of mean square error of
// the mean slope, in terms of the slopes there; and hidden variance, on average over that of brute
// force.
struct Agreement {
    double mean = 0.0, variance = 0.0;
};

Agreement compare(const OceanSettings& settings, vec2 sides, int places, int samples) {
    const Ocean ocean(settings);
    const test::WaveSum waves(settings);
    double byErrors = 0.0, squares = 0.0, ours = 0.0, theirs = 0.0;
    for (int i = 0; i < places; ++i) {
        const vec2 at(17.3f * float(i), 5.9f * float(i));
        const OceanSlopes s = ocean.slopes(at, {sides.x, 0.0f}, {0.0f, sides.y});
        const OceanSlopes b = bruteForce(waves, at, sides, samples);
        const vec2 d = s.mean - b.mean;
        byErrors += double(glm::dot(d, d));
        squares += double(glm::dot(b.mean, b.mean)) + double(b.varX + b.varY);
        ours += double(s.varX + s.varY);
        theirs += double(b.varX + b.varY);
    }
    return {std::sqrt(byErrors / squares), ours / theirs};
}

TEST(OceanSlopes, AgreeWithABruteForceAverage) {
    for (const float choppiness : {0.0f, 0.8f}) {
        // The finest grid has points 8 cm apart.
        for (const vec2 sides : {vec2(0.4f), vec2(1.0f), vec2(2.0f), vec2(8.0f), vec2(30.0f),
                                 vec2(8.0f, 1.0f), vec2(1.0f, 8.0f)}) {
            const Agreement a = compare(sea(choppiness), sides, 12, 24);
            // Levels are steps of two in size, and between points of a grid its shortest waves are
            // weaker; both measured here at -18 % to +4 % of the variance.
            EXPECT_LT(a.mean, 0.15) << sides.x << " " << sides.y << ", choppiness " << choppiness;
            EXPECT_NEAR(a.variance, 0.95, 0.17)
                << sides.x << " " << sides.y << ", choppiness " << choppiness;
        }
    }
}

// The variance that a square pixel hides is that of waves too short for it: of wave numbers above
// 2.52 over its side, where a sharp cut hides as much as a box does of slopes that are even in the
// logarithm of k: ln(k side / 2) = 3/2 - ln 2 - Euler's constant.
TEST(OceanSlopes, OfTheSpectrumAloneAgreeToo) {
    const OceanSettings settings = sea(0.0f);
    const Ocean ocean(settings);
    const test::WaveSum waves(settings);
    for (const float side : {1.0f, 2.0f, 4.0f, 16.0f}) {
        double pyramid = 0.0, brute = 0.0;
        constexpr int places = 40;
        for (int i = 0; i < places; ++i) {
            const vec2 at(17.3f * float(i), 5.9f * float(i));
            const OceanSlopes s = ocean.slopes(at, {side, 0.0f}, {0.0f, side});
            const OceanSlopes b = bruteForce(waves, at, vec2(side), 12);
            pyramid += double(s.varX + s.varY) / places;
            brute += double(b.varX + b.varY) / places;
        }
        const OceanMoments above = ocean.momentsAbove(2.52f / side), tail = ocean.tail();
        const double spectrum = double(above.xx + above.yy - tail.xx - tail.yy);
        // 40 places of one sea: some 5 %.
        EXPECT_NEAR(brute / spectrum, 1.0, 0.12) << side;
        EXPECT_NEAR(pyramid / spectrum, 1.0, 0.2) << side;
    }
}

TEST(OceanSlopes, CovariancesAreCovariances) {
    const Ocean ocean(sea(1.5f));
    for (int i = 0; i < 300; ++i) {
        const vec2 at(17.3f * float(i), 5.9f * float(i));
        const float angle = 0.3f * float(i), size = std::exp(0.04f * float(i) - 6.0f);
        const vec2 axis(std::cos(angle), std::sin(angle));
        const OceanSlopes s = ocean.slopes(at, size * axis, 20.0f * size * vec2(axis.y, axis.x));
        EXPECT_GE(s.varX, 0.0f);
        EXPECT_GE(s.varY, 0.0f);
        EXPECT_LE(s.cov * s.cov, s.varX * s.varY * 1.0001f + 1e-12f);
        EXPECT_GE(s.foam, 0.0f);
        EXPECT_LE(s.foam, 1.0f);
        EXPECT_TRUE(std::isfinite(s.mean.x + s.mean.y));
    }
}

TEST(OceanSlopes, OfFootprintsWithoutEndAreThoseOfTheWholeSea) {
    const Ocean ocean(sea(1.0f));
    const OceanSlopes whole = ocean.slopes({0.0f, 0.0f}, {1.0e5f, 0.0f}, {0.0f, 1.0e5f});
    const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    for (const float bad : {inf, -inf, nan}) {
        const OceanSlopes a = ocean.slopes({1.0f, 2.0f}, {bad, 0.0f}, {0.0f, 1.0f});
        EXPECT_EQ(a.varX, whole.varX) << bad;
        EXPECT_EQ(a.mean, whole.mean) << bad;
        const OceanSlopes b = ocean.slopes({bad, 2.0f}, {1.0f, 0.0f}, {0.0f, 1.0f});
        EXPECT_TRUE(std::isfinite(b.varX + b.varY + b.cov + b.mean.x + b.mean.y + b.foam)) << bad;
    }
}

// A surface that is steep everywhere and rough by a ten-thousandth: the difference of moments of
// single precision would have no digit of it.
TEST(OceanSlopes, SmallVarianceOnSteepSlopesIsExact) {
    constexpr uint32_t size = 16;
    std::vector<OceanPoint> points(size * size);
    for (uint32_t i = 0; i < size * size; ++i) {
        points[i].gradient = {30.0f + ((i ^ (i / size)) % 2 ? 1e-4f : -1e-4f), -7.0f};
    }
    SlopePyramid pyramid;
    pyramid.build(points.data(), size);
    EXPECT_EQ(pyramid.levels(), 5u);
    EXPECT_NEAR(pyramid.whole().mean.x, 30.0f, 1e-5f);
    // What floats near 30 are apart, 1.9e-6, is 2 % of the deviation.
    EXPECT_NEAR(pyramid.whole().cov.x, 1e-8f, 5e-10f);
    EXPECT_EQ(pyramid.whole().cov.y, 0.0f);
}

TEST(OceanSlopes, AreWeightedByDisplacedArea) {
    // Half of the points squeezed to a half and steep, half stretched to 3/2 and level.
    std::vector<OceanPoint> points(16 * 16);
    for (size_t i = 0; i < points.size(); ++i) {
        points[i].stretch.x = i % 2 ? -0.5f : 0.5f;
        points[i].gradient.x = i % 2 ? 0.5f : 0.0f;
    }
    SlopePyramid pyramid;
    pyramid.build(points.data(), 16);
    // Slopes 1 over a quarter of the area, 0 over three quarters.
    EXPECT_NEAR(pyramid.whole().mean.x, 0.25f, 1e-6f);
    EXPECT_NEAR(pyramid.whole().cov.x, 0.1875f, 1e-6f);
    EXPECT_NEAR(pyramid.whole().weight, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace gp
