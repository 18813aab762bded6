// What applications change, through the C++ wrapper.
#include <glitterpath/glitterpath.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "api/world.h"

namespace gp::test {
namespace {

GpDeviceDesc nullBackend() {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;
    return desc;
}

GpMaterialDesc named(const char* name) {
    GpMaterialDesc desc{};
    desc.name = name;
    return desc;
}

struct Shown {
    Device device{nullBackend()};
    Scene scene{device};
    Mesh mesh{device, triangleDesc(GP_MESH_STATIC)};
    Instance instance{scene, descOf(mesh)};

    static GpInstanceDesc descOf(const Mesh& mesh) {
        GpInstanceDesc desc{};
        desc.mesh = mesh.get();
        return desc;
    }
    nlohmann::json json() const { return nlohmann::json::parse(scene.describe()); }
};

TEST(WrapperChanges, MaterialsThatKeepTheirNames) {
    Shown shown;
    GpMaterialDesc lamp = named("lamp");
    lamp.emission[0] = 2;
    const Material old(shown.device, lamp), paint(shown.device, named("paint"));
    shown.instance.setMaterial(old);
    const auto material = [&] {
        const nlohmann::json j = shown.json();
        return j["materials"][size_t(j["instances"][0]["material"])];
    };
    const GpReplacedMaterials other = shown.scene.replaceMaterialModel("none", paint);
    EXPECT_EQ(other.instances, 0u);
    const GpReplacedMaterials replaced = shown.scene.replaceMaterialModel("lamp", paint);
    EXPECT_EQ(replaced.instances, 1u);
    EXPECT_EQ(replaced.kept, uint32_t(GP_MAP_BASE_COLOR | GP_MAP_EMISSION));
    EXPECT_EQ(replaced.left, 0u);
    EXPECT_EQ(material()["name"], "lamp");
    EXPECT_EQ(material()["emission"][0], 2);
    EXPECT_EQ(shown.scene.replaceMaterial("lamp", paint), 1u);
    EXPECT_EQ(material()["name"], "paint");
    EXPECT_EQ(material()["emission"][0], 0);
}

TEST(WrapperChanges, AnimatedMaterials) {
    Shown shown;
    const Material a(shown.device, named("a")), b(shown.device, named("b"));
    Material animated = Material::animated(shown.device, {a.get(), b.get()});
    shown.instance.setMaterial(animated);
    const auto material = [&] {
        const nlohmann::json j = shown.json();
        return j["materials"][size_t(j["instances"][0]["material"])];
    };
    EXPECT_EQ(material()["name"], "a");
    EXPECT_EQ(material()["frames"], 2);
    animated.setFrame(1);
    EXPECT_EQ(material()["name"], "b");
    EXPECT_EQ(material()["frame"], 1);
    try {
        animated.setFrame(2);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), GP_ERROR_OUT_OF_RANGE);
    }
    EXPECT_EQ(material()["name"], "b");
    shown.instance.setMaterial({});
    EXPECT_FALSE(shown.json()["instances"][0].contains("material"));
}

TEST(WrapperChanges, InstancesTexturesAndCoordinates) {
    Shown shown;
    const float red[4] = {1, 0, 0, 0.5f};
    shown.instance.setColor(red);
    shown.instance.setVisibility(GP_VISIBILITY_FIRST_PERSON, GP_VISIBLE_CAMERA);
    nlohmann::json instance = shown.json()["instances"][0];
    EXPECT_EQ(instance["color"], (nlohmann::json{1.0, 0.0, 0.0, 0.5}));
    EXPECT_EQ(instance["visibility"], 0);
    shown.instance.setVisibility(GP_VISIBILITY_VIEWER_BODY);
    EXPECT_EQ(shown.json()["instances"][0]["visibility"], GP_VISIBLE_BOUNCE | GP_VISIBLE_SHADOW);
    shown.mesh.updateTexCoords(1, nullptr);
    EXPECT_THROW(shown.mesh.updateTexCoords(2, nullptr), Error);
    Texture texture(shown.device, textureDesc());
    GpTextureUpdate update{};
    update.width = update.height = 1, update.pixels = textureDesc().pixels;
    texture.update(update);
    update.x = 2;
    EXPECT_THROW(texture.update(update), Error);
    const std::string folder = ::testing::TempDir();
    shown.device.setTextureOverrides({folder.c_str(), nullptr, nullptr, nullptr});
    EXPECT_THROW(shown.device.setTextureOverrides({"nowhere", nullptr, nullptr, nullptr}), Error);
    shown.device.clearTextureOverrides();
}

TEST(WrapperChanges, LightsThatArePolygonsAreDescribed) {
    Shown shown;
    const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    GpLightDesc desc{};
    desc.kind = GP_LIGHT_POLYGON, desc.intensity = 2;
    desc.unit = GP_UNIT_POWER_W;
    desc.corners = corners, desc.cornerCount = 3;
    const Light light(shown.scene, desc);
    const nlohmann::json j = shown.json()["lights"][0];
    EXPECT_EQ(j["kind"], "polygon");
    EXPECT_EQ(j["corners"].size(), 3u);
    EXPECT_NEAR(double(j["emission"][0]), 2 / (3.14159265 * 0.5), 1e-5);
}

}  // namespace
}  // namespace gp::test
