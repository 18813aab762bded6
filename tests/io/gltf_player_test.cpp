// Files that play on: every moment must be what a fresh load for that moment is, in the same
// objects as before.
#include "io/gltf_player.h"

#include <chrono>

#include "io/load_helpers.h"

using namespace gp;
using namespace gp::test;

namespace {

struct Playing {
    Scene scene;
    std::shared_ptr<io::GltfPlayer> player;
    std::vector<const Instance*> instances;
    std::vector<uint64_t> meshRevisions;

    explicit Playing(const std::string& path, int animation = -1, Scene before = {}) {
        scene = std::move(before);
        io::GltfOptions options;
        options.playable = true;
        options.animation = animation;
        player = io::loadGltf(path, options, scene);
        for (const auto& i : scene.instances) {
            instances.push_back(i.get());
            meshRevisions.push_back(i->mesh->revision);
        }
    }
    bool goTo(double time, int animation = -1, bool loop = false) {
        player->prepare({time, loop, animation});
        return player->apply(scene);
    }
};

// Bit for bit: both come from the same arithmetic on the same numbers.
void expectSame(const Mesh& a, const Mesh& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.triangles, b.triangles);
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (size_t v = 0; v < a.vertices.size(); ++v) {
        ASSERT_EQ(a.vertices[v].normalOct, b.vertices[v].normalOct) << v;
        ASSERT_EQ(a.vertices[v].tangentOct, b.vertices[v].tangentOct) << v;
        ASSERT_EQ(a.vertices[v].uv, b.vertices[v].uv) << v;
    }
    EXPECT_EQ(a.uv1, b.uv1);
    EXPECT_EQ(a.colors, b.colors);
}

void expectSame(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.instances.size(), b.instances.size());
    for (size_t i = 0; i < a.instances.size(); ++i) {
        EXPECT_EQ(a.instances[i]->id, b.instances[i]->id);
        EXPECT_EQ(a.instances[i]->worldFromObject, b.instances[i]->worldFromObject);
        EXPECT_EQ(a.instances[i]->mesh->kind, b.instances[i]->mesh->kind);
        expectSame(*a.instances[i]->mesh, *b.instances[i]->mesh);
    }
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (size_t i = 0; i < a.lights.size(); ++i) {
        EXPECT_EQ(a.lights[i]->position, b.lights[i]->position);
        EXPECT_EQ(a.lights[i]->direction, b.lights[i]->direction);
        EXPECT_EQ(a.lights[i]->emission, b.lights[i]->emission);
    }
    ASSERT_EQ(a.cameras.size(), b.cameras.size());
    for (size_t i = 0; i < a.cameras.size(); ++i) {
        EXPECT_EQ(a.cameras[i].position, b.cameras[i].position);
        EXPECT_EQ(a.cameras[i].target, b.cameras[i].target);
        EXPECT_EQ(a.cameras[i].up, b.cameras[i].up);
    }
}

Scene freshAt(const std::string& path, double time, int animation = -1) {
    io::GltfOptions options;
    options.time = time;
    options.animation = animation;
    Scene scene;
    io::loadGltf(path, options, scene);
    return scene;
}

std::string written(const GltfBuilder& b, const char* name) {
    const std::string path = inTemp(name);
    writeFile(path, b.gltf());
    return path;
}

// Two triangles: node 0 moves along X in animation 0 and along Y in animation 1; node 1 stays.
// Both are of mesh 0, but a third node shows a mesh that nothing moves.
GltfBuilder twoAnimations() {
    GltfBuilder b;
    b.addMesh(b.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    b.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 5}}});
    b.json["scenes"][0]["nodes"].push_back(1);
    b.addMesh(b.vec3s({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}));
    b.json["nodes"][0]["translation"] = {7, 7, 7};
    const size_t times = b.floats({1, 3});
    const auto animation = [&](const char* name, glm::vec3 to, const char* path) {
        const size_t output = b.vec3s({{0, 0, 0}, to});
        return nlohmann::json{
            {"name", name},
            {"samplers", {{{"input", times}, {"output", output}}}},
            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}};
    };
    b.json["animations"] = {animation("x", {4, 0, 0}, "translation"),
                            animation("size", {2, 2, 2}, "scale")};
    return b;
}

}  // namespace

TEST(GltfPlayer, EveryMomentIsThatOfAFreshLoad) {
    const std::string path = written(richGltf(), "rich.gltf");
    Playing p(path);
    for (const double time : {0.3, 1.0, 1.7, -2.0, 5.0, 0.0}) {
        SCOPED_TRACE(time);
        p.goTo(time);
        expectSame(p.scene, freshAt(path, time));
    }
}

TEST(GltfPlayer, ObjectsStayAndOnlyWhatChangesIsNew) {
    const std::string path = written(twoAnimations(), "two.gltf");
    Playing p(path);
    EXPECT_EQ(p.scene.instances[0]->mesh->kind, MeshKind::movable);
    EXPECT_EQ(p.scene.instances[2]->mesh->kind, MeshKind::staticMesh);
    EXPECT_TRUE(p.goTo(2));
    expectNear(worldVertex(*p.scene.instances[0], 0), {2, 0, 0});
    expectNear(worldVertex(*p.scene.instances[1], 0), {0, 0, 5});
    EXPECT_FALSE(p.goTo(2));  // the same moment: nothing is new
    for (size_t i = 0; i < p.instances.size(); ++i) {
        EXPECT_EQ(p.scene.instances[i].get(), p.instances[i]);
        EXPECT_EQ(p.scene.instances[i]->mesh->revision, p.meshRevisions[i]);
    }
    // The rich file deforms: its mesh gets a revision for each change, and none for none.
    Playing rich(written(richGltf(), "rich.gltf"));
    const Mesh* mesh = rich.scene.instances[0]->mesh.get();
    rich.goTo(0.5);
    EXPECT_EQ(mesh, rich.scene.instances[0]->mesh.get());
    EXPECT_EQ(mesh->revision, rich.meshRevisions[0] + 1);
    rich.goTo(0.5);
    EXPECT_EQ(mesh->revision, rich.meshRevisions[0] + 1);
}

TEST(GltfPlayer, AnimationsAreChosenAndWhatNoneMovesGoesBack) {
    const std::string path = written(twoAnimations(), "two.gltf");
    Playing p(path);
    p.goTo(3);
    expectNear(worldVertex(*p.scene.instances[0], 0), {4, 0, 0});
    p.goTo(3, 1);
    expectNear(worldVertex(*p.scene.instances[0], 0), {7, 7, 7});  // as the file has it
    expectNear(worldVertex(*p.scene.instances[0], 1), {9, 7, 7});
    expectSame(p.scene, freshAt(path, 3, 1));
    p.goTo(3, io::allAnimations);
    expectNear(worldVertex(*p.scene.instances[0], 0), {4, 0, 0});
    expectNear(worldVertex(*p.scene.instances[0], 1), {6, 0, 0});
    expectSame(p.scene, freshAt(path, 3, io::allAnimations));
    EXPECT_THROW(p.player->prepare({0, false, 2}), io::FileError);
}

TEST(GltfPlayer, LoopsStartAgain) {
    Playing p(written(twoAnimations(), "two.gltf"));
    const auto x = [&](double time, bool loop) {
        p.goTo(time, 0, loop);
        return p.scene.instances[0]->worldFromObject[3].x;
    };
    EXPECT_FLOAT_EQ(x(5, false), 4);   // the last key is at 3 s
    EXPECT_FLOAT_EQ(x(5, true), 2);    // 5 = 3 + 2
    EXPECT_FLOAT_EQ(x(2, true), 2);
    EXPECT_FLOAT_EQ(x(3, true), 0);    // the end is the beginning
    EXPECT_FLOAT_EQ(x(-1, true), 2);
    EXPECT_EQ(io::loopedTime(1.5, 0), 1.5);
}

TEST(GltfPlayer, FindsItsOwnAmongWhatWasThereBefore) {
    const GltfBuilder b = richGltf();
    Scene before = load(b);
    const size_t held = before.instances.size(), cameras = before.cameras.size();
    const glm::vec3 old = before.cameras[0].position;
    const std::string path = written(b, "rich.gltf");
    Playing p(path, -1, std::move(before));
    p.goTo(1);
    EXPECT_EQ(p.scene.cameras[0].position, old);
    const Scene fresh = freshAt(path, 1);
    EXPECT_EQ(p.scene.cameras[cameras].position, fresh.cameras[0].position);
    EXPECT_NE(p.scene.cameras[cameras].position, old);
    expectSame(*p.scene.instances[held]->mesh, *fresh.instances[0]->mesh);
}

TEST(GltfPlayer, AFailedMomentChangesNothing) {
    GltfBuilder b = twoAnimations();
    const size_t far = b.vec3s({{0, 0, 0}, {3e38f, 0, 0}});
    b.json["animations"][0]["samplers"][0]["output"] = far;
    Playing p(written(b, "far.gltf"));
    p.goTo(1);
    const glm::mat4x3 before = p.scene.instances[0]->worldFromObject;
    EXPECT_THROW(p.player->prepare({3, false, 0}), io::FileError);
    EXPECT_EQ(p.scene.instances[0]->worldFromObject, before);
    EXPECT_FALSE(p.goTo(0.5));
    EXPECT_TRUE(p.goTo(1, 1));  // and it goes on
}

TEST(GltfPlayer, UnusedAnimationsAreChecked) {
    GltfBuilder b = twoAnimations();
    b.json["animations"][1]["samplers"][0]["interpolation"] = "WAVY";
    EXPECT_EQ(load(b).instances.size(), 3u);  // nobody looks at it
    io::GltfOptions options;
    options.playable = true;
    EXPECT_EQ(errorOf(b, options), "animations[1].samplers[0]: unknown interpolation 'WAVY'");
}

TEST(GltfPlayer, FilesThatAreNotPlayableHaveNone) {
    Scene scene;
    EXPECT_EQ(io::loadGltf(written(richGltf(), "rich.gltf"), {}, scene), nullptr);
}

// The animated files beside the checkout; InterpolationTest has nine animations.
TEST(GltfPlayer, Assets) {
    const std::string assets = std::string(GP_SOURCE_DIR) + "/../shared/assets/";
    if (!std::filesystem::exists(assets)) GTEST_SKIP() << assets << " is missing";
    for (const char* file :
         {"Fox/Fox.gltf", "RiggedFigure/RiggedFigure.gltf", "SimpleSkin/SimpleSkin.gltf",
          "InterpolationTest/InterpolationTest.gltf", "SimpleMorph/SimpleMorph.gltf"}) {
        SCOPED_TRACE(file);
        Playing p(assets + file, io::allAnimations);
        for (const double time : {0.1, 0.75, 1.9}) {
            EXPECT_TRUE(p.goTo(time, io::allAnimations));
            expectSame(p.scene, freshAt(assets + file, time, io::allAnimations));
        }
        using Clock = std::chrono::steady_clock;
        const auto start = Clock::now();
        constexpr int moments = 200;
        for (int i = 0; i < moments; ++i) p.goTo(0.01 * i, io::allAnimations);
        const double ms =
            std::chrono::duration<double, std::milli>(Clock::now() - start).count() / moments;
        RecordProperty(std::string("milliseconds of ") + file, std::to_string(ms));
        std::printf("%s: %.3f ms a moment\n", file, ms);
    }
}

// A square whose two triangles mirror their textures, so that its tangents split vertices.
TEST(GltfPlayer, TrianglesKeepTheirVerticesUnderNormalMaps) {
    GltfBuilder b = richGltf();
    nlohmann::json& p = b.json["meshes"][0]["primitives"][0];
    p["attributes"]["TEXCOORD_0"] = b.vec2s({{0, 0}, {1, 0}, {1, 1}, {1, 0}});
    const size_t bend = b.vec3s({{0, 0, 0}, {3, 0, 2}, {0, -4, 0}, {0, 0, 5}});
    p["targets"] = {{{"POSITION", bend}}};
    const std::string path = written(b, "mirrored.gltf");
    Playing playing(path);
    const Mesh& mesh = *playing.scene.instances[0]->mesh;
    EXPECT_EQ(mesh.vertexCount(), 6u);
    const std::vector<glm::uvec3> triangles = mesh.triangles;
    std::vector<glm::vec2> uv;
    for (const ShadingVertex& v : mesh.vertices) uv.push_back(v.uv);
    for (const double time : {0.5, 1.0, 1.6}) {
        playing.goTo(time);
        EXPECT_EQ(mesh.triangles, triangles) << time;
        ASSERT_EQ(mesh.vertexCount(), uv.size()) << time;
        for (size_t v = 0; v < uv.size(); ++v) EXPECT_EQ(mesh.vertices[v].uv, uv[v]);
        for (const ShadingVertex& v : mesh.vertices) EXPECT_NE(v.tangentOct, 0u);
    }
}
