// The published dictionary and its reader, against statistics that were computed from the authors'
// code: that we read the method as they wrote it, and what our dictionary does differently.
//
// Their conventions (Chermain et al. 2020 and 2021, files for pbrt): 192 distributions, three of
// each texel; nodes, not bins; the finest level of the pyramid has 2^15 cells by unit of uv; the
// density is jittered by 2 levels of a normal number and rounded.
#include <filesystem>

#include <gtest/gtest.h>

#include "io/image_file.h"
#include "statistics/golden.h"
#include "water/glint_cases.h"

namespace {

using namespace gp::shading;
using gp::test::number;
using gp::test::Random;

constexpr float dictionaryDeviation = 0.353553391f;  // alpha 0.5

struct PublishedDictionary {
    gp::Image image;

    // Distribution `entry` of a level at x >= 0 in standard deviations: linear between nodes that
    // are 4 / 64 apart, the last one held.
    float density(int level, int entry, float x) const {
        if (x >= 4.0f) return 0.0f;
        const float p = 16.0f * x;
        const int k = std::min(int(p), 63), next = std::min(k + 1, 63);
        const auto node = [&](int i) {
            const size_t texel = size_t(15 - level) * image.width + size_t(entry / 3 * 64 + i);
            return image.floats()[4 * texel + size_t(entry % 3)] * dictionaryDeviation;
        };
        return node(k) + (p - float(k)) * (node(next) - node(k));
    }
};

// P22 of a square pixel as wide as cells of `level`, by the published method but for the hash.
double publishedP22(const PublishedDictionary& dictionary, const Slopes& d, float logDensity,
                    int level, vec2 uv, vec2 s) {
    const float cells = std::exp2(float(15 - level));
    const float cell = 1.0f / cells;
    const GlintFootprint footprint = glint_footprint(vec2(cell, 0.0f), vec2(0.0f, cell));
    const Ellipse e = ellipse_of(footprint, uv, cells, 1.0f);
    const Whitening w = whitening_of(d);
    const vec2 white = whitened(w, s - d.mean);
    const float facets = (logDensity / std::log(2.0f)) * 0.5f + float(level - 15);
    double sum = 0.0, weights = 0.0;
    for (int y = e.first; y <= e.last; ++y) {
        const EllipseRow row = ellipse_row(e, y);
        for (int x = row.start; x <= row.end; ++x) {
            const uvec3 h = hash_u32x3(uvec3(uint(x), uint(y), 1u));
            const vec2 normal = gaussian_pair(vec2(float(h.x >> 8u) * 0x1p-24f, 0.5f));
            const int at = int(clamp(std::round(facets + 2.0f * normal.x), 0.0f, 16.0f));
            const SinCos turn = sincos_turns(float(h.y >> 8u) * 0x1p-24f);
            const int i = int((h.z & 65535u) * 192u >> 16u), j = int((h.z >> 16u) * 192u >> 16u);
            const vec2 r(std::abs(turn.c * white.x + turn.s * white.y),
                         std::abs(turn.c * white.y - turn.s * white.x));
            const float p = at == 16 ? slopes_p22(d, s)
                                     : dictionary.density(at, i, r.x) *
                                           dictionary.density(at, j, r.y) * w.xx * w.yy;
            const double weight = double(ellipse_weight(e, x, y));
            sum += weight * double(p), weights += weight;
        }
    }
    return sum / weights;
}

struct Statistics {
    double mean = 0.0, deviation = 0.0, error = 0.0, zero = 0.0;
};

template <class P22>
Statistics statisticsOf(int count, P22 p22) {
    Random random(17);
    double sum = 0.0, squares = 0.0, zeros = 0.0;
    for (int i = 0; i < count; ++i) {
        const double p = p22(vec2(random.uniform(), random.uniform()));
        sum += p, squares += p * p, zeros += p <= 0.0 ? 1.0 : 0.0;
    }
    Statistics r;
    r.mean = sum / count;
    r.deviation = std::sqrt(squares / count - r.mean * r.mean);
    r.error = r.deviation / std::sqrt(double(count));
    r.zero = zeros / count;
    return r;
}

Slopes slopesOf(const gp::test::GoldenRow& row) {
    Slopes d;
    d.mean = vec2(0.0f);
    const float x = number(row, "sigma_x"), y = number(row, "sigma_y");
    d.var_x = x * x;
    d.var_y = y * y;
    d.cov = number(row, "rho") * x * y;
    return d;
}

// The rows of one convention without the filtering of kernels.
std::vector<gp::test::GoldenRow> nodeRows() {
    std::vector<gp::test::GoldenRow> rows;
    for (const gp::test::GoldenRow& row : gp::test::readGolden("glint/golden_glint_stats.csv"))
        if (row.at("mode") == "node" && row.at("ggaa") == "0") rows.push_back(row);
    return rows;
}

TEST(GlintPublished, StatisticsAreThoseOfTheAuthorsCode) {
    const char* name = "glint/dict_16_192_64_0p5_0p2.exr";
    const std::filesystem::path file =
        std::filesystem::path(GP_SOURCE_DIR) / ".." / "shared" / "golden" / name;
    const std::vector<gp::test::GoldenRow> rows = nodeRows();
    GP_SKIP_WITHOUT(rows, "glint/golden_glint_stats.csv");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "../shared/golden/" << name;
    const PublishedDictionary dictionary{gp::io::loadImage(file.string())};
    ASSERT_EQ(dictionary.image.width, 4096u);
    ASSERT_EQ(rows.size(), 120u);
    int outside = 0, compared = 0;
    double logarithms = 0.0;  // of the ratios of deviations
    for (const gp::test::GoldenRow& row : rows) {
        const Slopes d = slopesOf(row);
        const vec2 s(number(row, "slope_x"), number(row, "slope_y"));
        const int level = int(std::lround(15.0f + std::log2(number(row, "footprint"))));
        const Statistics ours = statisticsOf(20'000, [&](vec2 uv) {
            return publishedP22(dictionary, d, number(row, "log_density"), level, uv, s);
        });
        const double theirs = double(number(row, "mean_P22"));
        const double deviation = double(number(row, "std_P22"));
        const double error = std::hypot(ours.error, deviation / std::sqrt(20'000.0));
        // Their hash repeats cells along diagonals: where densities are high it is off by more than
        // independent points would be, up to 0.5 % over a set of rows.
        outside += std::abs(ours.mean - theirs) > 3.0 * error + 0.004 * theirs ? 1 : 0;
        EXPECT_NEAR(ours.mean, theirs, 4.5 * error + 0.004 * theirs) << row.at("log_density");
        if (number(row, "log_density") >= 18.0f) {
            logarithms += std::log(ours.deviation / deviation), ++compared;
        }
    }
    // Of 120 means 0.3 are beyond three standard errors by chance.
    EXPECT_LE(outside, 2);
    // Twice as many facets in a cell would show as 0.35; single deviations have heavy tails.
    EXPECT_EQ(compared, 72);
    EXPECT_NEAR(logarithms / compared, 0.0, 0.1);
    std::printf("  logarithm of the ratio of deviations: %.3f\n", logarithms / compared);
}

// In our own dictionary the mean is Beckmann's, where the published one is up to 27 % above it.
TEST(GlintPublished, OursHasTheMeanOfBeckmann) {
    const std::vector<gp::test::GoldenRow> rows = nodeRows();
    GP_SKIP_WITHOUT(rows, "glint/golden_glint_stats.csv");
    double worst = 0.0, published = 0.0;
    for (const gp::test::GoldenRow& row : rows) {
        Glint g{};
        g.slopes = slopesOf(row);
        g.d0.x = g.d1.y = number(row, "footprint");
        g.log_density = number(row, "log_density");
        g.area = 1.0f;
        g.jitter = 2.0f;
        g.dictionary = gp::glintDictionary();
        const vec2 s(number(row, "slope_x"), number(row, "slope_y"));
        const Statistics ours = statisticsOf(20'000, [&](vec2 uv) {
            g.uv = uv;
            return double(glint_p22(g, s));
        });
        const double beckmann = double(slopes_p22(g.slopes, s));
        const double ratio = ours.mean / beckmann;
        EXPECT_NEAR(ratio, 1.0, 0.02 + 3.0 * ours.error / beckmann) << row.at("log_density");
        worst = std::max(worst, std::abs(ratio - 1.0) - ours.error / beckmann);
        published = std::max(published, std::abs(double(number(row, "mean_over_beckmann")) - 1.0));
    }
    std::printf("  mean over Beckmann: off by %.3f at most (published: %.3f)\n", worst, published);
    EXPECT_LT(worst, 0.5 * published);
}

}  // namespace
