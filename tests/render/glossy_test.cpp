// Glossy surfaces: what a rectangle shows in them against integration of the reflectance over it,
// and white metals in a furnace against integration over the hemisphere.
#include "shading/shading.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {
namespace {

shading::BsdfParams metal(float roughness, glm::vec3 color) {
    shading::BsdfParams m = shading::bsdf_default();
    m.model = MODEL_GLTF;
    m.metallic = 1;
    m.base_color = color;
    m.alpha_x = m.alpha_y = roughness * roughness;
    return m;
}

GpMaterialDesc metalDesc(float roughness, glm::vec3 color) {
    GpMaterialDesc d{};
    d.metallic = 1, d.roughness = roughness;
    put(d.baseColor, color);
    d.baseColor[3] = 1;
    return d;
}

class Glossy : public ::testing::TestWithParam<Variant> {};

// Small lights are found by shadow rays, large ones in smooth metal by the metal's own rays.
TEST_P(Glossy, RectanglesInMetal) {
    struct Case {
        float roughness, size;
        uint32_t samples;
    };
    const glm::vec3 color(0.9f, 0.6f, 0.3f), wo = glm::normalize(glm::vec3(-0.5f, 0, 1));
    for (const Case c :
         {Case{0.3f, 0.1f, 256}, Case{0.3f, 2, 640}, Case{0.1f, 2, 256}, Case{0.6f, 0.5f, 512}}) {
        // The plane z = 0, the light above, a little off the mirror direction; it shines downwards.
        const glm::dvec3 corner(0.5 - 0.45 * c.size, -0.4 * c.size, 1), u(0, c.size, 0),
            v(c.size, 0, 0);
        const shading::BsdfParams m = metal(c.roughness, color);
        constexpr int steps = 600;
        glm::dvec3 expected(0);
        for (int j = 0; j < steps; ++j)
            for (int i = 0; i < steps; ++i) {
                const glm::dvec3 p = corner + u * ((i + 0.5) / steps) + v * ((j + 0.5) / steps);
                const double d2 = glm::dot(p, p), area = double(c.size) * c.size / (steps * steps);
                const glm::vec3 wi(p / std::sqrt(d2));
                expected += glm::dvec3(shading::bsdf_eval(m, wo, wi).f_cos) * (area * wi.z / d2);
            }
        Stage stage(GetParam());
        Triangles plane;
        plane.quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0});
        stage.add(plane, stage.material(metalDesc(c.roughness, color)));
        GpLightDesc light{};
        light.kind = GP_LIGHT_RECTANGLE, light.intensity = 2;
        put(light.position, glm::vec3(corner)), put(light.edgeU, glm::vec3(u)),
            put(light.edgeV, glm::vec3(v));
        stage.light(light);
        GpRenderOptions o = stage.options(effort(c.samples));
        o.maxBounces = GP_NO_BOUNCES;
        const Picture p = stage.render(8, 8, lookFrom({0, 0, 0}, wo, 0.1f, 1e-3f), o);
        expectMean(p, 2.0 * expected,
                   "roughness " + std::to_string(c.roughness) + " size " + std::to_string(c.size));
    }
}

TEST_P(Glossy, WhiteMetalsShowTheirAlbedo) {
    for (const float roughness : {0.5f, 1.0f}) {
        const shading::BsdfParams m = metal(roughness, glm::vec3(1));
        for (const double cosine : {0.9, 0.4}) {
            const glm::vec3 wo(float(std::sqrt(1 - cosine * cosine)), 0, float(cosine));
            constexpr int steps = 400;
            double albedo = 0;
            for (int j = 0; j < steps; ++j)
                for (int i = 0; i < 2 * steps; ++i) {
                    const float z = (float(j) + 0.5f) / steps, s = std::sqrt(1 - z * z);
                    const float phi = float(pi) * (float(i) + 0.5f) / steps;
                    albedo +=
                        double(shading::bsdf_eval(m, wo, {s * std::cos(phi), s * std::sin(phi), z})
                                   .f_cos.x);
                }
            albedo *= 2 * pi / (2.0 * steps * steps);
            Stage stage(GetParam());
            Triangles plane;
            plane.quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0});
            stage.add(plane, stage.material(metalDesc(roughness, glm::vec3(1))));
            stage.surround(glm::vec3(1));
            expectMean(
                stage.render(8, 8, lookFrom({0, 0, 0}, wo, 1, 0.1f), stage.options(effort(2048))),
                albedo, "roughness " + std::to_string(roughness));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Glossy, ::testing::ValuesIn(fullVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
