// The sampler: stratified as a (0,2)-sequence must be, scrambled well, and without correlation
// between pixels and draws.
#include "shading/shading.h"

#include <array>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace gp::shading {
namespace {

// One number of the second Sobol' dimension by its direction numbers, as the literature gives it:
// v1 = 1, each next one v ^ (v >> 1). [Bratley and Fox 1988, ACM TOMS algorithm 659]
uint sobolSecondByDirections(uint index) {
    uint direction = 0x80000000u;
    uint x = 0;
    for (; index != 0; index >>= 1) {
        x ^= (index & 1u) != 0 ? direction : 0u;
        direction ^= direction >> 1;
    }
    return x;
}

TEST(Sobol, ButterfliesEqualDirectionNumbers) {
    std::mt19937 random(1);
    for (uint i = 0; i < 100000; ++i) {
        const uint index = i < 50000 ? i : uint(random());
        ASSERT_EQ(reverse_bits(sobol_second_reversed(index)), sobolSecondByDirections(index));
    }
    EXPECT_EQ(reverse_bits(1u), 0x80000000u);
    EXPECT_EQ(reverse_bits(0x12345678u), 0x1E6A2C48u);
}

TEST(Sobol, FloatsStayBelowOne) {
    EXPECT_EQ(unit_float(0xFFFFFFFFu), ONE_MINUS_EPSILON);
    EXPECT_LT(unit_float(0xFFFFFFFFu), 1.0f);
    EXPECT_EQ(unit_float(0u), 0.0f);
}

// Every elementary interval of area 2^-k (2^a columns, 2^(k - a) rows) holds exactly one point.
void expectNet(const std::vector<vec2>& points, int k) {
    for (int a = 0; a <= k; ++a) {
        std::vector<int> count(points.size(), 0);
        for (const vec2& p : points) {
            const int column = int(p.x * float(1 << a));
            const int row = int(p.y * float(1 << (k - a)));
            ++count[size_t((row << a) + column)];
        }
        for (int c : count) {
            ASSERT_EQ(c, 1) << "2^" << a << " columns, 2^" << k - a << " rows";
        }
    }
}

TEST(Sampler, EveryAlignedBlockIsANet) {
    for (uint pixel = 0; pixel < 8; ++pixel) {
        for (uint dimension : {0u, 1u, 2u, 77u}) {
            for (int k = 0; k <= 10; ++k) {
                for (uint block : {0u, 1u, 5u, 1000u}) {
                    std::vector<vec2> points;
                    for (uint i = 0; i < 1u << k; ++i) {
                        Sampler s = sampler_begin(uvec2(pixel, 3u), (block << k) + i, 9u);
                        s.dimension = dimension;
                        points.push_back(sampler_next_2d(s));
                    }
                    expectNet(points, k);
                }
            }
        }
    }
}

TEST(Sampler, OneNumberIsStratifiedToo) {
    constexpr uint count = 4096;
    std::vector<int> cells(count, 0);
    for (uint i = 0; i < count; ++i) {
        Sampler s = sampler_begin(uvec2(17u, 4u), i, 1u);
        s.dimension = 5;
        ++cells[size_t(sampler_next_1d(s) * float(count))];
    }
    for (int c : cells) {
        ASSERT_EQ(c, 1);
    }
}

TEST(Sampler, DrawsDependOnNothingButTheirPlace) {
    Sampler a = sampler_begin(uvec2(5u, 6u), 7u, 8u);
    Sampler jumped = a;
    sampler_next_1d(a);
    sampler_next_2d(a);
    jumped.dimension = 2;
    EXPECT_EQ(a.dimension, 2u);
    EXPECT_EQ(sampler_next_2d(a), sampler_next_2d(jumped));
    std::set<float> values;  // and on each part of it
    for (const uvec4& place : {uvec4(5, 6, 7, 8), uvec4(4, 6, 7, 8), uvec4(6, 5, 7, 8),
                               uvec4(5, 6, 6, 8), uvec4(5, 6, 7, 9)}) {
        Sampler s = sampler_begin(uvec2(place.x, place.y), place.z, place.w);
        values.insert(sampler_next_1d(s));
    }
    EXPECT_EQ(values.size(), 5u);
}

// A nested uniform scramble: a digit may depend on higher ones only, and for a random seed it flips
// half of the time, whatever those are. In natural order, bit 31 is the first digit.
TEST(OwenScramble, FlipsEachDigitByTheOnesAbove) {
    std::mt19937 random(3);
    constexpr int trials = 20000;
    for (int bit = 31; bit >= 8; --bit) {
        int flipped = 0;
        int below = 0;
        for (int i = 0; i < trials; ++i) {
            const uint x = uint(random());
            const uint seed = uint(random());
            const uint y = owen_scramble(x, seed);
            const uint z = owen_scramble(x ^ (1u << bit), seed);
            ASSERT_EQ(uint64_t(y ^ z) >> bit, 1u) << "a higher digit changed, or this one did not";
            flipped += int(((x ^ y) >> bit) & 1u);
            below += int(((y ^ z) >> (bit - 1)) & 1u);
        }
        // Five standard deviations for the flips. How much the next digit depends on this one is a
        // matter of the hash; without dependence this would be 0 (a mere digital shift).
        EXPECT_NEAR(double(flipped) / trials, 0.5, 5.0 * 0.5 / std::sqrt(trials)) << "bit " << bit;
        EXPECT_NEAR(double(below) / trials, 0.5, 0.1) << "bit " << bit;
    }
}

// Pearson's correlation of two draws over many pixels: `second` is a place relative to the first.
double correlation(uvec2 pixelStep, uint dimensionStep, uint axis) {
    constexpr uint pixels = 256;
    constexpr uint samples = 16;
    double sum = 0.0;
    for (uint p = 0; p < pixels * pixels; ++p) {
        const uvec2 pixel(p % pixels, p / pixels);
        const uint i = p % samples;
        Sampler a = sampler_begin(pixel, i, 2u);
        Sampler b = sampler_begin(pixel + pixelStep, i, 2u);
        b.dimension = dimensionStep;
        const vec2 u = sampler_next_2d(a);
        const vec2 v = sampler_next_2d(b);
        sum += (double(u.x) - 0.5) * (double(axis == 0 ? v.x : v.y) - 0.5);
    }
    return 12.0 * sum / (pixels * pixels);
}

TEST(Sampler, PixelsDimensionsAndAxesAreUncorrelated) {
    const double allowed = 4.5 / 256.0;  // standard deviations of 65,536 independent pairs
    EXPECT_NEAR(correlation(uvec2(0, 0), 0, 1), 0.0, allowed);
    for (uint axis : {0u, 1u}) {
        EXPECT_NEAR(correlation(uvec2(1, 0), 0, axis), 0.0, allowed);
        EXPECT_NEAR(correlation(uvec2(0, 1), 0, axis), 0.0, allowed);
        EXPECT_NEAR(correlation(uvec2(64, 0), 0, axis), 0.0, allowed);
        for (uint dimension = 1; dimension <= 16; ++dimension) {
            EXPECT_NEAR(correlation(uvec2(0, 0), dimension, axis), 0.0, allowed) << dimension;
        }
    }
}

// Within one pixel, too: the joint counts of two draws over its samples, summed over few pixels,
// would show an order that both share.
TEST(Sampler, PaddedDrawsFillTheirSquareEvenly) {
    for (uint dimension = 1; dimension <= 12; ++dimension) {
        std::array<double, 64> count{};
        constexpr uint pixels = 64;
        constexpr uint samples = 1024;
        for (uint p = 0; p < pixels; ++p) {
            for (uint i = 0; i < samples; ++i) {
                Sampler s = sampler_begin(uvec2(p, 0), i, 4u);
                const float u = sampler_next_2d(s).x;
                s.dimension = dimension;
                const float v = sampler_next_2d(s).y;
                count[size_t(u * 8.0f) * 8 + size_t(v * 8.0f)] += 1.0;
            }
        }
        const double expected = pixels * samples / 64.0;
        double chi2 = 0.0;
        for (double c : count) {
            chi2 += (c - expected) * (c - expected) / expected;
        }
        // 49 degrees of freedom, as rows and columns are exact; this is beyond p = 1e-6.
        EXPECT_LT(chi2, 110.0) << "dimension " << dimension;
    }
}

double rmsError(uint samples, bool independent) {
    constexpr uint pixels = 512;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    double squares = 0.0;
    double bias = 0.0;
    for (uint p = 0; p < pixels; ++p) {
        double sum = 0.0;
        for (uint i = 0; i < samples; ++i) {
            Sampler s = sampler_begin(uvec2(p, 1u), i, 6u);
            vec2 u = sampler_next_2d(s);
            if (independent) {
                u.x = uniform(random);
                u.y = uniform(random);
            }
            sum += std::exp(double(u.x) * double(u.y)) * std::cos(3.0 * double(u.x));
        }
        // The integral of exp(x y) cos(3 x) over the unit square, by quadrature to 1e-9.
        const double error = sum / samples + 0.0789648872;
        squares += error * error;
        bias += error;
    }
    const double rms = std::sqrt(squares / pixels);
    EXPECT_LT(std::abs(bias / pixels), 4.0 * rms / std::sqrt(pixels)) << samples << " samples";
    return rms;
}

TEST(Sampler, ConvergesFasterThanIndependentSamples) {
    // Owen scrambling makes a smooth integrand's error fall like N^-1.5, where independent samples
    // give N^-0.5.
    const double coarse = rmsError(64, false);
    const double fine = rmsError(1024, false);
    EXPECT_LT(fine, coarse / std::pow(16.0, 1.2));
    EXPECT_LT(fine, rmsError(1024, true) / 16.0);
}

}  // namespace
}  // namespace gp::shading
