// Reads a scene back by a library that had no part in writing it.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gp::make_scene::testing {

struct ReadMesh {
    std::string name;
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uvs;
    std::vector<std::uint32_t> indices;
    glm::vec3 low = glm::vec3(0.0f), high = glm::vec3(0.0f);  // as the accessor claims
    int material = -1;
};

struct ReadScene {
    std::vector<ReadMesh> meshes;
    std::vector<std::string> cameras, lights, materials, required;
    std::vector<double> emissionStrengths;  // one a material, 0 where it does not emit
    std::size_t nodes = 0;
    std::size_t instancedTriangles = 0;  // over all nodes and instances
    std::size_t images = 0;
};

// A fresh path in the build tree for a file of this name.
std::string outputPath(const std::string& file);
// Generates and reads back; fails the test when tinygltf reports an error or a warning.
ReadScene generate(const std::string& name, const std::map<std::string, double>& parameters = {});
std::vector<char> readBytes(const std::string& path);

}  // namespace gp::make_scene::testing
