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

}  // namespace
}  // namespace gp
