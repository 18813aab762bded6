// Who looks at a number, as gpDescribeDenoisers tells: its extremes make other pictures there, and
// the same picture everywhere else.
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "render/stage.h"

namespace gp::test {
namespace {

using Json = nlohmann::json;
constexpr uint32_t width = 60, height = 39;
constexpr int frames = 4;

// Something of everything: edges, roughness, light from lamps and surfaces, shadows that move.
struct Room {
    Stage stage;

    Room() : stage(variant()) {
        GpMaterialDesc glossy{};
        glossy.metallic = 0.6f, glossy.roughness = 0.4f;
        Triangles floor, things;
        floor.quad({-3, -1, 3}, {6, 0, 0}, {0, 0, -6});
        floor.quad({-3, -1, -3}, {6, 0, 0}, {0, 4, 0});
        for (const glm::vec3 at : {glm::vec3(-1.2f, 0, 0), glm::vec3(0.3f, -0.4f, 0.8f),
                                   glm::vec3(1.5f, 0, -1)})
            things.sphere(at, 0.7f, 8, false, true);
        stage.add(floor, stage.lambert({0.7f, 0.6f, 0.4f}));
        stage.add(things, stage.material(glossy));
        stage.surround(glm::vec3(0.2f));
        GpLightDesc lamp{};
        lamp.kind = GP_LIGHT_SPHERE;
        lamp.radius = 0.2f;
        for (int i = 0; i < 6; ++i) {
            lamp.intensity = float(1 + i);
            put(lamp.position, {float(i) - 2.5f, 2, float(i % 3)});
            stage.light(lamp);
        }
    }
    static Variant variant() {
        Variant v;
        v.mode = GP_MODE_REALTIME;
        return v;
    }
    Json describe() const {
        size_t needed = 0;
        stage.check(gpDescribeDenoisers(stage.device, nullptr, 0, &needed));
        std::string text(needed, ' ');
        stage.check(gpDescribeDenoisers(stage.device, text.data(), needed, nullptr));
        text.pop_back();
        return Json::parse(text);
    }
    std::vector<glm::vec4> picture(const GpRealtimeOptions& realtime) {
        GpFrameDesc desc{};
        desc.width = width, desc.height = height, desc.mode = GP_MODE_REALTIME;
        const GpFrame frame = gpNewFrame(stage.device, &desc);
        GpRenderOptions o{};
        o.realtime = realtime;
        for (int i = 0; i < frames; ++i) {
            const float angle = 0.03f * float(i);
            const GpCameraDesc camera = lookFrom(
                {0, 0, 0}, {std::sin(angle), 0.2f, std::cos(angle)}, 6, 3);
            stage.check(gpRender(frame, stage.scene, &camera, &o));
        }
        auto color = stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, width * height);
        stage.check(gpReleaseFrame(frame));
        return color;
    }
    // Whether the extremes of a number make different pictures.
    bool counts(const Json& number, GpRealtimeOptions o) {
        const std::string name = number["name"];
        GpDenoiserParameter parameter{name.c_str(), number["minimum"]};
        o.parameters = &parameter, o.parameterCount = 1;
        const auto low = picture(o);
        parameter.value = number["maximum"];
        return picture(o) != low;
    }
};

bool lists(const Json& number, const char* user) {
    for (const Json& one : number["used_by"])
        if (one == user) return true;
    return false;
}

TEST(ParameterUsers, AreThoseThatTheDescriptionNames) {
    Room room;
    const std::pair<const char*, GpDenoiser> denoisers[] = {{"asvgf", GP_DENOISER_ASVGF},
                                                            {"svgf", GP_DENOISER_SVGF},
                                                            {"atrous", GP_DENOISER_ATROUS},
                                                            {"none", GP_DENOISER_NONE}};
    for (const Json& number : room.describe()["parameters"]) {
        ASSERT_FALSE(number["used_by"].empty()) << number["name"];
        for (const auto& [name, denoiser] : denoisers) {
            GpRealtimeOptions o{};
            o.denoiser = denoiser;
            o.antiAliasing = GP_AA_NONE;
            EXPECT_EQ(room.counts(number, o), lists(number, name)) << number["name"] << name;
        }
        GpRealtimeOptions o{};
        o.denoiser = GP_DENOISER_NONE;
        EXPECT_EQ(room.counts(number, o), lists(number, "anti-aliasing")) << number["name"];
        o.antiAliasing = GP_AA_NONE;
        o.lightReuse = GP_REUSE_BIASED;
        EXPECT_EQ(room.counts(number, o), lists(number, "light reuse")) << number["name"];
        o.lightReuse = GP_REUSE_NONE;
        o.indirectReuse = GP_REUSE_BIASED;
        EXPECT_EQ(room.counts(number, o), lists(number, "indirect reuse")) << number["name"];
    }
}

}  // namespace
}  // namespace gp::test
