// Surroundings: uniform ones, images against integration, where their parts are seen, rotation.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {
namespace {

constexpr int width = 32, height = 16;

// As glitterpath.h says: the centre looks along -Z, the top is +Y; the right is then +X. Linear
// between the centres of texels, around the sides, up to the poles.
struct Panorama {
    std::vector<float> pixels = std::vector<float>(width * height * 4, 0);
    float& at(int x, int y) { return pixels[size_t(4 * (y * width + x))]; }
    double radiance(glm::dvec3 d) const {
        const double u = (0.5 + std::atan2(d.x, -d.z) / (2 * pi)) * width - 0.5;
        const double v = std::acos(std::clamp(d.y, -1.0, 1.0)) / pi * height - 0.5;
        const int x = int(std::floor(u)), y = int(std::floor(v));
        const auto texel = [&](int i, int j) {
            return double(
                pixels[size_t(4 * (std::clamp(j, 0, height - 1) * width + (i + width) % width))]);
        };
        const double a = u - x, b = v - y;
        return (texel(x, y) * (1 - a) + texel(x + 1, y) * a) * (1 - b) +
               (texel(x, y + 1) * (1 - a) + texel(x + 1, y + 1) * a) * b;
    }
    // Of a surface with normal n, the panorama turned counter-clockwise about +Y.
    double irradiance(glm::dvec3 n, double rotation) const {
        constexpr int steps = 512;
        double sum = 0;
        for (int j = 0; j < steps; ++j) {
            const double y = 1 - 2 * (j + 0.5) / steps, s = std::sqrt(1 - y * y);
            for (int i = 0; i < 2 * steps; ++i) {
                const double phi = pi * (i + 0.5) / steps;
                const glm::dvec3 d(s * std::cos(phi), y, s * std::sin(phi));
                // Turning the image by r is looking into it turned by -r: +X goes to -Z.
                const double c = std::cos(rotation), q = std::sin(rotation);
                sum += radiance({c * d.x - q * d.z, d.y, q * d.x + c * d.z}) *
                       std::max(glm::dot(d, n), 0.0);
            }
        }
        return sum * 4 * pi / (2.0 * steps * steps);
    }
};

class Environments : public ::testing::TestWithParam<Variant> {
protected:
    static void surround(Stage& stage, const Panorama& p, float rotation) {
        GpEnvironmentDesc d{};
        d.width = width, d.height = height, d.pixels = p.pixels.data(), d.rotation = rotation;
        stage.check(gpSetEnvironment(stage.scene, &d));
    }
    static void expectIrradiance(const Panorama& panorama, glm::vec3 n, float rotation,
                                 uint32_t samples) {
        Stage stage(GetParam());
        surround(stage, panorama, rotation);
        const glm::vec3 other = std::abs(n.y) > 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        const glm::vec3 u = glm::normalize(glm::cross(other, n));
        const glm::vec3 v = glm::cross(n, u);
        Triangles plane;
        plane.quad(-u - v, 2.0f * u, 2.0f * v);
        stage.add(plane, stage.lambert(glm::vec3(1)));
        GpRenderOptions o = stage.options(effort(samples));
        o.maxBounces = GP_NO_BOUNCES;
        const Picture p = stage.render(8, 8, lookFrom({0, 0, 0}, n, 0.1f, 1e-3f), o);
        const double e = panorama.irradiance(n, rotation) / pi;
        // Only red is lit.
        EXPECT_LT(4 * p.sigma().x, 0.01 * e) << "too few samples";
        EXPECT_NEAR(p.mean().x, e, 4 * p.sigma().x + 1e-3 * e);
        EXPECT_EQ(p.mean().y, 0);
    }
};

TEST_P(Environments, UniformIsPiTimesItsRadiance) {
    Stage stage(GetParam());
    stage.surround({1, 0.5f, 2});
    Triangles plane;
    plane.quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    stage.add(plane, stage.lambert(glm::vec3(0.5f)));
    expectMean(
        stage.render(8, 8, lookFrom({0, 0, 0}, {0, 1, 0}, 1, 0.5f), stage.options(effort(512))),
        glm::dvec3(0.5, 0.25, 1));
}

TEST_P(Environments, CosineLobeImage) {
    Panorama p;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            p.at(x, y) = std::max(0.0f, std::cos(float(pi) * (float(y) + 0.5f) / height));
    // Of max(cos, 0) itself: 2 pi / 3; the image is coarse.
    EXPECT_NEAR(p.irradiance({0, 1, 0}, 0), 2 * pi / 3, 0.02);
    expectIrradiance(p, {0, 1, 0}, 0, 768);
    expectIrradiance(p, glm::normalize(glm::vec3(1, 0.5f, -0.3f)), 0, 2560);
}

TEST_P(Environments, OneBrightTexelLightsAndTurns) {
    Panorama p;
    p.at(22, 6) = 100;  // to the right of the middle: between -Z and +X
    expectIrradiance(p, glm::normalize(glm::vec3(1, 1, -1)), 0, 5120);
    expectIrradiance(p, glm::vec3(1, 0, 0), 1.3f, 12288);
    expectIrradiance(p, glm::vec3(-1, 0, 0), 2.2f, 5120);
    // A turn by 90 degrees from -Z leads to -X: brighter there than on the other side.
    EXPECT_GT(p.irradiance({-1, 0, 0}, 2.2), 10 * p.irradiance({1, 0, 0}, 2.2));
}

// Where the camera sees a texel: the middle of the image along -Z, its right towards +X.
TEST_P(Environments, TexelsAreSeenWhereTheyAre) {
    Panorama p;
    p.at(width / 2, height / 2) = 1, p.at(width / 2 - 1, height / 2) = 1;
    p.at(width / 2, height / 2 - 1) = 1, p.at(width / 2 - 1, height / 2 - 1) = 1;
    p.at(width * 3 / 4, 2) = 5;
    const auto seen = [&](glm::dvec3 d, float rotation) {
        Stage stage(GetParam());
        surround(stage, p, rotation);
        GpCameraDesc c{};
        put(c.target, glm::vec3(d));
        put(c.up, {0, 0.8f, 0.6f});
        c.verticalFov = 1e-4f;
        return stage.render(2, 2, c, stage.options(4)).mean().x;
    };
    EXPECT_NEAR(seen({0, 0, -1}, 0), 1, 1e-3);
    EXPECT_NEAR(seen({0, 0, 1}, 0), 0, 1e-3);
    EXPECT_NEAR(seen({-1, 0, 0}, float(pi / 2)), 1, 1e-3);  // turned counter-clockwise: -Z to -X
    const double phi = 2 * pi * (24.5 / width - 0.5), theta = pi * 2.5 / height;
    const glm::dvec3 bright(std::sin(theta) * std::sin(phi), std::cos(theta),
                            -std::sin(theta) * std::cos(phi));
    EXPECT_NEAR(seen(bright, 0), 5, 5e-3);
    EXPECT_NEAR(seen(bright * glm::dvec3(-1, 1, 1), 0), 0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Best, Environments, ::testing::ValuesIn(bestVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
