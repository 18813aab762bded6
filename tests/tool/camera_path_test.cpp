// Camera paths apart from the tool: keys, curves, orbits, and their files.
#include "animate/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tool_error.h"
#include "tool_runner.h"

namespace gp::test {
namespace {

using tool::CameraKey;
using tool::CameraKeys;
using tool::orbitAt;

CameraKey keyAt(double time, glm::dvec3 position) {
    CameraKey key;
    key.time = time;
    key.position = position;
    key.target = position + glm::dvec3(0, 0, -2);
    return key;
}

void expectPosition(const GpCameraDesc& camera, glm::dvec3 expected, double tolerance = 1e-6) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(camera.position[axis], expected[axis], tolerance) << axis;
    }
}

TEST(CameraPath, PassesThroughItsKeysAndHoldsStillOutside) {
    CameraKeys path;
    path.keys = {keyAt(1, {0, 0, 0}), keyAt(2, {3, 1, 0}), keyAt(4, {4, 0, 5})};
    path.keys[2].fovDeg = 90;
    for (const CameraKey& key : path.keys) {
        expectPosition(cameraAt(path, key.time), key.position);
    }
    expectPosition(cameraAt(path, -3), {0, 0, 0});
    expectPosition(cameraAt(path, 9), {4, 0, 5});
    EXPECT_NEAR(cameraAt(path, 3).verticalFov, 67.5 * std::numbers::pi / 180, 1e-6);
    path.keys.resize(1);
    expectPosition(cameraAt(path, 7), {0, 0, 0});
}

// Keys on a line at even speed, at uneven times: the spline is the line.
TEST(CameraPath, EvenMotionStaysEven) {
    CameraKeys path;
    for (const double t : {0.0, 1.0, 1.5, 4.0}) {
        path.keys.push_back(keyAt(t, {2 * t, -t, 0}));
    }
    for (double t = 0; t <= 4; t += 0.125) {
        expectPosition(cameraAt(path, t), {2 * t, -t, 0}, 2e-6);
    }
}

// The speed does not jump at a key, as it does where keys are joined by lines.
TEST(CameraPath, SmoothPathsHaveNoKinks) {
    CameraKeys path;
    path.keys = {keyAt(0, {0, 0, 0}), keyAt(1, {1, 0, 0}), keyAt(2, {1, 1, 0}),
                 keyAt(3, {0, 1, 0})};
    const auto jumpAt = [&](double t) {
        constexpr double h = 1.0 / 64;
        const auto x = [&](double s) { return double(cameraAt(path, s).position[0]); };
        return std::abs((x(t + h) - x(t)) - (x(t) - x(t - h))) / h;
    };
    EXPECT_LT(jumpAt(1), 0.1);
    path.straight = true;
    EXPECT_GT(jumpAt(1), 0.9);
}

TEST(CameraPath, RotationsTakeTheShortArcAtConstantSpeed) {
    CameraKeys path;
    path.turns = true;
    path.keys = {keyAt(0, {0, 0, 0}), keyAt(2, {0, 0, 0})};
    const double quarter = std::numbers::pi / 4;
    path.keys[1].rotation = -glm::dquat(std::cos(quarter), 0, std::sin(quarter), 0);
    // A quarter turn about +Y, to the left, from -Z to -X; a fourth of it after half a second.
    const GpCameraDesc camera = cameraAt(path, 0.5);
    EXPECT_NEAR(camera.target[0], -std::sin(quarter / 2), 1e-6);
    EXPECT_NEAR(camera.target[2], -std::cos(quarter / 2), 1e-6);
    EXPECT_NEAR(camera.up[1], 1, 1e-6);
}

TEST(CameraPath, OrbitsGoCounterClockwiseSeenFromAbove) {
    GpCameraDesc start{};
    start.position[0] = 1;
    start.position[1] = 5;
    start.position[2] = 4;
    const glm::dvec3 centre(1, 2, 0);
    expectPosition(orbitAt(start, centre, 8, 0), {1, 5, 4});
    expectPosition(orbitAt(start, centre, 8, 2), {5, 5, 0});   // +Z to +X
    expectPosition(orbitAt(start, centre, 8, 4), {1, 5, -4});
    expectPosition(orbitAt(start, centre, -8, 2), {-3, 5, 0});
    EXPECT_EQ(orbitAt(start, centre, 8, 3).target[1], 2);
}

class CameraFile : public ::testing::Test {
protected:
    CameraKeys read(const std::string& text) {
        writeText(folder("path.json"), text);
        return tool::readCameraKeys(folder("path.json"), 30);
    }
    std::string errorOf(const std::string& text) {
        try {
            read(text);
        } catch (const tool::RunError& error) {
            const std::string what = error.what();
            EXPECT_TRUE(what.starts_with(folder("path.json: "))) << what;
            return what.substr(folder("path.json: ").size());
        }
        return "no error";
    }
    TestFolder folder;
};

TEST_F(CameraFile, IsRead) {
    const CameraKeys path = read(R"({"interpolation": "linear", "keys": [
        {"time": 0, "position": [1, 2, 3], "target": [0, 0, 0]},
        {"time": 2.5, "position": [4, 5, 6], "target": [0, 1, 0], "fov": 60},
        {"time": 3, "position": [4, 5, 6], "target": [0, 1, 0]}]})");
    EXPECT_TRUE(path.straight);
    EXPECT_FALSE(path.turns);
    ASSERT_EQ(path.keys.size(), 3u);
    EXPECT_EQ(path.keys[0].fovDeg, 30);
    EXPECT_EQ(path.keys[1].time, 2.5);
    EXPECT_EQ(path.keys[1].position, glm::dvec3(4, 5, 6));
    EXPECT_EQ(path.keys[1].target, glm::dvec3(0, 1, 0));
    EXPECT_EQ(path.keys[2].fovDeg, 60);
    const CameraKeys turns =
        read(R"({"keys": [{"time": 0, "position": [0, 0, 0], "rotation": [0, 0, 0, 2]}]})");
    EXPECT_TRUE(turns.turns);
    EXPECT_FALSE(turns.straight);
    EXPECT_EQ(turns.keys[0].rotation, glm::dquat(1, 0, 0, 0));
}

TEST_F(CameraFile, FaultsAreNamedWithTheirPlace) {
    const std::string key = R"({"time": 0, "position": [1, 2, 3], "target": [0, 0, 0]})";
    EXPECT_EQ(errorOf("{"), "is not JSON");
    EXPECT_EQ(errorOf("[]"), "the file: must be an object");
    EXPECT_EQ(errorOf("{}"), "keys: must be a list with at least one key");
    EXPECT_EQ(errorOf(R"({"keys": []})"), "keys: must be a list with at least one key");
    EXPECT_EQ(errorOf(R"({"key": []})"), "the file: 'key' is not known; known are interpolation, "
                                         "keys");
    EXPECT_EQ(errorOf(R"({"interpolation": 3, "keys": [)" + key + "]}"),
              "interpolation: must be \"smooth\" or \"linear\"");
    EXPECT_EQ(errorOf(R"({"keys": [7]})"), "keys[0]: must be an object");
    EXPECT_EQ(errorOf(R"({"keys": [{"time": 0, "position": [1, 2], "target": [0, 0, 0]}]})"),
              "keys[0].position: must be 3 numbers");
    EXPECT_EQ(errorOf(R"({"keys": [{"position": [1, 2, 3], "target": [0, 0, 0]}]})"),
              "keys[0].time: must be a number, below 1e18");
    EXPECT_EQ(errorOf(R"({"keys": [)" + key + "," + key + "]}"),
              "keys[1].time: must be later than that of the key before");
    EXPECT_EQ(errorOf(R"({"keys": [{"time": 0, "position": [1e300, 2, 3], "target": [0, 0, 0]}]})"),
              "keys[0].position: must be a number, below 1e18");
    EXPECT_EQ(errorOf(R"({"keys": [{"time": 0, "position": [1, 2, 3], "target": [1, 2, 3]}]})"),
              "keys[0].target: is where the camera stands");
    EXPECT_EQ(errorOf(R"({"keys": [{"time": 0, "position": [1, 2, 3], "target": [0, 0, 0],
                          "fov": 180}]})"),
              "keys[0].fov: must be 0.01..179 degrees");
    EXPECT_EQ(errorOf(R"({"keys": [{"time": 0, "position": [0, 0, 0],
                          "rotation": [0, 0, 0, 0]}]})"),
              "keys[0].rotation: must not be zero");
    EXPECT_NE(errorOf(R"({"keys": [{"time": 0, "position": [0, 0, 0], "rotation": [0, 0, 0, 1],
                          "target": [0, 0, 0]}]})").find("'target' is not known"),
              std::string::npos);
}

TEST_F(CameraFile, MissingFilesAreNamed) {
    EXPECT_THROW(tool::readCameraKeys(folder("nowhere.json"), 45), tool::RunError);
}

}  // namespace
}  // namespace gp::test
