// GP_MODE_LOCAL: lamps over a plane against the light of points in closed form, and every lighting
// model against its own values.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/stage.h"

namespace gp::test {
namespace {

constexpr float pi = 3.14159265f;
constexpr uint32_t side = 9;        // pixels, odd: one of them has the middle
constexpr double rounding = 2e-5;   // relative: floats through some twenty operations

GpLightDesc lightDesc(GpLightKind kind, float intensity, glm::vec3 position = glm::vec3(0)) {
    GpLightDesc d{};
    d.kind = kind;
    d.intensity = intensity;
    put(d.position, position);
    return d;
}

// Samples in the very middle of pixels, as rasterisers have them.
GpRenderOptions centred(const Stage& stage, const GpLocalLighting& local) {
    GpRenderOptions o = stage.options(1);
    o.pixelFilter = GP_PIXEL_BOX;
    o.pixelFilterRadius = 1e-4f;
    o.local = local;
    return o;
}

GpCameraDesc fromAbove(float height) { return lookFrom({0, 0, 0}, {0, 1, 0}, 5, height); }

void expectColor(glm::dvec3 got, glm::dvec3 wanted, const std::string& what,
                 double tolerance = rounding) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(got[c], wanted[c], tolerance * std::abs(wanted[c]) + 1e-7)
            << what << ", channel " << c;
}

class LocalLightingTest : public ::testing::TestWithParam<Variant> {
protected:
    LocalLightingTest() : stage(GetParam()) {}

    // The floor y = 0; its tangent is +X, its bitangent +Z.
    void floor(GpMaterial material) {
        Triangles plane;
        plane.quad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8});
        stage.add(plane, material);
    }
    glm::vec3 middle(const GpLocalLighting& local = {}, float height = 1e-4f) {
        return stage.render(side, side, fromAbove(height), centred(stage, local))
            .at(side / 2, side / 2);
    }
    GpBsdf model(const char* name, const std::vector<GpBsdfParameter>& parameters = {}) {
        GpBsdfDesc desc{};
        desc.model = name;
        desc.parameters = parameters.data();
        desc.parameterCount = uint32_t(parameters.size());
        const GpBsdf bsdf = gpNewBsdf(stage.device, &desc);
        if (!bsdf) stage.check(gpGetError(stage.device, nullptr));
        return bsdf;
    }

    Stage stage;
};

TEST_P(LocalLightingTest, SunOnAMattePlane) {
    const glm::vec3 albedo(0.6f, 0.3f, 0.1f);
    floor(stage.lambert(albedo));
    GpLightDesc sun = lightDesc(GP_LIGHT_DIRECTIONAL, 3);
    put(sun.direction, {1, -2, 0.5f});
    put(sun.color, {1, 0.5f, 0.25f});
    stage.light(sun);
    const glm::dvec3 light = glm::dvec3(3, 1.5, 0.75) * (2 / std::sqrt(5.25));
    const Picture picture = stage.render(side, side, fromAbove(2), centred(stage, {}));
    for (uint32_t i = 0; i < side * side; ++i) {
        expectColor(picture.at(i % side, i / side), light * glm::dvec3(albedo) / double(pi), "sun");
        EXPECT_EQ(picture.color[i].w, 1.0f);
    }
    // Its disk counts as a direction; the other side of the plane is dark.
    sun.angularRadius = 0.4f;
    stage.light(sun);
    expectColor(middle(), 2.0 * light * glm::dvec3(albedo) / double(pi), "two suns");
    GpCameraDesc below = fromAbove(1);
    put(below.position, {0, -5, 0});
    expectColor(stage.render(1, 1, below, centred(stage, {})).at(0, 0), glm::dvec3(0), "below");
}

TEST_P(LocalLightingTest, FalloffsOfAPoint) {
    floor(stage.lambert(glm::vec3(0.5f)));
    const glm::dvec3 at(0.5, 2, -1);
    stage.light(lightDesc(GP_LIGHT_SPHERE, 7, glm::vec3(at)));
    const double d = glm::length(at), form = 7 * 0.5 / pi * at.y / d;
    const std::pair<GpFalloff, double> cases[] = {{GP_FALLOFF_INVERSE_SQUARE, form / (d * d)},
                                                  {GP_FALLOFF_INVERSE, form / d},
                                                  {GP_FALLOFF_NONE, form}};
    for (const auto& [falloff, expected] : cases) {
        GpLocalLighting local{};
        local.falloff = falloff;
        expectColor(middle(local), glm::dvec3(expected), "falloff " + std::to_string(falloff));
    }
}

// Lamps with a size shine from their centre, with their whole power, through whatever is between.
TEST_P(LocalLightingTest, LampsWithASizeAreAsPoints) {
    floor(stage.lambert(glm::vec3(0.5f)));
    const glm::dvec3 at(1, 2, -0.5);
    const double d = glm::length(at), form = 0.5 / pi * at.y / (d * d * d);
    GpLightDesc ball = lightDesc(GP_LIGHT_SPHERE, 5, glm::vec3(at));
    ball.radius = 0.7f;
    stage.light(ball);
    expectColor(middle(), glm::dvec3(5 * form), "a sphere");
    GpLightDesc cone = lightDesc(GP_LIGHT_SPOT, 4, glm::vec3(at));
    put(cone.direction, {-1, -2, 0.5f});
    cone.innerAngle = 0.2f, cone.radius = 0.3f;
    stage.light(cone);
    expectColor(middle(), glm::dvec3(9 * form), "and a spot");
    GpLightDesc panel = lightDesc(GP_LIGHT_RECTANGLE, 6, {0.5f, 2, -1});
    put(panel.edgeU, {1, 0, 0});
    put(panel.edgeV, {0, 0, 1});  // u x v points down
    stage.light(panel);
    const double intensity = 6 * at.y / d;  // radiance times its area as it is seen
    expectColor(middle(), glm::dvec3((9 + intensity) * form), "and a rectangle");
    Triangles screen;
    screen.quad({0.2f, 0.5f, 1}, {0.6f, 0, 0}, {0, 0, -2});
    stage.add(screen, stage.lambert(glm::vec3(0)));
    expectColor(middle(), glm::dvec3((9 + intensity) * form), "behind a screen");
}

TEST_P(LocalLightingTest, AmbientLightAndTheEnvironmentsMean) {
    const glm::dvec3 albedo(0.6, 0.3, 0.1);
    floor(stage.lambert(glm::vec3(albedo)));
    std::vector<glm::vec4> sky(8 * 4, glm::vec4(0));
    for (size_t i = 0; i < 16; ++i) sky[i] = {2, 4, 1, 1};  // the upper half
    GpEnvironmentDesc desc{};
    desc.width = 8, desc.height = 4;
    desc.pixels = &sky[0].x;
    put(desc.color, {1, 0.5f, 1});
    stage.check(gpSetEnvironment(stage.scene, &desc));
    GpLocalLighting local{};
    put(local.ambient, {0.25f, 0.5f, 1});
    const glm::dvec3 mean(1, 1, 0.5), ambient(0.25, 0.5, 1);
    // The packed pixels are rounded, the mean is of what was given.
    expectColor(middle(local), albedo * (mean + ambient), "image");
    stage.surround({3, 2, 1});
    expectColor(middle(local), albedo * (glm::dvec3(3, 2, 1) + ambient), "uniform");
    const GpFrame frame = stage.frame(1, 1);
    const GpRenderOptions options = centred(stage, local);
    const GpCameraDesc above = fromAbove(1);
    GpCameraDesc away = above;
    put(away.target, {0, 10, 0});
    stage.check(gpRender(frame, stage.scene, &above, &options));
    expectColor(glm::vec3(stage.read<glm::vec4>(frame, GP_IMAGE_INDIRECT, 1)[0]),
                albedo * (glm::dvec3(3, 2, 1) + ambient), "the image of indirect light");
    stage.check(gpRender(frame, stage.scene, &away, &options));
    expectColor(glm::vec3(stage.read<glm::vec4>(frame, GP_IMAGE_EMISSION, 1)[0]), {3, 2, 1},
                "the background");
}

// f cos E: of every model in the library, for directions in general.
TEST_P(LocalLightingTest, EveryModelIsItsOwnValueTimesTheLight) {
    const glm::dvec3 albedo(0.5, 1, 0.25);
    floor(stage.lambert(glm::vec3(albedo)));
    const glm::dvec3 toLight = glm::normalize(glm::dvec3(0.6, 0.9, 0.2));
    GpLightDesc sun = lightDesc(GP_LIGHT_DIRECTIONAL, 2);
    put(sun.direction, -glm::vec3(toLight));
    stage.light(sun);
    const glm::vec3 toViewer = glm::normalize(glm::vec3(-0.5f, 1, -0.1f));
    const GpCameraDesc camera = lookFrom({0, 0, 0}, toViewer, 3, 0.01f);
    size_t size = 0;
    stage.check(gpDescribeBsdfModels(stage.device, nullptr, 0, &size));
    std::string text(size, '\0');
    stage.check(gpDescribeBsdfModels(stage.device, text.data(), size, nullptr));
    uint32_t bright = 0;
    for (const auto& entry : nlohmann::json::parse(text.c_str())) {
        if (entry["fromFile"] == true) continue;  // has no values without its file
        const std::string name = entry["name"];
        std::vector<GpBsdfParameter> parameters;
        // Turned by 90 degrees these two would show another brightness.
        if (name == "ward") parameters = {{"alpha_x", "0.5"}, {"alpha_y", "0.2"}};
        for (const auto& p : entry["parameters"])
            if (p["name"] == "base_color") parameters.push_back({"base_color", "0.8"});
        GpLocalLighting local{};
        local.model = model(name.c_str(), parameters);
        // The surface's own colour tints the model's where it has one.
        std::vector<std::string> words;
        for (const double c : {albedo.x, albedo.y, albedo.z})
            words.push_back(std::to_string(0.8 * c));
        const std::string tint = words[0] + "," + words[1] + "," + words[2];
        if (!parameters.empty() && std::string(parameters.back().name) == "base_color")
            parameters.back().value = tint.c_str();
        const glm::vec3 wi(toLight.x, toLight.z, toLight.y), wo(toViewer.x, toViewer.z, toViewer.y);
        GpBsdfValue value{};
        stage.check(gpEvaluateBsdf(model(name.c_str(), parameters), 1, &wi.x, &wo.x, &value));
        const glm::dvec3 expected =
            glm::dvec3(value.f[0], value.f[1], value.f[2]) * double(wi.z) * 2.0;
        expectColor(stage.render(1, 1, camera, centred(stage, local)).at(0, 0), expected, name,
                    1e-3);
        bright += expected.y > 1e-3;
    }
    EXPECT_GE(bright, 20u);
}

// Without a model the material's own: here as the registry's glTF model with its parameters.
TEST_P(LocalLightingTest, OwnMaterials) {
    GpMaterialDesc desc{};
    put(desc.baseColor, {0.8f, 0.5f, 0.3f});
    desc.baseColor[3] = 1, desc.roughness = 0.5f, desc.metallic = 1;
    floor(stage.material(desc));
    stage.light(lightDesc(GP_LIGHT_SPHERE, 3, {0.3f, 1, 0}));
    const glm::vec3 toLight(0.3f, 1, 0), wi(0.3f, 0, 1), wo(0, 0, 1);
    GpBsdfValue value{};
    stage.check(gpEvaluateBsdf(model("gltf", {{"base_color", "0.8,0.5,0.3"},
                                              {"metallic", "1"},
                                              {"alpha_x", "0.25"},
                                              {"alpha_y", "0.25"}}),
                               1, &wi.x, &wo.x, &value));
    const double d = double(glm::length(toLight));
    expectColor(middle(),
                glm::dvec3(value.f[0], value.f[1], value.f[2]) * 3.0 / (d * d * d), "metal", 1e-3);
}

INSTANTIATE_TEST_SUITE_P(All, LocalLightingTest, ::testing::ValuesIn(localVariants()),
                         [](const auto& row) { return variantName(row.param); });

}  // namespace
}  // namespace gp::test
