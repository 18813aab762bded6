#include "shading/shading.h"

#include <random>

#include <gtest/gtest.h>

namespace gp::shading {
namespace {

vec3 randomDirection(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const float a = unit(random);
    return square_to_uniform_sphere(vec2(a, unit(random)));
}

void expectOrthonormal(const Frame& f, float handedness) {
    EXPECT_NEAR(length(f.t), 1.0f, 3e-6f);
    EXPECT_NEAR(length(f.b), 1.0f, 3e-6f);
    EXPECT_NEAR(dot(f.t, f.b), 0.0f, 3e-6f);
    EXPECT_NEAR(dot(f.t, f.n), 0.0f, 3e-6f);
    EXPECT_NEAR(dot(f.b, f.n), 0.0f, 3e-6f);
    EXPECT_NEAR(dot(cross(f.t, f.b), f.n), handedness, 3e-6f);
}

TEST(Frame, IsOrthonormalAndRightHanded) {
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        const vec3 n = randomDirection(random);
        const Frame f = frame_from_normal(n);
        expectOrthonormal(f, 1.0f);
        const vec3 v = randomDirection(random);
        EXPECT_LT(distance(world_from_local(f, local_from_world(f, v)), v), 3e-6f);
    }
    for (float z : {1.0f, -1.0f}) {  // where the formula divides by the least
        expectOrthonormal(frame_from_normal(vec3(0.0f, 0.0f, z)), 1.0f);
        expectOrthonormal(frame_from_normal(normalize(vec3(1e-4f, -1e-4f, z))), 1.0f);
    }
}

TEST(Frame, KeepsNormalAndMirrorsBitangent) {
    std::mt19937 random(2);
    for (int i = 0; i < 20000; ++i) {
        const vec3 n = randomDirection(random);
        const vec3 t = randomDirection(random) * 7.0f;
        if (length(cross(n, t)) < 0.7f) {
            continue;
        }
        const float handedness = (i & 1) != 0 ? -1.0f : 1.0f;
        const Frame f = frame_from_normal_tangent(n, t, handedness);
        EXPECT_EQ(f.n, n);
        EXPECT_GT(dot(f.t, t), 0.0f);
        expectOrthonormal(f, handedness);
    }
}

TEST(Frame, SurvivesUselessTangents) {
    const vec3 n = normalize(vec3(1.0f, 2.0f, -3.0f));
    for (const vec3& t : {vec3(0.0f), n, -5.0f * n, vec3(0.0f, 0.0f, 1e-30f) - n}) {
        expectOrthonormal(frame_from_normal_tangent(n, t, 1.0f), 1.0f);
    }
}

TEST(Octahedral, ErrorIsBelowAHalfStep) {
    std::mt19937 random(3);
    float worst = 0.0f;
    float worstTangent = 0.0f;
    for (int i = 0; i < 200000; ++i) {
        const vec3 d = randomDirection(random);
        worst = max(worst, length(cross(d, octahedral_decode(octahedral_encode(d)))));
        const float handedness = (i & 1) != 0 ? -1.0f : 1.0f;
        const uint code = tangent_encode(d, handedness);
        worstTangent = max(worstTangent, length(cross(d, tangent_decode(code))));
        EXPECT_EQ(tangent_decode_handedness(code), handedness);
    }
    EXPECT_LT(worst, 7e-5f);
    EXPECT_LT(worstTangent, 1.1e-4f);
}

TEST(Octahedral, KeepsTheAxes) {
    for (int axis = 0; axis < 3; ++axis) {
        for (float s : {1.0f, -1.0f}) {
            vec3 d(0.0f);
            d[axis] = s;
            EXPECT_EQ(octahedral_decode(octahedral_encode(d)), d);
            EXPECT_EQ(tangent_decode(tangent_encode(d, 1.0f)), d);
        }
    }
}

}  // namespace
}  // namespace gp::shading
