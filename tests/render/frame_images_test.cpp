// Every image of a frame against what it says it is, and the noise that a frame admits to.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

class FrameImages : public ::testing::TestWithParam<Variant> {};

TEST_P(FrameImages, GuidesOfAKnownSurfaceAreExact) {
    Stage stage(GetParam());
    Triangles left, right;
    left.quad({-1, -1, 0.5f}, {1, 0, 0}, {0, 2, 0});  // z = 0.5, faces +z
    right.quad({0.25f, -1, 0}, {0.5f, 0, -0.5f}, {0, 2, 0});
    GpMaterialDesc d = lambertDesc({0.25f, 0.5f, 0.75f});
    d.roughness = 0.4f;
    stage.add(left, stage.material(d));
    GpMaterialDesc metal{};
    metal.metallic = 1, metal.roughness = 0.7f;
    stage.add(right, stage.material(metal));
    GpRenderOptions o = stage.options(4);
    o.pixelFilter = GP_PIXEL_BOX;
    const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 0, 1}, 3, 2);
    const GpFrame frame = stage.frame(8, 8);
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    const auto albedo = stage.read<glm::vec4>(frame, GP_IMAGE_ALBEDO, 64);
    const auto normal = stage.read<glm::vec4>(frame, GP_IMAGE_NORMAL, 64);
    const auto roughness = stage.read<glm::vec4>(frame, GP_IMAGE_ROUGHNESS, 64);
    const auto color = stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, 64);
    const auto depth = stage.read<float>(frame, GP_IMAGE_DEPTH, 64);
    const auto instance = stage.read<uint32_t>(frame, GP_IMAGE_INSTANCE, 64);
    const bool full = GetParam().shading == GP_SHADING_FULL;
    const size_t l = 3 * 8 + 1, r = 3 * 8 + 5, none = 3 * 8 + 7;
    EXPECT_LT(glm::length(glm::vec3(albedo[l]) - glm::vec3(0.25f, 0.5f, 0.75f)), 1e-5f);
    EXPECT_LT(glm::length(glm::vec3(normal[l]) - glm::vec3(0, 0, 1)), 1e-4f);
    EXPECT_NEAR(depth[l], 2.5f, 1e-5f);
    EXPECT_EQ(instance[l], 1u);
    EXPECT_EQ(color[l].w, 1);
    EXPECT_LT(glm::length(glm::vec3(normal[r]) - glm::vec3(std::sqrt(0.5f), 0, std::sqrt(0.5f))),
              1e-4f);
    EXPECT_NEAR(depth[r], 3.125f, 0.07f);  // at the pixel's middle; samples lie around it
    EXPECT_EQ(instance[r], 2u);
    if (full) {  // plain-diffuse surfaces have neither
        EXPECT_NEAR(roughness[l].x, 0.4f, 1e-5f);
        EXPECT_NEAR(roughness[l].y, 0, 1e-6f);
        EXPECT_NEAR(roughness[r].x, 0.7f, 1e-5f);
        EXPECT_NEAR(roughness[r].y, 1, 1e-6f);
    }
    EXPECT_EQ(depth[none], std::numeric_limits<float>::infinity());
    EXPECT_EQ(instance[none], 0u);
    EXPECT_EQ(albedo[none], glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(color[none], glm::vec4(0));
}

// A lamp in a bright box, seen with the lamp: something of each kind of light.
void furnish(Stage& stage) {
    Triangles box, lamp;
    box.sphere({0, 0, 0}, 2, 8, true, false);
    stage.add(box, stage.lambert({0.7f, 0.5f, 0.3f}));
    lamp.quad({-0.5f, 1.2f, -0.5f}, {1, 0, 0}, {0, 0, 1});
    stage.add(lamp, stage.lambert(glm::vec3(0), {4, 4, 6}));
}

GpCameraDesc view() {
    GpCameraDesc c{};
    put(c.position, {0, -0.5f, 1});
    put(c.target, {0, 0.4f, 0});
    c.verticalFov = 1.2f;
    return c;
}

TEST_P(FrameImages, ColorIsTheSumOfItsParts) {
    Stage stage(GetParam());
    furnish(stage);
    const GpFrame frame = stage.frame(16, 16);
    const GpCameraDesc camera = view();
    const GpRenderOptions o = stage.options(16);
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    const auto color = stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, 256);
    const auto emission = stage.read<glm::vec4>(frame, GP_IMAGE_EMISSION, 256);
    const auto direct = stage.read<glm::vec4>(frame, GP_IMAGE_DIRECT, 256);
    const auto indirect = stage.read<glm::vec4>(frame, GP_IMAGE_INDIRECT, 256);
    glm::vec3 sums[3] = {};
    for (size_t i = 0; i < 256; ++i) {
        const glm::vec3 sum(emission[i] + direct[i] + indirect[i]);
        EXPECT_LT(glm::length(sum - glm::vec3(color[i])), 1e-5f * (1 + glm::length(sum))) << i;
        sums[0] += glm::vec3(emission[i]), sums[1] += glm::vec3(direct[i]),
            sums[2] += glm::vec3(indirect[i]);
    }
    for (const glm::vec3 sum : sums) EXPECT_GT(sum.x, 1);
}

// Veils that let half the rays through by chance before a bright surrounding: noise without any
// order, of which variances must tell the exact amount.
void furnishVeils(Stage& stage) {
    GpMaterialDesc d = lambertDesc({0.2f, 0.3f, 0.1f});
    d.alphaMode = GP_ALPHA_BLEND, d.baseColor[3] = 0.5f;
    Triangles veil;
    veil.quad({-4, -4, -1}, {8, 0, 0}, {0, 8, 0});
    veil.quad({-4, -4, -1.5f}, {8, 0, 0}, {0, 8, 0});
    stage.add(veil, stage.material(d));
    stage.surround({1, 2, 3});
}

using Furnish = void (*)(Stage&);

// The variance of pictures over 64 seeds as a share of what they tell of themselves.
glm::dvec3 shownOfTold(const Variant& variant, Furnish what) {
    Stage stage(variant);
    what(stage);
    constexpr int seeds = 64;
    std::vector<glm::dvec3> sum(256), squares(256);
    glm::dvec3 told(0), shown(0);
    for (uint64_t seed = 0; seed < seeds; ++seed) {
        GpRenderOptions o = stage.options(16);
        o.seed = seed;
        const Picture p = stage.render(16, 16, view(), o);
        for (size_t i = 0; i < 256; ++i) {
            const glm::dvec3 c(p.color[i]);
            sum[i] += c, squares[i] += c * c;
            told += glm::dvec3(p.variance[i]);
        }
    }
    for (size_t i = 0; i < 256; ++i)
        shown += (squares[i] - sum[i] * sum[i] / double(seeds)) / double(seeds - 1);
    return shown / (told / double(seeds));
}

TEST_P(FrameImages, VarianceIsWhatSeedsShow) {
    const glm::dvec3 chance = shownOfTold(GetParam(), furnishVeils);
    // Stratified samples make less noise than their spread tells: there it is a bound.
    const glm::dvec3 stratified = shownOfTold(GetParam(), furnish);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(chance[c], 1, 0.1) << c;
        EXPECT_LT(stratified[c], 1.1) << c;
        EXPECT_GT(stratified[c], 0) << c;
    }
}

// The noise told and the true one, relative, after a render that stops at `target`.
glm::dvec2 toldAndTrue(const Variant& variant, Furnish what, double target) {
    Stage stage(variant);
    what(stage);
    const Picture truth = stage.render(16, 16, view(), stage.options(effort(8192)));
    const GpFrame frame = stage.frame(16, 16);
    const GpCameraDesc camera = view();
    GpRenderOptions o = stage.options(0);
    o.noiseTarget = target, o.seed = 77;
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    GpFrameStatistics s{};
    stage.check(gpGetFrameStatistics(frame, &s));
    const auto color = stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, 256);
    double errors = 0, mean = 0;
    const glm::dvec3 weights(0.2126, 0.7152, 0.0722);
    for (size_t i = 0; i < 256; ++i) {
        const double d = glm::dot(glm::dvec3(color[i] - truth.color[i]), weights);
        errors += std::abs(d), mean += glm::dot(glm::dvec3(truth.color[i]), weights);
    }
    return {s.noise, errors / mean};
}

TEST_P(FrameImages, NoiseTargetIsReachedAndHonest) {
    for (const Furnish what : {&furnishVeils, &furnish}) {
        const glm::dvec2 noise = toldAndTrue(GetParam(), what, 0.02);
        EXPECT_LE(noise.x, 0.02);
        EXPECT_GT(noise.x, 0);
        EXPECT_LT(noise.y, 1.5 * noise.x);
        // The halves of a stratified picture complete each other: there the true error is less.
        if (what == &furnishVeils) {
            EXPECT_GT(noise.y, noise.x / 1.5);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, FrameImages, ::testing::ValuesIn(bestVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
