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

}  // namespace
}  // namespace gp::test
