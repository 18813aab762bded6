// Foam: where waves break, how it fades; and maps for other programs.
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ocean/foam.h"
#include "ocean/ocean.h"

namespace gp {
namespace {

constexpr uint32_t gridSize = 32;

uint16_t codeOf(float margin) {
    return uint16_t(std::lround((margin / squeezeMost + 1.0f) * 0.5f * float(squeezeCodes - 1)));
}

// A sea that breaks everywhere from second `from` to second `to`.
struct Breaking {
    double from = 0.0, to = 0.0;
    float most = 6.0f;  // deviations on the side of breaking
    int asked = 0;
    OceanSettings settings;
    std::vector<OceanPoint> points{gridSize * gridSize};

    std::vector<uint16_t> codes(double t) const {
        return std::vector<uint16_t>(points.size(), codeOf(t >= from && t <= to ? most : -6.0f));
    }
    float at(Foam& foam, double t) {
        foam.update(t, codes(t).data(), points.data(), [&](double when, uint16_t* to_) {
            ++asked;
            const auto c = codes(when);
            std::copy(c.begin(), c.end(), to_);
        });
        return points[77].foam;
    }
};

TEST(OceanFoam, AppearsWhereTheSurfaceIsSqueezedAndFadesAsSaid) {
    Breaking sea;
    sea.settings.size = gridSize;
    sea.settings.foamDecay = 3.0f;  // a tick is a second
    sea.from = 9.5;
    sea.to = 10.5;
    Foam foam(sea.settings);
    EXPECT_EQ(sea.at(foam, 9.0), 0.0f);
    EXPECT_NEAR(sea.at(foam, 10.2), 1.0f, 1e-3f);
    // The tick at 10 s saw it.
    EXPECT_NEAR(sea.at(foam, 11.5), std::exp(-1.5f / 3.0f), 1e-3f);
    EXPECT_NEAR(sea.at(foam, 16.0), std::exp(-6.0f / 3.0f), 1e-3f);
    EXPECT_EQ(sea.at(foam, 27.0), 0.0f);
    // Steps ahead ask for each tick once; going back gives the same.
    EXPECT_EQ(sea.asked, 16 + 18);
    EXPECT_NEAR(sea.at(foam, 11.5), std::exp(-1.5f / 3.0f), 1e-3f);
    EXPECT_EQ(sea.at(foam, -5.0), 0.0f);
}

TEST(OceanFoam, WithoutDecayLeavesNoTrace) {
    Breaking sea;
    sea.settings.size = gridSize;
    sea.settings.foamDecay = 0.0f;
    sea.from = 1.0;
    sea.to = 2.0;
    Foam foam(sea.settings);
    EXPECT_NEAR(sea.at(foam, 1.5), 1.0f, 1e-3f);
    EXPECT_EQ(sea.at(foam, 2.01), 0.0f);
    EXPECT_EQ(sea.asked, 0);
}

// What has an even chance at each tick, and unknown waves in between: the last tick that broke is
// how old with which chance. And time goes on from tick to tick without a jump.
TEST(OceanFoam, ExpectsTheTraceOfIndependentChances) {
    Breaking sea;
    sea.settings.size = gridSize;
    sea.settings.foamDecay = 3.0f;
    sea.from = -1000.0, sea.to = 1000.0;
    sea.most = 0.0f;
    Foam foam(sea.settings);
    double expected = 0.0;
    for (int age = 0; age < 16; ++age) expected += std::exp(-age / 3.0) * std::pow(0.5, age + 1);
    EXPECT_NEAR(sea.at(foam, 20.0), expected, 0.003);
    EXPECT_NEAR(sea.at(foam, 20.999), expected, 0.003);
    sea.to = 19.5;
    Foam faded(sea.settings);
    EXPECT_NEAR(sea.at(faded, 21.25), expected * std::exp(-2.25 / 3.0), 0.003);
}

float meanFoam(const Ocean& ocean) {
    return ocean.slopes({0.0f, 0.0f}, {1.0e4f, 0.0f}, {0.0f, 1.0e4f}).foam;
}

TEST(OceanFoam, GrowsWithWindThresholdAndChoppiness) {
    OceanSettings s;
    s.size = 64;
    s.lengths = {301.0f, 41.3f, 5.23f, 0.0f};
    float before = -1.0f;
    for (const float wind : {4.0f, 8.0f, 12.0f, 18.0f}) {
        s.windSpeed = wind;
        const float foam = meanFoam(Ocean(s));
        EXPECT_GT(foam, before) << wind;
        before = foam;
    }
    // Some percent in a fresh breeze, not half of the sea.
    EXPECT_LT(before, 0.3f);
    s.windSpeed = 12.0f;
    const float usual = meanFoam(Ocean(s));
    EXPECT_GT(usual, 1e-3f);
    s.foamThreshold = 0.3f;
    EXPECT_LT(meanFoam(Ocean(s)), 0.5f * usual);
    s.foamThreshold = 0.55f;
    s.choppiness = 0.0f;
    EXPECT_LT(meanFoam(Ocean(s)), 1e-6f);
}

// Where all cascades together squeeze the surface, foam is likelier than elsewhere.
TEST(OceanFoam, IsWhereTheWholeSeaIsSqueezed) {
    OceanSettings s;
    s.windSpeed = 12.0f;
    s.foamDecay = 0.0f;
    const Ocean ocean(s);
    double squeezed = 0.0, others = 0.0;
    int count = 0, rest = 0;
    for (int i = 0; i < 20000; ++i) {
        const OceanPoint p = ocean.at({3.37f * float(i % 141), 3.53f * float(i / 141)});
        const bool breaks = p.jacobian() < s.foamThreshold;
        (breaks ? squeezed : others) += double(p.foam);
        ++(breaks ? count : rest);
    }
    ASSERT_GT(count, 50);
    EXPECT_GT(squeezed / count, 20.0 * others / rest);
    // These Jacobians are interpolated, which takes some of the shortest waves away.
    const double share = double(count) / (count + rest);
    const double foam = (squeezed + others) / (count + rest);
    EXPECT_GT(foam, 0.8 * share);
    EXPECT_LT(foam, 1.6 * share);
}

TEST(OceanMaps, HoldWhatTheSeaIs) {
    OceanSettings s;
    s.size = 64;
    s.cascades = 2;
    s.lengths = {101.0f, 17.0f, 0.0f, 0.0f};
    Ocean ocean(s);
    ocean.setTime(3.0);
    const std::vector<OceanMap> maps = ocean.maps();
    const struct { const char* name; uint32_t channels; } kinds[] = {
        {"displacement", 3}, {"normal", 3}, {"foam", 1}, {"moments", 5}};
    ASSERT_EQ(maps.size(), 8u);
    for (uint32_t i = 0; i < 8; ++i) {
        EXPECT_EQ(maps[i].name, std::string(kinds[i % 4].name) + "_" + std::to_string(i / 4));
        EXPECT_EQ(maps[i].channels, kinds[i % 4].channels);
        ASSERT_EQ(maps[i].texels.size(), 64u * 64u * maps[i].channels);
    }
    // Column 5 of the third row from above.
    const OceanPoint p = ocean.gridPoint(1, 5, 61);
    const size_t i = 2 * 64 + 5;
    EXPECT_EQ(maps[4].texels[3 * i + 2], p.displacement.z);
    EXPECT_EQ(maps[4].texels[3 * i], p.displacement.x);
    const float* normal = &maps[5].texels[3 * i];
    EXPECT_NEAR(-normal[0] / normal[2], p.slope().x, 1e-5f);
    EXPECT_NEAR(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2], 1.0f, 1e-5f);
    EXPECT_EQ(maps[6].texels[i], p.foam);
    EXPECT_NEAR(maps[7].texels[5 * i + 4], p.slope().x * p.slope().y, 1e-7f);
}

}  // namespace
}  // namespace gp
