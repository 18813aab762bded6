// Animations, morph targets and skins at a moment, against values computed by hand.
#include "io/load_helpers.h"

using namespace gp;
using namespace gp::test;

namespace {

// A triangle whose node has one animated property.
GltfBuilder animated(const char* path, size_t (*output)(GltfBuilder&), const char* kind) {
    GltfBuilder b;
    b.addMesh(b.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    const size_t times = b.floats({1, 3});
    b.json["animations"] = {
        {{"name", "move"},
         {"samplers", {{{"input", times}, {"output", output(b)}, {"interpolation", kind}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}}};
    return b;
}

size_t fromZeroToFour(GltfBuilder& b) { return b.vec3s({{0, 0, 0}, {4, 0, 0}}); }
size_t quarterTurn(GltfBuilder& b) {
    return b.vec4s({{0, 0, 0, 1}, {0, 0, -0.70710678f, -0.70710678f}});  // 90 degrees, other sign
}
// in-tangent, value, out-tangent
size_t spline(GltfBuilder& b) {
    return b.vec3s({{9, 9, 9}, {0, 0, 0}, {3, 0, 0}, {-1, 0, 0}, {4, 0, 0}, {9, 9, 9}});
}

glm::vec3 originAt(const GltfBuilder& b, double time) {
    return worldVertex(*loadAt(b, time).instances[0], 0);
}

}  // namespace

TEST(GltfAnimation, LinearStepAndClamping) {
    const GltfBuilder linear = animated("translation", fromZeroToFour, "LINEAR");
    expectNear(originAt(linear, -5), {0, 0, 0});
    expectNear(originAt(linear, 1.5), {1, 0, 0});
    expectNear(originAt(linear, 3), {4, 0, 0});
    expectNear(originAt(linear, 99), {4, 0, 0});
    const GltfBuilder step = animated("translation", fromZeroToFour, "STEP");
    expectNear(originAt(step, 2.99), {0, 0, 0});
    expectNear(originAt(step, 3), {4, 0, 0});
}

TEST(GltfAnimation, CubicSpline) {
    const GltfBuilder b = animated("translation", spline, "CUBICSPLINE");
    // s = 1/4, duration 2: h10 * 2 * 3 + h01 * 4 + h11 * 2 * -1
    const float s = 0.25f, h10 = s * s * s - 2 * s * s + s, h01 = 3 * s * s - 2 * s * s * s,
                h11 = s * s * s - s * s;
    expectNear(originAt(b, 1.5), {h10 * 6 + h01 * 4 - h11 * 2, 0, 0});
    expectNear(originAt(b, 0), {0, 0, 0});
    expectNear(originAt(b, 9), {4, 0, 0});
}

TEST(GltfAnimation, RotationTakesTheShortWayAtConstantSpeed) {
    const GltfBuilder b = animated("rotation", quarterTurn, "LINEAR");
    const double quarter = loadAt(b, 1.5).instances[0]->mesh ? 22.5 : 0;
    const float a = float(quarter * 3.14159265 / 180);
    expectNear(worldVertex(*loadAt(b, 1.5).instances[0], 1), {std::cos(a), std::sin(a), 0});
}

TEST(GltfAnimation, ScaleAndKinds) {
    const GltfBuilder b = animated("scale", fromZeroToFour, "LINEAR");
    const Scene s = loadAt(b, 2);
    expectNear(worldVertex(*s.instances[0], 1), {2, 0, 0});
    EXPECT_EQ(s.instances[0]->mesh->kind, MeshKind::movable);
    EXPECT_EQ(s.animations, std::vector<std::string>{"move"});
    GltfBuilder still = b;
    still.json.erase("animations");
    EXPECT_EQ(load(still).instances[0]->mesh->kind, MeshKind::staticMesh);
}

TEST(GltfAnimation, ChildrenOfMovingNodesMove) {
    GltfBuilder b = animated("translation", fromZeroToFour, "LINEAR");
    b.json["nodes"].push_back({{"children", {0}}});
    b.json["nodes"][0]["translation"] = {0, 1, 0};
    b.json["animations"][0]["channels"][0]["target"]["node"] = 1;
    b.json["scenes"][0]["nodes"] = {1};
    expectNear(originAt(b, 3), {4, 1, 0});
    EXPECT_EQ(loadAt(b, 3).instances[0]->mesh->kind, MeshKind::movable);
}

TEST(GltfAnimation, OneIsChosen) {
    GltfBuilder b = animated("translation", fromZeroToFour, "LINEAR");
    nlohmann::json second = b.json["animations"][0];
    second["name"] = "second";
    second["samplers"][0]["output"] = b.vec3s({{0, 7, 0}, {0, 7, 0}});
    b.json["animations"].push_back(second);
    expectNear(worldVertex(*loadAt(b, 3).instances[0], 0), {4, 0, 0});
    expectNear(worldVertex(*loadAt(b, 3, 1).instances[0], 0), {0, 7, 0});
    EXPECT_EQ(load(b).animations.size(), 2u);
}

TEST(GltfMorph, WeightsOfMeshNodeAndAnimation) {
    GltfBuilder b;
    nlohmann::json& p = b.addMesh(b.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    const size_t up = b.vec3s(std::vector<glm::vec3>(3, {0, 0, 1}));
    const size_t right = b.vec3s(std::vector<glm::vec3>(3, {1, 0, 0}));
    p["targets"] = {{{"POSITION", up}}, {{"POSITION", right}}};
    expectNear(worldVertex(*load(b).instances[0], 0), {0, 0, 0});
    b.json["meshes"][0]["weights"] = {0.5, 0};
    expectNear(worldVertex(*load(b).instances[0], 0), {0, 0, 0.5f});
    EXPECT_EQ(load(b).instances[0]->mesh->kind, MeshKind::staticMesh);
    b.json["nodes"][0]["weights"] = {0.25, 2};
    expectNear(worldVertex(*load(b).instances[0], 0), {2, 0, 0.25f});
    const size_t times = b.floats({0, 1}), weights = b.floats({0, 0, 1, 4});
    b.json["animations"] = {
        {{"samplers", {{{"input", times}, {"output", weights}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    const Scene s = loadAt(b, 0.5);
    expectNear(worldVertex(*s.instances[0], 0), {2, 0, 0.5f});
    EXPECT_EQ(s.instances[0]->mesh->kind, MeshKind::dynamic);
}

TEST(GltfSkin, BlendsJointsAndIgnoresItsNode) {
    GltfBuilder b;
    nlohmann::json& p = b.addMesh(b.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    const std::vector<uint8_t> joints = {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
    p["attributes"]["JOINTS_0"] = b.accessor(joints.data(), 12, 3, 5121, "VEC4");
    // Byte weights that do not quite sum to one: 127 + 127.
    const std::vector<uint8_t> weights = {255, 0, 0, 0, 255, 0, 0, 0, 127, 127, 0, 0};
    p["attributes"]["WEIGHTS_0"] = b.accessor(weights.data(), 12, 3, 5121, "VEC4", true);
    p["attributes"]["NORMAL"] = b.vec3s(std::vector<glm::vec3>(3, {0, 0, 1}));
    glm::mat4 bind(1);
    bind[3] = {-1, 0, 0, 1};
    const size_t inverse = b.mat4s({glm::mat4(1), bind});
    b.json["nodes"][0]["skin"] = 0;
    b.json["nodes"][0]["translation"] = {100, 0, 0};
    b.json["nodes"].push_back({{"translation", {0, 0, 2}}});
    b.json["nodes"].push_back({{"translation", {0, 5, 0}}});
    b.json["scenes"][0]["nodes"] = {0, 1, 2};
    b.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
    const Scene s = load(b);
    expectNear(worldVertex(*s.instances[0], 0), {0, 0, 2});
    expectNear(worldVertex(*s.instances[0], 1), {0, 5, 0});
    expectNear(worldVertex(*s.instances[0], 2), {-0.5f, 3.5f, 1});
    EXPECT_EQ(s.instances[0]->mesh->kind, MeshKind::staticMesh);
}
