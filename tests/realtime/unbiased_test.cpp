// Real-time frames without a filter are estimates of the reference: their mean is its picture.
#include <cmath>

#include <gtest/gtest.h>

#include "realtime/box_scene.h"
#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t width = 40, height = 30, block = 5;

// Walls that are lit by a window of sky, a sun, a ball and a glowing plate; a glossy ball, a rough
// metal one, a mirror, and a pane of glass before part of it.
void build(Stage& stage, bool withMirrors) {
    Triangles room;
    room.quad({-2, -1, -2}, {4, 0, 0}, {0, 3, 0});
    room.quad({-2, -1, -2}, {0, 0, 4}, {4, 0, 0});
    room.quad({-2, -1, -2}, {0, 3, 0}, {0, 0, 4});
    GpMaterialDesc plaster{};
    plaster.given = GP_GIVEN_BASE_COLOR;
    const float pink[4] = {0.7f, 0.5f, 0.4f, 1};
    std::copy_n(pink, 4, plaster.baseColor);
    plaster.roughness = 0.6f;
    stage.add(room, stage.material(plaster));
    const auto ball = [&](glm::vec3 centre, float metallic, float roughness) {
        GpMaterialDesc d{};
        d.given = GP_GIVEN_ROUGHNESS;
        d.metallic = metallic, d.roughness = roughness;
        d.baseColor[0] = 0.9f, d.baseColor[1] = 0.6f, d.baseColor[2] = 0.3f, d.baseColor[3] = 1;
        Triangles t;
        t.sphere(centre, 0.5f, 16, false, true);
        t.uv0.clear();
        stage.add(t, stage.material(d));
    };
    ball({-1.1f, -0.5f, 0}, 0, 0.3f);
    ball({0, -0.5f, -0.4f}, 1, 0.5f);
    ball({1.1f, -0.5f, 0}, 1, withMirrors ? 0.0f : 0.4f);
    GpMaterialDesc glass{};
    glass.given = GP_GIVEN_ROUGHNESS;
    glass.transmission = 1;
    glass.roughness = withMirrors ? 0.0f : 0.5f;
    Triangles pane;
    pane.quad({-1.5f, -0.9f, 1.2f}, {1.2f, 0, 0}, {0, 1.5f, 0});
    stage.add(pane, stage.material(glass));
    Triangles plate;
    plate.quad({0.4f, 1.6f, -1.5f}, {0, 0, 0.6f}, {-0.6f, 0, 0});
    stage.add(plate, stage.lambert(glm::vec3(0), glm::vec3(6, 5, 4)));
    GpLightDesc lamp{};
    lamp.kind = GP_LIGHT_SPHERE, lamp.intensity = 1.5f, lamp.radius = 0.2f;
    put(lamp.position, {-1, 1.2f, 0.5f});
    stage.light(lamp);
    GpLightDesc sun{};
    sun.kind = GP_LIGHT_DIRECTIONAL, sun.intensity = 1.2f, sun.angularRadius = 0.05f;
    put(sun.direction, {-0.6f, -0.9f, -0.5f});
    stage.light(sun);
    stage.surround({0.2f, 0.3f, 0.4f});
}

// A wall in milky water, at night, with a lamp over the water that shines down: what the wall has
// comes from the sea, and what the sea has beside the lamp's spot from the wall.
void buildShore(Stage& stage, bool) {
    GpOceanDesc sea{};
    sea.given = GP_GIVEN_ABSORPTION | GP_GIVEN_SCATTERING;
    sea.wind = 3, sea.resolution = 32, sea.cascades = 1, sea.level = -0.6f;
    for (int c = 0; c < 3; ++c) sea.absorption[c] = 0.01f, sea.scattering[c] = 1;
    stage.check(gpSetOcean(stage.scene, &sea));
    Triangles wall;
    wall.quad({-2, -1, -0.6f}, {4, 0, 0}, {0, 2.5f, 0});
    stage.add(wall, stage.lambert({0.8f, 0.7f, 0.6f}));
    GpLightDesc lamp{};
    lamp.kind = GP_LIGHT_SPOT, lamp.intensity = 10, lamp.radius = 0.05f;
    put(lamp.position, {0.2f, 0, 0.2f});
    put(lamp.direction, {0, -1, 0});
    lamp.innerAngle = 0.4f, lamp.outerAngle = 0.6f;
    stage.light(lamp);
    stage.surround(glm::vec3(0.001f));
}

GpCameraDesc camera(float aside = 0) {
    GpCameraDesc c{};
    put(c.position, {0.4f + aside, 0.6f, 5});
    put(c.target, {aside, 0.1f, 0});
    c.verticalFov = 0.6f;
    return c;
}

struct Blocks {
    std::vector<glm::dvec3> sum, squares;
    int count = 0;

    void add(const std::vector<glm::vec4>& pixels) {
        std::vector<glm::dvec3> means((width / block) * (height / block));
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x)
                means[y / block * (width / block) + x / block] +=
                    glm::dvec3(pixels[y * width + x]) / double(block * block);
        sum.resize(means.size()), squares.resize(means.size());
        for (size_t i = 0; i < means.size(); ++i)
            sum[i] += means[i], squares[i] += means[i] * means[i];
        ++count;
    }
    glm::dvec3 mean(size_t i) const { return sum[i] / double(count); }
    glm::dvec3 varianceOfMean(size_t i) const {
        const glm::dvec3 m = mean(i);
        return (squares[i] / double(count) - m * m) / double(count - 1);
    }
};

class RealtimeUnbiased : public ::testing::TestWithParam<Variant> {};

struct Reuse {
    GpLightReuse light = GP_REUSE_NONE, indirect = GP_REUSE_NONE;
    float step = 0;                          // metres that the camera moves aside each frame
    float rayLength = 0;
    void (*scene)(Stage&, bool) = build;     // second: with mirrors
    uint32_t frames = 320;
};

void expectReference(const Variant& variant, bool withMirrors, int bounces,
                     const Reuse& reuse = {}) {
    Variant reference = variant;
    reference.mode = GP_MODE_REFERENCE;
    Stage a(reference), b(variant);
    reuse.scene(a, withMirrors), reuse.scene(b, withMirrors);
    const GpCameraDesc view = camera();
    Blocks expected, found;
    // Both sides as means of many pictures that are independent, or nearly so.
    const GpFrame still = a.frame(width, height);
    for (uint32_t i = 0; i < effort(40); ++i) {
        GpRenderOptions o = a.options(8);
        o.seed = 1000 + i, o.maxBounces = bounces, o.pixelFilter = GP_PIXEL_BOX;
        o.rayLength = reuse.rayLength;
        a.check(gpRender(still, a.scene, &view, &o));
        expected.add(a.read<glm::vec4>(still, GP_IMAGE_COLOR, width * height));
    }
    const GpFrame moving = b.frame(width, height);
    // Frames that hand on light samples are not independent: then only the last of a few counts.
    const uint32_t chain = reuse.light == GP_REUSE_NONE && reuse.indirect == GP_REUSE_NONE ? 1 : 5;
    for (uint32_t i = 0; i < effort(reuse.frames) * (chain > 1 ? 3u : 1u); ++i) {
        GpRenderOptions o = b.options(0);
        o.seed = i, o.maxBounces = bounces, o.rayLength = reuse.rayLength;
        o.realtime.antiAliasing = GP_AA_JITTER;
        o.realtime.denoiser = GP_DENOISER_NONE;
        o.realtime.lightReuse = reuse.light, o.realtime.indirectReuse = reuse.indirect;
        o.realtime.resetHistory = i % chain == 0;
        const GpCameraDesc now = camera(reuse.step * float(chain - 1 - i % chain));
        b.check(gpRender(moving, b.scene, &now, &o));
        if (i % chain == chain - 1)
            found.add(b.read<glm::vec4>(moving, GP_IMAGE_COLOR, width * height));
    }
    double sumOfSquares = 0;
    for (size_t i = 0; i < expected.sum.size(); ++i) {
        const glm::dvec3 difference = found.mean(i) - expected.mean(i);
        const glm::dvec3 sigma = glm::sqrt(found.varianceOfMean(i) + expected.varianceOfMean(i));
        for (int c = 0; c < 3; ++c) {
            // Halves and 8-bit albedos round each frame's numbers.
            const double z = difference[c] / (sigma[c] + 3e-4 * expected.mean(i)[c] + 1e-12);
            EXPECT_LT(std::abs(z), 4.5) << "block " << i << ", channel " << c << ": "
                                        << found.mean(i)[c] << " for " << expected.mean(i)[c];
            sumOfSquares += z * z;
        }
    }
    // Variances of 40 means make each 1.05 on average; of 48 blocks, whose channels go together,
    // the mean has a deviation of 0.21. Three of these.
    EXPECT_LT(sumOfSquares / double(3 * expected.sum.size()), 1.7);
    // The whole of the picture: what errors of one sign would show in.
    glm::dvec3 all{0}, allExpected{0}, variance{0};
    for (size_t i = 0; i < expected.sum.size(); ++i) {
        all += found.mean(i), allExpected += expected.mean(i);
        variance += found.varianceOfMean(i) + expected.varianceOfMean(i);
    }
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(all[c], allExpected[c], 4 * std::sqrt(variance[c]) + 3e-4 * allExpected[c]);
}

// Mirrors on the way to what a pixel shows are bounces for one and not for the other: there are
// enough of both that the last do not matter.
TEST_P(RealtimeUnbiased, TheMeanOfFramesIsTheReference) { expectReference(GetParam(), true, 12); }

// The last surface of a path has a shadow ray only; nothing may be missing for that.
TEST_P(RealtimeUnbiased, WithOneBounce) { expectReference(GetParam(), false, 1); }

// What neighbours and the past found is weighted by who could have found it.
TEST_P(RealtimeUnbiased, WithLightReuse) {
    expectReference(GetParam(), false, 1, {.light = GP_REUSE_UNBIASED});
}

// Ways of light over one more surface, with all kinds of lobes at both ends.
TEST_P(RealtimeUnbiased, WithIndirectReuse) {
    expectReference(GetParam(), false, 1, {.indirect = GP_REUSE_UNBIASED});
}

// Further bounces come beside them, and their weights know it.
TEST_P(RealtimeUnbiased, WithIndirectReuseAndBounces) {
    expectReference(GetParam(), false, 3,
                    {.light = GP_REUSE_UNBIASED, .indirect = GP_REUSE_UNBIASED});
}

// Light of surfaces alone, from a moving camera: corners, edges, what comes into view, and finds
// that other pixels' rays are too short for.
TEST_P(RealtimeUnbiased, WithIndirectReuseInABoxFromAMovingCamera) {
    expectReference(GetParam(), false, 1,
                    {.indirect = GP_REUSE_UNBIASED, .step = 0.1f, .rayLength = 7.7f,
                     .scene = [](Stage& stage, bool) { buildBox(stage); }});
}

// What was found on the sea is found again although its triangles go with the camera.
TEST(RealtimeUnbiasedSea, WithIndirectReuseFromAMovingCamera) {
    Variant best = bestFullVariant().front();
    best.mode = GP_MODE_REALTIME;
    expectReference(best, false, 1,
                    {.indirect = GP_REUSE_UNBIASED, .step = 0.25f, .scene = buildShore,
                     .frames = 80});
}

std::vector<Variant> realtimeVariants() {
    std::vector<Variant> variants = fullVariants();
    for (Variant& v : variants) {
        v.mode = GP_MODE_REALTIME;
        v.name.replace(0, std::string("reference").size(), "realtime");
    }
    return variants;
}

INSTANTIATE_TEST_SUITE_P(All, RealtimeUnbiased, ::testing::ValuesIn(realtimeVariants()),
                         [](const auto& i) { return variantName(i.param); });

}  // namespace
}  // namespace gp::test
