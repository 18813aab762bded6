// Accessors, primitives and nodes of glTF files.
#include <set>

#include "io/load_helpers.h"

using namespace gp;
using namespace gp::test;

namespace {

const std::vector<glm::vec3> corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

GltfBuilder oneTriangle() {
    GltfBuilder b;
    b.addMesh(b.vec3s(corner));
    return b;
}

// COLOR_0 shows what became of four numbers.
glm::ivec4 colorOf(const void* data, size_t bytes, unsigned type, bool normalized) {
    GltfBuilder b;
    nlohmann::json& p = b.addMesh(b.vec3s(corner));
    std::vector<std::byte> three;
    const std::byte* first = static_cast<const std::byte*>(data);
    for (int i = 0; i < 3; ++i) three.insert(three.end(), first, first + bytes);
    p["attributes"]["COLOR_0"] =
        b.accessor(three.data(), three.size(), 3, type, "VEC4", normalized);
    return load(b).instances[0]->mesh->colors[1];
}

}  // namespace

TEST(GltfAccessor, ComponentTypesAndNormalisation) {
    const uint8_t u8[4] = {0, 51, 102, 255};
    const uint16_t u16[4] = {0, 13107, 26214, 65535};
    const int8_t s8[4] = {-127, -128, 127, 0};
    const int16_t s16[4] = {-32767, 32767, -32768, 0};
    const float f32[4] = {0, 0.2f, 0.4f, 1};
    EXPECT_EQ(colorOf(u8, 4, 5121, true), glm::ivec4(0, 51, 102, 255));
    EXPECT_EQ(colorOf(u8, 4, 5121, false), glm::ivec4(0, 51, 102, 255));  // colours are fractions
    EXPECT_EQ(colorOf(u16, 8, 5123, true), glm::ivec4(0, 51, 102, 255));
    EXPECT_EQ(colorOf(s8, 4, 5120, true), glm::ivec4(0, 0, 255, 0));
    EXPECT_EQ(colorOf(s16, 8, 5122, true), glm::ivec4(0, 255, 0, 0));
    EXPECT_EQ(colorOf(f32, 16, 5126, false), glm::ivec4(0, 51, 102, 255));
}

TEST(GltfAccessor, QuantizedPositions) {
    GltfBuilder b;
    const std::vector<int16_t> raw = {-100, 0, 7, 300, 0, 7, -100, 5, 7};
    const std::vector<int8_t> unit = {-127, 0, 127, 127, 0, 0, 0, 127, 0};
    b.addMesh(b.accessor(raw.data(), 18, 3, 5122, "VEC3"));
    b.addMesh(b.accessor(unit.data(), 9, 3, 5120, "VEC3", true));
    b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const Scene s = load(b);
    EXPECT_EQ(s.instances[0]->mesh->positions[1], glm::vec3(300, 0, 7));
    EXPECT_EQ(s.instances[1]->mesh->positions[0], glm::vec3(-1, 0, 1));
    EXPECT_TRUE(s.warnings.empty());
}

TEST(GltfAccessor, StridesAndOffsets) {
    GltfBuilder b;
    // Position and something else, interleaved; the first element is skipped by an offset.
    std::vector<float> raw;
    for (int i = 0; i < 4; ++i) raw.insert(raw.end(), {float(i), float(i * i), 2, 99});
    const size_t a = b.accessor(raw.data(), raw.size() * 4, 3, 5126, "VEC3");
    b.json["bufferViews"][0]["byteStride"] = 16;
    b.json["accessors"][a]["byteOffset"] = 16;
    b.addMesh(a);
    const Scene s = load(b);
    EXPECT_EQ(s.instances[0]->mesh->positions[0], glm::vec3(1, 1, 2));
    EXPECT_EQ(s.instances[0]->mesh->positions[2], glm::vec3(3, 9, 2));
}

// glTF 2.0 asks for one element at least; exporters write none for parts that they left out.
TEST(GltfAccessor, NoElementsAreNoTriangles) {
    GltfBuilder b;
    b.addMesh(b.vec3s(corner));
    const size_t none = b.vec3s(corner);
    b.json["accessors"][none]["count"] = 0;
    b.addMesh(none);
    GltfBuilder indices = b;
    EXPECT_EQ(load(b).instances.size(), 1u);
    const size_t noIndex = indices.shorts({0, 1, 2});
    indices.json["accessors"][noIndex]["count"] = 0;
    indices.addMesh(indices.vec3s(corner))["indices"] = noIndex;
    EXPECT_EQ(load(indices).instances.size(), 1u);
}

TEST(GltfAccessor, SparseWithAndWithoutBase) {
    for (const bool base : {true, false}) {
        GltfBuilder b;
        const size_t a = b.vec3s(corner);
        const size_t values = b.vec3s({{5, 6, 7}}), where = b.shorts({2});
        if (!base) b.json["accessors"][a].erase("bufferView");
        b.json["accessors"][a]["sparse"] = {
            {"count", 1},
            {"indices", {{"bufferView", where}, {"componentType", 5123}}},
            {"values", {{"bufferView", values}}}};
        b.addMesh(a);
        const Scene s = load(b);
        EXPECT_EQ(s.instances[0]->mesh->positions[1], base ? glm::vec3(1, 0, 0) : glm::vec3(0));
        EXPECT_EQ(s.instances[0]->mesh->positions[2], glm::vec3(5, 6, 7));
    }
}

TEST(GltfPrimitive, IndexTypesAndModes) {
    const std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
    const auto trianglesOf = [&](int mode, unsigned type) {
        GltfBuilder b;
        nlohmann::json& primitive = b.addMesh(b.vec3s(p));
        const std::vector<uint8_t> u8 = {0, 1, 2, 3, 4};
        const std::vector<uint32_t> u32 = {0, 1, 2, 3, 4};
        primitive["indices"] = type == 5121   ? b.accessor(u8.data(), 5, 5, type, "SCALAR")
                               : type == 5125 ? b.accessor(u32.data(), 20, 5, type, "SCALAR")
                                              : b.shorts({0, 1, 2, 3, 4});
        primitive["mode"] = mode;
        return load(b).instances.at(0)->mesh;
    };
    // Each strip triangle keeps its side: all face +Z here.
    for (const unsigned type : {5121u, 5123u, 5125u}) {
        const auto strip = trianglesOf(5, type);
        ASSERT_EQ(strip->triangles.size(), 3u);
        for (const glm::uvec3 t : strip->triangles)
            EXPECT_GT(glm::cross(strip->positions[t.y] - strip->positions[t.x],
                                 strip->positions[t.z] - strip->positions[t.x]).z, 0);
    }
    const auto fan = trianglesOf(6, 5123);
    ASSERT_EQ(fan->triangles.size(), 3u);
    for (const glm::uvec3 t : fan->triangles) EXPECT_EQ(fan->positions[t.z], p[0]);
    EXPECT_EQ(trianglesOf(4, 5123)->triangles.size(), 1u);  // two vertices too many
}

TEST(GltfPrimitive, PointsAndLinesWarn) {
    for (int mode = 0; mode < 4; ++mode) {
        GltfBuilder b = oneTriangle();
        b.json["meshes"][0]["primitives"][0]["mode"] = mode;
        const Scene s = load(b);
        EXPECT_TRUE(s.instances.empty());
        ASSERT_EQ(s.warnings.size(), 1u);
        EXPECT_NE(s.warnings[0].find("points and lines are not drawn"), std::string::npos);
    }
}

TEST(GltfPrimitive, UnusedVerticesAreDropped) {
    GltfBuilder b;
    std::vector<glm::vec3> many(1000, glm::vec3(7));
    many[500] = {1, 0, 0};
    many[999] = {0, 1, 0};
    nlohmann::json& p = b.addMesh(b.vec3s(many));
    p["indices"] = b.shorts({0, 500, 999});
    p["attributes"]["NORMAL"] = b.vec3s(std::vector<glm::vec3>(1000, {0, 0, 1}));
    const auto mesh = load(b).instances[0]->mesh;
    EXPECT_EQ(mesh->vertexCount(), 3u);
    EXPECT_EQ(mesh->positions[mesh->triangles[0].z], glm::vec3(0, 1, 0));
}

TEST(GltfNodes, TransformsCombine) {
    GltfBuilder b = oneTriangle();
    b.json["nodes"][0]["scale"] = {2, 3, 4};
    b.json["nodes"][0]["rotation"] = {0, 0, 0.70710678, 0.70710678};  // 90 degrees about Z
    b.json["nodes"][0]["translation"] = {10, 0, 0};
    b.json["nodes"].push_back(
        {{"children", {0}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 5, 6, 1}}});
    b.json["scenes"][0]["nodes"] = {1};
    const Scene s = load(b);
    // (1,0,0) * 2 turned to +Y, moved by (10,0,0), then by the mirroring parent.
    expectNear(worldVertex(*s.instances[0], 1), {10, 7, 6});
    expectNear(worldVertex(*s.instances[0], 2), {7, 5, 6});
    EXPECT_LT(glm::determinant(glm::mat3(s.instances[0]->worldFromObject)), 0);
}

TEST(GltfNodes, ScenesAreChosen) {
    GltfBuilder b = oneTriangle();
    b.json["nodes"].push_back({{"mesh", 0}, {"name", "other"}});
    b.json["scenes"].push_back({{"nodes", {1, 0}}});
    EXPECT_EQ(load(b).instances.size(), 1u);
    io::GltfOptions options;
    options.scene = 1;
    const Scene second = load(b, options);
    ASSERT_EQ(second.instances.size(), 2u);
    EXPECT_EQ(second.instances[0]->name, "other");
    b.json["scene"] = 1;
    EXPECT_EQ(load(b).instances.size(), 2u);
    b.json.erase("scene");
    b.json.erase("scenes");
    EXPECT_EQ(load(b).instances.size(), 2u);  // no scenes: all roots
}

TEST(GltfNodes, MeshesAreSharedAndIdsAreStable) {
    GltfBuilder b = oneTriangle();
    b.json["nodes"].push_back({{"mesh", 0}});
    b.json["scenes"][0]["nodes"].push_back(1);
    const Scene s = load(b), again = load(b);
    ASSERT_EQ(s.instances.size(), 2u);
    EXPECT_EQ(s.instances[0]->mesh, s.instances[1]->mesh);
    EXPECT_NE(s.instances[0]->id, s.instances[1]->id);
    EXPECT_EQ(s.instances[1]->id, again.instances[1]->id);
    EXPECT_EQ(s.instances[1]->mesh->id, again.instances[1]->mesh->id);
    // A second copy in the same scene is told apart.
    Scene twice = load(b);
    io::loadGltf(inTemp("test.gltf"), {}, twice);
    std::set<uint64_t> ids;
    for (const auto& i : twice.instances) ids.insert(i->id);
    EXPECT_EQ(ids.size(), 4u);
    EXPECT_EQ(twice.sources.size(), 2u);
}

TEST(GltfNodes, GpuInstancing) {
    GltfBuilder b = oneTriangle();
    const size_t t = b.vec3s({{0, 0, 0}, {5, 0, 0}});
    const std::vector<int16_t> turns = {0, 0, 0, 32767, 0, 0, 23170, 23170};
    const size_t r = b.accessor(turns.data(), 16, 2, 5122, "VEC4", true);
    const size_t scale = b.vec3s({{1, 1, 1}, {2, 2, 2}});
    b.json["nodes"][0]["translation"] = {0, 0, 3};
    b.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", t}, {"ROTATION", r}, {"SCALE", scale}};
    const Scene s = load(b);
    ASSERT_EQ(s.instances.size(), 2u);
    EXPECT_EQ(s.instances[0]->mesh, s.instances[1]->mesh);
    expectNear(worldVertex(*s.instances[0], 1), {1, 0, 3});
    expectNear(worldVertex(*s.instances[1], 1), {5, 2, 3}, 1e-3f);
    EXPECT_NE(s.instances[0]->id, s.instances[1]->id);
}

TEST(GltfContainer, GlbDataUriAndExternalAreTheSame) {
    const GltfBuilder b = oneTriangle();
    const Scene inside = load(b), binary = load(b.glb());
    GltfBuilder external = b;
    std::filesystem::create_directories(inTemp("sub folder"));
    writeFile(inTemp("sub folder/data.bin"), b.binary);
    external.binary.clear();
    external.json["buffers"] = {
        {{"byteLength", 36}, {"uri", "sub%20folder/../sub%20folder/data.bin"}}};
    const Scene outside = load(external);
    for (const Scene* s : {&binary, &outside})
        EXPECT_EQ(s->instances[0]->mesh->positions, inside.instances[0]->mesh->positions);
}
