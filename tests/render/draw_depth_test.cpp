// Rasterised geometry against the depth of what was traced, and against its own.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "render/canvas.h"
#include "render/stage.h"

namespace gp::test {
namespace {

constexpr uint32_t side = 24;

struct DepthCase {
    std::string name;
    GpFrameMode mode;
    bool orthographic, sloped;
};
void PrintTo(const DepthCase& c, std::ostream* out) { *out << c.name; }

std::vector<DepthCase> depthCases() {
    std::vector<DepthCase> cases;
    for (int i = 0; i < 8; ++i) {
        const bool local = (i & 1) != 0, orthographic = (i & 2) != 0, sloped = (i & 4) != 0;
        cases.push_back({std::string(local ? "local" : "reference") +
                             (orthographic ? "_orthographic" : "_perspective") +
                             (sloped ? "_sloped" : "_facing"),
                         local ? GP_MODE_LOCAL : GP_MODE_REFERENCE, orthographic, sloped});
    }
    return cases;
}

class DrawDepth : public ::testing::TestWithParam<DepthCase> {};

GpCameraDesc cameraOf(const DepthCase& c) {
    GpCameraDesc camera{};
    camera.kind = c.orthographic ? GP_CAMERA_ORTHOGRAPHIC : GP_CAMERA_PERSPECTIVE;
    put(camera.position, {0.4f, 0.3f, 5});
    put(camera.target, {0.1f, -0.2f, 0});
    camera.orthographicHeight = 2.5f;
    return camera;
}

// A wall that fills the picture; facing the camera, or turned by some 50 degrees.
Triangles wallOf(const DepthCase& c) {
    Triangles wall;
    if (c.sloped)
        wall.quad({-6, -9, 3}, {12, 0, -8}, {0, 18, 0});
    else
        wall.quad({-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    return wall;
}

// The same wall, seen in the same place, with all depths multiplied by `scale`.
std::vector<glm::vec3> atDepth(const DepthCase& c, const Triangles& wall, float scale) {
    const GpCameraDesc camera = cameraOf(c);
    const glm::vec3 eye(camera.position[0], camera.position[1], camera.position[2]);
    const glm::vec3 forward =
        glm::normalize(glm::vec3(camera.target[0], camera.target[1], camera.target[2]) - eye);
    std::vector<glm::vec3> moved;
    for (const glm::vec3& p : wall.positions) {
        const float depth = glm::dot(p - eye, forward);
        moved.push_back(c.orthographic ? p + forward * (depth * (scale - 1))
                                       : eye + (p - eye) * scale);
    }
    return moved;
}

// Pixels of the picture that show what was drawn.
size_t visible(const DepthCase& c, float scale, const std::function<void(GpDrawDesc&)>& change) {
    Variant variant = bestFullVariant()[0];
    variant.mode = c.mode;
    Stage stage(variant);
    const Triangles wall = wallOf(c);
    stage.add(wall, stage.lambert(glm::vec3(0.5f)));
    const std::vector<glm::vec3> corners = atDepth(c, wall, scale);
    GpDrawDesc d{};
    d.positions = &corners[0].x;
    d.vertexCount = uint32_t(corners.size());
    d.color[0] = d.color[3] = 1;
    change(d);
    const GpFrame frame = stage.frame(side, side);
    stage.check(gpDraw(frame, &d));
    GpRenderOptions o = stage.options(1);
    o.pixelFilter = GP_PIXEL_BOX;
    o.pixelFilterRadius = 1e-4f;  // rays through the middles of pixels
    const GpCameraDesc camera = cameraOf(c);
    stage.check(gpRender(frame, stage.scene, &camera, &o));
    size_t count = 0;
    for (const glm::vec4& p : stage.read<glm::vec4>(frame, GP_IMAGE_COLOR, side * side))
        count += p == glm::vec4(1, 0, 0, 1);
    return count;
}

TEST_P(DrawDepth, WallsHideWhatLiesBehindAndShowWhatLiesInThem) {
    const auto plain = [](GpDrawDesc&) {};
    // Hidden from 1.5e-4 on: the bias is 1e-4, and a half of that is left to rounding.
    EXPECT_EQ(visible(GetParam(), 1 + 1.5e-4f, plain), 0u);
    EXPECT_EQ(visible(GetParam(), 1 + 5e-5f, plain), side * side);
    EXPECT_EQ(visible(GetParam(), 1, plain), side * side);
    EXPECT_EQ(visible(GetParam(), 0.5f, plain), side * side);
}

TEST_P(DrawDepth, BiasAndFunctionsMoveTheBorder) {
    const DepthCase& c = GetParam();
    EXPECT_EQ(visible(c, 1.01f, [](GpDrawDesc& d) { d.depthBias = 0.011f; }), side * side);
    EXPECT_EQ(visible(c, 1.01f, [](GpDrawDesc& d) { d.depthBias = 0.009f; }), 0u);
    EXPECT_EQ(visible(c, 0.99f, [](GpDrawDesc& d) { d.depthBias = -0.011f; }), 0u);
    EXPECT_EQ(visible(c, 1.01f, [](GpDrawDesc& d) { d.depthTest = GP_DEPTH_ALWAYS; }),
              side * side);
    EXPECT_EQ(visible(c, 0.99f, [](GpDrawDesc& d) { d.depthTest = GP_DEPTH_NEVER; }), 0u);
    EXPECT_EQ(visible(c, 1.01f, [](GpDrawDesc& d) { d.depthTest = GP_DEPTH_GREATER; }),
              side * side);
    EXPECT_EQ(visible(c, 0.99f, [](GpDrawDesc& d) { d.depthTest = GP_DEPTH_GREATER; }), 0u);
}

std::string depthCaseName(const ::testing::TestParamInfo<DepthCase>& info) {
    return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(All, DrawDepth, ::testing::ValuesIn(depthCases()), depthCaseName);

class RasterDepth : public ::testing::TestWithParam<std::string> {};

TEST_P(RasterDepth, FunctionsCompareWithWhatWasWritten) {
    const auto layer = [](float z, uint32_t test, glm::vec4 color) {
        DrawCommand d = rectangleDraw({0, 0}, {20, 3}, color);
        for (glm::vec4& p : d.positions) p.z = z;
        d.state.depthTest = test;
        return d;
    };
    for (uint32_t test = DEPTH_NEVER; test <= DEPTH_ALWAYS; ++test)
        for (float z : {1.0f, 2.0f, 3.0f}) {
            Canvas canvas(20, 3, GetParam());
            DrawCommand ground = layer(2, DEPTH_ALWAYS, {0, 1, 0, 1});
            ground.state.depthWrite = true;
            DrawCommand over = layer(z, test, {1, 0, 0, 1});
            over.state.depthWrite = test == DEPTH_LESS;
            canvas.draw({ground, over});
            const bool passes = test == DEPTH_ALWAYS || (test == DEPTH_LESS && z < 2) ||
                                (test == DEPTH_EQUAL && z == 2) ||
                                (test == DEPTH_LESS_OR_EQUAL && z <= 2) ||
                                (test == DEPTH_GREATER && z > 2) ||
                                (test == DEPTH_NOT_EQUAL && z != 2) ||
                                (test == DEPTH_GREATER_OR_EQUAL && z >= 2);
            for (size_t i = 0; i < canvas.color.size(); ++i) {
                ASSERT_EQ(canvas.color[i].x, passes ? 1.0f : 0.0f) << test << " at " << z;
                ASSERT_EQ(canvas.depth[i], test == DEPTH_LESS && passes ? z : 2.0f);
            }
        }
}

// A matrix as every program makes one gives the pixels and the depths of the camera.
TEST_P(RasterDepth, APerspectiveMatrixIsTheCamera) {
    Canvas byCamera(40, 30, GetParam()), byMatrix(40, 30, GetParam());
    byCamera.camera.target = {0, 0, -1};  // at the origin, along -Z, 45 degrees
    DrawCommand d = pixelDraw({}, {0.3f, 0.6f, 0.9f, 1});
    d.view = DrawView::camera;
    d.positions = {{-3, -1, -2, 1}, {2, -1, -9, 1}, {0, 4, -6, 1}};
    d.state.depthWrite = true;
    byCamera.draw(d);
    // [OpenGL 2.1 reference pages, gluPerspective]
    const float f = 1 / std::tan(0.5f * byCamera.camera.verticalFov), near = 0.1f, far = 100;
    d.view = DrawView::matrix;
    d.viewProjection = glm::mat4(0);
    d.viewProjection[0][0] = f * 30 / 40, d.viewProjection[1][1] = f;
    d.viewProjection[2][2] = (far + near) / (near - far);
    d.viewProjection[3][2] = 2 * far * near / (near - far);
    d.viewProjection[2][3] = -1;
    byMatrix.draw(d);
    size_t drawn = 0;
    for (size_t i = 0; i < byCamera.color.size(); ++i) {
        drawn += byCamera.color[i].w > 0;
        ASSERT_EQ(byCamera.color[i], byMatrix.color[i]) << i;
        if (byCamera.color[i].w > 0) {
            ASSERT_NEAR(byCamera.depth[i], byMatrix.depth[i], 2e-6f * byCamera.depth[i]);
            ASSERT_GT(byCamera.depth[i], 1.99f);
        }
    }
    EXPECT_GT(drawn, 200u);
    // Its planes cut: what lies nearer than `near` or farther than `far` is not there.
    d.positions = {{-1, -1, -0.05f, 1}, {1, -1, -0.05f, 1}, {0, 1, -0.05f, 1},
                   {-90, -90, -110, 1}, {90, -90, -110, 1}, {0, 90, -110, 1}};
    Canvas outside(40, 30, GetParam());
    outside.draw(d);
    for (const glm::vec4& c : outside.color) ASSERT_EQ(c, glm::vec4(0));
}

INSTANTIATE_TEST_SUITE_P(All, RasterDepth, ::testing::ValuesIn(instructionSetsHere()),
                         instructionSetName);

}  // namespace
}  // namespace gp::test
