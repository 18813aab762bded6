// What strangers' files do wrong: each time one line that names the file and the thing, and the
// scene as it was (checked by errorOf).
#include "io/load_helpers.h"

using namespace gp;
using namespace gp::test;
using nlohmann::json;

namespace {

GltfBuilder good() {
    GltfBuilder b;
    json& p = b.addMesh(b.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    p["indices"] = b.shorts({0, 1, 2});
    return b;
}

// The good file with one value replaced.
std::string errorWith(const char* pointer, const json& value) {
    GltfBuilder b = good();
    b.json[json::json_pointer(pointer)] = value;
    return errorOf(b);
}

std::string uriError(const std::string& uri) {
    GltfBuilder b = good();
    b.json["buffers"] = {{{"byteLength", 4}, {"uri", uri}}};
    b.binary.clear();
    return errorOf(b);
}

void expectContains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << "\n  lacks  " << part;
}

}  // namespace

TEST(GltfErrors, TheGoodFileIsGood) { EXPECT_EQ(errorOf(good()), "no error"); }

TEST(GltfErrors, NotThere) {
    Scene scene;
    try {
        io::loadGltf(inTemp("nothing.gltf"), {}, scene);
        FAIL();
    } catch (const io::FileError& e) {
        EXPECT_EQ(e.kind, io::FileError::Kind::notFound);
        expectContains(e.what(), "nothing.gltf: no such file");
    }
}

TEST(GltfErrors, NotGltf) {
    EXPECT_EQ(errorOf(Bytes{}), "the file is empty");
    expectContains(errorOf(bytesOf("hello")), "the JSON is invalid or ends early at byte");
    expectContains(errorOf(bytesOf("[1, 2]")), "the JSON is not an object");
    expectContains(errorOf(bytesOf("{}")), "'asset' is missing");
    expectContains(errorOf(bytesOf(std::string(100000, '['))), "nested too deeply");
    std::string deep = R"({"asset":{"version":"2.0"},"extras":)";
    for (int i = 0; i < 5000; ++i) deep += R"({"a":)";
    expectContains(errorOf(bytesOf(deep)), "nested too deeply");
    expectContains(errorOf(bytesOf(R"({"asset":{"version":"1.0"}})")), "glTF version '1.0'");
    expectContains(errorOf(bytesOf(R"({"asset":{"version":"2.1","minVersion":"2.1"}})")), "'2.1'");
    expectContains(errorOf(bytesOf(R"({"asset":{"version":"2.0"},"nodes":{}})")),
                   "nodes: must be an array");
    expectContains(errorOf(bytesOf(R"({"asset":{"version":"2.0"},"scene":1e999})")), "number");
}

TEST(GltfErrors, Truncation) {
    const Bytes glb = good().glb(), text = good().gltf(), rich = richGltf().glb();
    for (const Bytes& file : {glb, text, rich})
        for (size_t n = 0; n < file.size(); n += 1 + file.size() / 300)
            EXPECT_NE(errorOf(Bytes(file.begin(), file.begin() + ptrdiff_t(n))), "no error") << n;
    expectContains(errorOf(Bytes(glb.begin(), glb.end() - 4)), "damaged GLB: truncated");
    Bytes lying = glb;
    lying[12] = std::byte(0xff);
    lying[15] = std::byte(0x7f);
    expectContains(errorOf(lying), "a chunk is longer than the file");
    Bytes version = glb;
    version[4] = std::byte(3);
    expectContains(errorOf(version), "GLB version 3");
}

TEST(GltfErrors, Extensions) {
    GltfBuilder b = good();
    b.json["extensionsUsed"] = {"EXT_shiny"};
    const Scene s = load(b);
    ASSERT_EQ(s.warnings.size(), 1u);
    expectContains(s.warnings[0], "uses the extension EXT_shiny, which is ignored");
    b.json["extensionsRequired"] = {"EXT_shiny"};
    expectContains(errorOf(b), "requires the extension EXT_shiny");
    b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    expectContains(errorOf(b), "KHR_draco_mesh_compression");
}

TEST(GltfErrors, UrisStayInTheFolder) {
    writeFile(inTemp("../gp-secret.bin"), bytesOf("secret"));
    for (const char* uri : {"../gp-secret.bin", "a/../../gp-secret.bin", "%2e%2e/gp-secret.bin",
                            "..%2Fgp-secret.bin", "./%2E./gp-secret.bin", ".."})
        expectContains(uriError(uri), "leaves the folder of this file");
    expectContains(uriError("/etc/passwd"), "leaves the folder");
    expectContains(uriError("%2Fetc/passwd"), "leaves the folder");
    for (const char* uri :
         {"http://example.com/x.bin", "HTTPS://x", "file:///etc/passwd", "C:/x.bin", "ftp:x"})
        expectContains(uriError(uri), "is not a file beside this one");
    expectContains(uriError("..\\x.bin"), "forbidden character");
    expectContains(uriError("..%5Cx.bin"), "forbidden character");
    expectContains(uriError("x.bin%00.png"), "forbidden character");
    expectContains(uriError(""), "an empty uri");
    expectContains(uriError("nothing-here.bin"), "no such file");
    expectContains(uriError("."), "not a regular file");
    expectContains(uriError("data:nothing"), "data uri without data");
    expectContains(uriError("data:;base64,A*A="), "damaged base64");
    std::filesystem::remove(inTemp("../gp-secret.bin"));
}

TEST(GltfErrors, BuffersAndViews) {
    expectContains(uriError("data:,abc"), "buffers[0]: claims 4 bytes, but there are only 3");
    expectContains(errorWith("/bufferViews/0/byteLength", 1000000), "lies outside of its buffer");
    expectContains(errorWith("/bufferViews/0/byteOffset", 18446744073709551615ull), "lies outside");
    expectContains(errorWith("/bufferViews/0/buffer", 9), "there is no buffers[9]");
    expectContains(errorWith("/bufferViews/0/buffer", -1), "must be a whole number");
    expectContains(errorWith("/bufferViews/0/byteStride", 2), "smaller than an element");
    expectContains(errorWith("/bufferViews/0/byteStride", 100000), "out of range");
}

TEST(GltfErrors, Accessors) {
    expectContains(errorWith("/accessors/0/count", 4),
                   "accessors[0]: reaches beyond its bufferView");
    expectContains(errorWith("/accessors/0/count", 4294967295u), "absurd");
    expectContains(errorWith("/accessors/0/count", 18446744073709551615ull), "absurd");
    expectContains(errorWith("/accessors/0/count", 357913942), "reaches beyond");  // * 12 overflows
    expectContains(errorWith("/accessors/0/count", 2.5), "must be a whole number");
    expectContains(errorWith("/accessors/0/count", "3"), "must be a whole number");
    expectContains(errorWith("/accessors/0/byteOffset", 18446744073709551615ull), "reaches beyond");
    expectContains(errorWith("/accessors/0/type", "VEC2"), "must be VEC3 here, but is 'VEC2'");
    expectContains(errorWith("/accessors/0/type", ""), "must be VEC3");
    expectContains(errorWith("/accessors/0/componentType", 5124), "unknown componentType 5124");
    expectContains(errorWith("/accessors/0/bufferView", 77), "there is no bufferViews[77]");
    expectContains(errorWith("/accessors/1/componentType", 5122), "indices must be unsigned");
    GltfBuilder b = good();
    b.json["accessors"][0].erase("bufferView");
    b.json["accessors"][0]["count"] = 4000000000u;
    expectContains(errorOf(b), "elements and no bufferView");
    const json sparse = {
        {"count", 1},
        {"indices", {{"bufferView", 1}, {"componentType", 5123}, {"byteOffset", 4}}},
        {"values", {{"bufferView", 0}}}};
    EXPECT_EQ(errorWith("/accessors/0/sparse", sparse), "no error");  // index 2 of three
    json beyond = sparse;
    beyond["indices"]["componentType"] = 5125;
    expectContains(errorWith("/accessors/0/sparse", beyond), "reaches beyond");
    beyond["indices"]["byteOffset"] = 0;
    expectContains(errorWith("/accessors/0/sparse", beyond), "element 65536 does not exist");
    beyond["count"] = 99;
    expectContains(errorWith("/accessors/0/sparse", beyond),
                   "replaces more elements than there are");
}

TEST(GltfErrors, Vertices) {
    GltfBuilder b;
    b.addMesh(b.vec3s({{0, 0, 0}, {1, NAN, 0}, {0, 1, 0}}));
    EXPECT_EQ(errorOf(b), "accessors[0]: POSITION 1 is not finite (NaN or infinity)");
    GltfBuilder infinite;
    infinite.addMesh(infinite.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, INFINITY}}));
    expectContains(errorOf(infinite), "POSITION 2 is not finite");
    GltfBuilder index = good();
    index.json["meshes"][0]["primitives"][0]["indices"] = index.shorts({0, 1, 3});
    EXPECT_EQ(errorOf(index),
              "meshes[0].primitives[0].indices: index 2 is 3, but there are 3 vertices");
    GltfBuilder count = good();
    count.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = count.vec3s({{0, 0, 1}});
    expectContains(errorOf(count), "attributes.NORMAL: has 1 values for 3 positions");
    expectContains(errorWith("/meshes/0/primitives/0/mode", 7), "unknown mode 7");
    expectContains(errorWith("/meshes/0/primitives/0/material", 0), "there is no materials[0]");
    expectContains(errorWith("/meshes/0/primitives/0/attributes/POSITION", 5), "no accessors[5]");
    expectContains(errorWith("/meshes/0/primitives", 3), "must be an array");
    // NaN in a normal is repaired, with a warning.
    GltfBuilder normal = good();
    normal.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        normal.vec3s({{0, 0, 1}, {0, NAN, 0}, {0, 0, 1}});
    expectContains(load(normal).warnings.at(0), "NORMAL: has values that are not finite");
}

TEST(GltfErrors, NodeGraph) {
    const auto nodes = [](const json& list) {
        GltfBuilder b = good();
        b.json["nodes"] = list;
        b.json["scenes"][0]["nodes"] = {0};
        return errorOf(b);
    };
    expectContains(nodes({{{"children", {0}}}}), "nodes[0]: is its own ancestor");
    expectContains(nodes({{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}}),
                   "nodes[1]: is its own ancestor");
    expectContains(nodes({{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}}),
                   "nodes[2]: is a child of both nodes[0] and nodes[1]");
    expectContains(nodes({{{"children", {1, 1}}}, {{"mesh", 0}}}),
                   "child of both nodes[0] and nodes[0]");
    expectContains(nodes({{{"children", {8}}}}), "nodes[0].children[0]: there is no nodes[8]");
    expectContains(nodes({{{"mesh", 4}}}), "nodes[0].mesh: there is no meshes[4]");
    expectContains(nodes({{{"scale", {1, 2}}}}), "nodes[0].scale: must have 3 numbers");
    expectContains(nodes({{{"scale", {1e300, 1, 1}}}}), "nodes[0].scale[0]: is too large");
    expectContains(nodes({{{"scale", {1e30, 1, 1}}, {"children", {1}}}, {{"scale", {1e30, 1, 1}}}}),
                   "nodes[1]: its transform is not finite");
    expectContains(nodes({{{"translation", "up"}}}), "must be an array");
    expectContains(nodes({{{"mesh", 0}, {"scale", {1e38, 1, 1}}, {"translation", {3e38, 0, 0}}}}),
                   "the scene is too large: it reaches beyond 1e18 m");
    expectContains(errorWith("/scenes/0/nodes", {0, 0}), "listed twice");
    expectContains(errorWith("/scene", 5), "there is no scenes[5]");
    io::GltfOptions options;
    options.scene = 3;
    expectContains(errorOf(good(), options), "there is no scene 3; the file has 1");
    options = {};
    options.animation = 0;
    expectContains(errorOf(good(), options), "there is no animation 0; the file has 0");
}

TEST(GltfErrors, AMillionLevelsAreNoProblem) {
    GltfBuilder b = good();
    constexpr int depth = 20000;
    for (int i = 1; i < depth; ++i) b.json["nodes"].push_back({{"children", {i - 1}}});
    b.json["scenes"][0]["nodes"] = {depth - 1};
    EXPECT_EQ(load(b).instances.size(), 1u);
}

TEST(GltfErrors, SkinsAndAnimations) {
    const GltfBuilder rich = richGltf();
    const auto with = [&](const char* pointer, const json& value) {
        GltfBuilder b = rich;
        b.json[json::json_pointer(pointer)] = value;
        return errorOf(b);
    };
    EXPECT_EQ(errorOf(rich), "no error");
    expectContains(with("/skins/0/joints", {1}), "follows joint 1, but the skin has 1");
    expectContains(with("/skins/0/joints", {1, 99}), "there is no nodes[99]");
    expectContains(with("/skins/0/joints", json::array()), "has no joints");
    expectContains(with("/skins/0/joints", {1, 2, 0}), "only 2 inverse bind matrices");
    expectContains(with("/nodes/0/skin", 4), "there is no skins[4]");
    expectContains(with("/animations/0/channels/0/sampler", 9), "there is no sampler 9");
    expectContains(with("/animations/0/samplers/0/interpolation", "SMOOTH"), "'SMOOTH'");
    const json output = rich.json["animations"][0]["samplers"][2]["output"];
    expectContains(with("/animations/0/samplers/0/output", output), "must be VEC4 here");
    expectContains(with("/animations/0/samplers/1/interpolation", "LINEAR"),
                   "output numbers where 9");
    expectContains(with("/animations/0/channels/0/target/node", 50), "there is no nodes[50]");
    GltfBuilder order = rich;
    order.json["animations"][0]["samplers"][0]["input"] = order.floats({0, 2, 1});
    expectContains(errorOf(order), "key times must not decrease");
}

TEST(GltfErrors, MaterialsImagesLightsCameras) {
    const GltfBuilder rich = richGltf();
    const auto with = [&](const char* pointer, const json& value) {
        GltfBuilder b = rich;
        b.json[json::json_pointer(pointer)] = value;
        return errorOf(b);
    };
    const char* base = "/materials/0/pbrMetallicRoughness/baseColorTexture/index";
    expectContains(with(base, 7), "there is no textures[7]");
    expectContains(with("/textures/0/source", 7), "there is no images[7]");
    expectContains(with("/textures/0/sampler", 7), "there is no samplers[7]");
    expectContains(with("/samplers/0/wrapS", 1), "unknown wrapS");
    expectContains(with("/samplers/0/minFilter", 1), "unknown filter");
    expectContains(with("/materials/0/alphaMode", "FOG"), "unknown alphaMode 'FOG'");
    expectContains(with("/materials/0/pbrMetallicRoughness", 1), "must be an object");
    expectContains(with("/images/0/uri", "../x.png"),
                   "images[0].uri: '../x.png' leaves the folder");
    expectContains(with("/images/0/uri", "data:,hello"),
                   "images[0]: not an image that can be read");
    std::string cut = rich.json["images"][0]["uri"];
    cut.resize(cut.size() - 40);
    expectContains(with("/images/0/uri", cut), "images[0]: damaged PNG");
    io::GltfOptions small;
    small.maxImagePixels = 10;
    expectContains(errorOf(rich, small), "the limit is 10 pixels");
    expectContains(with("/cameras/0/perspective/yfov", 4), "yfov must be between 0 and pi");
    expectContains(with("/cameras/0/type", "fish"), "unknown type of camera 'fish'");
    const char* light = "/extensions/KHR_lights_punctual/lights/0";
    expectContains(with(light, {{"type", "area"}}), "unknown type of light 'area'");
    expectContains(with(light, {{"type", "spot"}, {"spot", {{"innerConeAngle", 1}}}}),
                   "cone angles");
    expectContains(with("/nodes/1/extensions/KHR_lights_punctual/light", 3), "there is no light 3");
}

// A few bytes that many things refer to must not become gigabytes.
TEST(GltfErrors, MemoryIsBounded) {
    GltfBuilder b;
    const size_t zeros = b.vec3s({{0, 0, 0}});
    b.json["accessors"][zeros].erase("bufferView");
    b.json["accessors"][zeros]["count"] = 3000000;
    b.addMesh(zeros);
    json primitive = b.json["meshes"][0]["primitives"][0];
    for (int i = 0; i < 40; ++i) b.json["meshes"][0]["primitives"].push_back(primitive);
    expectContains(errorOf(b), "the file asks for more than 256 MiB of memory");
}
