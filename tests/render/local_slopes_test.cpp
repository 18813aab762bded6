// GP_MODE_LOCAL on surfaces of slopes: light from all sides by a few facets, and suns with a disc,
// against the path tracer.
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

// A plane of facets, on which path tracer and local lighting show the same point.
struct Plane {
    explicit Plane(GpFrameMode mode, const char* alpha, const char* metallic = "1") : stage([&] {
        Variant v = bestFullVariant().front();
        v.mode = mode;
        return v;
    }()) {
        const GpBsdfParameter parameters[] = {{"alpha_x", alpha}, {"alpha_y", alpha},
                                              {"metallic", metallic}, {"method", "smooth"},
                                              {"base_color", "0.9,0.6,0.3"}};
        GpBsdfDesc bsdf{};
        bsdf.model = "glint", bsdf.parameters = parameters, bsdf.parameterCount = 5;
        GpMaterialDesc desc{};
        desc.bsdf = gpNewBsdf(stage.device, &bsdf);
        if (!desc.bsdf) stage.check(gpGetError(stage.device, nullptr));
        Triangles t;
        t.quad({-40, 0, 40}, {80, 0, 0}, {0, 0, -80});
        stage.add(t, stage.material(desc));
    }

    Picture look(const GpCameraDesc& camera, uint32_t size, uint32_t samples, uint32_t facets) {
        GpRenderOptions o = stage.options(samples);
        if (stage.variant.mode == GP_MODE_LOCAL) o.local.environmentFacets = facets;
        return stage.render(size, size, camera, o);
    }

    Stage stage;
};

// Brighter above than at the horizon, and on one side than on the other.
void setSky(Stage& stage) {
    std::vector<glm::vec4> pixels;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x) {
            const float up = std::cos(3.14159265f * (float(y) + 0.5f) / 64);
            const float side = std::sin(6.2831853f * (float(x) + 0.5f) / 128);
            const float light = up > 0 ? 0.4f + 1.6f * up : 0.1f;
            pixels.emplace_back(light * (1 + 0.5f * side), light, light * (1 - 0.5f * side), 1);
        }
    GpEnvironmentDesc sky{};
    sky.width = 128, sky.height = 64, sky.pixels = &pixels[0].x, sky.rotation = 0.7f;
    stage.check(gpSetEnvironment(stage.scene, &sky));
}

glm::vec3 from(double degrees) {
    const double t = degrees * 3.14159265 / 180;
    return {float(0.6 * std::sin(t)), float(std::cos(t)), float(0.8 * std::sin(t))};
}

struct EnvironmentCase {
    const char *alpha, *metallic;
    double tolerance;
};

// The path tracer's own noise is below 0.5 % of its 16,384 paths.
TEST(LocalSlopes, TheEnvironmentIsReflectedAsByThePathTracer) {
    for (const EnvironmentCase& c : {EnvironmentCase{"0.05", "1", 0.03}, {"0.2", "1", 0.03},
                                     {"0.4", "1", 0.05}, {"0.2", "0", 0.04}}) {
        Plane traced(GP_MODE_REFERENCE, c.alpha, c.metallic);
        Plane local(GP_MODE_LOCAL, c.alpha, c.metallic);
        setSky(traced.stage), setSky(local.stage);
        for (const double degrees : {5.0, 45.0, 70.0}) {
            const GpCameraDesc camera = lookFrom({0, 0, 0}, from(degrees), 10, 1e-3f);
            const glm::dvec3 expected = traced.look(camera, 1, 16384, 0).mean();
            for (const uint32_t facets : {9u, 16u, 25u}) {
                const glm::dvec3 found = local.look(camera, 1, 1, facets).mean();
                for (int i = 0; i < 3; ++i)
                    EXPECT_NEAR(found[i] / expected[i], 1, c.tolerance)
                        << c.alpha << ' ' << c.metallic << ' ' << degrees << ' ' << facets;
            }
            // The mean of all sides is another light.
            EXPECT_GT(std::abs(local.look(camera, 1, 1, 0).mean().y / expected.y - 1), 0.1);
        }
    }
}

// The sea too: its waves, and what reflects other waves at grazing angles.
TEST(LocalSlopes, TheSeaReflectsTheSkyAsByThePathTracer) {
    for (const float wind : {0.0f, 5.0f, 12.0f})
        for (const float pitch : {-0.08f, -0.25f, -0.9f}) {
            const auto look = [&](GpFrameMode mode, uint32_t facets) {
                Variant v = bestFullVariant().front();
                v.mode = mode;
                Stage stage(v);
                setSky(stage);
                GpOceanDesc sea{};
                sea.given = GP_GIVEN_WIND | GP_GIVEN_FOAM, sea.wind = wind, sea.resolution = 128;
                stage.check(gpSetOcean(stage.scene, &sea));
                GpCameraDesc camera{};
                camera.position[1] = 10, camera.verticalFov = 0.1f;
                put(camera.target, {0, 10 + std::sin(pitch), -std::cos(pitch)});
                GpRenderOptions o = stage.options(mode == GP_MODE_LOCAL ? 16 : effort(512));
                o.local.environmentFacets = facets;
                return stage.render(24, 16, camera, o).mean().y;
            };
            const double expected = look(GP_MODE_REFERENCE, 0);
            EXPECT_NEAR(look(GP_MODE_LOCAL, 9) / expected, 1, 0.05) << wind << ' ' << pitch;
            EXPECT_NEAR(look(GP_MODE_LOCAL, 25) / expected, 1, 0.025) << wind << ' ' << pitch;
        }
}

// What has no slopes has its irradiance, by its normal.
TEST(LocalSlopes, MatteSurfacesHaveTheIrradiance) {
    for (const bool above : {true, false}) {
        glm::dvec3 light[2];
        for (const GpFrameMode mode : {GP_MODE_REFERENCE, GP_MODE_LOCAL}) {
            Variant variant = bestFullVariant().front();
            variant.mode = mode;
            Stage stage(variant);
            setSky(stage);
            Triangles t;
            t.quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 1});
            stage.add(t, stage.lambert(glm::vec3(0.5f)));
            GpRenderOptions o = stage.options(mode == GP_MODE_LOCAL ? 1 : 16384);
            if (mode == GP_MODE_LOCAL) o.local.environmentFacets = 9;
            const glm::vec3 side(0.1f, 0.3f, above ? 1.0f : -1.0f);
            light[mode == GP_MODE_LOCAL] =
                stage.render(1, 1, lookFrom({0, 0, 0.5f}, glm::normalize(side), 5, 1e-3f), o)
                    .mean();
        }
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(light[1][i] / light[0][i], 1, 0.01) << above;
    }
}

GpCameraDesc highlight(double elevation, float fov) {
    const double e = elevation * 3.14159265 / 180;
    GpCameraDesc camera{};
    put(camera.position, {0, 10 * float(std::sin(e)), 10 * float(std::cos(e))});
    camera.verticalFov = fov;
    return camera;
}

// A sun's highlight has all of its light, and its shape whether slopes are wider or narrower than
// the disc: the sharp image of a disc seven times as wide as the slopes is no brighter than that.
TEST(LocalSlopes, TheSunsDiscWidensHighlights) {
    struct Case {
        const char* alpha;
        float radius, fov;
        double peak;  // tolerance of the brightest pixel
    };
    for (const Case& c : {Case{"0.003", 0.00465f, 0.06f, 0.03}, {"0.01", 0.00465f, 0.12f, 0.03},
                          {"0.05", 0.00465f, 0.5f, 0.03}, {"0.003", 0.02f, 0.12f, 0.04},
                          {"0.05", 0.02f, 0.5f, 0.04}})
        for (const double elevation : {60.0, 30.0}) {
            Picture pictures[2];
            for (const GpFrameMode mode : {GP_MODE_REFERENCE, GP_MODE_LOCAL}) {
                Plane plane(mode, c.alpha);
                GpLightDesc sun{};
                sun.kind = GP_LIGHT_DIRECTIONAL, sun.intensity = 1;
                sun.angularRadius = c.radius;
                const double e = elevation * 3.14159265 / 180;
                put(sun.direction, {0, -float(std::sin(e)), float(std::cos(e))});
                plane.stage.light(sun);
                pictures[mode == GP_MODE_LOCAL] =
                    plane.look(highlight(elevation, c.fov), 21, effort(256), 0);
            }
            const double traced = pictures[0].mean().y, local = pictures[1].mean().y;
            EXPECT_NEAR(local / traced, 1, 0.03) << c.alpha << ' ' << c.radius << ' ' << elevation;
            const double middle = double(pictures[1].at(10, 10).y / pictures[0].at(10, 10).y);
            EXPECT_NEAR(middle, 1, c.peak) << c.alpha << ' ' << c.radius << ' ' << elevation;
        }
}

}  // namespace
}  // namespace gp::test
