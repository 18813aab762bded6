// A closed diffuse surface that emits the same everywhere: L = E + albedo L at every point, so
// L = E / (1 - albedo) whatever the shape. The facets keep their own flat normals, because a
// shading normal that is not the surface's would break that equation.
#include "scenes.h"
#include "shapes.h"

namespace gp::make_scene {

void buildClosedSphere(GlbBuilder& glb, const Parameters& parameters)
{
    Mesh shell = cubeSphere(static_cast<int>(parameters.at("subdivisions")));
    shell.flip();
    shell.makeFlat();
    Material wall;
    wall.name = "wall";
    wall.color = glm::vec3(static_cast<float>(parameters.at("albedo")));
    wall.emission = glm::vec3(static_cast<float>(parameters.at("emission")));
    wall.specular = 0.0f;
    glb.add("shell", shell, glb.addMaterial(wall));

    Camera camera;
    camera.name = "inside";
    camera.position = glm::vec3(0.3f, 0.1f, 0.2f);  // off centre: nothing may depend on it
    camera.target = glm::vec3(-0.2f, 0.0f, -1.0f);
    camera.verticalFovDegrees = 60.0f;
    glb.addCamera(camera);
}

}  // namespace gp::make_scene
