// Textures seen head-on give the very numbers of their texels; far away they give their mean.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

// 4 x 2 texels, linear, every one different: R by column, G by row.
struct Texels {
    float pixels[2][4][4];
    Texels() {
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x) {
                const float rgba[4] = {float(x + 1), float(y + 1), 0.5f, 1};
                std::copy_n(rgba, 4, pixels[y][x]);
            }
    }
    glm::vec3 at(int x, int y) const { return {pixels[y][x][0], pixels[y][x][1], pixels[y][x][2]}; }
};

class Textures : public ::testing::TestWithParam<Variant> {
protected:
    static GpTextureDesc desc(const Texels& t) {
        GpTextureDesc d{};
        d.width = 4, d.height = 2, d.format = GP_FORMAT_RGBA32F, d.pixels = t.pixels;
        d.noMipmaps = 1;
        return d;
    }
    // The square [0, 1]^2 shows the texture as it is; texture coordinates are x and y, times
    // `scale`.
    static Picture look(const GpTextureDesc& texture, uint32_t width, uint32_t height,
                        uint32_t samples, float scale = 1, const float* transform = nullptr,
                        uint32_t set = 0, float radius = 0.001f) {
        Stage stage(GetParam());
        Triangles t;
        t.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        for (glm::vec2& uv : t.uv0) uv = glm::vec2(uv.x, 1 - uv.y) * scale;  // v grows downwards
        if (set == 1) {
            t.uv1 = t.uv0;
            t.uv0.assign(6, glm::vec2(0.1f));
        }
        GpMaterialDesc d = lambertDesc(glm::vec3(0));
        put(d.baseColor, glm::vec3(1));
        d.unlit = 1;
        d.baseColorTexture.texture = stage.texture(texture);
        d.baseColorTexture.texCoord = set;
        if (transform) std::copy_n(transform, 6, d.baseColorTexture.transform);
        stage.add(t, stage.material(d));
        GpRenderOptions o = stage.options(samples);
        o.pixelFilter = GP_PIXEL_BOX, o.pixelFilterRadius = radius;  // the pixel's middle
        GpCameraDesc c = lookFrom({0.5f, 0.5f, 0}, {0, 0, 1}, 1, 1);
        c.orthographicHeight = float(height) / float(width);
        return stage.render(width, height, c, o);
    }
    static void expectColor(glm::vec3 got, glm::vec3 wanted, int x, int y) {
        EXPECT_LT(glm::length(got - wanted), 0.01f)
            << x << ", " << y << ": " << got.x << ", " << got.y;
    }
};

TEST_P(Textures, NearestTexelsAndWraps) {
    const Texels t;
    for (const GpWrap wrap : {GP_WRAP_REPEAT, GP_WRAP_CLAMP, GP_WRAP_MIRROR}) {
        GpTextureDesc d = desc(t);
        d.magFilter = d.minFilter = GP_FILTER_NEAREST;
        d.wrapU = d.wrapV = wrap;
        // uv runs from -1 to 2: 12 x 6 texels on 12 x 12 pixels.
        const float transform[6] = {3, 0, -1, 0, 3, -1};
        const Picture p = look(d, 12, 12, 1, 1, transform);
        const auto wrapped = [&](int i, int n) {
            if (wrap == GP_WRAP_CLAMP) return std::clamp(i, 0, n - 1);
            const int repeat = (i + 4 * n) % n, period = (i + 4 * n) / n;
            return wrap == GP_WRAP_MIRROR && period % 2 == 1 ? n - 1 - repeat : repeat;
        };
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x)
                expectColor(p.at(uint32_t(x), uint32_t(y)),
                            t.at(wrapped(x - 4, 4), wrapped(y / 2 - 2, 2)), x, y);
    }
}

TEST_P(Textures, LinearBetweenTexels) {
    const Texels t;
    GpTextureDesc d = desc(t);
    d.wrapU = d.wrapV = GP_WRAP_CLAMP;
    const Picture p = look(d, 16, 16, 1);
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = 0; x < 16; ++x) {
            const float u = (float(x) + 0.5f) / 4 - 0.5f, v = (float(y) + 0.5f) / 8 - 0.5f;
            expectColor(p.at(x, y),
                        {std::clamp(u, 0.0f, 3.0f) + 1, std::clamp(v, 0.0f, 1.0f) + 1, 0.5f},
                        int(x), int(y));
        }
}

TEST_P(Textures, TransformAndSecondSet) {
    const Texels t;
    GpTextureDesc d = desc(t);
    d.magFilter = d.minFilter = GP_FILTER_NEAREST;
    // A quarter turn, u' = v, v' = 1 - u, on the second set.
    const float turn[6] = {0, 1, 0, -1, 0, 1};
    const Picture p = look(d, 8, 8, 1, 1, turn, 1);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            expectColor(p.at(uint32_t(x), uint32_t(y)), t.at(y / 2, x < 4 ? 1 : 0), x, y);
}

TEST_P(Textures, SrgbIsDecodedAndAlphaIsNot) {
    const uint8_t grey[4] = {188, 55, 0, 128};
    GpTextureDesc d{};
    d.width = d.height = 1, d.pixels = grey;
    // IEC 61966-2-1.
    const auto decoded = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const Picture p = look(d, 2, 2, 1);
    EXPECT_NEAR(p.at(0, 0).x, decoded(188 / 255.0), 1e-5);
    EXPECT_NEAR(p.at(1, 1).y, decoded(55 / 255.0), 1e-5);
    d.colorSpace = GP_COLOR_LINEAR;
    EXPECT_NEAR(look(d, 2, 2, 1).at(1, 0).x, 188 / 255.0, 1e-5);
}

// A checker with many fields in each pixel: its mean at every level of detail, for each filter.
TEST_P(Textures, CheckersFarAwayAverage) {
    std::vector<uint8_t> checker(64 * 64 * 4);
    for (size_t y = 0; y < 64; ++y)
        for (size_t x = 0; x < 64; ++x)
            for (size_t c = 0; c < 4; ++c)
                checker[(y * 64 + x) * 4 + c] = c == 3 || (x + y) % 2 ? 255 : 0;
    for (const GpFilter filter : {GP_FILTER_LINEAR, GP_FILTER_NEAREST})
        for (const float repeats : {0.25f, 1.0f, 3.0f, 20.0f}) {
            GpTextureDesc d{};
            d.width = d.height = 64, d.pixels = checker.data();
            d.magFilter = d.minFilter = filter;
            const Picture p = look(d, 16, 16, effort(1024), repeats, nullptr, 0, 0.5f);
            EXPECT_NEAR(p.mean().x, 0.5, 0.004) << "filter " << filter << ", repeats " << repeats;
        }
}

INSTANTIATE_TEST_SUITE_P(All, Textures, ::testing::ValuesIn(allVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
