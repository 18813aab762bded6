// The dictionary of glints: what it stores, and what is read from it.
#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "water/glint_cases.h"

namespace {

using namespace gp::shading;
using gp::glintDictionary;

GlintWidth width(uint index) {
    GlintWidth w;
    w.width = index;
    w.share = 0.0f;
    return w;
}

// What is stored of a bin, 0 … 63 and one more at both ends, of the copies 0 … 4.
double stored(uint row, uint copy, int bin) {
    const uint width = std::min(copy, 3u);
    const uint word =
        table_uint2(glintDictionary(), glint_at(row, width, uint(bin + 1))).x;
    return double(copy == width ? glint_narrow(word) : glint_wide(word)) *
           (double(GLINT_ROOT) * double(GLINT_ROOT));
}

TEST(GlintDictionary, EveryRowIntegratesToOneOverBothSides) {
    for (uint level = 0; level < uint(GLINT_LEVELS); ++level) {
        for (uint entry = 0; entry < glint_entries(level); ++entry) {
            for (uint copy = 0; copy <= 4; ++copy) {
                double sum = 0.0;
                for (int i = 0; i < int(GLINT_BINS); ++i)
                    sum += stored(glint_row(level, entry), copy, i);
                ASSERT_NEAR(2.0 * sum / double(GLINT_BINS_PER_UNIT), 1.0, 2e-6)
                    << level << ' ' << entry << ' ' << copy;
            }
        }
    }
}

// A word has a bin of two copies, and both ends have their bin twice.
TEST(GlintDictionary, WhatIsStoredTwiceIsTheSame) {
    const uvec2 table = glintDictionary();
    for (uint level = 0; level < uint(GLINT_LEVELS); ++level) {
        for (uint entry = 0; entry < glint_entries(level); ++entry) {
            const uint row = glint_row(level, entry);
            for (uint width = 0; width < 4; ++width) {
                for (uint bin = 0; width < 3 && bin < GLINT_COPY - 1; ++bin) {
                    ASSERT_EQ(table_uint2(table, glint_at(row, width, bin)).x >> 16u,
                              table_uint2(table, glint_at(row, width + 1, bin)).x & 65535u);
                }
                const uvec2 first = table_uint2(table, glint_at(row, width, 0));
                const uvec2 last = table_uint2(table, glint_at(row, width, GLINT_BINS));
                ASSERT_EQ(first.x, first.y);
                ASSERT_EQ(last.x, last.y);
            }
        }
    }
}

// Linear reading, mirrored at the ends, integrates to the sum of the bins: a trapezoid rule on a
// grid that has all corners of it is exact.
TEST(GlintDictionary, ReadingKeepsTheIntegral) {
    const uvec2 table = glintDictionary();
    constexpr int steps = 4 * 32;  // half a bin of the finest
    for (const float share : {0.0f, 0.37f}) {
        for (uint w = 0; w < 4; ++w) {
            GlintWidth kernel = width(w);
            kernel.share = share;
            double sum = 0.0;
            for (int i = 0; i <= steps; ++i) {
                const float x = std::min(4.0f * float(i) / steps, 3.999999f);
                sum += (i == 0 || i == steps ? 0.5 : 1.0) *
                       double(glint_marginal(table, glint_row(2, 17), kernel, x));
            }
            EXPECT_NEAR(2.0 * sum * 4.0 / steps, 1.0, 1e-5) << w;
        }
    }
    EXPECT_EQ(glint_marginal(table, glint_row(2, 17), width(0), 4.0f), 0.0f);
}

// The published dictionary's mean is off by 23 % at level 0, in the norm taken here, and by 0.2 %
// at the last level.
TEST(GlintDictionary, MeanOfAllEntriesIsNormalAtEveryLevel) {
    const uvec2 table = glintDictionary();
    for (uint level = 0; level < uint(GLINT_LEVELS); ++level) {
        for (uint w = 0; w < 4; ++w) {
            double squares = 0.0, normalSquares = 0.0, variance = 0.0;
            for (int i = 0; i < 400; ++i) {
                const double x = (i + 0.5) / 100.0;
                double mean = 0.0;
                for (uint entry = 0; entry < glint_entries(level); ++entry)
                    mean += double(glint_marginal(table, glint_row(level, entry), width(w),
                                                  float(x)));
                mean /= double(glint_entries(level));
                const double normal = std::exp(-0.5 * x * x) / std::sqrt(2.0 * M_PI);
                squares += (mean - normal) * (mean - normal);
                normalSquares += normal * normal;
                variance += 0.02 * mean * x * x;
            }
            EXPECT_LT(std::sqrt(squares / normalSquares), level < 2 ? 0.015 : 0.008)
                << "level " << level << ", width " << w;
            EXPECT_NEAR(variance, 1.0, 0.01) << "level " << level << ", width " << w;
        }
    }
}

// A row is the mean of its two children, and the last level's two together are all. Rounding: half
// a unit of a root is 4e-5 of the root of a density, of three rows, and what the bin before left.
TEST(GlintDictionary, RowsAreTheMeansOfTheirChildren) {
    for (uint level = 1; level < uint(GLINT_LEVELS); ++level) {
        for (uint entry = 0; entry < glint_entries(level); ++entry) {
            const uint row = glint_row(level, entry), first = glint_row(level - 1, entry);
            const uint second = glint_row(level - 1, entry + glint_entries(level));
            for (uint copy = 0; copy <= 4; ++copy) {
                double largest = 0.0;
                for (int i = 0; i < int(GLINT_BINS); ++i) {
                    const double a = stored(first, copy, i), b = stored(second, copy, i);
                    const double own = std::max({a, b, 1e-4});
                    ASSERT_NEAR(stored(row, copy, i), 0.5 * (a + b),
                                2.0 * 4e-5 * (std::sqrt(own) + std::sqrt(largest)))
                        << level << ' ' << entry << ' ' << copy << ' ' << i;
                    largest = own;
                }
            }
        }
    }
    EXPECT_EQ(glint_entries(uint(GLINT_LEVELS - 1)), 2u);
}

// By size of their slopes, from the means of what is stored of them.
std::vector<uint> ranksOfLeaves() {
    std::vector<std::pair<double, uint>> leaves;
    for (uint leaf = 0; leaf < glint_entries(0u); ++leaf) {
        double mean = 0.0;
        for (int bin = 0; bin < int(GLINT_BINS); ++bin)
            mean += (bin + 0.5) / 128.0 * stored(glint_row(0u, leaf), 0, bin);
        leaves.emplace_back(mean, leaf);
    }
    std::sort(leaves.begin(), leaves.end());
    std::vector<uint> ranks(leaves.size());
    for (uint i = 0; i < leaves.size(); ++i) ranks[leaves[i].second] = i;
    return ranks;
}

TEST(GlintDictionary, LeavesBelowEveryRowAreStratified) {
    const std::vector<uint> ranks = ranksOfLeaves();
    for (uint level = 0; level < uint(GLINT_LEVELS); ++level) {
        const uint entries = glint_entries(level);
        for (uint entry = 0; entry < entries; ++entry) {
            std::set<uint> strata;
            for (uint leaf = entry; leaf < GLINT_LEAVES; leaf += entries)
                strata.insert(ranks[leaf] / entries);
            ASSERT_EQ(strata.size(), 1u << level) << level << ' ' << entry;
        }
    }
}

// A cell glints as 4^level facets of four spikes each do, at one and two deviations from the mean
// (docs/water.md: nearer to it cells of many facets are too even).
TEST(GlintDictionary, ContrastIsNearThatOfAsManyFacets) {
    const uvec2 table = glintDictionary();
    gp::test::Random random(3);
    for (uint level = 1; level <= 6; ++level) {
        for (const float radius : {1.0f, 2.0f}) {
            double sum = 0.0, squares = 0.0;
            constexpr int count = 20'000;
            const uint entries = glint_entries(level);
            for (int i = 0; i < count; ++i) {
                const float angle = 1.5707963f * random.uniform();
                const double p =
                    double(glint_marginal(table, glint_row(level, random.next() % entries),
                                          width(0), radius * std::cos(angle))) *
                    double(glint_marginal(table, glint_row(level, random.next() % entries),
                                          width(0), radius * std::sin(angle)));
                sum += p, squares += p * p;
            }
            const double mean = sum / count;
            const double contrast = std::sqrt(squares / count / (mean * mean) - 1.0);
            // Spikes are Gaussians of width 1/16: the integral of their square is 256 / (4 pi).
            const double density = std::exp(-0.5 * double(radius * radius)) / (2.0 * M_PI);
            const double spikes = 4.0 * std::exp2(2.0 * level);
            const double facets = std::sqrt(256.0 / (4.0 * M_PI) / (density * spikes));
            EXPECT_GT(contrast, 0.35 * facets) << level << ' ' << radius;
            EXPECT_LT(contrast, 1.5 * facets) << level << ' ' << radius;
        }
    }
}

// Within its stratum a leaf lies anywhere: regular ones would make rows of a level that differ by
// no more than a shift. The variance of the place in a stratum is that of a uniform number, and
// neighbouring strata know nothing of each other.
TEST(GlintDictionary, LeavesAreUnevenWithinTheirStrata) {
    const std::vector<uint> ranks = ranksOfLeaves();
    const uint level = 5, entries = glint_entries(level);
    double squares = 0.0, products = 0.0;
    for (uint entry = 0; entry < entries; ++entry) {
        std::vector<double> places(size_t(1) << level);
        for (uint leaf = entry; leaf < GLINT_LEAVES; leaf += entries)
            places[ranks[leaf] / entries] = (ranks[leaf] % entries + 0.5) / entries - 0.5;
        for (size_t i = 0; i < places.size(); ++i) {
            squares += places[i] * places[i] / double(GLINT_LEAVES);
            products += places[i] * places[i ^ 1u] / double(GLINT_LEAVES);
        }
    }
    EXPECT_NEAR(squares * 12.0, 1.0, 0.01);
    // 512 pairs.
    EXPECT_LT(std::abs(products / squares), 0.2);
}

}  // namespace
