// The loops over cells, which compilers turn into vectors, against the cells one by one.
#include <gtest/gtest.h>

#include "water/glint_cases.h"

namespace {

using namespace gp::shading;
using gp::test::glintCases;
using gp::test::NamedGlint;
using gp::test::Random;

struct Mean {
    double value = 0.0;
    int cells = 0;
};

// Of all cells of one level whose weight is not 0, those far outside too.
Mean meanOf(const GlintQuery& q, const Ellipse& e, const GlintLevel& level) {
    Mean mean;
    double weights = 0.0;
    const int middle = int(std::floor(e.centre.x));
    for (int y = e.first - 2; y <= e.last + 2; ++y) {
        for (int x = middle - 20; x <= middle + 20; ++x) {
            const double weight = double(ellipse_weight(e, x, y));
            if (weight <= 0.0) continue;
            const GlintCell c = glint_cell(level, x, y);
            const float sx = std::abs(c.turn.c * q.slope.x + c.turn.s * q.slope.y);
            const float sy = std::abs(c.turn.c * q.slope.y - c.turn.s * q.slope.x);
            const GlintWidth wx = glint_width(glint_kernel_along(q, c.turn.c, c.turn.s));
            const GlintWidth wy = glint_width(glint_kernel_along(q, -c.turn.s, c.turn.c));
            const double roots = double(GLINT_ROOT) * double(GLINT_ROOT);
            const double facets = double(glint_marginal(q.table, c.row_x, wx, sx)) *
                                  double(glint_marginal(q.table, c.row_y, wy, sy)) *
                                  double(q.scale) / (roots * roots);
            mean.value += weight * glm::mix(double(q.gaussian), facets, double(c.share));
            weights += weight;
            ++mean.cells;
        }
    }
    mean.value /= weights;
    return mean;
}

// Footprints of all shapes in all directions, slopes out to where tables end and beyond.
TEST(GlintCells, LoopsOverBlocksAreTheMeanOverCells) {
    Random random(21);
    int fewest = 1000, most = 0, rows = 0;
    for (const NamedGlint& c : glintCases()) {
        Glint g = c.glint;
        for (int i = 0; i < 2000; ++i) {
            // Near the origin: far from it floats do not tell which cells are within an ellipse.
            g.uv = 0.01f * vec2(random.uniform(), random.uniform());
            g.seed = random.next();
            const float length = glm::length(c.glint.d0), width = length * random.uniform();
            const SinCos turn = sincos_turns(random.uniform());
            g.d0 = length * vec2(turn.c, turn.s);
            g.d1 = width * vec2(-turn.s, turn.c);
            const Slopes d = glint_slopes_within(g);
            const Whitening w = whitening_of(d);
            const SinCos way = sincos_turns(random.uniform());
            const vec2 at = 5.6f * random.uniform() * vec2(way.c, way.s);
            const GlintPyramid p = glint_pyramid(g);
            if (p.smooth_only) continue;
            const GlintQuery q = glint_query(g, d, w, d.mean + unwhitened(w, at));
            const GlintSteps s = glint_steps(p, g.uv, g.seed);
            const Mean low = meanOf(q, s.low_cells, s.low);
            const Mean high = meanOf(q, s.high_cells, s.high);
            const double mean = glm::mix(low.value, high.value, double(s.share));
            const double peak = double(slopes_p22(d, d.mean));
            ASSERT_NEAR(double(glint_mean_of_cells(q, s)), mean, 2e-5 * mean + 1e-5 * peak)
                << c.name << ' ' << i;
            fewest = std::min(fewest, low.cells);
            most = std::max(most, low.cells + high.cells);
            rows = std::max(rows, ellipse_rows(s.low_cells) + ellipse_rows(s.high_cells));
        }
    }
    EXPECT_LE(fewest, 3);
    EXPECT_GT(most, 2 * GLINT_BLOCK);
    EXPECT_GT(rows, 8);  // the loop over rows has two turns
}

// Widths by the bits of a float against the definition: the mixture has the kernel's variance.
TEST(GlintCells, WidthsMixToTheVariance) {
    for (int i = 0; i <= 1000; ++i) {
        const float kernel = float(i) / 1000.0f;
        const GlintWidth w = glint_width(kernel);
        ASSERT_LE(w.width, 3u);
        ASSERT_GE(w.share, -1e-6f);
        ASSERT_LE(w.share, 1.0f + 1e-6f);
        const double narrow = std::exp2(2.0 * w.width) / 256.0;
        EXPECT_NEAR(narrow * (1.0 + 3.0 * double(w.share)), (1.0 + 255.0 * double(kernel)) / 256.0,
                    1e-6);
    }
    // Differences of kernels are below 0 by rounding.
    EXPECT_EQ(glint_width(-1e-6f).width, 0u);
    EXPECT_EQ(glint_width(-1e-6f).share, 0.0f);
    EXPECT_EQ(glint_width(7.0f).share, 1.0f);
    EXPECT_EQ(glint_width(std::nanf("")).share, 1.0f);
}

}  // namespace
