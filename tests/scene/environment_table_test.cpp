// The table that environment directions are chosen from.
#include "scene/environment_table.h"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "scene/image.h"
#include "shading/shading.h"

namespace gp {
namespace {

// Dim noise with a sun of one texel: five orders of magnitude.
Image sunny(uint32_t width, uint32_t height) {
    Image image{width, height, PixelFormat::rgba32f, {}};
    image.pixels.resize(size_t(width) * height * 16);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> dim(0.0f, 0.2f);
    for (size_t i = 0; i < size_t(width) * height * 4; ++i) image.floats()[i] = dim(random);
    for (size_t c = 0; c < 3; ++c) image.floats()[4 * (5 * width + 3) + c] = 20000;
    return image;
}

TEST(EnvironmentTable, AliasesGiveEveryCellItsShare) {
    const Image image = sunny(96, 48);
    const EnvironmentTable table = *makeEnvironmentTable(image.floats(), 96, 48);
    ASSERT_EQ(table.side, 128u);
    const double count = double(table.cells.size());
    std::vector<double> share(table.cells.size());
    double sum = 0;
    for (size_t i = 0; i < table.cells.size(); ++i) {
        const shared::EnvironmentCell& c = table.cells[i];
        share[i] += double(c.keep) / count;
        share[c.alias] += (1 - double(c.keep)) / count;
        sum += double(table.density(uint32_t(i))) / count;
    }
    EXPECT_NEAR(sum, 1, 1e-5);
    for (size_t i = 0; i < share.size(); ++i)
        ASSERT_NEAR(share[i], double(table.density(uint32_t(i))) / count, 2e-6 * share[i] + 1e-10)
            << i;
}

TEST(EnvironmentTable, EveryLitDirectionHasADensity) {
    Image image{64, 32, PixelFormat::rgba32f, {}};
    image.pixels.resize(64 * 32 * 16);
    for (size_t c = 0; c < 3; ++c) image.floats()[4 * (9 * 64) + c] = 1;  // at the left edge
    const EnvironmentTable table = *makeEnvironmentTable(image.floats(), 64, 32);
    for (uint32_t y = 0; y < table.side; ++y)
        for (uint32_t x = 0; x < table.side; ++x) {
            // Bilinear reading spreads the texel over one texel's width on each side.
            const double px = (x + 0.5) / table.side * 64 - 0.5,
                         py = (y + 0.5) / table.side * 32 - 0.5;
            const double dx = std::min(std::abs(px), 64 - std::abs(px));
            if (dx < 1 && std::abs(py - 9) < 1) {
                EXPECT_GT(table.density(shading::morton_from_cell({x, y})), 0) << x << ' ' << y;
            }
        }
}

TEST(EnvironmentTable, BlackImagesHaveNone) {
    Image image{8, 4, PixelFormat::rgba32f, {}};
    image.pixels.resize(8 * 4 * 16);
    EXPECT_TRUE(makeEnvironmentTable(image.floats(), 8, 4)->black());
}

// Numbers of 24 bits, as the sampler gives them: even in the largest table the choice between a
// cell and its alias must be fine, or densities lie.
TEST(EnvironmentTable, LargeTablesLeaveBitsToChooseWith) {
    std::mt19937 random(3);
    std::set<float> rests;
    constexpr int n = 1 << 18;
    constexpr float threshold = 0.3712f;
    int below = 0;
    for (int i = 0; i < n; ++i) {
        const glm::vec2 u(float(random() >> 8) * 0x1p-24f, float(random() >> 8) * 0x1p-24f);
        const shading::AliasPick p = shading::alias_pick(u, 512 * 512);
        ASSERT_LT(p.index, 512u * 512u);
        ASSERT_TRUE(p.rest >= 0 && p.rest < 1 && p.row > 0 && p.row < 1);
        rests.insert(p.rest);
        below += p.rest < threshold;
    }
    EXPECT_GT(rests.size(), 100000u);
    const double sigma = std::sqrt(n * threshold * (1 - threshold));
    EXPECT_NEAR(below, n * threshold, 4 * sigma);
}

// A sky that brightens to the right and below a dark half.
std::vector<glm::vec4> slope(float scale, uint32_t shift = 0) {
    std::vector<glm::vec4> pixels;
    for (uint32_t y = 0; y < 32; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            pixels.emplace_back(glm::vec3(y < 16 ? scale * float((x + shift) % 64) : 0.0f), 1);
    return pixels;
}

TEST(SkyTable, DirectionsStayWhileRadianceChanges) {
    const std::vector<glm::vec4> first = slope(1), second = slope(3, 1);
    const auto table = makeSkyTable(&first[0].x, 64, 32);
    const auto densities = table->densities;
    const double mean = table->meanLuminance;
    ASSERT_TRUE(refreshSkyTable(*table, &second[0].x));
    EXPECT_EQ(table->densities, densities);
    EXPECT_EQ(table->radiance(9, 3).x, 30);
    EXPECT_NEAR(table->meanLuminance, 3 * mean, 1e-6 * mean);
    EXPECT_NEAR(table->mean.y, 3 * mean, 1e-6 * mean);
}

TEST(SkyTable, LightElsewhereNeedsAnotherOne) {
    const std::vector<glm::vec4> first = slope(1), black(64 * 32, glm::vec4(0));
    std::vector<glm::vec4> second = first;
    second[30 * 64 + 5] = glm::vec4(1e4f);
    const auto table = makeSkyTable(&first[0].x, 64, 32);
    EXPECT_FALSE(refreshSkyTable(*table, &second[0].x));
    EXPECT_FALSE(refreshSkyTable(*table, &black[0].x));
    EXPECT_EQ(table->radiance(9, 3).x, 9);
    EXPECT_TRUE(makeSkyTable(&black[0].x, 64, 32)->black());
    // Light may appear anywhere.
    for (uint32_t i = 0; i < table->side * table->side; ++i) ASSERT_GT(table->density(i), 0) << i;
}

}  // namespace
}  // namespace gp
