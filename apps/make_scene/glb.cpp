#include "glb.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace gp::make_scene {
namespace {

using nlohmann::json;

// Values of the glTF 2.0 specification, section 3.6 and 3.8.
constexpr int componentFloat = 5126, componentUint16 = 5123, componentUint32 = 5125;
constexpr int targetVertices = 34962, targetIndices = 34963;
constexpr int filterLinear = 9729, filterTrilinear = 9987, wrapRepeat = 10497, wrapClamp = 33071;

int lastIndex(const json& list) { return static_cast<int>(list.size()) - 1; }

void appendUint32(std::vector<std::uint8_t>& bytes, std::uint32_t value)
{
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

}  // namespace

GlbBuilder::GlbBuilder(const std::string& sceneName)
{
    m_gltf["asset"] = {{"version", "2.0"}, {"generator", "glitterpath make-scene"}};
    m_gltf["scene"] = 0;
    m_gltf["scenes"] = json::array({{{"name", sceneName}, {"nodes", json::array()}}});
}

void GlbBuilder::use(const char* extension, bool required)
{
    m_used.insert(extension);
    if (required)
        m_required.insert(extension);
}

int GlbBuilder::addView(const void* data, std::size_t bytes, int target)
{
    m_binary.resize((m_binary.size() + 3) / 4 * 4);  // every accessor type starts on 4 bytes
    json view = {{"buffer", 0}, {"byteOffset", m_binary.size()}, {"byteLength", bytes}};
    if (target != 0)
        view["target"] = target;
    const auto* begin = static_cast<const std::uint8_t*>(data);
    m_binary.insert(m_binary.end(), begin, begin + bytes);
    m_gltf["bufferViews"].push_back(view);
    return lastIndex(m_gltf["bufferViews"]);
}

int GlbBuilder::addVectors(const float* data, std::size_t count, int components, bool vertices)
{
    const auto width = static_cast<std::size_t>(components);
    json accessor = {{"bufferView", addView(data, count * width * sizeof(float),
                                            vertices ? targetVertices : 0)},
                     {"componentType", componentFloat},
                     {"count", count},
                     {"type", "VEC" + std::to_string(components)}};
    std::vector<float> low(data, data + width), high = low;
    for (std::size_t i = 0; i < count * width; ++i) {
        low[i % width] = std::min(low[i % width], data[i]);
        high[i % width] = std::max(high[i % width], data[i]);
    }
    accessor["min"] = low;
    accessor["max"] = high;
    m_gltf["accessors"].push_back(accessor);
    return lastIndex(m_gltf["accessors"]);
}

int GlbBuilder::addTexture(const std::string& name, const Image& image, bool repeat)
{
    const int wrap = repeat ? wrapRepeat : wrapClamp;
    const json sampler = {{"magFilter", filterLinear}, {"minFilter", filterTrilinear},
                          {"wrapS", wrap}, {"wrapT", wrap}};
    json& samplers = m_gltf["samplers"];
    int samplerIndex = 0;
    while (samplerIndex <= lastIndex(samplers) &&
           samplers[static_cast<std::size_t>(samplerIndex)] != sampler)
        ++samplerIndex;
    if (samplerIndex > lastIndex(samplers))
        samplers.push_back(sampler);
    const std::vector<std::uint8_t> png = encodePng(image);
    m_gltf["images"].push_back({{"name", name},
                                {"mimeType", "image/png"},
                                {"bufferView", addView(png.data(), png.size(), 0)}});
    m_gltf["textures"].push_back(
        {{"name", name}, {"source", lastIndex(m_gltf["images"])}, {"sampler", samplerIndex}});
    return lastIndex(m_gltf["textures"]);
}

void GlbBuilder::setMaps(Material& material, const MaterialImages& maps)
{
    material.colorTexture = addTexture(material.name + " colour", maps.color);
    material.normalTexture = addTexture(material.name + " normal", maps.normal);
    material.metallicRoughnessTexture =
        addTexture(material.name + " metallic-roughness", maps.metallicRoughness);
    material.metallic = 1.0f;  // factors of the texture's values from here on
    material.roughness = 1.0f;
}

int GlbBuilder::addMesh(const std::string& name, const Mesh& mesh, int material)
{
    static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::vec2) == 8);
    const std::size_t count = mesh.positions.size();
    json attributes = {{"POSITION", addVectors(&mesh.positions[0].x, count, 3, true)},
                       {"NORMAL", addVectors(&mesh.normals[0].x, count, 3, true)},
                       {"TEXCOORD_0", addVectors(&mesh.uvs[0].x, count, 2, true)}};
    if (!mesh.tangents.empty())
        attributes["TANGENT"] = addVectors(&mesh.tangents[0].x, count, 4, true);
    const bool narrow = count < 65536;
    int view = 0;
    if (narrow) {
        const std::vector<std::uint16_t> shorts(mesh.indices.begin(), mesh.indices.end());
        view = addView(shorts.data(), shorts.size() * sizeof(std::uint16_t), targetIndices);
    } else {
        view = addView(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t),
                       targetIndices);
    }
    m_gltf["accessors"].push_back({{"bufferView", view},
                                   {"componentType", narrow ? componentUint16 : componentUint32},
                                   {"count", mesh.indices.size()},
                                   {"type", "SCALAR"}});
    const json primitive = {{"attributes", attributes},
                            {"indices", lastIndex(m_gltf["accessors"])},
                            {"material", material}};
    m_gltf["meshes"].push_back({{"name", name}, {"primitives", json::array({primitive})}});
    return lastIndex(m_gltf["meshes"]);
}

int GlbBuilder::addMeshLike(const std::string& name, int mesh, int material)
{
    json copy = m_gltf["meshes"][static_cast<std::size_t>(mesh)];
    copy["name"] = name;
    copy["primitives"][0]["material"] = material;
    m_gltf["meshes"].push_back(copy);
    return lastIndex(m_gltf["meshes"]);
}

int GlbBuilder::addRootNode(json node)
{
    m_gltf["nodes"].push_back(std::move(node));
    const int index = lastIndex(m_gltf["nodes"]);
    m_gltf["scenes"][0]["nodes"].push_back(index);
    return index;
}

int GlbBuilder::addNode(const std::string& name, int mesh, const glm::mat4& worldFromObject)
{
    json node = {{"name", name}, {"mesh", mesh}};
    if (worldFromObject != glm::mat4(1.0f)) {
        json matrix = json::array();
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                matrix.push_back(worldFromObject[column][row]);
        node["matrix"] = matrix;
    }
    return addRootNode(node);
}

int GlbBuilder::addInstances(const std::string& name, int mesh, const Instances& instances)
{
    use("EXT_mesh_gpu_instancing", true);
    const std::size_t count = instances.translations.size();
    const json attributes = {
        {"TRANSLATION", addVectors(&instances.translations[0].x, count, 3, false)},
        {"ROTATION", addVectors(&instances.rotations[0].x, count, 4, false)},
        {"SCALE", addVectors(&instances.scales[0].x, count, 3, false)}};
    return addRootNode(
        {{"name", name},
         {"mesh", mesh},
         {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
}

void GlbBuilder::add(const std::string& name, const Mesh& mesh, int material)
{
    addNode(name, addMesh(name, mesh, material));
}

void GlbBuilder::addCamera(const Camera& camera)
{
    const glm::vec3 z = glm::normalize(camera.position - camera.target);  // looks along -Z
    const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), z));
    const glm::vec3 y = glm::cross(z, x);
    m_gltf["cameras"].push_back(
        {{"name", camera.name},
         {"type", "perspective"},
         {"perspective", {{"yfov", glm::radians(camera.verticalFovDegrees)},
                          {"aspectRatio", camera.aspect},
                          {"znear", 0.01}}}});
    const glm::vec3 p = camera.position;
    addRootNode({{"name", camera.name},
                 {"camera", lastIndex(m_gltf["cameras"])},
                 {"matrix", {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0,
                             p.x, p.y, p.z, 1}}});
}

void GlbBuilder::addPointLight(const std::string& name, glm::vec3 position, glm::vec3 color,
                               float wattsPerSteradian)
{
    constexpr float lumenPerWatt = 683.0f;  // glTF counts in candela
    use("KHR_lights_punctual");
    json& lights = m_gltf["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"name", name},
                      {"type", "point"},
                      {"color", {color.x, color.y, color.z}},
                      {"intensity", wattsPerSteradian * lumenPerWatt}});
    addRootNode({{"name", name},
                 {"translation", {position.x, position.y, position.z}},
                 {"extensions", {{"KHR_lights_punctual", {{"light", lastIndex(lights)}}}}}});
}

void GlbBuilder::write(const std::string& path)
{
    m_binary.resize((m_binary.size() + 3) / 4 * 4);
    m_gltf["buffers"] = json::array({{{"byteLength", m_binary.size()}}});
    if (!m_used.empty())
        m_gltf["extensionsUsed"] = m_used;
    if (!m_required.empty())
        m_gltf["extensionsRequired"] = m_required;
    std::string text = m_gltf.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');

    // glTF 2.0 specification, section 4.4: header, JSON chunk, BIN chunk
    const std::size_t total = 12 + 8 + text.size() + 8 + m_binary.size();
    if (total > 0xffffffffu)
        throw std::runtime_error(path + ": the scene is larger than a GLB file can be (4 GiB)");
    std::vector<std::uint8_t> head, middle;
    for (const std::uint32_t word : {0x46546c67u, 2u, static_cast<std::uint32_t>(total),
                                     static_cast<std::uint32_t>(text.size()), 0x4e4f534au})
        appendUint32(head, word);
    for (const std::uint32_t word : {static_cast<std::uint32_t>(m_binary.size()), 0x004e4942u})
        appendUint32(middle, word);

    const std::string temporary = path + ".part";
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    const auto put = [&file](const auto& bytes) {
        file.write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()));
    };
    put(head);
    put(text);
    put(middle);
    put(m_binary);
    file.close();
    std::error_code error;
    if (file)
        std::filesystem::rename(temporary, path, error);
    if (!file || error) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw std::runtime_error(path + ": cannot write the file");
    }
}

}  // namespace gp::make_scene
