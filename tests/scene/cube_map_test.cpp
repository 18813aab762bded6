// Six faces as one latitude-longitude image: where they lie, their light, their seams.
#include "scene/cube_map.h"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "scene/environment_table.h"
#include "shading/shading.h"

namespace gp {
namespace {

// Where the middle, the s axis and the t axis of each face point, written down apart from the
// library: a viewer at the origin who looks at +X with +Y up has s, to the right, along -Z.
struct FaceAxes {
    glm::vec3 middle, s, t;
};
constexpr FaceAxes axes[6] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},  {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},    {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},   {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};

glm::vec3 towards(uint32_t face, double s, double t) {
    return axes[face].middle + axes[face].s * float(2 * s - 1) + axes[face].t * float(2 * t - 1);
}

CubeMap painted(uint32_t size, const std::function<glm::vec3(uint32_t, uint32_t, uint32_t)>& f) {
    CubeMap cube{size, {}};
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) cube.texels.push_back(f(face, x, y));
    return cube;
}

// Solid angle of the rectangle from the middle of a face to (x, y) on it.
double cornerAngle(double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1)); }

// Over the sphere, each texel by its own solid angle.
glm::dvec3 meanOf(const CubeMap& cube) {
    glm::dvec3 sum(0);
    const auto at = [&](uint32_t i) { return 2.0 * i / cube.size - 1; };
    for (size_t i = 0; i < cube.texels.size(); ++i) {
        const uint32_t x = uint32_t(i % cube.size), y = uint32_t(i / cube.size % cube.size);
        const double angle = cornerAngle(at(x + 1), at(y + 1)) - cornerAngle(at(x), at(y + 1)) -
                             cornerAngle(at(x + 1), at(y)) + cornerAngle(at(x), at(y));
        sum += glm::dvec3(cube.texels[i]) * angle;
    }
    return sum / (4 * M_PI);
}

glm::dvec3 meanOf(const LatLongImage& image) {
    return makeEnvironmentTable(&image.pixels[0].x, image.width, image.height)->mean;
}

glm::vec3 nearest(const LatLongImage& image, glm::vec3 d) {
    const glm::vec2 uv = shading::environment_uv_from_direction(glm::normalize(d));
    const auto x = std::min(uint32_t(uv.x * float(image.width)), image.width - 1);
    const auto y = std::min(uint32_t(uv.y * float(image.height)), image.height - 1);
    return glm::vec3(image.pixels[size_t(y) * image.width + x]);
}

TEST(CubeMap, FacesLieWhereOpenGlPutsThem) {
    // Each quadrant of each face has a colour of its own.
    const auto color = [](uint32_t face, bool right, bool low) {
        return glm::vec3(float(face + 1), right ? 10.0f : 1.0f, low ? 10.0f : 1.0f);
    };
    const CubeMap cube = painted(16, [&](uint32_t face, uint32_t x, uint32_t y) {
        return color(face, x >= 8, y >= 8);
    });
    const LatLongImage image = latLongFromCube(cube, glm::mat3(1));
    for (uint32_t face = 0; face < 6; ++face)
        for (int q = 0; q < 4; ++q) {
            const glm::vec3 seen =
                nearest(image, towards(face, q & 1 ? 0.75 : 0.25, q & 2 ? 0.75 : 0.25));
            const glm::vec3 expected = color(face, (q & 1) != 0, (q & 2) != 0);
            EXPECT_LT(glm::length(seen - expected), 1e-3f) << "face " << face << ", quarter " << q;
        }
}

TEST(CubeMap, TurnsWithTheMatrix) {
    const CubeMap cube = painted(
        16, [](uint32_t face, uint32_t, uint32_t) { return glm::vec3(float(face + 1)); });
    // The world's -Z, +X, +Y are the cube's +X, +Y, +Z.
    const glm::mat3 worldFromCube(glm::vec3(0, 0, -1), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0));
    const LatLongImage image = latLongFromCube(cube, glm::transpose(worldFromCube));
    EXPECT_EQ(nearest(image, {0, 0, -1}).x, 1);
    EXPECT_EQ(nearest(image, {0, 0, 1}).x, 2);
    EXPECT_EQ(nearest(image, {1, 0, 0}).x, 3);
    EXPECT_EQ(nearest(image, {-1, 0, 0}).x, 4);
    EXPECT_EQ(nearest(image, {0, 1, 0}).x, 5);
    EXPECT_EQ(nearest(image, {0, -1, 0}).x, 6);
}

TEST(CubeMap, KeepsItsLight) {
    for (uint32_t size : {1u, 3u, 16u, 100u}) {
        std::mt19937 random(size);
        std::exponential_distribution<float> noise(1.0f);
        const CubeMap cube = painted(size, [&](uint32_t, uint32_t, uint32_t) {
            return glm::vec3(noise(random), noise(random), noise(random));
        });
        const glm::dvec3 before = meanOf(cube), after = meanOf(latLongFromCube(cube, glm::mat3(1)));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(after[c] / before[c], 1, size < 4 ? 0.06 : 0.01) << size;
    }
}

// All light in one texel: in a face's middle, which is a pole of the image, elsewhere, and at its
// edge, where half of what bilinear reading makes of it lies on texels of another face.
TEST(CubeMap, KeepsTheLightOfOneTexel) {
    constexpr uint32_t size = 64;
    for (glm::uvec2 at : {glm::uvec2(32, 32), glm::uvec2(20, 41), glm::uvec2(0, 30)}) {
        const CubeMap cube = painted(size, [&](uint32_t face, uint32_t x, uint32_t y) {
            return glm::vec3(face == 3 && x == at.x && y == at.y ? 1e4f : 0.0f);
        });
        const double before = meanOf(cube).x, after = meanOf(latLongFromCube(cube, glm::mat3(1))).x;
        EXPECT_NEAR(after / before, 1, at.x == 0 ? 0.06 : 0.03) << at.x << ' ' << at.y;
    }
}

TEST(CubeMap, SeamsDoNotShow) {
    const auto sky = [](glm::vec3 d) {
        d = glm::normalize(d);
        return glm::vec3(1 + 0.5f * d.x, 1 - 0.7f * d.y, 1 + 0.3f * d.z * d.x);
    };
    constexpr uint32_t size = 64;
    const CubeMap cube = painted(size, [&](uint32_t face, uint32_t x, uint32_t y) {
        return sky(towards(face, (x + 0.5) / size, (y + 0.5) / size));
    });
    const LatLongImage image = latLongFromCube(cube, glm::mat3(1));
    float worst = 0;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const glm::vec3 d = shading::environment_direction_from_uv(
                {(float(x) + 0.5f) / float(image.width), (float(y) + 0.5f) / float(image.height)});
            const glm::vec3 off = glm::vec3(image.pixels[size_t(y) * image.width + x]) - sky(d);
            worst = std::max(worst, glm::length(off));
        }
    EXPECT_LT(worst, 0.5f * 2 / size);  // half a texel of the steepest slope
}

TEST(CubeMap, SmallFacesMakeNoSmallImage) {
    const CubeMap cube =
        painted(2, [](uint32_t, uint32_t, uint32_t) { return glm::vec3(0.25f, 0.5f, 1); });
    const LatLongImage image = latLongFromCube(cube, glm::mat3(1));
    EXPECT_EQ(image.width, leastLatLongWidth);
    EXPECT_EQ(image.height, leastLatLongWidth / 2);
    for (const glm::vec4& p : image.pixels)
        ASSERT_LT(glm::length(p - glm::vec4(0.25f, 0.5f, 1, 1)), 1e-5f);
}

}  // namespace
}  // namespace gp
