// Three objects for lighting models: a pleated, twisted bulb whose folds face each other, and a
// sphere of few and one of many triangles, both with smooth normals. All are white, so that a
// model's own colours show, under a violet and a red point light.
#include "scenes.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// From the foot (t = 0) to the tip (1), `turn` in [0, 1] around the axis. The pleats wind up the
// body and lean to one side, so that each hides a part of the next.
glm::vec3 pleatedBulb(float turn, float t)
{
    constexpr float pleats = 7, depth = 0.28f, winding = 0.42f, lean = 0.8f;
    // A foot, a belly and a neck that closes.
    const float belly = std::pow(std::sin(pi * std::pow(t, 0.72f)), 0.8f);
    const float radius = 0.62f * belly * (1.0f - 0.35f * t);
    const float fold = std::sin(pi * std::min(1.0f, 1.15f * t));  // no pleats at the two ends
    const float wave = 2.0f * pi * pleats * (turn + winding * t * t);
    const float crest = std::cos(wave) + 0.18f * std::cos(2.0f * wave);
    const float r = t > 0.0f && t < 1.0f ? radius * (1.0f + depth * fold * crest) : 0.0f;
    const float angle = 2.0f * pi * turn + lean * fold * std::cos(wave) / pleats;
    return {r * std::cos(angle), 1.7f * t, -r * std::sin(angle)};
}

}  // namespace

void buildThreeObjects(GlbBuilder& glb, const Parameters&)
{
    Material white;
    white.name = "white";
    white.roughness = 0.4f;
    const int material = glb.addMaterial(white);

    // The last column of vertices lies on the first to the bit, or the bulb would be open.
    Mesh bulb = surface(337, 129, [](glm::vec2 uv) {
        return pleatedBulb(uv.x < 1.0f ? uv.x : 0.0f, uv.y);
    });
    bulb.removeUnusedVertices();
    bulb.transform(translation(0.0f, -0.85f, -0.15f));
    Mesh low = sphere(0.58f, 10, 6), high = sphere(0.58f, 128, 64);
    low.transform(translation(-1.33f, -0.2f, 0.25f) * rotationX(0.35f));
    high.transform(translation(1.33f, -0.2f, 0.25f));
    const auto add = [&](const char* name, Mesh& mesh) {
        mesh.computeTangents();  // for models of fibres and grooves
        glb.add(name, mesh, material);
    };
    add("pleated bulb", bulb);
    add("low sphere", low);
    add("high sphere", high);

    glb.addPointLight("violet", {-2.1f, 2.0f, 2.6f}, {0.32f, 0.07f, 1.0f}, 40.0f);
    glb.addPointLight("red", {2.9f, 0.1f, 1.5f}, {1.0f, 0.05f, 0.02f}, 18.0f);

    Camera camera;
    camera.name = "front";
    camera.position = glm::vec3(0.0f, 0.45f, 6.2f);
    camera.target = glm::vec3(0.0f, -0.02f, 0.0f);
    camera.verticalFovDegrees = 22.0f;
    glb.addCamera(camera);
}

}  // namespace gp::make_scene
