#include "glb_reader.h"

#include "make_scene/make_scene.h"

#define TINYGLTF_IMPLEMENTATION
#define STB_IMAGE_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE_WRITE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace gp::make_scene::testing {
namespace {

const unsigned char* data(const tinygltf::Model& model, const tinygltf::Accessor& accessor)
{
    const tinygltf::BufferView& view =
        model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    EXPECT_LE(view.byteOffset + view.byteLength, model.buffers[0].data.size());
    EXPECT_EQ(view.byteOffset % 4, 0u);
    return model.buffers[0].data.data() + view.byteOffset + accessor.byteOffset;
}

template <typename Vector>
std::vector<Vector> vectors(const tinygltf::Model& model, int index)
{
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    EXPECT_EQ(accessor.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT);
    std::vector<Vector> result(accessor.count);
    std::memcpy(result.data(), data(model, accessor), accessor.count * sizeof(Vector));
    return result;
}

std::vector<std::uint32_t> indices(const tinygltf::Model& model, int index)
{
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const unsigned char* bytes = data(model, accessor);
    std::vector<std::uint32_t> result(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
            std::uint16_t value = 0;
            std::memcpy(&value, bytes + 2 * i, 2);
            result[i] = value;
        } else {
            std::memcpy(&result[i], bytes + 4 * i, 4);
        }
    }
    return result;
}

glm::vec3 toVec3(const std::vector<double>& v)
{
    return v.size() == 3 ? glm::vec3(v[0], v[1], v[2]) : glm::vec3(std::nanf(""));
}

ReadMesh readMesh(const tinygltf::Model& model, const tinygltf::Mesh& source)
{
    const tinygltf::Primitive& primitive = source.primitives.at(0);
    const tinygltf::Accessor& position =
        model.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))];
    ReadMesh mesh;
    mesh.name = source.name;
    mesh.positions = vectors<glm::vec3>(model, primitive.attributes.at("POSITION"));
    mesh.normals = vectors<glm::vec3>(model, primitive.attributes.at("NORMAL"));
    mesh.uvs = vectors<glm::vec2>(model, primitive.attributes.at("TEXCOORD_0"));
    mesh.indices = indices(model, primitive.indices);
    mesh.low = toVec3(position.minValues);
    mesh.high = toVec3(position.maxValues);
    mesh.material = primitive.material;
    return mesh;
}

std::size_t instanceCount(const tinygltf::Model& model, const tinygltf::Node& node)
{
    const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == node.extensions.end())
        return 1;
    const tinygltf::Value& attributes = extension->second.Get("attributes");
    const int index = attributes.Get("TRANSLATION").GetNumberAsInt();
    return model.accessors.at(static_cast<std::size_t>(index)).count;
}

double emissionStrength(const tinygltf::Material& material)
{
    double peak = 0.0;
    for (const double channel : material.emissiveFactor)
        peak = std::max(peak, channel);
    const auto extension = material.extensions.find("KHR_materials_emissive_strength");
    if (extension != material.extensions.end())
        peak *= extension->second.Get("emissiveStrength").GetNumberAsDouble();
    return peak;
}

}  // namespace

std::string outputPath(const std::string& file)
{
    const std::filesystem::path folder =
        std::filesystem::path(GP_BINARY_DIR) / "test_output" / "make_scene";
    std::filesystem::create_directories(folder);
    const std::string path = (folder / file).string();
    std::filesystem::remove(path);
    return path;
}

std::vector<char> readBytes(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

ReadScene generate(const std::string& name, const std::map<std::string, double>& parameters)
{
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    // Tests run side by side: each writes under its own name.
    const std::string path = outputPath(std::string(info->name()) + "-" + name + ".glb");
    makeScene({name, path, parameters});
    tinygltf::Model model;
    tinygltf::TinyGLTF loader;
    std::string error, warning;
    EXPECT_TRUE(loader.LoadBinaryFromFile(&model, &error, &warning, path)) << error;
    EXPECT_EQ(error, "");
    EXPECT_EQ(warning, "");
    std::filesystem::remove(path);

    ReadScene scene;
    for (const tinygltf::Mesh& mesh : model.meshes)
        scene.meshes.push_back(readMesh(model, mesh));
    for (const tinygltf::Node& node : model.nodes) {
        if (node.camera >= 0)
            scene.cameras.push_back(node.name);
        if (node.mesh >= 0)
            scene.instancedTriangles +=
                instanceCount(model, node) *
                scene.meshes.at(static_cast<std::size_t>(node.mesh)).indices.size() / 3;
    }
    for (const tinygltf::Material& material : model.materials) {
        scene.materials.push_back(material.name);
        scene.emissionStrengths.push_back(emissionStrength(material));
    }
    for (const tinygltf::Light& light : model.lights)
        scene.lights.push_back(light.name + " " + light.type);
    scene.required = model.extensionsRequired;
    scene.nodes = model.nodes.size();
    scene.images = model.images.size();
    for (const tinygltf::Image& image : model.images)
        EXPECT_GT(image.image.size(), 0u) << image.name;  // decoded
    return scene;
}

}  // namespace gp::make_scene::testing
