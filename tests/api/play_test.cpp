// gpSetSceneTime through the public interface: which file plays what, and what the device notices.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "api/world.h"

namespace gp::test {

namespace {

using Json = nlohmann::json;

Json describe(GpScene scene) {
    size_t needed = 0;
    EXPECT_EQ(gpDescribeScene(scene, nullptr, 0, &needed), GP_SUCCESS);
    std::string text(needed, ' ');
    EXPECT_EQ(gpDescribeScene(scene, text.data(), needed, nullptr), GP_SUCCESS);
    text.pop_back();
    return Json::parse(text);
}

// A triangle and a camera; animation 1 moves the triangle to X = 4 within 2 s, animation 2 the
// camera to Y = 4. Three positions, then times 0 and 2, then (0,0,0) (4,0,0), then (0,0,0) (0,4,0).
constexpr const char* file = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"mesh": 0, "name": "kite"}, {"camera": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 1}}],
"animations": [
 {"samplers": [{"input": 1, "output": 2}],
  "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]},
 {"samplers": [{"input": 1, "output": 3}],
  "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}]}],
"buffers": [{"byteLength": 92, "uri": "data:application/octet-stream;base64,)"
    R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAEAAAAAAAAAAAAAAAAAAAIBA)"
    R"(AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAACAQAAAAAA="}],
"bufferViews": [{"buffer": 0, "byteLength": 92}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
 {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 2, "type": "SCALAR"},
 {"bufferView": 0, "byteOffset": 44, "componentType": 5126, "count": 2, "type": "VEC3"},
 {"bufferView": 0, "byteOffset": 68, "componentType": 5126, "count": 2, "type": "VEC3"}]})";

class Play : public ::testing::Test {
protected:
    void load(int32_t playable, double time = 0) {
        const std::string path = w.folder + "gp_play.gltf";
        std::ofstream(path) << file;
        GpLoadOptions options{};
        options.playable = playable;
        options.time = time;
        ASSERT_EQ(gpLoadSceneFile(scene, path.c_str(), &options), GP_SUCCESS);
    }
    double x(size_t instance) const {
        return describe(scene)["instances"][instance]["worldFromObject"][3];
    }
    float cameraY(uint32_t index) const {
        GpCameraDesc camera{};
        EXPECT_EQ(gpGetSceneCamera(scene, index, &camera, nullptr), GP_SUCCESS);
        return camera.position[1];
    }
    GpError setTime(double time, uint32_t animation = 0, int32_t loop = 0) {
        const GpPlayOptions options{animation, loop};
        return gpSetSceneTime(scene, time, &options);
    }

    World w;
    GpScene scene = gpNewScene(w.device);
};

TEST_F(Play, MovesWhatTheFileMoves) {
    load(1);
    const Json before = describe(scene);
    ASSERT_EQ(setTime(1), GP_SUCCESS);
    EXPECT_DOUBLE_EQ(x(0), 2);
    Json after = describe(scene);
    after["instances"][0]["worldFromObject"][3] = 0.0;
    EXPECT_EQ(before, after);  // ids, revisions and all the rest
    ASSERT_EQ(setTime(5, 0, 1), GP_SUCCESS);
    EXPECT_DOUBLE_EQ(x(0), 2);
}

TEST_F(Play, TheChosenAnimationGoesOnPlaying) {
    load(1);
    ASSERT_EQ(setTime(1, 2), GP_SUCCESS);
    EXPECT_DOUBLE_EQ(x(0), 0);
    EXPECT_FLOAT_EQ(cameraY(0), 2);
    ASSERT_EQ(setTime(2), GP_SUCCESS);
    EXPECT_FLOAT_EQ(cameraY(0), 4);
    ASSERT_EQ(setTime(2, GP_ALL_ANIMATIONS), GP_SUCCESS);
    EXPECT_DOUBLE_EQ(x(0), 4);
    EXPECT_FLOAT_EQ(cameraY(0), 4);
}

// Animations 1 and 2 are of the first file, 3 and 4 of the second, 5 and 6 of the third.
TEST_F(Play, NumbersCountThroughAllFiles) {
    load(1);
    load(0);
    load(1);
    ASSERT_EQ(setTime(1, 6), GP_SUCCESS);
    EXPECT_DOUBLE_EQ(x(0), 2);
    EXPECT_DOUBLE_EQ(x(1), 0);
    EXPECT_DOUBLE_EQ(x(2), 0);
    EXPECT_FLOAT_EQ(cameraY(0), 0);
    EXPECT_FLOAT_EQ(cameraY(2), 2);
    EXPECT_EQ(setTime(2, 3), GP_ERROR_INVALID_OPERATION);
    EXPECT_EQ(setTime(2, 7), GP_ERROR_OUT_OF_RANGE);
    EXPECT_DOUBLE_EQ(x(0), 2);  // unmoved by the errors
    gpGetError(w.device, nullptr);
}

// What a frame shows is still true while only the camera of the file moves.
TEST_F(Play, OnlyWhatRaysMeetEndsAccumulation) {
    load(1);
    GpCameraDesc camera{};
    camera.position[2] = 3;
    GpRenderOptions more = fewSamples();
    ASSERT_EQ(gpRender(w.frame, scene, &camera, &more), GP_SUCCESS);
    more.accumulate = 1;
    ASSERT_EQ(setTime(1, 2), GP_SUCCESS);
    EXPECT_EQ(gpRender(w.frame, scene, &camera, &more), GP_SUCCESS);
    ASSERT_EQ(setTime(1, 1), GP_SUCCESS);
    EXPECT_EQ(gpRender(w.frame, scene, &camera, &more), GP_ERROR_INVALID_OPERATION);
    gpGetError(w.device, nullptr);
}

TEST_F(Play, FilesLoadedWithoutStandStill) {
    load(0, 2);
    EXPECT_DOUBLE_EQ(x(0), 4);
    EXPECT_EQ(setTime(1), GP_ERROR_INVALID_OPERATION);
    gpGetError(w.device, nullptr);
}

}  // namespace

}  // namespace gp::test
