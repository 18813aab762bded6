// The dictionary of glints: what it stores, and what is read from it.
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

uint rowOf(uint level, uint entry) { return (level * GLINT_ENTRIES + entry) * GLINT_ROW; }

TEST(GlintDictionary, EveryRowIntegratesToOneOverBothSides) {
    const uvec2 table = glintDictionary();
    for (uint level = 0; level < uint(GLINT_LEVELS); ++level) {
        for (uint entry = 0; entry < GLINT_ENTRIES; ++entry) {
            for (uint w = 0; w <= 4; ++w) {
                const GlintBins bins = glint_bins(rowOf(level, entry), w);
                double sum = 0.0;
                for (uint i = 0; i < bins.count; ++i)
                    sum += double(table_float(table, bins.base + i));
                ASSERT_NEAR(2.0 * sum * 4.0 / bins.count, 1.0, 2e-6) << level << ' ' << entry;
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
                       double(glint_marginal(table, rowOf(2, 17), kernel, x));
            }
            EXPECT_NEAR(2.0 * sum * 4.0 / steps, 1.0, 1e-5) << w;
        }
    }
    EXPECT_EQ(glint_marginal(table, rowOf(2, 17), width(0), 4.0f), 0.0f);
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
                for (uint entry = 0; entry < GLINT_ENTRIES; ++entry)
                    mean += double(glint_marginal(table, rowOf(level, entry), width(w), float(x)));
                mean /= double(GLINT_ENTRIES);
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

// Entries of one level differ from each other as independent draws do: the variance over entries of
// the share below one deviation, 0.6827, is p (1 - p) / 2^level.
TEST(GlintDictionary, LobesOfAnEntryAreAsUnevenAsIndependentDraws) {
    const uvec2 table = glintDictionary();
    for (const uint level : {3u, 6u, 9u}) {
        double squares = 0.0;
        for (uint entry = 0; entry < GLINT_ENTRIES; ++entry) {
            double below = 0.0;
            for (uint bin = 0; bin < 16; ++bin)
                below += 2.0 / 16.0 * double(table_float(table, rowOf(level, entry) + bin));
            squares += (below - 0.6827) * (below - 0.6827);
        }
        const double expected = 0.6827 * 0.3173 / std::exp2(double(level));
        // 192 draws know their variance to 10 %; blurring by the lobes takes some of it away.
        EXPECT_NEAR(squares / double(GLINT_ENTRIES) / expected, 0.95, 0.3) << level;
    }
}

// Half of the lobes of a level are those of the level below.
TEST(GlintDictionary, LevelsAreNested) {
    const uvec2 table = glintDictionary();
    for (uint level = 0; level + 1 < uint(GLINT_LEVELS); ++level) {
        for (uint bin = 0; bin < GLINT_ROW; ++bin) {
            const float below = table_float(table, rowOf(level, 100) + bin);
            EXPECT_GE(table_float(table, rowOf(level + 1, 100) + bin), 0.4999f * below);
        }
    }
}

}  // namespace
