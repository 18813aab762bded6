// That right calls do what the header says: defaults, units, reading back, saving.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr double pi = std::numbers::pi;

nlohmann::json describe(GpScene scene) {
    size_t needed = 0;
    EXPECT_EQ(gpDescribeScene(scene, nullptr, 0, &needed), GP_SUCCESS);
    std::string text(needed, ' ');
    EXPECT_EQ(gpDescribeScene(scene, text.data(), needed, nullptr), GP_SUCCESS);
    text.pop_back();
    return nlohmann::json::parse(text);
}

// The material of an instance made with `desc`, as the scene's description shows it.
nlohmann::json materialOf(World& w, const GpMaterialDesc* desc) {
    const GpScene scene = gpNewScene(w.device);
    GpInstanceDesc instance{};
    instance.mesh = w.mesh;
    instance.material = gpNewMaterial(w.device, desc);
    EXPECT_NE(gpNewInstance(scene, &instance), nullptr);
    const nlohmann::json j = describe(scene);
    return j["materials"][size_t(j["instances"][0]["material"])];
}

TEST(Behaviour, MaterialOfZerosIsTheDefault) {
    World w;
    const GpMaterialDesc zeros{};
    EXPECT_EQ(materialOf(w, &zeros), materialOf(w, nullptr));
    const nlohmann::json j = materialOf(w, &zeros);
    EXPECT_EQ(j["baseColor"], (nlohmann::json{1.0, 1.0, 1.0, 1.0}));
    EXPECT_EQ(j["roughness"], 1.0);
    EXPECT_EQ(j["ior"], 1.5);
}

TEST(Behaviour, GivenMakesZeroCount) {
    World w;
    GpMaterialDesc desc{};
    desc.given = GP_GIVEN_BASE_COLOR | GP_GIVEN_ROUGHNESS | GP_GIVEN_SPECULAR;
    const nlohmann::json j = materialOf(w, &desc);
    EXPECT_EQ(j["baseColor"], (nlohmann::json{0.0, 0.0, 0.0, 0.0}));
    EXPECT_EQ(j["roughness"], 0.0);
    EXPECT_EQ(j["specular"], 0.0);
}

double emissionOf(World& w, GpLightDesc desc) {
    const GpScene scene = gpNewScene(w.device);
    EXPECT_NE(gpNewLight(scene, &desc), nullptr);
    return describe(scene)["lights"][0]["emission"][1];
}

TEST(Behaviour, LightUnitsAreConverted) {
    World w;
    GpLightDesc light{};
    light.kind = GP_LIGHT_SPHERE;
    light.intensity = 683;
    EXPECT_NEAR(emissionOf(w, light), 683, 1e-3);
    light.unit = GP_UNIT_PHOTOMETRIC;
    EXPECT_NEAR(emissionOf(w, light), 1, 1e-6);
    light.unit = GP_UNIT_POWER_W;
    EXPECT_NEAR(emissionOf(w, light), 683 / (4 * pi), 1e-4);
    light.unit = GP_UNIT_POWER_LM;
    EXPECT_NEAR(emissionOf(w, light), 1 / (4 * pi), 1e-7);
    light.kind = GP_LIGHT_RECTANGLE;
    light.edgeU[0] = 2;
    light.edgeV[2] = 3;
    EXPECT_NEAR(emissionOf(w, light), 1 / (pi * 6), 1e-7);
    light.twoSided = 1;
    EXPECT_NEAR(emissionOf(w, light), 1 / (pi * 12), 1e-7);
}

TEST(Behaviour, LightOfZerosIsOffAndShinesDown) {
    World w;
    const GpLightDesc zeros{};
    const GpScene scene = gpNewScene(w.device);
    EXPECT_NE(gpNewLight(scene, &zeros), nullptr);
    const nlohmann::json j = describe(scene)["lights"][0];
    EXPECT_EQ(j["kind"], "directional");
    EXPECT_EQ(j["emission"], (nlohmann::json{0.0, 0.0, 0.0}));
    EXPECT_EQ(j["direction"], (nlohmann::json{0.0, -1.0, 0.0}));
}

TEST(Behaviour, SettingALightKeepsItsId) {
    World w;
    GpLightDesc desc{};
    desc.id = 99;
    desc.kind = GP_LIGHT_SPOT;
    desc.intensity = 2;
    EXPECT_EQ(gpSetLight(w.light, &desc), GP_SUCCESS);
    const nlohmann::json j = describe(w.scene)["lights"][0];
    EXPECT_EQ(j["id"], 7);
    EXPECT_EQ(j["kind"], "spot");
    EXPECT_NEAR(double(j["outerAngle"]), pi / 4, 1e-6);
}

TEST(Behaviour, AnEnvironmentTakesTheSkysSunAway) {
    World w;
    const GpScene scene = gpNewScene(w.device);
    const GpLightDesc own{};
    EXPECT_NE(gpNewLight(scene, &own), nullptr);
    EXPECT_EQ(gpSetSky(scene, 0, 1, 0), GP_SUCCESS);
    EXPECT_EQ(gpSetSky(scene, 1, 1, 0), GP_SUCCESS);
    GpSceneInfo info{};
    EXPECT_EQ(gpGetSceneInfo(scene, &info), GP_SUCCESS);
    EXPECT_EQ(info.lights, 2u);
    EXPECT_EQ(info.hasEnvironment, 1);
    EXPECT_EQ(gpSetEnvironment(scene, nullptr), GP_SUCCESS);
    EXPECT_EQ(gpGetSceneInfo(scene, &info), GP_SUCCESS);
    EXPECT_EQ(info.lights, 1u);
    EXPECT_EQ(info.hasEnvironment, 0);
}

TEST(Behaviour, SceneInfoCountsSharedThingsOnce) {
    World w;
    GpInstanceDesc again{};
    again.mesh = w.mesh;
    EXPECT_NE(gpNewInstance(w.scene, &again), nullptr);
    GpSceneInfo info{};
    EXPECT_EQ(gpGetSceneInfo(w.scene, &info), GP_SUCCESS);
    EXPECT_EQ(info.meshes, 3u);
    EXPECT_EQ(info.instances, 4u);
    EXPECT_EQ(info.triangles, 3u);
    EXPECT_EQ(info.instancedTriangles, 4u);
    EXPECT_EQ(info.lights, 1u);
    EXPECT_EQ(info.boundsMax[0], 1);
    EXPECT_EQ(info.boundsMin[2], 0);
    const GpScene empty = gpNewScene(w.device);
    EXPECT_EQ(gpGetSceneInfo(empty, &info), GP_SUCCESS);
    EXPECT_EQ(info.instances, 0u);
    EXPECT_EQ(info.boundsMax[0], 0);
}

TEST(Behaviour, SamplesAccumulateOnlyWhenAsked) {
    World w;
    GpFrameStatistics statistics{};
    GpRenderOptions options = fewSamples(3);
    options.accumulate = 1;
    EXPECT_EQ(gpRender(w.frame, w.scene, nullptr, &options), GP_SUCCESS);
    EXPECT_EQ(gpGetFrameStatistics(w.frame, &statistics), GP_SUCCESS);
    EXPECT_EQ(statistics.samplesPerPixel, 5u);  // two are in it from the start
    options.accumulate = 0;
    EXPECT_EQ(gpRender(w.frame, w.scene, nullptr, &options), GP_SUCCESS);
    EXPECT_EQ(gpGetFrameStatistics(w.frame, &statistics), GP_SUCCESS);
    EXPECT_EQ(statistics.samplesPerPixel, 3u);
    // A mesh that changes makes it another scene.
    const GpMeshDesc moved = triangleDesc(GP_MESH_DYNAMIC);
    EXPECT_EQ(gpUpdateMesh(w.dynamicMesh, &moved), GP_SUCCESS);
    options.accumulate = 1;
    EXPECT_EQ(gpRender(w.frame, w.scene, nullptr, &options), GP_ERROR_INVALID_OPERATION);
    options.accumulate = 0;
    EXPECT_EQ(gpRender(w.frame, w.scene, nullptr, &options), GP_SUCCESS);
}

TEST(Behaviour, TheProgressCallbackCanStop) {
    World w;
    GpRenderOptions options = fewSamples(1000000);
    options.progress = [](void*, const GpProgress* p) { return p->samplesPerPixel >= 4 ? 1 : 0; };
    EXPECT_EQ(gpRender(w.frame, w.scene, nullptr, &options), GP_ERROR_CANCELLED);
    GpFrameStatistics statistics{};
    EXPECT_EQ(gpGetFrameStatistics(w.frame, &statistics), GP_SUCCESS);
    EXPECT_GE(statistics.samplesPerPixel, 4u);
    EXPECT_LT(statistics.samplesPerPixel, 1000000u);
}

TEST(Behaviour, EveryImageCanBeReadBack) {
    World w;
    for (int i = 0; i < GP_IMAGE_COUNT; ++i) {
        GpImageInfo info{};
        ASSERT_EQ(gpGetImageInfo(GpFrameImage(i), &info), GP_SUCCESS);
        EXPECT_GT(std::string(info.name).size(), 3u);
        std::vector<unsigned char> pixels(12 * info.bytesPerPixel + 1, 0xab);
        EXPECT_EQ(gpReadFrameImage(w.frame, GpFrameImage(i), pixels.data(), pixels.size()),
                  GP_SUCCESS);
        EXPECT_EQ(pixels.back(), 0xab) << "written past the end";
        EXPECT_NE(pixels[0], 0xab) << info.name;
    }
}

TEST(Behaviour, FramesAreSavedAndReadAgain) {
    World w;
    GpSaveOptions layers{};
    layers.layers = (1u << GP_IMAGE_COUNT) - 1;
    for (const char* name : {"gp_frame.png", "gp_frame.exr", "gp_frame.hdr", "GP_FRAME.EXR"}) {
        const std::string path = w.folder + name;
        const bool exr = path.ends_with("exr");
        ASSERT_EQ(gpSaveFrame(w.frame, path.c_str(), exr ? &layers : nullptr), GP_SUCCESS) << name;
        GpImage image{};
        ASSERT_EQ(gpLoadImage(w.device, path.c_str(), &image), GP_SUCCESS) << name;
        EXPECT_EQ(image.width, 4u);
        EXPECT_EQ(image.height, 3u);
        EXPECT_EQ(image.displayReferred != 0, path.ends_with("png"));
        EXPECT_EQ(image.pixels[0], 0) << "the null backend renders black";
        gpFreeImage(&image);
        EXPECT_EQ(image.pixels, nullptr);
    }
}

TEST(Behaviour, ImagesKeepTheirValues) {
    World w;
    float pixels[8] = {0, 0.25f, 0.5f, 1, 1, 0.125f, 0.75f, 0.5f};
    const GpImage image = {2, 1, pixels, 0};
    const struct {
        const char* name;
        float tolerance;
    } kinds[] = {{"gp_image.exr", 1e-3f}, {"gp_image.hdr", 1e-2f}, {"gp_image.png", 5e-3f}};
    for (const auto& kind : kinds) {
        const std::string path = w.folder + kind.name;
        ASSERT_EQ(gpSaveImage(w.device, path.c_str(), &image), GP_SUCCESS);
        GpImage back{};
        ASSERT_EQ(gpLoadImage(w.device, path.c_str(), &back), GP_SUCCESS);
        for (int i = 0; i < 8; ++i) {
            const bool noAlpha = i % 4 == 3 && path.ends_with("hdr");
            EXPECT_NEAR(back.pixels[i], noAlpha ? 1 : pixels[i], kind.tolerance)
                << kind.name << " " << i;
        }
        gpFreeImage(&back);
    }
}

// The float next to 1.01 is below it, and means the same.
TEST(Behaviour, RangesHoldTheFloatsOfTheirEnds) {
    World w;
    GpOceanDesc sea{};
    sea.cascades = 1, sea.resolution = 16;
    sea.ior = 1.01f;
    EXPECT_EQ(gpSetOcean(w.scene, &sea), GP_SUCCESS);
    sea.ior = 1.009f;
    EXPECT_EQ(gpSetOcean(w.scene, &sea), GP_ERROR_OUT_OF_RANGE);
}

TEST(Behaviour, CamerasLookingDownNeedNoUp) {
    World w;
    GpCameraDesc camera{};
    camera.position[1] = 5;
    const GpRenderOptions one = fewSamples();
    EXPECT_EQ(gpRender(w.frame, w.scene, &camera, &one), GP_SUCCESS);
    camera = {};  // zeros: from the origin along -Z
    EXPECT_EQ(gpRender(w.frame, w.scene, &camera, &one), GP_SUCCESS);
}

TEST(Behaviour, TheDeviceHasAName) {
    World w;
    EXPECT_NE(std::string(gpGetDeviceName(w.device)).find("null"), std::string::npos);
}

}  // namespace
}  // namespace gp::test
