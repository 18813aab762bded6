// Slope maps of materials through the C interface: one surface as heights, offsets and normals
// gives one picture, from near by and from afar, and changes with its pixels.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t texels = 64;
constexpr float pi = 3.14159265f;

// Waves on 1 x 1 m that repeat; u to the right, v downwards.
float heightAt(glm::vec2 uv) {
    return 0.01f * std::sin(2 * pi * (3 * uv.x + uv.y)) + 0.008f * std::cos(2 * pi * 4 * uv.y);
}
glm::vec2 gradientAt(glm::vec2 uv) {
    const float a = 0.01f * 2 * pi * std::cos(2 * pi * (3 * uv.x + uv.y));
    return {3 * a, a - 0.008f * 2 * pi * 4 * std::sin(2 * pi * 4 * uv.y)};
}

struct Floor {
    explicit Floor(const Variant& v) : variant(v) {}

    std::vector<float> pixels(const std::function<glm::vec3(glm::vec2)>& texel) const {
        std::vector<float> p(size_t(texels) * texels * 4, 1.0f);
        for (uint32_t i = 0; i < texels * texels; ++i) {
            const glm::vec3 t =
                texel((glm::vec2(i % texels, i / texels) + 0.5f) / float(texels));
            p[4 * size_t(i)] = t.x, p[4 * size_t(i) + 1] = t.y, p[4 * size_t(i) + 2] = t.z;
        }
        return p;
    }
    std::vector<float> of(GpSlopeMapKind kind) const {
        return pixels([kind](glm::vec2 uv) {
            const glm::vec2 g = gradientAt(uv);
            const glm::vec3 n = glm::normalize(glm::vec3(-g.x, g.y, 1)) * 0.5f + 0.5f;
            return kind == GP_SLOPE_MAP_NORMAL  ? n
                   : kind == GP_SLOPE_MAP_HEIGHT ? glm::vec3(heightAt(uv), 9, 9)
                                                 : glm::vec3(0, 0, heightAt(uv));
        });
    }
    // 4 x 4 m in the sun with the map on it, four times each way, `height` m of it in the
    // picture. `then`: called between the map's making and the picture.
    Picture look(GpMaterialDesc material, std::vector<GpSlopeMapKind> kinds, float height,
                 const std::function<void(Stage&, GpTexture)>& then = {}) const {
        Stage stage(variant);
        std::vector<GpSlopeMap> maps;
        for (const GpSlopeMapKind kind : kinds) {
            GpTextureDesc d{};
            const std::vector<float> p = of(kind);
            d.width = d.height = texels, d.format = GP_FORMAT_RGBA32F, d.pixels = p.data();
            GpSlopeMap map{};
            map.kind = kind, map.texture.texture = stage.texture(d);
            const float fourTimes[6] = {4, 0, 0, 0, 4, 0};
            std::copy(fourTimes, fourTimes + 6, map.texture.transform);
            maps.push_back(map);
        }
        material.slopeMaps = maps.data(), material.slopeMapCount = uint32_t(maps.size());
        Triangles t;
        t.quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
        for (glm::vec2& uv : t.uv0) uv.y = 1 - uv.y;  // v grows towards the viewer
        stage.add(t, stage.material(material));
        GpLightDesc sun{};
        put(sun.direction, {0.3f, -1, -0.4f});
        sun.intensity = 3, sun.angularRadius = 0.1f;
        stage.light(sun);
        stage.surround(glm::vec3(0.2f));
        if (then) then(stage, maps.empty() ? nullptr : maps[0].texture.texture);
        return stage.render(40, 40, lookFrom({0, 0, 0}, {0, 0.8f, 0.6f}, 5, height),
                            stage.options(16));
    }

    Variant variant;
};

GpMaterialDesc metal(float roughness) {
    GpMaterialDesc d{};
    d.metallic = 1, d.roughness = roughness;
    return d;
}

// Root of the mean squared difference, over the mean of `b`.
double difference(const Picture& a, const Picture& b) {
    double squares = 0;
    for (size_t i = 0; i < a.color.size(); ++i) {
        const glm::dvec3 d(a.color[i] - b.color[i]);
        squares += glm::dot(d, d) / 3;
    }
    return std::sqrt(squares / double(a.color.size())) / (b.mean().y + 1e-9);
}

class SlopeMaps : public ::testing::TestWithParam<Variant> {};

TEST_P(SlopeMaps, HeightsDisplacementsAndNormalsOfOneSurfaceGiveOnePicture) {
    const Floor floor(GetParam());
    for (const float height : {0.5f, 2.0f}) {  // 80 and 20 pixels a metre
        const Picture normals = floor.look(metal(0.5f), {GP_SLOPE_MAP_NORMAL}, height);
        const Picture heights = floor.look(metal(0.5f), {GP_SLOPE_MAP_HEIGHT}, height);
        const Picture offsets = floor.look(metal(0.5f), {GP_SLOPE_MAP_DISPLACEMENT}, height);
        EXPECT_LT(difference(heights, offsets), 0.01) << height;
        // A texel of heights has the slopes of its area, one of normals that of its centre.
        EXPECT_LT(difference(heights, normals), 0.05) << height;
    }
}

TEST_P(SlopeMaps, NewPixelsAndNoMapsAreFlat) {
    const Floor floor(GetParam());
    const Picture flat = floor.look(metal(0.5f), {}, 0.5f);
    const auto flatten = [](Stage& stage, GpTexture texture) {
        // First what it was, so that something is there to be replaced.
        stage.render(8, 8, lookFrom({0, 0, 0}, {0, 0.8f, 0.6f}, 5, 1), stage.options(1));
        const std::vector<float> zeros(size_t(texels) * texels * 4, 0.0f);
        GpTextureUpdate u{};
        u.width = u.height = texels, u.format = GP_FORMAT_RGBA32F, u.pixels = zeros.data();
        stage.check(gpUpdateTexture(texture, &u));
    };
    const Picture bumpy = floor.look(metal(0.5f), {GP_SLOPE_MAP_HEIGHT}, 0.5f);
    EXPECT_GT(difference(bumpy, flat), 0.1);
    EXPECT_LT(difference(floor.look(metal(0.5f), {GP_SLOPE_MAP_HEIGHT}, 0.5f, flatten), flat),
              1e-3);
}

INSTANTIATE_TEST_SUITE_P(Reference, SlopeMaps, ::testing::ValuesIn(bestFullVariant()),
                         [](const auto& i) { return variantName(i.param); });
INSTANTIATE_TEST_SUITE_P(Local, SlopeMaps, ::testing::ValuesIn(localVariants()),
                         [](const auto& i) { return variantName(i.param); });

}  // namespace
}  // namespace gp::test
