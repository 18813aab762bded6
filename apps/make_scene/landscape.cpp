#include "landscape.h"

#include "noise.h"
#include "shapes.h"
#include "textures.h"

#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

// A ring of hills around the place; the far ones are paler, as air makes them.
Mesh ridge(float distance, float height, std::uint32_t seed)
{
    return surface(193, 9, [=](glm::vec2 uv) {
        // The last column repeats the first one exactly: the noise runs around its own circle.
        const float turn = uv.x >= 1.0f ? 0.0f : uv.x;
        const float angle = 2 * std::numbers::pi_v<float> * turn;
        const glm::vec2 direction(std::cos(angle), std::sin(angle));
        const glm::vec3 place(direction * 4.0f, static_cast<float>(seed));
        const float crest = height * (0.55f + 0.9f * fbm(place, 5, seed));
        const float up = 0.5f - 0.5f * std::cos(uv.y * std::numbers::pi_v<float>);
        const float fold = 0.12f * height * fbm(glm::vec3(direction * 14.0f, uv.y * 3.0f), 4, seed);
        const float radius = distance * (1.0f + 0.35f * uv.y);
        return glm::vec3(direction.x * radius, up * (crest + fold) - 2.0f, direction.y * radius);
    });
}

}  // namespace

void addLandscape(GlbBuilder& glb, float y)
{
    Material meadow;
    meadow.name = "meadow";
    glb.setMaps(meadow, bake({{256, 256}, {40, 40}}, foliage(srgb(0x59682f), 71u)));
    Mesh plain = quad({0, 0, 0}, {0, 0, 2500}, {2500, 0, 0}, glm::vec2(125.0f));
    plain.transform(translation(0, y, 0));
    glb.add("meadow", plain, glb.addMaterial(meadow));

    const float distances[] = {260.0f, 620.0f, 1400.0f};
    const float heights[] = {16.0f, 62.0f, 190.0f};
    const std::uint32_t colors[] = {0x4a5a33, 0x62725f, 0x8494a4};
    for (std::uint32_t i = 0; i < 3; ++i) {
        Material hill;
        hill.name = "hills " + std::to_string(i + 1);
        hill.color = srgb(colors[i]);
        hill.roughness = 1.0f;
        hill.specular = 0.0f;
        Mesh mesh = ridge(distances[i], heights[i], 31u + i);
        mesh.transform(translation(0, y, 0));
        glb.add(hill.name, mesh, glb.addMaterial(hill));
    }
}

}  // namespace gp::make_scene
