// What surrounds a scene at all levels of detail: means that stay, faces without seams, irradiance
// of skies whose integral is known.
#include "shading/shading.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "backend/cpu/scene_view.h"
#include "scene/sky_pyramid.h"
#include "statistics/random.h"

namespace gp {
namespace {

using namespace glm;
using shading::cube_direction;
using shading::cube_point;
using shading::CubePoint;
using cpu::SkyLevelView;
using cpu::SkyPyramidView;
#include "backend/cpu/sky_sampling.h"

template <class Sky>
CubeMap cubeOf(uint32_t size, const Sky& sky) {
    CubeMap cube;
    cube.size = size;
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x)
                cube.texels.push_back(sky(normalize(
                    cube_direction(face, {(float(x) + 0.5f) / float(size),
                                          (float(y) + 0.5f) / float(size)}))));
    return cube;
}

SkyLevelView viewOf(const SkyLevel& level) { return {level.texels.data(), level.size}; }

SkyPyramidView viewOf(const SkyPyramid& sky) {
    SkyPyramidView view{};
    view.levelCount = uint32_t(sky.levels.size());
    for (size_t i = 0; i < sky.levels.size(); ++i) view.levels[i] = viewOf(sky.levels[i]);
    view.irradiance = viewOf(sky.irradiance);
    return view;
}

vec3 gradient(vec3 d) { return vec3(1.0f + d.y, 1.0f + 0.5f * d.x * d.z, 2.0f - d.x); }

TEST(SkyPyramid, AUniformSkyIsTheSameEverywhere) {
    const vec3 light(0.5f, 1, 3);
    const SkyPyramid sky = makeSkyPyramid(cubeOf(16, [&](vec3) { return light; }));
    ASSERT_EQ(sky.levels.size(), 5u);
    for (const SkyLevel& level : sky.levels)
        for (const vec3& texel : level.texels)
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(texel[c], light[c], 1e-5f) << level.size;
    for (const vec3& texel : sky.irradiance.texels)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(texel[c], light[c], 1e-5f);
}

// Every level has the same mean over the sphere, also where all light is in one corner.
TEST(SkyPyramid, LevelsKeepTheLight) {
    const vec3 corner = normalize(vec3(1, 0.97f, -0.98f));
    const SkyPyramid sky = makeSkyPyramid(
        cubeOf(64, [&](vec3 d) { return vec3(dot(d, corner) > 0.995f ? 100.0f : 0.1f); }));
    // Texel 0 of each face of the last level is one of six equal parts of the sphere.
    double coarsest = 0;
    for (uint32_t face = 0; face < 6; ++face)
        coarsest += double(sky.levels.back().texels[face * 9 + 4].x) / 6;
    const double share = (1 - 0.995) / 2;  // of the sphere, of a cap
    EXPECT_NEAR(coarsest, 100 * share + 0.1 * (1 - share), 0.02);
}

// Two directions, a hair apart on both sides of an edge or a corner, find the same light.
TEST(SkyPyramid, FacesMeetWithoutSeams) {
    test::Random random(3);
    CubeMap cube;
    cube.size = 8;
    for (int i = 0; i < 6 * 64; ++i) cube.texels.emplace_back(random.uniform());
    const SkyPyramid sky = makeSkyPyramid(cube);
    const auto look = [&](size_t level, vec3 d) {
        return sampleSkyLevel(viewOf(sky.levels[level]), cube_point(d)).x;
    };
    float apart = 0;
    for (int i = 0; i < 5000; ++i) {
        const float t = 2 * random.uniform() - 1;
        const vec3 signs(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
        for (int axis = 0; axis < 3; ++axis) {
            vec3 edge = signs;
            edge[axis] = i < 8 ? signs[axis] : t;  // the first ones are corners
            for (size_t level = 0; level < sky.levels.size(); ++level) {
                vec3 a = edge, b = edge;
                a[(axis + 1) % 3] *= 1 + 1e-5f, b[(axis + 2) % 3] *= 1 + 1e-5f;
                EXPECT_NEAR(look(level, a), look(level, b), 2e-3f);
                b = edge + vec3(0.3f, 0.2f, 0.1f);
                apart = max(apart, abs(look(level, a) - look(level, b)));
            }
        }
    }
    EXPECT_GT(apart, 0.3f);  // there is something to see
}

TEST(SkyPyramid, SmoothSkiesAreReadAsTheyAre) {
    const SkyPyramid pyramid = makeSkyPyramid(cubeOf(64, gradient));
    const SkyPyramidView sky = viewOf(pyramid);
    test::Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const vec3 d = normalize(vec3(random.uniform(), random.uniform(), random.uniform()) -
                                 0.5f);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(sampleSkyPyramid(sky, d, 0)[c], gradient(d)[c], 4e-3f);
            EXPECT_NEAR(sampleSkyPyramid(sky, d, 2.5f)[c], gradient(d)[c], 0.04f);
        }
        // Far beyond the last level, and no level at all, are the nearest there are.
        EXPECT_EQ(sampleSkyPyramid(sky, d, 99).x, sampleSkyPyramid(sky, d, 6).x);
        EXPECT_EQ(sampleSkyPyramid(sky, d, -3).x, sampleSkyPyramid(sky, d, 0).x);
    }
}

TEST(SkyPyramid, IrradianceIsTheIntegralOverTheHemisphere) {
    // Of 1 + y: 1 + 2/3 n.y. Of a hemisphere: (1 + n.y) / 2. Of a small lamp: its cosine.
    const SkyPyramid smooth = makeSkyPyramid(cubeOf(64, gradient));
    const SkyPyramid half =
        makeSkyPyramid(cubeOf(128, [](vec3 d) { return vec3(d.y > 0 ? 1.0f : 0.0f); }));
    const vec3 at = normalize(vec3(0.3f, 0.8f, -0.4f));
    const float cosine = 0.9995f;
    const SkyPyramid lamp = makeSkyPyramid(
        cubeOf(256, [&](vec3 d) { return vec3(dot(d, at) > cosine ? 1.0f : 0.0f); }));
    test::Random random(5);
    for (int i = 0; i < 500; ++i) {
        const vec3 n = normalize(vec3(random.uniform(), random.uniform(), random.uniform()) -
                                 0.5f);
        const auto read = [&](const SkyPyramid& sky) {
            return sampleSkyLevel(viewOf(sky.irradiance), cube_point(n)).x;
        };
        EXPECT_NEAR(read(smooth), 1 + 2.0f / 3.0f * n.y, 6e-3f);
        EXPECT_NEAR(read(half), 0.5f * (1 + n.y), 6e-3f);
        const float power = 2 * (1 - cosine);  // its solid angle over pi
        EXPECT_NEAR(read(lamp), power * max(dot(n, at), 0.0f), 0.03f * power);
    }
}

}  // namespace
}  // namespace gp
