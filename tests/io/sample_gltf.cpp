#include <fstream>

#include "io/sample_files.h"

namespace gp::test {

using nlohmann::json;

Bytes bytesOf(std::string_view text) {
    const std::byte* first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

std::string base64(const Bytes& bytes) {
    constexpr const char* digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        unsigned v = 0;
        for (size_t k = 0; k < 3; ++k)
            v = v << 8 | (i + k < bytes.size() ? unsigned(bytes[i + k]) : 0u);
        for (unsigned k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : digits[v >> (18 - 6 * k) & 63];
    }
    return out;
}

void writeFile(const std::string& path, const Bytes& bytes) {
    std::ofstream f(path, std::ios::binary | std::ios::trunc);
    f.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

Bytes readWholeFile(const std::string& path) {
    std::ifstream f(path, std::ios::binary);
    return bytesOf(std::string(std::istreambuf_iterator<char>(f), {}));
}

size_t GltfBuilder::view(const Bytes& data) {
    while (binary.size() % 4) binary.push_back(std::byte(0));
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", data.size()}});
    binary.insert(binary.end(), data.begin(), data.end());
    return json["bufferViews"].size() - 1;
}

size_t GltfBuilder::accessor(const void* data, size_t bytes, size_t count, unsigned componentType,
                             const char* type, bool normalized) {
    const std::byte* first = static_cast<const std::byte*>(data);
    const size_t v = view(Bytes(first, first + bytes));
    json["accessors"].push_back({{"bufferView", v},
                                 {"componentType", componentType},
                                 {"count", count},
                                 {"type", type},
                                 {"normalized", normalized}});
    return json["accessors"].size() - 1;
}

size_t GltfBuilder::floats(const std::vector<float>& v) {
    return accessor(v.data(), v.size() * 4, v.size(), 5126, "SCALAR");
}
size_t GltfBuilder::vec2s(const std::vector<glm::vec2>& v) {
    return accessor(v.data(), v.size() * 8, v.size(), 5126, "VEC2");
}
size_t GltfBuilder::vec3s(const std::vector<glm::vec3>& v) {
    return accessor(v.data(), v.size() * 12, v.size(), 5126, "VEC3");
}
size_t GltfBuilder::vec4s(const std::vector<glm::vec4>& v) {
    return accessor(v.data(), v.size() * 16, v.size(), 5126, "VEC4");
}
size_t GltfBuilder::mat4s(const std::vector<glm::mat4>& v) {
    return accessor(v.data(), v.size() * 64, v.size(), 5126, "MAT4");
}
size_t GltfBuilder::shorts(const std::vector<uint16_t>& v) {
    return accessor(v.data(), v.size() * 2, v.size(), 5123, "SCALAR");
}

json& GltfBuilder::addMesh(size_t positions) {
    nlohmann::json mesh;
    mesh["primitives"] = nlohmann::json::array({{{"attributes", {{"POSITION", positions}}}}});
    json["meshes"].push_back(mesh);
    json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    return json["meshes"].back()["primitives"][0];
}

std::string GltfBuilder::text() const {
    nlohmann::json whole = json;
    if (!binary.empty())
        whole["buffers"] = {{{"byteLength", binary.size()},
                             {"uri", "data:application/octet-stream;base64," + base64(binary)}}};
    return whole.dump();
}

Bytes GltfBuilder::glb() const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", binary.size()}}};
    std::string text = whole.dump();
    while (text.size() % 4) text += ' ';
    Bytes bin = binary;
    while (bin.size() % 4) bin.push_back(std::byte(0));
    std::string out;
    const auto word = [&](size_t v) {
        for (int i = 0; i < 4; ++i) out += char(v >> (8 * i) & 0xff);
    };
    word(0x46546c67), word(2), word(12 + 8 + text.size() + 8 + bin.size());
    word(text.size()), word(0x4e4f534a);
    out += text;
    word(bin.size()), word(0x004e4942);
    Bytes all = bytesOf(out);
    all.insert(all.end(), bin.begin(), bin.end());
    return all;
}

namespace {

void addSkinAndMorph(GltfBuilder& b, json& primitive) {
    const std::vector<uint8_t> joints = {0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0};
    primitive["attributes"]["JOINTS_0"] = b.accessor(joints.data(), 16, 4, 5121, "VEC4");
    primitive["attributes"]["WEIGHTS_0"] = b.vec4s(
        {{1, 0, 0, 0}, {0.5f, 0.5f, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}});
    const size_t deltas = b.vec3s({{0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}});
    primitive["targets"] = json::array({{{"POSITION", deltas}}});
    b.json["meshes"][0]["weights"] = {0.25};
    b.json["nodes"].push_back({{"name", "joint0"}, {"children", {2}}, {"translation", {0, 1, 0}}});
    b.json["nodes"].push_back({{"name", "joint1"}, {"rotation", {0, 0, 0, 1}}});
    b.json["nodes"][0]["skin"] = 0;
    b.json["scenes"][0]["nodes"].push_back(1);
    const size_t matrices = b.mat4s({glm::mat4(1), glm::mat4(1)});
    b.json["skins"] = json::array({{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}});
}

void addAnimation(GltfBuilder& b) {
    const size_t times = b.floats({0, 1, 2});
    const size_t turns = b.vec4s({{0, 0, 0, 1}, {0, 0, 0.7071068f, 0.7071068f}, {0, 0, 1, 0}});
    const size_t cubic = b.vec3s(std::vector<glm::vec3>(9, glm::vec3(1)));
    const size_t weights = b.floats({0, 1, 0});
    const auto sampler = [&](size_t output, const char* kind) {
        return json{{"input", times}, {"output", output}, {"interpolation", kind}};
    };
    const auto channel = [](int s, int node, const char* path) {
        return json{{"sampler", s}, {"target", {{"node", node}, {"path", path}}}};
    };
    json a;
    a["name"] = "wave";
    a["samplers"] = {sampler(turns, "LINEAR"), sampler(cubic, "CUBICSPLINE"),
                     sampler(weights, "STEP")};
    a["channels"] = {channel(0, 1, "rotation"), channel(1, 2, "translation"),
                     channel(2, 0, "weights")};
    b.json["animations"] = json::array({a});
}

void addMaterial(GltfBuilder& b) {
    b.json["images"] = {
        {{"uri", "data:image/png;base64," + base64(samplePng(PngKind::rgba))}},
        {{"bufferView", b.view(sampleJpeg(JpegKind::rgb))}, {"mimeType", "image/jpeg"}}};
    b.json["samplers"] = json::array({{{"wrapS", 33071}, {"magFilter", 9728}}});
    b.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}};
    const json moved = {
        {"index", 1},
        {"extensions",
         {{"KHR_texture_transform",
           {{"offset", {0.5, 0}}, {"rotation", 0.1}, {"scale", {2, 3}}, {"texCoord", 0}}}}}};
    json m;
    m["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}}, {"roughnessFactor", 0.4}};
    m["normalTexture"] = moved;
    m["alphaMode"] = "MASK";
    m["extensions"] = {{"KHR_materials_clearcoat", {{"clearcoatFactor", 0.5}}},
                       {"KHR_materials_sheen", {{"sheenColorFactor", {1, 0, 0}}}},
                       {"KHR_materials_transmission", {{"transmissionFactor", 0.5}}},
                       {"KHR_materials_volume", {{"thicknessFactor", 1}}},
                       {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.3}}}};
    b.json["materials"] = json::array({m});
}

}  // namespace

GltfBuilder richGltf() {
    GltfBuilder b;
    json& primitive = b.addMesh(b.vec3s({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    primitive["indices"] = b.shorts({0, 1, 2, 0, 2, 3});
    primitive["material"] = 0;
    primitive["attributes"]["NORMAL"] = b.vec3s(std::vector<glm::vec3>(4, {0, 0, 1}));
    primitive["attributes"]["TEXCOORD_0"] = b.vec2s({{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    const std::vector<uint8_t> red = {255, 0, 0, 255, 255, 0, 0, 255,
                                      255, 0, 0, 255, 255, 0, 0, 255};
    primitive["attributes"]["COLOR_0"] = b.accessor(red.data(), 16, 4, 5121, "VEC4", true);
    addSkinAndMorph(b, primitive);
    addAnimation(b);
    addMaterial(b);
    b.json["cameras"] = json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}}}}});
    b.json["nodes"][2]["camera"] = 0;
    b.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    b.json["extensions"]["KHR_lights_punctual"]["lights"] =
        json::array({{{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}}}}});
    const size_t places = b.vec3s({{0, 0, 0}, {5, 0, 0}});
    b.json["nodes"].push_back(
        {{"mesh", 0},
         {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 9, 1}},
         {"extensions",
          {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}});
    b.json["scenes"][0]["nodes"].push_back(3);
    return b;
}

}  // namespace gp::test
