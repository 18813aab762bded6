// GP_MODE_LOCAL: where light is computed (for pixels, corners or triangles), what textures and glow
// do there, and that the images of a frame add up.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr float pi = 3.14159265f;
constexpr uint32_t size = 32;

// One triangle with a corner of the picture at each of its corners but one, seen from above; the
// floor is y = 0 and the picture 2 x 2 m.
struct Setting {
    explicit Setting(const Variant& variant) : stage(variant) {}

    void triangle(GpMaterial material, const std::vector<glm::vec3>& normals = {}) {
        Triangles t;
        t.positions = {{-3, 0, 3}, {3, 0, 3}, {-3, 0, -3}};
        t.normals = normals;
        t.uv0 = {{0, 0}, {1, 0}, {0, 1}};
        stage.add(t, material);
    }
    void point(glm::vec3 at, float intensity) {
        GpLightDesc d{};
        d.kind = GP_LIGHT_SPHERE, d.intensity = intensity;
        put(d.position, at);
        stage.light(d);
    }
    GpRenderOptions options(GpShadingFrequency frequency) const {
        GpRenderOptions o = stage.options(1);
        o.pixelFilter = GP_PIXEL_BOX, o.pixelFilterRadius = 1e-4f;
        o.local.frequency = frequency;
        return o;
    }
    Picture look(const GpRenderOptions& o) {
        return stage.render(size, size, lookFrom({0, 0, 0}, {0, 1, 0}, 5, 2), o);
    }
    // Of the middle of a pixel; the camera's up is -Z.
    static glm::dvec2 onFloor(uint32_t x, uint32_t y) {
        return {(x + 0.5) / size * 2 - 1, (y + 0.5) / size * 2 - 1};
    }
    // Barycentrics of the second and third corner there.
    static glm::dvec2 barycentrics(glm::dvec2 p) { return {(p.x + 3) / 6, (3 - p.y) / 6}; }
    static bool inside(glm::dvec2 b) { return b.x + b.y < 1; }

    Stage stage;
};

// Light of a point on a matte surface of reflectance 1.
double matte(glm::dvec3 p, glm::dvec3 n, glm::dvec3 lamp, double intensity) {
    const glm::dvec3 d = lamp - p;
    const double l = glm::length(d);
    return std::max(glm::dot(glm::normalize(n), d), 0.0) / (l * l * l) * intensity / double(pi);
}

class LocalFrequency : public ::testing::TestWithParam<Variant> {};

TEST_P(LocalFrequency, PixelsInterpolateTheNormal) {
    Setting s(GetParam());
    // Any normals do: nothing makes a rasteriser's belong to the triangle.
    const std::array<glm::vec3, 3> n = {glm::vec3(0, 1, 0), glm::normalize(glm::vec3(1, 2, 0)),
                                        glm::normalize(glm::vec3(0, 2, 1))};
    s.triangle(s.stage.lambert(glm::vec3(1)), {n.begin(), n.end()});
    s.point({0.4f, 1.5f, -0.3f}, 9);
    const Picture picture = s.look(s.options(GP_FREQUENCY_PIXEL));
    for (uint32_t i = 0; i < size * size; ++i) {
        const glm::dvec2 p = s.onFloor(i % size, i / size), b = s.barycentrics(p);
        if (!s.inside(b)) continue;
        const glm::dvec3 normal = glm::dvec3(n[0]) * (1 - b.x - b.y) + glm::dvec3(n[1]) * b.x +
                                  glm::dvec3(n[2]) * b.y;
        const double expected = matte({p.x, 0, p.y}, normal, {0.4, 1.5, -0.3}, 9);
        // Normals are stored with an error of up to 7e-5.
        ASSERT_NEAR(picture.at(i % size, i / size).y, expected, 4e-4 * expected) << i;
    }
}

TEST_P(LocalFrequency, CornersInterpolateTheLight) {
    Setting s(GetParam());
    s.triangle(s.stage.lambert(glm::vec3(1)));
    s.point({0.4f, 1.5f, -0.3f}, 9);
    const Picture picture = s.look(s.options(GP_FREQUENCY_VERTEX));
    const glm::dvec3 lamp(0.4, 1.5, -0.3), up(0, 1, 0);
    const double a = matte({-3, 0, 3}, up, lamp, 9), b = matte({3, 0, 3}, up, lamp, 9),
                 c = matte({-3, 0, -3}, up, lamp, 9);
    uint32_t tested = 0;
    for (uint32_t i = 0; i < size * size; ++i) {
        const glm::dvec2 w = s.barycentrics(s.onFloor(i % size, i / size));
        if (!s.inside(w)) continue;
        const double expected = a * (1 - w.x - w.y) + b * w.x + c * w.y;
        ASSERT_NEAR(picture.at(i % size, i / size).x, expected, 3e-5 * expected) << i;
        ++tested;
    }
    EXPECT_GT(tested, size * size / 3);
    // The lamp is near the middle, where no corner is: the highlight of the pixels is lost.
    EXPECT_GT(s.look(s.options(GP_FREQUENCY_PIXEL)).at(14, 14).x, 5 * picture.at(14, 14).x);
}

TEST_P(LocalFrequency, TrianglesAreOfOneColour) {
    Setting s(GetParam());
    s.triangle(s.stage.lambert(glm::vec3(1)),
               {{0, 1, 0}, glm::normalize(glm::vec3(1, 1, 0)), glm::normalize(glm::vec3(0, 1, 1))});
    s.point({0.4f, 1.5f, -0.3f}, 9);
    const Picture picture = s.look(s.options(GP_FREQUENCY_TRIANGLE));
    const double expected = matte({-1, 0, 1}, {0, 1, 0}, {0.4, 1.5, -0.3}, 9);
    for (uint32_t i = 0; i < size * size; ++i) {
        if (!s.inside(s.barycentrics(s.onFloor(i % size, i / size)))) continue;
        ASSERT_EQ(picture.color[i], picture.color[size * size - size]) << i;
        ASSERT_NEAR(picture.color[i].x, expected, 3e-5 * expected);
    }
}

// A viewer from near sees each corner from another side: a lobe that follows the mirror direction.
TEST_P(LocalFrequency, CornersAreSeenFromTheViewersPlace) {
    Setting s(GetParam());
    s.triangle(s.stage.lambert(glm::vec3(1)));
    GpLightDesc sun{};
    sun.intensity = 2;
    s.stage.light(sun);  // straight down
    const GpBsdfParameter words[] = {{"exponent", "4"}, {"divide_by_cosine", "false"}};
    GpBsdfDesc desc{};
    desc.model = "phong", desc.parameters = words, desc.parameterCount = 2;
    GpRenderOptions o = s.options(GP_FREQUENCY_VERTEX);
    o.local.model = gpNewBsdf(s.stage.device, &desc);
    GpCameraDesc camera{};
    put(camera.position, {-1, 4, 1});
    put(camera.target, {-1, 0, 1});
    put(camera.up, {0, 0, -1});
    camera.verticalFov = 0.01f;
    // f is the fourth power of the mirror direction's cosine: the viewer's with the normal. The
    // centroid has a third of each corner.
    double expected = 0;
    for (const glm::dvec3 corner : {glm::dvec3(-3, 0, 3), {3, 0, 3}, {-3, 0, -3}})
        expected += std::pow(4 / glm::length(glm::dvec3(-1, 4, 1) - corner), 4) * 2 / 3;
    EXPECT_NEAR(s.stage.render(1, 1, camera, o).at(0, 0).x, expected, 1e-4 * expected);
}

TEST_P(LocalFrequency, TexturesTintTheModelAndBumpsNeedPixels) {
    Setting s(GetParam());
    const uint8_t grey[4] = {255, 0, 128, 255}, bump[4] = {218, 128, 218, 255};  // 45 degrees
    GpTextureDesc t{};
    t.width = t.height = 1, t.colorSpace = GP_COLOR_LINEAR;
    t.pixels = grey;
    GpMaterialDesc desc = lambertDesc({0.5f, 0.5f, 0.5f});
    desc.baseColorTexture.texture = s.stage.texture(t);
    t.pixels = bump;
    desc.normalTexture.texture = s.stage.texture(t);
    s.triangle(s.stage.material(desc));
    GpLightDesc sun{};
    sun.intensity = pi;
    put(sun.direction, {-1, -1, 0});
    s.stage.light(sun);
    GpBsdfDesc model{};
    model.model = "lambert";
    const GpBsdfParameter half = {"base_color", "0.5"};
    model.parameters = &half, model.parameterCount = 1;
    for (const GpBsdf bsdf : {GpBsdf(nullptr), gpNewBsdf(s.stage.device, &model)}) {
        const double share = bsdf ? 0.25 : 0.5;
        for (const auto& [frequency, cosine] :
             {std::pair(GP_FREQUENCY_PIXEL, 1.0), std::pair(GP_FREQUENCY_VERTEX, std::sqrt(0.5)),
              std::pair(GP_FREQUENCY_TRIANGLE, std::sqrt(0.5))}) {
            GpRenderOptions o = s.options(frequency);
            o.local.model = bsdf;
            const glm::vec3 c = s.look(o).at(4, 20);
            EXPECT_NEAR(c.x, share * cosine, 0.005 * share) << frequency;
            EXPECT_EQ(c.y, 0);
            EXPECT_NEAR(c.z, share * cosine * 128 / 255, 0.005 * share) << frequency;
        }
    }
}

// What glows shows it and lights nothing; unlit surfaces are as they are; the images add up.
TEST_P(LocalFrequency, GlowAndTheSumOfTheImages) {
    for (const GpShadingFrequency frequency :
         {GP_FREQUENCY_PIXEL, GP_FREQUENCY_VERTEX, GP_FREQUENCY_TRIANGLE}) {
        Setting s(GetParam());
        s.triangle(s.stage.lambert({0.5f, 0.5f, 0.5f}, {1, 2, 3}));
        Triangles panel;
        panel.quad({0.5f, 0.1f, -0.5f}, {0.4f, 0, 0}, {0, 0, -0.4f});
        GpMaterialDesc unlit = lambertDesc({0.7f, 0.6f, 0.5f});
        unlit.unlit = 1;
        s.stage.add(panel, s.stage.material(unlit));
        s.point({0, 2, 0}, 3);
        GpRenderOptions o = s.options(frequency);
        put(o.local.ambient, {0.2f, 0.1f, 0.4f});
        const GpFrame frame = s.stage.frame(size, size);
        const GpCameraDesc camera = lookFrom({0, 0, 0}, {0, 1, 0}, 5, 2);
        s.stage.check(gpRender(frame, s.stage.scene, &camera, &o));
        const auto read = [&](GpFrameImage image) {
            return s.stage.read<glm::vec4>(frame, image, size * size);
        };
        const auto color = read(GP_IMAGE_COLOR), emission = read(GP_IMAGE_EMISSION),
                   direct = read(GP_IMAGE_DIRECT), indirect = read(GP_IMAGE_INDIRECT),
                   albedo = read(GP_IMAGE_ALBEDO);
        for (uint32_t i = 0; i < size * size; ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(color[i][c], emission[i][c] + direct[i][c] + indirect[i][c], 1e-6);
        const uint32_t glowing = size * 20 + 4, shown = size * 5 + 26;
        EXPECT_EQ(glm::vec3(emission[glowing]), glm::vec3(1, 2, 3));
        EXPECT_EQ(glm::vec3(albedo[glowing]), glm::vec3(0.5f));
        EXPECT_GT(direct[glowing].x, 0);
        EXPECT_NEAR(indirect[glowing].z, 0.2, 1e-6);
        EXPECT_EQ(glm::vec3(color[shown]), glm::vec3(0.7f, 0.6f, 0.5f));
        // The glow beside it adds nothing to what the lamp makes of another surface.
        EXPECT_NEAR(direct[glowing].x, direct[glowing].z, 1e-7);
    }
}

INSTANTIATE_TEST_SUITE_P(All, LocalFrequency, ::testing::ValuesIn(localVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
