// Spheres over roughness and metallic, white: under a uniform environment of radiance 1 whatever
// differs from 1 is energy that a material loses or invents.
#include "scenes.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace gp::make_scene {

void buildFurnace(GlbBuilder& glb, const Parameters& parameters)
{
    const int rows = static_cast<int>(parameters.at("rows"));
    const int columns = static_cast<int>(parameters.at("columns"));
    const float spacing = 0.25f;  // metres between centres; spheres of 0.1 m radius
    const auto step = [](int i, int count) {
        return count > 1 ? static_cast<float>(i) / static_cast<float>(count - 1) : 0.0f;
    };
    int geometry = -1;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            Material white;
            white.roughness = step(column, columns);
            white.metallic = step(row, rows);
            white.name = "roughness " + std::to_string(white.roughness).substr(0, 5) +
                         " metallic " + std::to_string(white.metallic).substr(0, 5);
            const int material = glb.addMaterial(white);
            const int mesh = geometry < 0 ? glb.addMesh(white.name, sphere(0.1f, 96, 48), material)
                                          : glb.addMeshLike(white.name, geometry, material);
            geometry = geometry < 0 ? mesh : geometry;
            const float x = static_cast<float>(column) - 0.5f * static_cast<float>(columns - 1);
            const float y = static_cast<float>(row) - 0.5f * static_cast<float>(rows - 1);
            glb.addNode(white.name, mesh, translation(x * spacing, y * spacing, 0));
        }
    Camera camera;
    camera.name = "front";
    camera.aspect = static_cast<float>(columns) / static_cast<float>(rows);
    camera.verticalFovDegrees = 20.0f;
    // Far enough that the whole grid with half a spacing around it is in the picture.
    const float halfHeight = 0.5f * spacing * static_cast<float>(rows);
    camera.position = glm::vec3(0, 0, halfHeight / std::tan(glm::radians(10.0f)) + 0.1f);
    camera.target = glm::vec3(0.0f);
    glb.addCamera(camera);
}

}  // namespace gp::make_scene
