// Images of slope moments: known height fields, any footprint against all texels under it, and
// mean slopes far above the spread.
#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/slope/lean.glsl"
GP_SHADING_END

#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/mipmap.h"
#include "scene/slope_map.h"
#include "shared/scene_structs.h"
#include "statistics/random.h"

namespace gp {
namespace {

using namespace gp::shading;
using namespace gp::shared;

// The kernel's reading, over a map of ours.
struct Reader {
    const SlopeMap& source;

    SlopeMapSize load_slope_map(uint) const {
        const bool repeats = source.wrapU != Wrap::clampToEdge && source.wrapV != Wrap::clampToEdge;
        return {source.levels[0].width, source.levels[0].height, uint(source.levels.size()),
                repeats ? 1u : 0u};
    }
    Slopes load_slopes(uint, int level, int x, int y) const {
        const MipLevel& l = source.levels[size_t(level)];
        const int i = wrapped_texel(x, int(l.width), uint(source.wrapU));
        const int j = wrapped_texel(y, int(l.height), uint(source.wrapV));
        return slope_texel_decode(std::bit_cast<SlopeTexel>(
            source.texels[l.offset + size_t(j) * l.width + size_t(i)]));
    }
#include "kernels/slope_map.glsl"
};

// Raw moments in double: what LEAN would store if precision were no question.
struct Raw {
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0, weight = 0;

    void add(double sx, double sy, double w) {
        x += w * sx, y += w * sy, xx += w * sx * sx, yy += w * sy * sy, xy += w * sx * sy;
        weight += w;
    }
    void add(const Slopes& s, double w) {
        add(s.mean.x, s.mean.y, w);
        xx += w * double(s.var_x), yy += w * double(s.var_y), xy += w * double(s.cov);
    }
    double meanX() const { return x / weight; }
    double meanY() const { return y / weight; }
    double varX() const { return xx / weight - meanX() * meanX(); }
    double varY() const { return yy / weight - meanY() * meanY(); }
    double cov() const { return xy / weight - meanX() * meanY(); }
};

void expectMoments(const Slopes& s, const Raw& r, double tolerance) {
    const double variance = std::max(r.varX() + r.varY(), 1e-12);
    EXPECT_NEAR(s.mean.x, r.meanX(), tolerance * std::sqrt(variance));
    EXPECT_NEAR(s.mean.y, r.meanY(), tolerance * std::sqrt(variance));
    EXPECT_NEAR(s.var_x, r.varX(), tolerance * variance);
    EXPECT_NEAR(s.var_y, r.varY(), tolerance * variance);
    EXPECT_NEAR(s.cov, r.cov(), tolerance * variance);
}

std::shared_ptr<Texture> normalMap(uint32_t w, uint32_t h, auto&& slope, Wrap wrap = Wrap::repeat) {
    TextureDesc d;
    d.image.width = w, d.image.height = h, d.image.format = PixelFormat::rgba32f;
    d.image.pixels.resize(size_t(w) * h * 16);
    d.colorSpace = ColorSpace::linear;
    d.wrapU = d.wrapV = wrap;
    for (uint32_t y = 0; y < h; ++y)
        for (uint32_t x = 0; x < w; ++x) {
            const glm::vec2 s = slope(x, y);
            const glm::vec3 n = glm::normalize(glm::vec3(-s, 1)) * 0.5f + 0.5f;
            float* p = d.image.floats() + 4 * (size_t(y) * w + x);
            p[0] = n.x, p[1] = n.y, p[2] = n.z, p[3] = 1;
        }
    return makeTexture(std::move(d));
}

std::shared_ptr<Texture> randomMap(uint32_t w, uint32_t h, glm::vec2 mean, float sigma) {
    test::Random random(7);
    return normalMap(w, h, [&](uint32_t, uint32_t) {
        const float a = random.uniform() - 0.5f, b = random.uniform() - 0.5f;
        // Uniform, correlated, of different widths.
        return mean + sigma * 3.4641f * glm::vec2(a, 0.5f * (0.6f * a + 0.8f * b));
    });
}

Slopes texelOf(const SlopeMap& map, size_t level, uint32_t x, uint32_t y) {
    const MipLevel& l = map.levels[level];
    return slope_texel_decode(
        std::bit_cast<SlopeTexel>(map.texels[l.offset + size_t(y) * l.width + x]));
}

TEST(SlopeMap, LevelsAreMomentsOfTheirAreasAtOddSizesToo) {
    const uint32_t w = 37, h = 11;
    const SlopeMap map = slopeMapFromNormals(*randomMap(w, h, {0.2f, -0.1f}, 0.1f));
    ASSERT_EQ(map.levels.size(), 6u);
    for (size_t level = 0; level < map.levels.size(); ++level) {
        const MipLevel& l = map.levels[level];
        for (uint32_t y = 0; y < l.height; ++y)
            for (uint32_t x = 0; x < l.width; ++x) {
                // The polyphase box is exact of one level to the next; of two, its middle weights
                // are those of the box of both only for the whole image. Levels 0, 1 and the last.
                if (level > 1 && level + 1 < map.levels.size()) continue;
                Raw raw;
                const double x0 = double(x) * w / l.width, x1 = double(x + 1) * w / l.width;
                const double y0 = double(y) * h / l.height, y1 = double(y + 1) * h / l.height;
                for (uint32_t j = 0; j < h; ++j)
                    for (uint32_t i = 0; i < w; ++i) {
                        const double a = std::min(x1, i + 1.0) - std::max(x0, double(i));
                        const double b = std::min(y1, j + 1.0) - std::max(y0, double(j));
                        if (a > 1e-9 && b > 1e-9) raw.add(texelOf(map, 0, i, j), a * b);
                    }
                // Halves: 2^-11 of a deviation is 1e-3 of a variance.
                expectMoments(texelOf(map, level, x, y), raw, 1.1e-3);
            }
    }
}

// The weight that the reading gives to each texel of level 0, by reading maps that are 1 there:
// the mean is linear in the texels. Then raw moments in double say what it should have found.
TEST(SlopeMap, AFootprintsMomentsAreThoseOfAllTexelsUnderIt) {
    const uint32_t w = 16, h = 12;
    const auto source = randomMap(w, h, {0.3f, 0.1f}, 0.05f);
    const SlopeMap map = slopeMapFromNormals(*source);
    const struct { glm::vec2 uv, d0, d1; } footprints[] = {
        {{0.31f, 0.62f}, {0.01f, 0}, {0, 0.01f}},        // magnified
        {{0.31f, 0.62f}, {0.2f, 0.05f}, {-0.03f, 0.1f}}, // a rotated ellipse
        {{0.9f, -0.4f}, {0.5f, 0.4f}, {0.02f, 0.04f}},   // long, over the edge
        {{7.3f, 2.2f}, {0.4f, 0}, {0, 0.35f}},           // several texels both ways
        {{0.5f, 0.5f}, {3, 1}, {0.5f, 4}},               // more than the image
        {{0.2f, 0.2f}, {0.3f, 0.3f}, {0.3f, 0.3f}},      // no area
    };
    for (const auto& f : footprints) {
        Raw raw;
        for (uint32_t y = 0; y < h; ++y)
            for (uint32_t x = 0; x < w; ++x) {
                const auto one = normalMap(w, h, [&](uint32_t i, uint32_t j) {
                    return glm::vec2(i == x && j == y ? 1.0f : 0.0f, 0);
                });
                const SlopeMap unit = slopeMapFromNormals(*one);
                const double weight = Reader{unit}.read_slope_map(0, f.uv, f.d0, f.d1).mean.x;
                EXPECT_GE(weight, -1e-6);
                raw.add(texelOf(map, 0, x, y), weight);
            }
        EXPECT_NEAR(raw.weight, 1, 1e-4);
        expectMoments(Reader{map}.read_slope_map(0, f.uv, f.d0, f.d1), raw, 2e-3);
    }
}

// Of a map whose slopes are its texels' positions, the covariance is that of the filter itself.
TEST(SlopeMap, TheReadingCoversTheEllipseOfThePixel) {
    const uint32_t n = 512;
    const SlopeMap map = slopeMapFromNormals(*normalMap(
        n, n, [](uint32_t x, uint32_t y) { return glm::vec2(x, y) / float(n); }));
    const struct { glm::vec2 d0, d1; } pixels[] = {
        {{3, 0}, {0, 3}}, {{12, 0}, {0, 12}}, {{40, 10}, {-2, 8}}, {{3, 60}, {6, 2}},
        {{50, 50}, {-5, 5}}, {{9, 0}, {40, 20}}};
    for (const auto& p : pixels) {
        const glm::vec2 centre(261.3f, 247.8f);
        const Slopes s = Reader{map}.read_slope_map(0, centre / float(n), p.d0 / float(n),
                                                    p.d1 / float(n));
        // Centred on the pixel, to an eighth of it.
        const glm::vec2 off = s.mean * float(n) + 0.5f - centre;
        EXPECT_LT(glm::length(off), 0.125f * glm::length(p.d0 + p.d1)) << p.d0.x;
        // In pixels: a box has a variance of 1/12, a good filter about 1/5 (a Gaussian that leaves
        // no aliases), a long ellipse's short axis is widened where probes end (1/16 of the long).
        const glm::mat2 toPixel = glm::inverse(glm::mat2(p.d0, p.d1));
        const glm::mat2 covariance =
            toPixel * glm::mat2(s.var_x, s.cov, s.cov, s.var_y) * glm::transpose(toPixel) *
            (float(n) * float(n));
        const float half = 0.5f * (covariance[0][0] + covariance[1][1]);
        const float radius = std::sqrt(half * half - glm::determinant(covariance));
        EXPECT_GT(half - radius, 0.07f) << p.d0.x << ' ' << p.d0.y;
        EXPECT_LT(half + radius, 0.4f) << p.d0.x << ' ' << p.d0.y;
    }
}

DisplacementGrid heights(uint32_t w, uint32_t h, auto&& height) {
    DisplacementGrid g;
    g.width = w, g.height = h;
    g.extent = {float(w) * 0.5f, float(h) * 0.25f};  // texels of 0.5 by 0.25 metres
    g.offset = [height](uint32_t x, uint32_t y) { return glm::vec3(0, 0, height(x, y)); };
    return g;
}

TEST(SlopeMap, KnownHeightFields) {
    // A plane, away from where it jumps: x to the right, y up.
    DisplacementGrid plane = heights(16, 16, [](uint32_t x, uint32_t y) {
        return 0.1f * 0.5f * float(x) - 0.2f * 0.25f * float(y);
    });
    plane.wrapU = plane.wrapV = Wrap::clampToEdge;
    const Slopes p = texelOf(slopeMapFromDisplacement(plane), 0, 8, 8);
    EXPECT_NEAR(p.mean.x, 0.1f, 1e-5f);
    EXPECT_NEAR(p.mean.y, 0.2f, 1e-5f);
    EXPECT_NEAR(p.var_x + p.var_y, 0, 1e-9f);

    // A sine: no mean slope, variance (a k)^2 / 2 of the bilinear surface, which is that of the
    // sine times sinc(k dx / 2)^2.
    const float a = 0.05f, k = TWO_PI / 8 / 0.5f;
    const SlopeMap sine = slopeMapFromDisplacement(heights(64, 8, [&](uint32_t x, uint32_t) {
        return a * std::sin(k * 0.5f * float(x));
    }));
    const Slopes whole = texelOf(sine, sine.levels.size() - 1, 0, 0);
    const float sinc = std::sin(k * 0.25f) / (k * 0.25f);
    EXPECT_NEAR(whole.mean.x, 0, 1e-6f);
    EXPECT_NEAR(whole.var_x, 0.5f * a * a * k * k * sinc * sinc, 1e-3f * whole.var_x);
    EXPECT_NEAR(whole.var_y, 0, 1e-9f);

    // A roof of slopes +0.3 and -0.3 along y with its ridge on texels' centres.
    const SlopeMap roof = slopeMapFromDisplacement(heights(8, 16, [](uint32_t, uint32_t y) {
        return 0.3f * 0.25f * float(y % 8 < 4 ? y % 8 : 8 - y % 8);
    }));
    const Slopes ridge = texelOf(roof, 0, 3, 4), side = texelOf(roof, 0, 3, 2);
    EXPECT_NEAR(ridge.mean.y, 0, 1e-6f);
    EXPECT_NEAR(ridge.var_y, 0.09f, 1e-4f);
    EXPECT_NEAR(side.mean.y, -0.3f, 1e-6f);
    EXPECT_NEAR(side.var_y, 0, 1e-9f);
    EXPECT_NEAR(texelOf(roof, roof.levels.size() - 1, 0, 0).var_y, 0.09f, 1e-4f);
}

// The exact claim: all of a texel's area, against 100 x 100 points of the bilinear surface.
TEST(SlopeMap, RoughHeightsAndDisplacementAgreeWithTheirSurface) {
    const uint32_t n = 6;
    test::Random random(3);
    std::vector<glm::vec3> offsets(n * n);
    for (auto& o : offsets)
        o = {0.1f * random.uniform(), 0.1f * random.uniform(), 0.3f * random.uniform()};
    for (const float choppy : {0.0f, 1.0f}) {
        DisplacementGrid g;
        g.width = g.height = n, g.extent = glm::vec2(n);
        const auto at = [&](uint32_t x, uint32_t y) {
            return offsets[(y % n) * n + x % n] * glm::vec3(choppy, choppy, 1);
        };
        g.offset = at;
        const SlopeMap map = slopeMapFromDisplacement(g);
        // Texel (2, 3): the position of the displaced point as a function, differences of it.
        const auto point = [&](double u, double v) {
            const double x = u - 0.5, y = v - 0.5, fx = x - std::floor(x), fy = y - std::floor(y);
            const uint32_t i = uint32_t(x), j = uint32_t(y);
            const glm::dvec3 o =
                glm::mix(glm::mix(glm::dvec3(at(i, j)), glm::dvec3(at(i + 1, j)), fx),
                         glm::mix(glm::dvec3(at(i, j + 1)), glm::dvec3(at(i + 1, j + 1)), fx), fy);
            return glm::dvec3(u, -v, 0) + o;
        };
        Raw raw;
        for (int j = 0; j < 100; ++j)
            for (int i = 0; i < 100; ++i) {
                const double u = 2 + (i + 0.5) / 100, v = 3 + (j + 0.5) / 100, e = 1e-4;
                const glm::dvec3 normal = glm::cross(point(u + e, v) - point(u - e, v),
                                                     point(u, v - e) - point(u, v + e));
                raw.add(-normal.x / normal.z, -normal.y / normal.z, 1);
            }
        // Slopes of displaced points are no polynomials: 16 points leave some of them.
        expectMoments(texelOf(map, 0, 2, 3), raw, choppy == 0 ? 1e-3 : 5e-3);
    }
}

float asHalf(double x) { return unpackHalf2x16(packHalf2x16(vec2(float(x), 0))).x; }

// The table of docs/water.md: the error of the variance along x, as a share of it.
TEST(SlopeMap, SlopesFarAboveTheirSpreadKeepIt) {
    const uint32_t n = 64;
    for (const float sigma : {0.1f, 0.01f, 0.001f}) {
        const SlopeMap map = slopeMapFromNormals(*randomMap(n, n, {1.0f, -1.0f}, sigma));
        Raw raw;
        for (uint32_t y = 0; y < n; ++y)
            for (uint32_t x = 0; x < n; ++x) raw.add(texelOf(map, 0, x, y), 1);
        const double mean = raw.meanX(), second = raw.xx / raw.weight;
        const float meanFloat = float(mean), secondFloat = float(second);
        const double floats = double(secondFloat - meanFloat * meanFloat) / raw.varX() - 1;
        const double halves =
            double(asHalf(second) - asHalf(mean) * asHalf(mean)) / raw.varX() - 1;
        const Slopes top = texelOf(map, map.levels.size() - 1, 0, 0);
        const double ours = double(top.var_x) / raw.varX() - 1;
        fmt::print("sigma {}: raw halves {:.2g}, raw floats {:.2g}, ours {:.2g}\n", sigma, halves,
                   floats, ours);
        expectMoments(top, raw, 1.5e-3);
        if (sigma == 0.001f) {
            EXPECT_GT(std::abs(halves), 0.9) << "raw halves would do, and cost less";
            EXPECT_GT(std::abs(floats), 0.01) << "raw floats would do";
        }
        // What the pixel's own filter leaves out, of noise of 64 texels a side.
        expectMoments(Reader{map}.read_slope_map(0, {0.4f, 0.3f}, {1, 0.2f}, {0.1f, 1}), raw, 0.06);
    }
}

TEST(SlopeMap, TwoMapsOfIndependentSlopesAddUp) {
    // Every pair of texels of both maps once: slopes of one say nothing of the other's.
    const uint32_t n = 8;
    const SlopeMap a = slopeMapFromNormals(*randomMap(n, n, {0.2f, 0.1f}, 0.1f));
    const SlopeMap b = slopeMapFromNormals(*randomMap(n, n, {-0.4f, 0.3f}, 0.03f));
    const vec2 scale(0.5f, 2.0f);
    Raw raw;
    for (uint32_t i = 0; i < n * n; ++i)
        for (uint32_t j = 0; j < n * n; ++j) {
            const vec2 s = texelOf(a, 0, i % n, i / n).mean +
                           scale * texelOf(b, 0, j % n, j / n).mean;
            raw.add(s.x, s.y, 1);
        }
    const Slopes sum = slopes_added(texelOf(a, 3, 0, 0), slopes_scaled(texelOf(b, 3, 0, 0), scale));
    expectMoments(sum, raw, 1e-3);
}

TEST(SlopeMap, NoInputMakesWhatIsNotFinite) {
    const float nan = NAN, inf = INFINITY;
    auto texture = normalMap(4, 4, [](uint32_t, uint32_t) { return glm::vec2(0.1f); });
    auto* pixels = reinterpret_cast<float*>(texture->pixels.data());
    pixels[0] = nan, pixels[5] = inf, pixels[10] = -inf, pixels[12] = pixels[13] = pixels[14] = 0;
    const SlopeMap map = slopeMapFromNormals(*texture);
    for (const float u : {0.1f, 1e9f, -1e30f, nan, inf})
        for (const float d : {0.0f, 1e-30f, 0.3f, 1e30f, nan, inf}) {
            const Slopes s = Reader{map}.read_slope_map(0, {u, 0.3f}, {d, 0.1f}, {0, d});
            EXPECT_TRUE(std::isfinite(s.mean.x + s.mean.y + s.var_x + s.var_y + s.cov)) << u << d;
            EXPECT_LE(std::abs(s.mean.x), SLOPE_LIMIT);
            EXPECT_GE(s.var_x, 0.0f);
        }
    DisplacementGrid g = heights(4, 4, [&](uint32_t x, uint32_t) { return x == 1 ? nan : 1e30f; });
    for (const PackedSlopes& p : slopeMapFromDisplacement(g).texels)
        EXPECT_TRUE(std::isfinite(p.meanX) && std::isfinite(p.correlation));
    g.extent.x = 0;
    EXPECT_THROW(slopeMapFromDisplacement(g), std::invalid_argument);
    g.extent.x = 1, g.width = 0;
    EXPECT_THROW(slopeMapFromDisplacement(g), std::invalid_argument);
    g.width = 4, g.wrapU = Wrap::mirroredRepeat;
    EXPECT_THROW(slopeMapFromDisplacement(g), std::invalid_argument);
}

}  // namespace
}  // namespace gp
