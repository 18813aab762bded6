// From numbers in a picture to names and parameters.
#include <gtest/gtest.h>

#include "view/scene_index.h"

namespace gp::test {
namespace {

using tool::view::PickedThing;
using tool::view::Row;
using tool::view::SceneIndex;

// As gpDescribeScene writes it: two instances of one mesh, one with a material of its own.
const char* const kDescription = R"({
 "instances": [{"name": "left", "id": 0, "mesh": 0},
               {"name": "right", "id": 0, "mesh": 0, "material": 1}],
 "meshes": [{"name": "ball", "material": 0}],
 "materials": [
  {"name": "clay", "baseColor": [0.8, 0.25, 0.1, 1.0], "roughness": 0.5,
   "coat": {"strength": 1.0, "roughness": 0.125}, "textures": {"baseColor": 0}},
  {"name": "steel", "ior": 1.5, "layers": [
   {"model": "ward", "parameters": {"alpha_x": 0.25, "base_color": "0.8,0.5,0.3"}},
   {"model": "ward", "parameters": {}, "weight": 0.5}]}],
 "textures": [{"name": "", "width": 64, "height": 32}],
 "lights": [{"name": "sun", "id": 7, "kind": "directional", "emission": [1, 2, 3]}],
 "cameras": [{"name": "front"}, {"name": ""}]
})";

std::string valueOf(const std::vector<Row>& rows, const std::string& name) {
    for (const auto& [known, value] : rows) {
        if (known == name) {
            return value;
        }
    }
    return "(none)";
}

TEST(SceneIndex, TellsTheMaterialOfAnInstance) {
    const SceneIndex index(nlohmann::ordered_json::parse(kDescription));
    const std::optional<PickedThing> left = index.thingAt(1);
    ASSERT_TRUE(left);
    EXPECT_EQ(left->instance, 0u);
    EXPECT_EQ(left->instanceName, "left");
    EXPECT_EQ(left->meshName, "ball");
    EXPECT_EQ(left->materialName, "clay");
    EXPECT_EQ(left->model, "glTF");
    EXPECT_EQ(valueOf(left->parameters, "baseColor"), "0.8, 0.25, 0.1, 1");
    EXPECT_EQ(valueOf(left->parameters, "coat.roughness"), "0.125");
    EXPECT_EQ(valueOf(left->parameters, "texture: baseColor"), "texture 0 (64x32)");
    EXPECT_EQ(valueOf(left->parameters, "name"), "(none)");

    const std::optional<PickedThing> right = index.thingAt(2);
    ASSERT_TRUE(right);
    EXPECT_EQ(right->materialName, "steel");  // its own, not the mesh's
    EXPECT_EQ(right->model, "ward");
    EXPECT_EQ(valueOf(right->parameters, "alpha_x"), "0.25");
    EXPECT_EQ(valueOf(right->parameters, "layer 1: weight"), "0.5");
    EXPECT_EQ(valueOf(right->parameters, "ior"), "1.5");
}

TEST(SceneIndex, NothingIsNothing) {
    const SceneIndex index(nlohmann::ordered_json::parse(kDescription));
    EXPECT_FALSE(index.thingAt(0));
    EXPECT_FALSE(index.thingAt(3));
    EXPECT_FALSE(index.thingAt(0xffffffffu));
    EXPECT_FALSE(SceneIndex().thingAt(1));
}

TEST(SceneIndex, ListsCameras) {
    const SceneIndex index(nlohmann::ordered_json::parse(kDescription));
    EXPECT_EQ(index.cameras(), (std::vector<std::string>{"front", ""}));
}

}  // namespace
}  // namespace gp::test
