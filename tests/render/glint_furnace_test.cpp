// Glints in a furnace: whatever a pixel's facets are, where radiance is 1 on all sides white metal,
// white paint and clear bodies that carry them disappear. Under the sky alone, in an enclosed room
// of lights and walls, in real time and in local mode.
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

struct Body {
    const char *name, *alpha, *metallic, *transmission, *thin;
    double lost;  // what single scattering by V-cavities loses of it, at most
    const char *coat = "0", *sheen = "0";
};

// Metal: light that leaves a cavity into its other side. Clear: what refraction into and out of
// cavities loses at grazing angles. Paint: what its polynomial of the facets' albedo is off by.
const Body bodies[] = {{"metal", "0.1", "1", "0", "1", 0.006},
                       {"paint", "0.3", "0", "0", "1", 0.002},
                       {"clear", "0.03", "0", "1", "0", 0.009}};
// What a coat and a sheen throw back at what is below them is lost, as it is in glTF's material.
const Body underLayers[] = {{"coated metal", "0.1", "1", "0", "1", 0.1, "1"},
                            {"coated paint", "0.3", "0", "0", "1", 0.1, "1"},
                            {"cloth", "0.3", "0", "0", "1", 0.1, "0", "0.6"}};

GpMaterial materialOf(Stage& stage, const Body& body, const char* method) {
    // A pixel of these pictures, 0.02 m² of the sphere, sees a thousand facets.
    const GpBsdfParameter words[] = {
        {"alpha_x", body.alpha}, {"alpha_y", body.alpha}, {"metallic", body.metallic},
        {"transmission", body.transmission}, {"thin", body.thin}, {"base_color", "1"},
        {"method", method}, {"density", "5e4"}, {"coat", body.coat}, {"coat_alpha", "0.01"},
        {"sheen_color", body.sheen}, {"sheen_alpha", "0.4"}};
    GpBsdfDesc bsdf{};
    bsdf.model = "glint", bsdf.parameters = words, bsdf.parameterCount = std::size(words);
    GpMaterialDesc desc{};
    desc.bsdf = gpNewBsdf(stage.device, &bsdf);
    if (!desc.bsdf) stage.check(gpGetError(stage.device, nullptr));
    return stage.material(desc);
}

// Texture coordinates are metres seen from the front. Of flat triangles: interpolated normals lose
// light of their own near the edge, where they turn away from the viewer.
Triangles ball(glm::vec3 centre) {
    Triangles t;
    t.sphere(centre, 1, 24, false, false);
    for (const glm::vec3& p : t.positions) t.uv0.emplace_back(p.x, p.y);
    return t;
}

GpCameraDesc frontCamera() { return lookFrom({0, 0, 0}, {0, 0, 1}, 3, 2.2f); }

// The mean over the ball alone, of a picture that is 1 elsewhere.
struct OnBall {
    double mean, sigma;
};
OnBall onBall(const Picture& p) {
    const double share = 3.14159265 / (2.2 * 2.2);
    return {1 + (p.mean().y - 1) / share, p.sigma().y / share};
}

class GlintFurnace : public ::testing::TestWithParam<const char*> {};

TEST_P(GlintFurnace, BodiesUnderTheSkyVanish) {
    for (const Body& body : bodies) {
        Stage stage(bestFullVariant().front());
        stage.add(ball({0, 0, 0}), materialOf(stage, body, GetParam()));
        stage.surround(glm::vec3(1));
        GpRenderOptions o = stage.options(effort(256));
        o.maxBounces = 64;
        const OnBall seen = onBall(stage.render(16, 16, frontCamera(), o));
        const double tolerance = 4 * seen.sigma + 0.001;
        EXPECT_LT(seen.sigma, 0.003) << body.name << ": too few samples";
        EXPECT_LT(seen.mean, 1 + tolerance) << body.name;
        EXPECT_GT(seen.mean, 1 - body.lost - tolerance) << body.name;
    }
}

TEST_P(GlintFurnace, LayersLetNoLightOutThatDidNotComeIn) {
    for (const Body& body : underLayers) {
        Stage stage(bestFullVariant().front());
        stage.add(ball({0, 0, 0}), materialOf(stage, body, GetParam()));
        stage.surround(glm::vec3(1));
        const OnBall seen = onBall(stage.render(16, 16, frontCamera(), stage.options(256)));
        const double tolerance = 4 * seen.sigma + 0.001;
        EXPECT_LT(seen.sigma, 0.003) << body.name << ": too few samples";
        EXPECT_LT(seen.mean, 1 + tolerance) << body.name;
        EXPECT_GT(seen.mean, 1 - body.lost - tolerance) << body.name;
    }
}

// Walls that reflect half of the light and emit the other half of radiance 1: light arrives by
// emissive triangles that are chosen, and by paths that end at them, between bodies too.
TEST_P(GlintFurnace, BodiesInARoomVanish) {
    Stage stage(bestFullVariant().front());
    Triangles room;
    room.box(glm::vec3(3), glm::vec3(-3));  // seen from inside
    stage.add(room, stage.lambert(glm::vec3(0.5f), glm::vec3(0.5f)));
    const glm::vec3 places[] = {{-1.1f, -0.9f, 0}, {1.1f, -0.9f, 0.2f}, {0, 1, -0.1f}};
    for (int i = 0; i < 3; ++i)
        stage.add(ball(places[i]), materialOf(stage, bodies[i], GetParam()));
    GpRenderOptions o = stage.options(effort(256));
    o.maxBounces = 64;
    const Picture p = stage.render(16, 16, lookFrom({0, 0, 0}, {0, 0, 1}, 2.9f, 4.4f), o);
    // The balls are half of the picture.
    EXPECT_LT(p.sigma().y, 0.003) << "too few samples";
    EXPECT_NEAR(p.mean().y, 1, 4 * p.sigma().y + 0.003);
}

INSTANTIATE_TEST_SUITE_P(Methods, GlintFurnace,
                         ::testing::Values("smooth", "dictionary", "counting", "zirr"),
                         [](const auto& row) { return std::string(row.param); });

// Rays without a denoiser, whose average over frames is the same light: metal and paint need one
// bounce. (Temporal anti-aliasing takes sparks for noise.)
TEST(GlintFurnaceRealtime, BodiesUnderTheSkyVanish) {
    for (const char* method : {"dictionary", "counting"})
        for (const Body& body : {bodies[0], bodies[1]}) {
            Variant variant = bestFullVariant().front();
            variant.mode = GP_MODE_REALTIME;
            Stage stage(variant);
            stage.add(ball({0, 0, 0}), materialOf(stage, body, method));
            stage.surround(glm::vec3(1));
            const GpFrame frame = stage.frame(24, 24);
            const GpCameraDesc camera = frontCamera();
            GpRenderOptions o = stage.options(0);
            o.realtime.denoiser = GP_DENOISER_NONE, o.realtime.antiAliasing = GP_AA_JITTER;
            const int frames = 64;
            double sum = 0, squares = 0;
            for (int i = 0; i < frames; ++i) {
                o.seed = uint64_t(i) + 1;
                stage.check(gpRender(frame, stage.scene, &camera, &o));
                double mean = 0;
                for (const glm::vec4& c : stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, 24 * 24))
                    mean += double(c.y) / (24 * 24);
                const double seen = 1 + (mean - 1) * (2.2 * 2.2) / 3.14159265;
                sum += seen / frames, squares += seen * seen / frames;
            }
            const double sigma = std::sqrt(std::max(squares - sum * sum, 0.0) / frames);
            EXPECT_LT(sigma, 0.003);
            EXPECT_NEAR(sum, 1, body.lost + 4 * sigma + 0.002)
                << method << ' ' << body.name;
        }
}

// Light from all sides by facets of the Gaussian: what their sum is off by (docs/water.md).
TEST(GlintFurnaceLocal, BodiesUnderTheSkyVanish) {
    for (const Body& body :
         {bodies[0], bodies[1], underLayers[0], underLayers[1], underLayers[2]}) {
        Variant variant = bestFullVariant().front();
        variant.mode = GP_MODE_LOCAL;
        Stage stage(variant);
        stage.add(ball({0, 0, 0}), materialOf(stage, body, "dictionary"));
        stage.surround(glm::vec3(1));
        GpRenderOptions o = stage.options(64);
        o.local.environmentFacets = 25;
        const double seen = onBall(stage.render(16, 16, frontCamera(), o)).mean;
        EXPECT_NEAR(seen, 1, 0.01) << body.name;
    }
}

}  // namespace
}  // namespace gp::test
