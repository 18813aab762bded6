// Writes binary glTF 2.0. One builder is one scene; every add… returns the glTF index.
#pragma once

#include "image.h"
#include "mesh.h"

#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace gp::make_scene {

// A glTF material with the extensions that our scenes use. The defaults are those of glTF, except
// that it is a dielectric; an extension is written only where one of its values differs.
struct Material {
    std::string name;
    glm::vec3 color = glm::vec3(1.0f);
    float alpha = 1.0f;
    float metallic = 0.0f;
    float roughness = 1.0f;
    glm::vec3 emission = glm::vec3(0.0f);  // radiance, W/(m^2 sr); may exceed 1
    int colorTexture = -1;
    int metallicRoughnessTexture = -1;
    int normalTexture = -1;
    float normalScale = 1.0f;
    int emissionTexture = -1;
    const char* alphaMode = "OPAQUE";  // or MASK (cut at 0.5), BLEND
    bool doubleSided = false;
    float clearcoat = 0.0f, clearcoatRoughness = 0.0f;
    glm::vec3 sheenColor = glm::vec3(0.0f);
    float sheenRoughness = 0.0f;
    float transmission = 0.0f;
    float thickness = 0.0f;  // metres; above 0: a solid, bounded by closed surfaces
    glm::vec3 attenuationColor = glm::vec3(1.0f);
    float attenuationDistance = 0.0f;  // metres; 0: no attenuation
    float ior = 1.5f;
    float specular = 1.0f;
    float anisotropy = 0.0f, anisotropyRotation = 0.0f;  // radians
    float iridescence = 0.0f, iridescenceIor = 1.3f;
    float filmThicknessMinNm = 100.0f, filmThicknessMaxNm = 400.0f;
    int filmThicknessTexture = -1;
};

struct Camera {
    std::string name;
    glm::vec3 position = glm::vec3(0.0f);
    glm::vec3 target = glm::vec3(0, 0, -1);
    float verticalFovDegrees = 45.0f;
    float aspect = 16.0f / 9.0f;
};

struct Instances {
    std::vector<glm::vec3> translations;
    std::vector<glm::vec4> rotations;  // unit quaternions x, y, z, w
    std::vector<glm::vec3> scales;
};

class GlbBuilder {
public:
    explicit GlbBuilder(const std::string& sceneName);

    int addTexture(const std::string& name, const Image& image, bool repeat = true);
    // Bakes' three maps into a material in one go.
    void setMaps(Material& material, const MaterialImages& maps);
    int addMaterial(const Material& material);

    int addMesh(const std::string& name, const Mesh& mesh, int material);
    // The same geometry once more with another material: shares the accessors.
    int addMeshLike(const std::string& name, int mesh, int material);

    int addNode(const std::string& name, int mesh, const glm::mat4& worldFromObject = glm::mat4(1));
    int addInstances(const std::string& name, int mesh, const Instances& instances);
    // Mesh and node of one name, in place.
    void add(const std::string& name, const Mesh& mesh, int material);
    void addCamera(const Camera& camera);
    void addPointLight(const std::string& name, glm::vec3 position, glm::vec3 color,
                       float wattsPerSteradian);

    // Writes beside the target first and renames: a reader never sees half a file.
    void write(const std::string& path);

private:
    int addView(const void* data, std::size_t bytes, int target);
    int addVectors(const float* data, std::size_t count, int components, bool bounds);
    nlohmann::json textureInfo(int texture) const;
    void use(const char* extension, bool required = false);
    nlohmann::json materialExtensions(const Material& material);
    int addRootNode(nlohmann::json node);

    nlohmann::json m_gltf;
    std::vector<std::uint8_t> m_binary;
    std::set<std::string> m_used, m_required;
};

}  // namespace gp::make_scene
