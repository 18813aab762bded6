// Lives of handles: what releasing means, and that an old handle never comes to mean a new object.
#include <set>

#include <gtest/gtest.h>

#include "api/handle.h"
#include "api/objects.h"
#include "api/world.h"

namespace gp::test {

namespace {

TEST(Handles, ManyReusesOfASlotNeverReviveAnOldHandle) {
    const GpDevice device = newNullDevice();
    std::set<GpMaterial> old;
    for (int i = 0; i < 5000; ++i) {
        const GpMaterial material = gpNewMaterial(device, nullptr);
        ASSERT_NE(material, nullptr);
        EXPECT_TRUE(old.insert(material).second) << "a handle came a second time";
        EXPECT_EQ(gpReleaseMaterial(material), GP_SUCCESS);
    }
    for (GpMaterial material : old) EXPECT_EQ(gpReleaseMaterial(material), GP_ERROR_INVALID_HANDLE);
    EXPECT_EQ(gpReleaseDevice(device), GP_SUCCESS);
    EXPECT_EQ(gpGetError(nullptr, nullptr), GP_ERROR_INVALID_HANDLE);
}

TEST(Handles, ASlotWithoutGenerationsLeftIsNotUsedAgain) {
    struct Nothing final : api::Object {
        api::DeviceObject device;
        api::DeviceObject& owner() override { return device; }
    };
    api::HandleTable table;
    const auto object = std::make_shared<Nothing>();
    const api::HandleBits first = table.add(api::HandleType::mesh, object);
    EXPECT_NE(table.find(first, api::HandleType::mesh), nullptr);
    EXPECT_EQ(table.find(first, api::HandleType::scene), nullptr);
    table.remove(first);
    const api::HandleBits second = table.add(api::HandleType::mesh, object);
    EXPECT_NE(first, second);
    EXPECT_FALSE(table.alive(first));
    EXPECT_TRUE(table.alive(second));
    EXPECT_EQ(table.remove(first), nullptr);
    EXPECT_STREQ(table.fault(first, api::HandleType::mesh), "was released");
    EXPECT_STREQ(table.fault(~api::HandleBits(0), api::HandleType::mesh), "is not a handle");
}

TEST(Handles, ObjectsLiveOnWhileSomethingUsesThem) {
    World w;
    GpInstanceDesc desc{};
    desc.mesh = w.mesh;
    const GpInstance instance = gpNewInstance(w.scene, &desc);
    EXPECT_EQ(gpReleaseMesh(w.mesh), GP_SUCCESS);
    EXPECT_EQ(gpReleaseInstance(w.instance), GP_SUCCESS);
    GpSceneInfo info{};
    EXPECT_EQ(gpGetSceneInfo(w.scene, &info), GP_SUCCESS);
    EXPECT_EQ(info.instances, 4u);
    EXPECT_EQ(info.instancedTriangles, 4u);
    EXPECT_EQ(gpSetInstanceTransform(instance, identity), GP_SUCCESS);
    const GpRenderOptions one = fewSamples();
    EXPECT_EQ(gpRender(w.frame, w.scene, nullptr, &one), GP_SUCCESS);
}

TEST(Handles, AnInstanceOutlivesTheHandleOfItsScene) {
    World w;
    EXPECT_EQ(gpReleaseScene(w.scene), GP_SUCCESS);
    EXPECT_EQ(gpSetInstanceTransform(w.instance, identity), GP_SUCCESS);
    EXPECT_EQ(gpRemoveInstance(w.instance), GP_SUCCESS);
    EXPECT_EQ(gpRemoveLight(w.light), GP_SUCCESS);
    w.scene = w.foreign.scene;
}

TEST(Handles, ReleasingADeviceEndsEveryHandleOfIt) {
    const GpDevice device = newNullDevice();
    std::vector<GpMaterial> materials;
    std::vector<GpScene> scenes;
    for (int i = 0; i < 100; ++i) {
        materials.push_back(gpNewMaterial(device, nullptr));
        scenes.push_back(gpNewScene(device));
    }
    EXPECT_EQ(gpReleaseDevice(device), GP_SUCCESS);
    for (GpMaterial m : materials) EXPECT_EQ(gpReleaseMaterial(m), GP_ERROR_INVALID_HANDLE);
    for (GpScene s : scenes) EXPECT_EQ(gpSetSky(s, 0, 1, 0), GP_ERROR_INVALID_HANDLE);
    EXPECT_EQ(gpReleaseDevice(device), GP_ERROR_INVALID_HANDLE);
    gpGetError(nullptr, nullptr);
}

TEST(Handles, AnIdIsFreeAgainOnceItsObjectIsRemoved) {
    World w;
    EXPECT_EQ(gpRemoveInstance(w.instance), GP_SUCCESS);
    EXPECT_EQ(gpRemoveLight(w.light), GP_SUCCESS);
    GpInstanceDesc instance{};
    instance.id = 7;
    instance.mesh = w.mesh;
    EXPECT_NE(gpNewInstance(w.scene, &instance), nullptr);
    GpLightDesc light{};
    light.id = 7;
    EXPECT_NE(gpNewLight(w.scene, &light), nullptr);
    // Releasing gives up the handle only: the id stays taken.
    EXPECT_EQ(gpNewInstance(w.scene, &instance), nullptr);
    EXPECT_EQ(gpGetError(w.device, nullptr), GP_ERROR_DUPLICATE_ID);
}

}  // namespace
}  // namespace gp::test
