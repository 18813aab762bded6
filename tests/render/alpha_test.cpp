// What rays of each kind pass through: masks, blending, vertex alpha, visibility bits, blockers.
// The same layer is met by camera rays, by shadow rays and by bounces; the answer must be the same.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {
namespace {

enum class RayKind { camera, shadow, bounce };

// Layers of the unit square at heights z = 1, 1.1, ... between the camera, or a surface, and the
// light.
using Layers = std::function<void(Stage&)>;

Triangles square(float z) {
    Triangles t;
    t.quad({-0.5f, -0.5f, z}, {1, 0, 0}, {0, 1, 0});
    return t;
}

class Alpha : public ::testing::TestWithParam<Variant> {
protected:
    // The picture of what passes the layers: 1 where everything does.
    static Picture passing(RayKind kind, const Layers& layers, uint32_t samples) {
        Stage stage(GetParam());
        layers(stage);
        const bool camera = kind == RayKind::camera;
        if (kind == RayKind::shadow) {
            GpLightDesc sun{};
            sun.intensity = float(pi);
            put(sun.direction, {0, 0, -1});
            stage.light(sun);
            stage.add(square(0), stage.lambert(glm::vec3(1)));
        } else {
            stage.surround(glm::vec3(1));
        }
        if (kind == RayKind::bounce) {
            GpMaterialDesc mirror{};
            mirror.given = GP_GIVEN_ROUGHNESS;
            mirror.metallic = 1;
            stage.add(square(0), stage.material(mirror));
        }
        GpRenderOptions o = stage.options(samples);
        o.pixelFilter = GP_PIXEL_BOX;
        // A height of 1 shows the square exactly; cameras for the others stand under the layers.
        return stage.render(16, 16, lookFrom({0, 0, 0}, {0, 0, 1}, camera ? 5 : 0.5f, 1), o);
    }
    static std::vector<RayKind> kinds() {
        if (GetParam().shading == GP_SHADING_FULL)
            return {RayKind::camera, RayKind::shadow, RayKind::bounce};
        return {RayKind::camera, RayKind::shadow};  // no mirrors in plain-diffuse shading
    }
};

GpMaterialDesc black(GpAlphaMode mode, float alpha) {
    GpMaterialDesc d = lambertDesc(glm::vec3(0));
    d.alphaMode = mode;
    d.baseColor[3] = alpha;
    return d;
}

TEST_P(Alpha, OpaqueBlocksEverything) {
    for (const RayKind kind : kinds()) {
        const Picture p = passing(
            kind, [](Stage& s) { s.add(square(1), s.lambert(glm::vec3(0))); }, 4);
        for (const glm::vec4& c : p.color) EXPECT_EQ(glm::vec3(c), glm::vec3(0)) << int(kind);
    }
}

// A checker of alpha 0 and 1 with as many fields as pixels: each pixel is wholly open or closed.
TEST_P(Alpha, MaskOfACheckerIsExact) {
    const uint8_t alpha[16] = {9, 9, 9, 255, 9, 9, 9, 0, 9, 9, 9, 0, 9, 9, 9, 255};
    const Layers layers = [&](Stage& s) {
        GpTextureDesc texture{};
        texture.width = texture.height = 2;
        texture.pixels = alpha;
        texture.magFilter = texture.minFilter = GP_FILTER_NEAREST;
        GpMaterialDesc d = black(GP_ALPHA_MASK, 1);
        d.baseColorTexture.texture = s.texture(texture);
        const float scale[6] = {8, 0, 0, 0, 8, 0};
        std::copy_n(scale, 6, d.baseColorTexture.transform);
        s.add(square(1), s.material(d));
    };
    for (const RayKind kind : kinds()) {
        const Picture p = passing(kind, layers, 4);
        size_t open = 0;
        for (uint32_t y = 0; y < 16; ++y)
            for (uint32_t x = 0; x < 16; ++x) {
                const bool isOpen = p.at(x, y).x > 0.5f;
                open += isOpen;
                // The mirror's microfacets spread its rays a little, some across an edge.
                EXPECT_NEAR(p.at(x, y).x, isOpen ? 1 : 0, kind == RayKind::bounce ? 0.3 : 1e-3)
                    << int(kind) << " at " << x << ", " << y;
                EXPECT_EQ(isOpen, p.at(x ^ 1, y).x < 0.5f) << int(kind) << " at " << x << ", " << y;
            }
        EXPECT_EQ(open, 128u) << int(kind);
    }
}

TEST_P(Alpha, MaskComparesWithItsCutoff) {
    for (const float cutoff : {0.3f, 0.5f, 0.7f}) {
        const Layers layers = [&](Stage& s) {
            GpMaterialDesc d = black(GP_ALPHA_MASK, 0.5f);
            d.alphaCutoff = cutoff;
            s.add(square(1), s.material(d));
        };
        const double expected = 0.5f >= cutoff ? 0 : 1;
        for (const RayKind kind : kinds())
            EXPECT_NEAR(passing(kind, layers, 2).mean().x, expected, 1e-3);
    }
}

// Blending is noise, and so costs samples.
class BlendedAlpha : public Alpha {};

TEST_P(BlendedAlpha, BlendedLayersMultiply) {
    for (const float alpha : {0.25f, 0.5f})
        for (const int count : alpha > 0.4f ? std::vector{1, 2} : std::vector{1})
            for (const RayKind kind : kinds()) {
                const Layers layers = [&](Stage& s) {
                    const GpMaterial m = s.material(black(GP_ALPHA_BLEND, alpha));
                    for (int i = 0; i < count; ++i) s.add(square(1 + 0.1f * float(i)), m);
                };
                // Each sample is 0 or 1 with this chance; so many make 4 sigma 1 % of it, and a few
                // more.
                const double p = std::pow(1 - alpha, count);
                const auto samples = uint32_t(1.2 * 160000 / 256 * (1 - p) / p);
                expectMean(passing(kind, layers, effort(samples)), p,
                           "rays " + std::to_string(int(kind)));
            }
}

TEST_P(BlendedAlpha, LayersOfOneMeshAreIndependent) {
    const Layers layers = [&](Stage& s) {
        Triangles t = square(1);
        t.quad({-0.5f, -0.5f, 1.1f}, {1, 0, 0}, {0, 1, 0});
        s.add(t, s.material(black(GP_ALPHA_BLEND, 0.5f)));
    };
    for (const RayKind kind : kinds()) expectMean(passing(kind, layers, effort(2048)), 0.25);
}

TEST_P(BlendedAlpha, VertexColoursCarryAlpha) {
    const Layers layers = [&](Stage& s) {
        Triangles t = square(1);
        t.colors.assign(6, glm::vec4(1, 1, 1, 0.6f));  // 153 of 255
        s.add(t, s.material(black(GP_ALPHA_BLEND, 0.5f)));
    };
    for (const RayKind kind : kinds()) expectMean(passing(kind, layers, effort(1024)), 0.7);
}

// A veil that glows: its own light counts by its coverage, for rays and for chosen lights alike.
TEST_P(Alpha, EmissionCountsByCoverage) {
    for (const GpAlphaMode mode : {GP_ALPHA_BLEND, GP_ALPHA_MASK}) {
        Stage stage(GetParam());
        Triangles plane, lamp;
        plane.quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10});
        stage.add(plane, stage.lambert(glm::vec3(1)));
        lamp.quad({-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1});
        GpMaterialDesc d = black(mode, 0.4f);
        d.alphaCutoff = 0.6f;
        put(d.emission, glm::vec3(5));
        stage.add(lamp, stage.material(d));
        GpRenderOptions o = stage.options(effort(1024));
        o.maxBounces = GP_NO_BOUNCES;
        const Picture p = stage.render(8, 8, lookFrom({0, 0, 0}, {0, 1, 0}, 0.1f, 1e-3f), o);
        const double form =
            polygonIrradiance(quadPolygon({-0.5, 1, -0.5}, {1, 0, 0}, {0, 0, 1}), {0, 1, 0});
        expectMean(p, mode == GP_ALPHA_BLEND ? 0.4 * 5 * form / pi : 0,
                   mode == GP_ALPHA_BLEND ? "blend" : "mask");
    }
}

TEST_P(Alpha, VisibilityBitsNameTheirRays) {
    const uint32_t bits[] = {GP_VISIBLE_CAMERA, GP_VISIBLE_SHADOW, GP_VISIBLE_BOUNCE};
    for (const RayKind kind : kinds())
        for (const uint32_t bit : bits) {
            const Layers layers = [&](Stage& s) { s.add(square(1), s.lambert(glm::vec3(0)), bit); };
            const double expected = bit == bits[size_t(kind)] ? 1 : 0;
            EXPECT_NEAR(passing(kind, layers, 2).mean().x, expected, 1e-3)
                << int(kind) << " " << bit;
        }
}

TEST_P(Alpha, EmissionLeavesTheFrontUnlessDoubleSided) {
    for (const bool back : {false, true})
        for (const bool doubleSided : {false, true}) {
            Stage stage(GetParam());
            GpMaterialDesc d = lambertDesc(glm::vec3(0));
            put(d.emission, {2, 3, 4});
            d.doubleSided = doubleSided;
            stage.add(square(0), stage.material(d));
            const Picture p = stage.render(
                4, 4, lookFrom({0, 0, 0}, {0, 0, back ? -1.0f : 1.0f}, 1, 0.2f), stage.options(2));
            expectMean(p, back && !doubleSided ? glm::dvec3(0) : glm::dvec3(2, 3, 4));
        }
}

INSTANTIATE_TEST_SUITE_P(All, Alpha, ::testing::ValuesIn(allVariants()),
                         [](const auto& row) { return variantName(row.param); });
INSTANTIATE_TEST_SUITE_P(Best, BlendedAlpha, ::testing::ValuesIn(bestVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
