// Cameras, ray cones and ray offsets.
#include "shading/shading.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "statistics/random.h"

namespace gp::shading {
namespace {

using test::Random;

vec2 uniform2(Random& random) {
    const float x = random.uniform();
    return vec2(x, random.uniform());
}

CameraParams camera(uint kind, float halfY = 0.5f) {
    return camera_look_at(kind, vec3(1.0f, 2.0f, 3.0f), vec3(1.0f, 2.0f, -7.0f),
                          vec3(0.0f, 3.0f, 1.0f), halfY, 2.0f);
}

TEST(Camera, CornersOfAPerspectiveFilm) {
    const CameraParams c = camera(CAMERA_PERSPECTIVE);
    const auto expectRay = [&](vec2 film, vec3 d) {
        const Ray r = camera_ray(c, film, vec2(0.3f, 0.4f));
        EXPECT_EQ(r.origin, c.position);
        EXPECT_LT(distance(r.direction, normalize(d)), 1e-6f);
        EXPECT_EQ(r.t_min, 0.0f);
        EXPECT_EQ(r.t_max, FLOAT_MAX);
    };
    expectRay(vec2(0.5f, 0.5f), vec3(0, 0, -1));
    expectRay(vec2(0, 0), vec3(-1.0f, 0.5f, -1.0f));  // upper left
    expectRay(vec2(1, 0), vec3(1.0f, 0.5f, -1.0f));
    expectRay(vec2(1, 1), vec3(1.0f, -0.5f, -1.0f));
}

TEST(Camera, OrthographicRaysAreParallel) {
    const CameraParams c = camera(CAMERA_ORTHOGRAPHIC, 4.0f);
    const Ray r = camera_ray(c, vec2(1.0f, 0.0f), vec2(0.0f));
    EXPECT_LT(distance(r.direction, vec3(0, 0, -1)), 1e-6f);
    EXPECT_LT(distance(r.origin, vec3(9.0f, 6.0f, 3.0f)), 1e-5f);
}

TEST(Camera, FilmUndoesTheRay) {
    Random random(1);
    for (uint kind : {CAMERA_PERSPECTIVE, CAMERA_ORTHOGRAPHIC}) {
        for (int i = 0; i < 5000; ++i) {
            const CameraParams c =
                camera_look_at(kind, vec3(random.uniform(), 1.0f, 2.0f), vec3(0.0f),
                               vec3(0, 1, 0), 0.2f + random.uniform(), 0.5f + random.uniform());
            const vec2 film = uniform2(random);
            const Ray r = camera_ray(c, film, vec2(0.0f));
            const float t = 0.1f + 50.0f * random.uniform();
            const vec3 back = camera_film_from_world(c, r.origin + r.direction * t);
            EXPECT_NEAR(back.x, film.x, 2e-5f);
            EXPECT_NEAR(back.y, film.y, 2e-5f);
            EXPECT_NEAR(back.z, t * dot(r.direction, c.forward), 1e-4f);
        }
    }
}

TEST(Camera, LensKeepsThePlaneInFocus) {
    Random random(2);
    for (uint kind : {CAMERA_PERSPECTIVE, CAMERA_ORTHOGRAPHIC}) {
        CameraParams c = camera(kind);
        const vec2 film(0.2f, 0.7f);
        const Ray chief = camera_ray(c, film, vec2(0.0f));
        c.lens_radius = 0.1f;
        c.focus_distance = 6.0f;
        const vec3 focus =
            chief.origin + chief.direction * (6.0f / dot(chief.direction, c.forward));
        vec3 mean(0.0f);
        for (int i = 0; i < 4000; ++i) {
            const Ray r = camera_ray(c, film, uniform2(random));
            const float t = 6.0f / dot(r.direction, c.forward);
            EXPECT_LT(distance(r.origin + r.direction * t, focus), 1e-4f);
            EXPECT_LE(length(r.origin - chief.origin), 0.1f + 1e-6f);
            mean += (r.origin - chief.origin) / 4000.0f;
        }
        EXPECT_LT(length(mean), 0.005f);
    }
}

TEST(Camera, LooksAlongItsUp) {
    for (const vec3& target : {vec3(0, 5, 0), vec3(0, -5, 0)}) {
        const CameraParams c = camera_look_at(CAMERA_PERSPECTIVE, vec3(0.0f), target,
                                              vec3(0, 1, 0), 1.0f, 1.0f);
        EXPECT_NEAR(length(c.right), 1.0f, 1e-6f);
        EXPECT_NEAR(dot(c.right, c.forward), 0.0f, 1e-6f);
        EXPECT_NEAR(dot(cross(c.right, c.forward), c.up), 1.0f, 1e-6f);
    }
}

// The cone of a pixel at distance t is as wide as the pixel is there.
TEST(RayCone, CoversAPixel) {
    for (uint kind : {CAMERA_PERSPECTIVE, CAMERA_ORTHOGRAPHIC}) {
        const CameraParams c = camera(kind);
        const float height = 1000.0f;
        const RayCone cone = ray_cone_propagate(camera_ray_cone(c, height), 20.0f);
        const Ray a = camera_ray(c, vec2(0.5f, 0.5f), vec2(0.0f));
        const Ray b = camera_ray(c, vec2(0.5f, 0.5f + 1.0f / height), vec2(0.0f));
        const vec3 between = b.origin + b.direction * 20.0f - a.origin - a.direction * 20.0f;
        EXPECT_NEAR(cone.width / length(between), 1.0f, 1e-3f);
    }
}

TEST(RayCone, BouncesWidenIt) {
    RayCone cone;
    cone.width = 0.01f;
    cone.spread = 0.001f;
    EXPECT_EQ(ray_cone_bounce(cone, 0.0f).spread, 0.001f);
    // A mirror of alpha 0.1 has half vectors within 0.0707 rad: reflections within twice that,
    // and the cone counts both sides.
    EXPECT_NEAR(ray_cone_bounce(cone, 0.1f).spread, 4.0f * 0.0707107f, 5e-4f);
    EXPECT_LT(ray_cone_bounce(cone, 0.1f).spread, ray_cone_bounce(cone, 0.2f).spread);
    cone.spread = -0.3f;
    EXPECT_LT(ray_cone_bounce(cone, 0.001f).spread, 0.0f);
    EXPECT_GT(ray_cone_bounce(cone, 0.5f).spread, 0.0f);
}

// A unit square with unit texture coordinates and 256 texels: a cone of 1/256 sees one texel.
TEST(RayCone, LevelOfDetail) {
    RayCone cone;
    cone.spread = 0.0f;
    cone.width = 1.0f / 256.0f;
    const float size = std::log2(256.0f);
    EXPECT_NEAR(ray_cone_lod(cone, 0.5f, 0.5f, 1.0f) + size, 0.0f, 1e-5f);
    cone.width *= 8.0f;
    EXPECT_NEAR(ray_cone_lod(cone, 0.5f, 0.5f, 1.0f) + size, 3.0f, 1e-5f);
    EXPECT_NEAR(ray_cone_lod(cone, 0.5f, 0.5f, -0.25f) + size, 4.0f, 1e-5f);  // seen aslant
    EXPECT_NEAR(ray_cone_lod(cone, 0.5f, 8.0f, 1.0f) + size, 1.0f, 1e-5f);
    EXPECT_TRUE(std::isfinite(ray_cone_lod(cone, 0.0f, 0.0f, 0.0f)));
    cone.width = 0.0f;
    EXPECT_TRUE(std::isfinite(ray_cone_lod(cone, 0.0f, 1.0e20f, 1.0f)));
}

// A point of a surface, rounded to single precision, may lie behind it by some units in the last
// place of its coordinates; the offset brings it to the front, and not far.
TEST(RayOffset, LeavesTheSurfaceButBarely) {
    Random random(3);
    for (int i = 0; i < 200000; ++i) {
        const vec3 n = square_to_uniform_sphere(uniform2(random));
        const float scale = std::exp2(std::floor(30.0f * random.uniform() - 12.0f));
        // Coordinates of one magnitude, either sign: the method treats each by itself.
        vec3 p;
        for (int axis = 0; axis < 3; ++axis) {
            const float sign = random.uniform() < 0.5f ? -1.0f : 1.0f;
            p[axis] = sign * scale * (0.5f + 0.499f * random.uniform());
        }
        const vec3 q = offset_ray_origin(p, n);
        const double moved = dot(dvec3(q) - dvec3(p), dvec3(n));
        const double ulp = std::exp2(-24.0) * double(scale);
        ASSERT_GT(moved, 8.0 * ulp) << p.x << " " << p.y << " " << p.z;
        ASSERT_LT(distance(dvec3(q), dvec3(p)), 1.6e-5 + 257.0 * ulp);
    }
}

TEST(Medium, AbsorbsAsItsColourSays) {
    const vec3 colour(0.5f, 0.25f, 1.0f);
    const vec3 absorption = medium_absorption(colour, 2.0f);
    EXPECT_LT(distance(medium_transmittance(absorption, 2.0f), colour), 1e-6f);
    EXPECT_NEAR(medium_transmittance(absorption, 4.0f).x, 0.25f, 1e-6f);
    EXPECT_EQ(medium_transmittance(absorption, 0.0f), vec3(1.0f));
    EXPECT_EQ(medium_absorption(colour, std::numeric_limits<float>::infinity()), vec3(0.0f));
    const vec3 black = medium_absorption(vec3(0.0f), 0.1f);
    EXPECT_EQ(medium_transmittance(black, 0.0f), vec3(1.0f));
    EXPECT_LT(medium_transmittance(black, 0.1f).x, 2e-6f);
}

}  // namespace
}  // namespace gp::shading
