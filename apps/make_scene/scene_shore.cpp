// The edge of a sea: sand that slopes down under the level y = 0, stones in it and out of it, and a
// mooring post. The water itself is not in the file: the renderer has it.
#include "noise.h"
#include "rock.h"
#include "scenes.h"
#include "shapes.h"

#include <array>
#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float width = 60.0f;    // of the sand, metres
constexpr float nearEdge = 12.0f; // z of its upper end
constexpr float length = 70.0f;

// Out of the water at z = 4, and steeper the farther out.
float sandHeight(float x, float z)
{
    const float out = 4.0f - z;
    const float slope = out > 0.0f ? 0.09f * out + 0.0016f * out * out : 0.05f * out;
    return -slope + 0.12f * fbm(glm::vec3(0.35f * x, 0.0f, 0.35f * z), 3, 5u);
}

// Ripples that wind and waves leave, 2 x 2.
Texel sand(glm::vec2 uv)
{
    const glm::ivec2 period(8);
    const glm::vec2 p = uv * 8.0f;
    const float bend = fbm(p, period, 3, 21u);
    const float ripple = std::sin(2.0f * pi * (9.0f * uv.y + 0.55f * bend));
    const float grain = noise(uv * 256.0f, glm::ivec2(256), 3u);
    Texel t;
    t.height = 0.006f * ripple + 0.0006f * grain;
    const float light = 0.92f + 0.06f * ripple + 0.08f * grain + 0.10f * bend;
    t.color = srgb(0xcdb68c) * light;
    t.roughness = 0.95f;
    return t;
}

void addSand(GlbBuilder& glb)
{
    Material material;
    material.name = "sand";
    material.specular = 0.3f;
    BakeOptions options;
    options.metres = glm::vec2(2.0f);
    glb.setMaps(material, bake(options, sand));
    const int index = glb.addMaterial(material);
    Mesh mesh = surface(161, 191, [](glm::vec2 uv) {
        const float x = width * (uv.x - 0.5f), z = nearEdge - length * uv.y;
        return glm::vec3(x, sandHeight(x, z), z);
    });
    mesh.scaleUv(glm::vec2(width, length) / 2.0f);
    mesh.computeTangents();
    glb.add("sand", mesh, index);
}

void addStones(GlbBuilder& glb)
{
    constexpr std::array<std::uint32_t, 4> colors{0x6f6a63, 0x8b7f70, 0x4f5254, 0x9c9184};
    Random random(4u);
    for (std::size_t shape = 0; shape < colors.size(); ++shape) {
        Material stone;
        stone.name = "stone " + std::to_string(shape + 1);
        stone.color = srgb(colors[shape]);
        stone.roughness = 0.7f;
        Instances list;
        const auto put = [&](float x, float z, float size) {
            const float turn = random.uniform(0.0f, pi);
            list.rotations.push_back(glm::vec4(0, std::sin(turn), 0, std::cos(turn)));
            list.translations.push_back(glm::vec3(x, sandHeight(x, z) + 0.25f * size, z));
            list.scales.push_back(glm::vec3(size));
        };
        for (int i = 0; i < 110; ++i) {
            const float x = random.uniform(-9.0f, 9.0f), z = random.uniform(-16.0f, 3.5f);
            put(x, z, 0.05f + 0.35f * std::pow(random.uniform(), 3.0f));
        }
        // One of each that stands out of the water.
        constexpr std::array<glm::vec2, 4> large{glm::vec2(-2.6f, -1.2f), glm::vec2(3.4f, -4.5f),
                                                 glm::vec2(-4.5f, -8.0f), glm::vec2(1.2f, 1.4f)};
        put(large[shape].x, large[shape].y, 0.55f + 0.05f * std::abs(large[shape].y));
        const std::string name = "rock " + std::to_string(shape + 1);
        const Mesh mesh = rock(24, static_cast<std::uint32_t>(shape) + 1u);
        glb.addInstances(name, glb.addMesh(name, mesh, glb.addMaterial(stone)), list);
    }
}

}  // namespace

void buildShore(GlbBuilder& glb, const Parameters&)
{
    addSand(glb);
    addStones(glb);

    Material wood;
    wood.name = "wood";
    wood.color = srgb(0x6b5137);
    wood.roughness = 0.8f;
    const glm::vec3 foot(0.9f, sandHeight(0.9f, -2.2f) - 0.3f, -2.2f);
    glb.add("post", bar(foot, foot + glm::vec3(0.25f, 2.0f, 0.1f), 0.07f, 32),
            glb.addMaterial(wood));

    Camera camera;
    camera.name = "on the beach";
    camera.position = glm::vec3(0.3f, 1.5f, 3.6f);
    camera.target = glm::vec3(0.0f, -0.5f, -0.6f);
    camera.verticalFovDegrees = 50.0f;
    glb.addCamera(camera);
}

}  // namespace gp::make_scene
