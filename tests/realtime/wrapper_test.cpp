// The C++ wrapper's real-time frames, as a program would use them.
#include <gtest/gtest.h>

#include "glitterpath/glitterpath.hpp"

namespace gp::test {
namespace {

TEST(RealtimeWrapper, PassesAndLayers) {
    const gp::Device device;
    const gp::Scene scene(device);
    GpEnvironmentDesc surrounding{};
    surrounding.color[0] = surrounding.color[1] = surrounding.color[2] = 1;
    ASSERT_EQ(gpSetEnvironment(scene.get(), &surrounding), GP_SUCCESS);
    gp::Frame frame(device, 8, 4, GP_MODE_REALTIME);
    EXPECT_TRUE(frame.passTimes().empty());
    frame.render(scene);
    EXPECT_STREQ(frame.passTimes().front().name, "primary");
    const std::vector<float> emission = frame.layer("emission");
    ASSERT_EQ(emission.size(), 8u * 4u * 4u);
    EXPECT_EQ(emission[0], 1);
    EXPECT_THROW(frame.layer("emision"), gp::Error);
}

TEST(RealtimeWrapper, ACubemapSurroundsTheScene) {
    const gp::Device device;
    gp::Scene scene(device);
    const float pixel[4] = {1, 2, 3, 1};
    GpTextureDesc desc{};
    desc.width = desc.height = 1, desc.format = GP_FORMAT_RGBA32F, desc.pixels = pixel;
    const gp::Texture face(device, desc);
    GpCubemapDesc cube{};
    for (GpTexture& f : cube.faces) f = face.get();
    scene.setCubemap(cube);
    gp::Frame frame(device, 4, 4, GP_MODE_REALTIME);
    frame.render(scene);
    EXPECT_NEAR(frame.layer("emission")[1], 2, 0.01);
    cube.faces[5] = nullptr;
    EXPECT_THROW(scene.setCubemap(cube), gp::Error);
}

}  // namespace
}  // namespace gp::test
