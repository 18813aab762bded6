// gpGetSceneLight: what a scene's lights are, whoever brought them, and a handle for each.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "api/world.h"
#include "glitterpath/glitterpath.hpp"

namespace gp::test {
namespace {

struct Lit {
    Device device{nullBackend()};
    Scene scene{device};

    static GpDeviceDesc nullBackend() {
        GpDeviceDesc desc{};
        desc.backend = GP_BACKEND_NULL;
        return desc;
    }
};

TEST(SceneLight, TellsWhatItWasMadeOf) {
    Lit s;
    GpLightDesc spot{};
    spot.kind = GP_LIGHT_SPOT;
    spot.id = 9;
    spot.name = "torch";
    spot.intensity = 8;
    spot.color[0] = 1, spot.color[1] = 0.5f, spot.color[2] = 0.25f;
    spot.position[1] = 3;
    spot.direction[0] = 2;
    spot.radius = 0.125f, spot.innerAngle = 0.25f, spot.outerAngle = 0.5f;
    spot.invisible = 1;
    const Light made(s.scene, spot);
    const GpLightDesc told = s.scene.light(0);
    EXPECT_EQ(told.id, 9u);
    EXPECT_STREQ(told.name, "torch");
    EXPECT_EQ(told.kind, GP_LIGHT_SPOT);
    EXPECT_EQ(told.unit, GP_UNIT_RADIOMETRIC);
    EXPECT_EQ(told.intensity, 8);
    EXPECT_EQ(told.color[1], 0.5f);
    EXPECT_EQ(told.position[1], 3);
    EXPECT_EQ(told.direction[0], 1);  // of length one
    EXPECT_EQ(told.radius, 0.125f);
    EXPECT_NEAR(told.innerAngle, 0.25f, 1e-6f);
    EXPECT_NEAR(told.outerAngle, 0.5f, 1e-6f);
    EXPECT_NE(told.invisible, 0);
}

TEST(SceneLight, PolygonsRectanglesAndSunsAndBack) {
    Lit s;
    const float corners[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    GpLightDesc desc{};
    desc.kind = GP_LIGHT_POLYGON;
    desc.corners = corners, desc.cornerCount = 4;
    desc.intensity = 2, desc.twoSided = 1;
    const Light polygon(s.scene, desc);
    desc = {};
    desc.kind = GP_LIGHT_RECTANGLE;
    desc.edgeU[0] = 2, desc.edgeV[2] = 3, desc.intensity = 1;
    const Light rectangle(s.scene, desc);
    s.scene.setSky(1, 0.5f);
    EXPECT_EQ(s.scene.light(0).cornerCount, 4u);
    EXPECT_EQ(s.scene.light(0).corners[3], 1);
    EXPECT_NE(s.scene.light(0).twoSided, 0);
    EXPECT_EQ(s.scene.light(1).edgeV[2], 3);
    EXPECT_STREQ(s.scene.light(2).name, "sun");
    EXPECT_GT(s.scene.light(2).angularRadius, 0.004f);
    // What is told makes the same light again.
    const std::string before = s.scene.describe();
    for (uint32_t i = 0; i < 3; ++i) {
        Light same(s.scene, i);
        same.set(s.scene.light(i));
    }
    EXPECT_EQ(s.scene.describe(), before);
}

TEST(SceneLight, OffAndOnAgain) {
    Lit s;
    GpLightDesc desc{};
    desc.kind = GP_LIGHT_SPHERE;
    const Light light(s.scene, desc);
    EXPECT_EQ(s.scene.light(0).intensity, 0);
    EXPECT_EQ(s.scene.light(0).color[2], 1);
}

TEST(SceneLight, AnotherHandleOutlivesTheLight) {
    Lit s;
    GpLightDesc desc{};
    desc.kind = GP_LIGHT_SPHERE;
    desc.intensity = 1;
    Light first(s.scene, desc);
    Light second(s.scene, 0);
    second.remove();
    EXPECT_EQ(s.scene.info().lights, 0u);
    EXPECT_THROW(first.set(desc), Error);
    EXPECT_THROW(first.remove(), Error);
    // The sun of a sky goes with it, also once it was set.
    s.scene.setSky(0, 1);
    Light sun(s.scene, 0);
    GpLightDesc red = s.scene.light(0);
    red.color[2] = 0;
    sun.set(red);
    s.scene.setSky(0, 0.5f);
    EXPECT_EQ(s.scene.info().lights, 1u);
    EXPECT_THROW(sun.set(red), Error);
}

}  // namespace
}  // namespace gp::test
