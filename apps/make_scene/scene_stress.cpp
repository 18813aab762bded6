// As many triangles as asked for: a few rocks, each instanced many times over a plain.
#include "noise.h"
#include "rock.h"
#include "scenes.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gp::make_scene {
namespace {

constexpr int shapeCount = 4;  // different rocks; the eye does not count further

Instances scatter(int first, int count, float extent, Random& random)
{
    Instances list;
    const int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
    for (int i = first; i < count; i += shapeCount) {
        // One rock a cell with jitter: even cover without clumps that no eye believes.
        const float cell = extent / static_cast<float>(side);
        const glm::vec2 corner(i % side, i / side);
        const glm::vec2 jitter(random.uniform(), random.uniform());
        const glm::vec2 place = (corner + jitter) * cell - 0.5f * extent;
        // Cubing makes many pebbles and few boulders.
        const float size = cell * (0.18f + 0.6f * std::pow(random.uniform(), 3.0f));
        const float turn = random.uniform(0.0f, 3.14159f), tilt = random.uniform(-0.12f, 0.12f);
        const glm::vec4 yaw(0, std::sin(turn), 0, std::cos(turn));
        // The product of a turn about Y and a small one about X, written out.
        const float s = std::sin(tilt), c = std::cos(tilt);
        list.rotations.push_back(glm::vec4(yaw.w * s, yaw.y * c, -yaw.y * s, yaw.w * c));
        list.translations.push_back(glm::vec3(place.x, size * 0.25f, place.y));
        list.scales.push_back(glm::vec3(size));
    }
    return list;
}

}  // namespace

void buildStress(GlbBuilder& glb, const Parameters& parameters)
{
    const double triangles = parameters.at("triangles");
    const int instances = static_cast<int>(parameters.at("instances"));
    // cubeSphere(n) has 12 n^2 triangles; nearest n, so the total is right to a few per cent
    const int subdivisions =
        std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / instances / 12.0))));
    const float extent = 60.0f;

    Material ground;
    ground.name = "ground";
    ground.color = srgb(0x8a7a60);
    ground.roughness = 0.95f;
    glb.add("ground", quad({0, 0, 0}, {0, 0, 400}, {400, 0, 0}), glb.addMaterial(ground));

    const std::array<std::uint32_t, shapeCount> colors{0x8d8579, 0x75706c, 0x9a8b74, 0x6d7069};
    Random random(11u);
    for (int shape = 0; shape < shapeCount; ++shape) {
        Material stone;
        stone.name = "stone " + std::to_string(shape + 1);
        stone.color = srgb(colors[static_cast<std::size_t>(shape)]);
        stone.roughness = 0.85f;
        const Mesh mesh = rock(subdivisions, static_cast<std::uint32_t>(shape) + 1u);
        const std::string name = "rock " + std::to_string(shape + 1);
        glb.addInstances(name, glb.addMesh(name, mesh, glb.addMaterial(stone)),
                         scatter(shape, instances, extent, random));
    }
    Camera camera;
    camera.name = "over the field";
    camera.position = glm::vec3(0, 7.0f, 36.0f);
    camera.target = glm::vec3(0, 0, 6.0f);
    camera.verticalFovDegrees = 35.0f;
    glb.addCamera(camera);
}

}  // namespace gp::make_scene
