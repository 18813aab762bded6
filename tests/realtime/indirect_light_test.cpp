// Relighting by mapped normals: for fields of light that vary slowly it is exact to first order.
#include <random>

#include <gtest/gtest.h>

#include "shading/shading.h"

namespace gp::test {
namespace {

using namespace gp::shading;

// What rays over the hemisphere of n0 gather from L = a + b.w: means by midpoint quadrature in the
// square of the cosine-distributed directions.
glm::vec4 momentsOf(const Frame& frame, float a, glm::vec3 b) {
    constexpr int n = 200;
    glm::dvec4 sum(0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double u = (i + 0.5) / n, phi = 2 * 3.14159265358979 * (j + 0.5) / n;
            const double r = std::sqrt(u);
            const glm::vec3 w = world_from_local(
                frame, glm::vec3(float(r * std::cos(phi)), float(r * std::sin(phi)),
                                 float(std::sqrt(1 - u))));
            const double light = a + glm::dot(b, w);
            sum += glm::dvec4(light, glm::dvec3(w) * light);
        }
    return glm::vec4(sum / double(n * n));
}

TEST(IndirectLight, IsExactToFirstOrderInTheTilt) {
    std::mt19937 random(7);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 20; ++i) {
        const auto any = [&] { return glm::vec3(normal(random), normal(random), normal(random)); };
        const glm::vec3 n0 = glm::normalize(any());
        const Frame frame = frame_from_normal(n0);
        const glm::vec3 b = any();
        const float a = glm::length(b) * 1.25f;  // nowhere negative
        const glm::vec4 moments = momentsOf(frame, a, b);
        const auto exact = [&](glm::vec3 n) { return a + 2.0f / 3.0f * glm::dot(b, n); };
        // Quadrature of 40,000 points and floats.
        EXPECT_NEAR(indirect_at_normal(moments, n0, n0), exact(n0), 1e-4f * a);
        EXPECT_NEAR(indirect_at_normal(moments, n0, n0), moments.x, 1e-6f * a);
        const glm::vec3 aside = world_from_local(frame, glm::vec3(std::cos(float(i)),
                                                                  std::sin(float(i)), 0));
        for (const float tilt : {0.02f, 0.1f, 0.3f, 0.6f}) {
            const glm::vec3 n = n0 * std::cos(tilt) + aside * std::sin(tilt);
            // What is left is of second order: (1 - cos) of a share of the light.
            const float allowed = 1e-4f * a + 0.6f * (1 - std::cos(tilt)) * 1.8f * a;
            EXPECT_NEAR(indirect_at_normal(moments, n0, n), exact(n), allowed) << tilt;
        }
    }
}

TEST(IndirectLight, IsNeverNegativeAndKeepsItsColour) {
    const glm::vec3 n0(0, 0, 1);
    const glm::vec4 moments(1, 0.6f, 0, 0.7f);
    const glm::vec3 color(0.8f, 0.4f, 0.1f);
    const glm::vec3 c = ycocg_from_rgb(color);
    const glm::vec2 chroma(c.y / c.x, c.z / c.x);
    for (int i = 0; i <= 100; ++i) {
        const float angle = -3.14159f + 0.0628318f * float(i);
        const glm::vec3 n(std::sin(angle), 0, std::cos(angle));
        const float luma = indirect_at_normal(moments, n0, n);
        EXPECT_GE(luma, 0);
        const glm::vec3 light = indirect_relit(moments, chroma, n0, n);
        EXPECT_NEAR(light.x, luma / c.x * color.x, 1e-5f * (1 + luma));
        EXPECT_NEAR(light.z, luma / c.x * color.z, 1e-5f * (1 + luma));
    }
    // Towards the light, brighter; away from it, darker.
    EXPECT_GT(indirect_at_normal(moments, n0, glm::normalize(glm::vec3(1, 0, 2))), 1);
    EXPECT_LT(indirect_at_normal(moments, n0, glm::normalize(glm::vec3(-1, 0, 2))), 1);
    EXPECT_EQ(indirect_relit(glm::vec4(0), glm::vec2(0), n0, n0), glm::vec3(0));
}

}  // namespace
}  // namespace gp::test
