// The camera that flies: known moves lead to known places.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "view/fly_camera.h"

namespace gp::test {
namespace {

using tool::view::FlyCamera;

constexpr float kPi = std::numbers::pi_v<float>;

GpCameraDesc cameraAt(glm::vec3 position, glm::vec3 target, glm::vec3 up = glm::vec3(0.0f)) {
    GpCameraDesc desc{};
    for (int i = 0; i < 3; ++i) {
        desc.position[i] = position[i];
        desc.target[i] = target[i];
        desc.up[i] = up[i];
    }
    return desc;
}

void expectNear(const float* a, glm::vec3 b, float tolerance = 1.0e-5f) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(a[i], b[i], tolerance) << "axis " << i;
    }
}

// Three metres in three seconds: one metre a second.
constexpr float kReach = 3.0f;

TEST(FlyCamera, ShowsWhatTheFileShowedUntilSomebodyMoves) {
    const GpCameraDesc starts[] = {
        cameraAt({1, 2, 3}, {4, 0, -5}),
        cameraAt({1, 2, 3}, {1, 2, 4}, {0, 1, 0}),
        cameraAt({0, 5, 0}, {0, 0, 0}),                    // straight down: -Z is up
        cameraAt({0, 5, 0}, {0, 0, 0}, {1, 0, 0}),
        cameraAt({0, -5, 0}, {0, 0, 0}, {0, 0, 1}),        // straight up
        cameraAt({0, 0, 0}, {0, 0, -2}, {1, 0, 0}),        // lying on its side
        cameraAt({0, 0, 0}, {0, 0, -2}, {0, -1, 0})};      // on its head
    const glm::vec3 ups[] = {{},        {0, 1, 0}, {0, 0, -1}, {1, 0, 0},
                             {0, 0, 1}, {1, 0, 0}, {0, -1, 0}};
    for (std::size_t i = 0; i < std::size(starts); ++i) {
        SCOPED_TRACE(i);
        const GpCameraDesc desc = FlyCamera(starts[i], kReach).desc();
        expectNear(desc.position, {starts[i].position[0], starts[i].position[1],
                                   starts[i].position[2]});
        expectNear(desc.target, {starts[i].target[0], starts[i].target[1], starts[i].target[2]});
        if (i > 0) {
            expectNear(desc.up, ups[i]);
        }
    }
}

TEST(FlyCamera, FliesAlongItsAxes) {
    // Looking along +X, level: right is +Z.
    FlyCamera camera(cameraAt({0, 0, 0}, {2, 0, 0}), kReach);
    camera.move({0, 0, 1}, 1.0f, false);
    expectNear(camera.desc().position, {1, 0, 0});
    camera.move({1, 0, 0}, 1.0f, false);
    expectNear(camera.desc().position, {1, 0, 1});
    camera.move({0, 1, 0}, 0.5f, false);
    expectNear(camera.desc().position, {1, 0.5f, 1});
    camera.move({0, 0, -1}, 1.0f, true);
    expectNear(camera.desc().position, {-3, 0.5f, 1});
    // The target goes along.
    expectNear(camera.desc().target, {-1, 0.5f, 1});
}

TEST(FlyCamera, ADragOverThePictureTurnsByItsAngleOfView) {
    GpCameraDesc start = cameraAt({0, 0, 0}, {0, 0, -1});
    start.verticalFov = 0.5f;
    FlyCamera camera(start, kReach);
    camera.turn(0, -300, 300);  // up
    expectNear(camera.desc().target, {0, std::sin(0.5f), -std::cos(0.5f)});
    camera.turn(0, 300, 300);
    camera.turn(300, 0, 300);  // to the right, which is +X
    expectNear(camera.desc().target, {std::sin(0.5f), 0, -std::cos(0.5f)});
}

TEST(FlyCamera, NeverTurnsOver) {
    FlyCamera camera(cameraAt({0, 0, 0}, {0, 0, -1}), kReach);
    camera.turn(0, -100000, 100);
    EXPECT_FLOAT_EQ(camera.pitch(), 0.5f * kPi);
    expectNear(camera.desc().target, {0, 1, 0});
    expectNear(camera.desc().up, {0, 0, 1});  // what was behind
    camera.turn(12345, 0, 100);
    EXPECT_LE(std::abs(camera.heading()), kPi);
}

TEST(FlyCamera, WheelAndLevel) {
    FlyCamera camera(cameraAt({0, 0, 0}, {0, 0, -1}, {1, 0, 0}), kReach);
    camera.changeSpeed(4);
    EXPECT_FLOAT_EQ(camera.speed(), 2.0f);
    camera.changeSpeed(-8);
    EXPECT_FLOAT_EQ(camera.speed(), 0.5f);
    camera.changeSpeed(1.0e6f);
    EXPECT_TRUE(std::isfinite(camera.speed()));
    camera.levelOut();
    expectNear(camera.desc().up, {0, 1, 0});
}

TEST(FlyCamera, ComparesEverythingThatIsSeen) {
    const GpCameraDesc a = cameraAt({1, 2, 3}, {4, 0, -5});
    EXPECT_TRUE(tool::view::sameCamera(a, a));
    GpCameraDesc b = a;
    b.position[1] += 1.0e-6f;
    EXPECT_FALSE(tool::view::sameCamera(a, b));
    b = a;
    b.verticalFov = 1;
    EXPECT_FALSE(tool::view::sameCamera(a, b));
    b = a;
    b.apertureRadius = 0.01f;
    EXPECT_FALSE(tool::view::sameCamera(a, b));
}

}  // namespace
}  // namespace gp::test
