// A box of our own in the manner of Cornell's: 2 m a side, open to the front, one lamp.
// The inside spans x and z in [-1, 1], y in [0, 2]; all surfaces are purely diffuse.
#include "scenes.h"
#include "shapes.h"

namespace gp::make_scene {
namespace {

int diffuse(GlbBuilder& glb, const char* name, glm::vec3 albedo)
{
    Material material;
    material.name = name;
    material.color = albedo;
    material.specular = 0.0f;  // without it glTF adds a 4 % dielectric reflection
    return glb.addMaterial(material);
}

}  // namespace

void buildCornell(GlbBuilder& glb, const Parameters& parameters)
{
    const int white = diffuse(glb, "white", glm::vec3(0.73f));
    const int red = diffuse(glb, "red", glm::vec3(0.6f, 0.06f, 0.05f));
    const int green = diffuse(glb, "green", glm::vec3(0.12f, 0.45f, 0.1f));
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    glb.add("floor", quad({0, 0, 0}, z, x), white);
    glb.add("ceiling", quad({0, 2, 0}, x, z), white);
    glb.add("back wall", quad({0, 1, -1}, x, y), white);
    glb.add("left wall", quad({-1, 1, 0}, y, z), red);
    glb.add("right wall", quad({1, 1, 0}, z, y), green);

    Mesh tall = box({0.6f, 1.2f, 0.6f});
    tall.transform(translation(-0.34f, 0.6f, -0.35f) * rotationY(glm::radians(18.0f)));
    glb.add("tall block", tall, white);
    Mesh low = box({0.6f, 0.6f, 0.6f});
    low.transform(translation(0.36f, 0.3f, 0.3f) * rotationY(glm::radians(-17.0f)));
    glb.add("low block", low, white);

    Material lamp;
    lamp.name = "lamp";
    lamp.color = glm::vec3(0.0f);
    lamp.specular = 0.0f;
    lamp.emission = glm::vec3(1.0f, 0.85f, 0.6f) * static_cast<float>(parameters.at("radiance"));
    // A hair below the ceiling: in its plane the two would fight for the ray.
    glb.add("lamp", quad({0, 1.995f, 0}, 0.25f * x, 0.25f * z), glb.addMaterial(lamp));

    Camera camera;
    camera.name = "front";
    camera.position = glm::vec3(0, 1, 4.6f);
    camera.target = glm::vec3(0, 1, 0);
    camera.verticalFovDegrees = 32.0f;
    camera.aspect = 1.0f;
    glb.addCamera(camera);
}

}  // namespace gp::make_scene
