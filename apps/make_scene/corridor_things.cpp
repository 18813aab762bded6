#include "corridor.h"
#include "noise.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace gp::make_scene {

Torch torch(std::uint32_t seed)
{
    Torch t;
    const glm::vec3 foot(0.10f, 0.0f, 0), head(0.22f, 0.42f, 0);  // it leans off the wall
    const glm::vec3 axis = glm::normalize(head - foot);
    t.shaft = tube({foot, glm::mix(foot, head, 0.5f), head}, {0.017f, 0.021f, 0.026f}, 16);
    t.shaft.scaleUv({1 / 1.2f, 1 / 0.4f});
    // A plate on the wall, an arm, a ring around the shaft and a cage around the burning end.
    Mesh plate = box({0.012f, 0.24f, 0.09f}, 0.003f, 2);
    t.iron.append(plate.transform(translation(0.006f, 0.16f, 0)));
    t.iron.append(tube({{0.0f, 0.10f, 0}, {0.07f, 0.085f, 0}, {0.125f, 0.095f, 0}}, {0.010f}, 12));
    t.iron.append(tube({{0.0f, 0.24f, 0}, {0.10f, 0.255f, 0}, {0.165f, 0.25f, 0}}, {0.009f}, 12));
    const glm::mat4 along = translation(foot) * rotationFromY(axis);
    for (const float at : {0.095f, 0.262f}) {
        Mesh ring = torus(0.026f, 0.006f, 28, 10);
        t.iron.append(ring.transform(along * translation(0, at, 0)));
    }
    Mesh cup = lathe({{0.027f, 0.37f, true}, {0.030f, 0.37f, true}, {0.048f, 0.45f, true},
                      {0.045f, 0.45f, true}, {0.027f, 0.37f, true}}, 28);
    t.iron.append(cup.transform(along));

    // The flame stands upright whatever the shaft does, wavers, and is torn at its tip.
    t.flame = lathe(smoothProfile({{0, 0},
                                   {0.020f, 0.006f},
                                   {0.040f, 0.040f},
                                   {0.043f, 0.075f},
                                   {0.030f, 0.130f},
                                   {0.015f, 0.185f},
                                   {0.005f, 0.225f},
                                   {0, 0.245f}},
                                  3),
                    24);
    const float offset = static_cast<float>(seed) * 7.7f;
    for (glm::vec3& p : t.flame.positions) {
        const float up = p.y / 0.245f;
        const glm::vec3 q(p.x * 16.0f, p.y * 11.0f, p.z * 16.0f + offset);
        const float lick = 1.0f + 0.9f * up * noise(q, seed);
        const glm::vec2 bend(std::sin(8.0f * up + offset), std::cos(6.0f * up + offset));
        const glm::vec2 sway = 0.030f * up * up * bend;
        p = glm::vec3(p.x * lick + sway.x, p.y, p.z * lick + sway.y);
    }
    t.flame.computeSmoothNormals();
    t.flame.transform(translation(head + axis * 0.01f));
    return t;
}

Barrel barrel()
{
    Barrel b;
    b.staves = lathe(smoothProfile({{0, 0.035f},
                                    {0.205f, 0.035f, true},
                                    {0.212f, 0, true},
                                    {0.228f, 0, true},
                                    {0.272f, 0.22f},
                                    {0.288f, 0.42f},
                                    {0.272f, 0.62f},
                                    {0.228f, 0.84f, true},
                                    {0.212f, 0.84f, true},
                                    {0.205f, 0.805f, true},
                                    {0, 0.805f}},
                                   5),
                     60);
    // Grooves between twenty staves.
    for (glm::vec3& p : b.staves.positions) {
        const float groove = std::pow(std::abs(std::cos(10 * std::atan2(p.z, p.x))), 40.0f);
        p *= glm::vec3(1 - 0.012f * groove, 1, 1 - 0.012f * groove);
    }
    b.staves.computeSmoothNormals();
    for (glm::vec2& uv : b.staves.uvs)
        uv = glm::vec2(uv.y * 1.4f, uv.x * 4.0f);  // the grain runs up the staves
    const float heights[] = {0.07f, 0.20f, 0.64f, 0.77f};
    const float radii[] = {0.244f, 0.268f, 0.268f, 0.244f};
    for (std::size_t i = 0; i < 4; ++i) {
        const float r = radii[i], y = heights[i];
        const float slope = y < 0.42f ? 0.006f : -0.006f;
        const float inner = r - 0.006f, outer = r + 0.005f, low = y - 0.02f, high = y + 0.02f;
        b.hoops.append(lathe({{inner - slope, low, true},
                              {outer - slope, low, true},
                              {outer + slope, high, true},
                              {inner + slope, high, true},
                              {inner - slope, low, true}},
                             60));
    }
    return b;
}

Mesh crate()
{
    Mesh mesh;
    const float size = 0.56f, board = 0.022f;
    const auto add = [&](glm::vec3 s, glm::vec3 at, float grain) {
        Mesh b = box(s, 0.003f, 1);
        b.scaleUv({1 / 1.2f, 1 / 0.4f}, {grain, 0.7f * grain});
        mesh.append(b.transform(translation(at)));
    };
    const float half = size / 2;
    add(glm::vec3(size - 0.05f), {0, half, 0}, 0.5f);  // the dark inside, seen between the boards
    for (int i = 0; i < 4; ++i) {
        const float w = size / 4, y = w * (static_cast<float>(i) + 0.5f);
        const float g = 0.23f * static_cast<float>(i);
        for (const float side : {-1.0f, 1.0f}) {
            add({size, w - 0.008f, board}, {0, y, side * (half - board / 2)}, g + side);
            add({board, w - 0.008f, size - 2 * board}, {side * (half - board / 2), y, 0}, g - side);
        }
        add({size, board, w - 0.006f}, {0, size - board / 2, y - half}, g + 0.4f);
    }
    for (const float x : {-1.0f, 1.0f})
        for (const float z : {-1.0f, 1.0f}) {
            add({0.07f, size, 0.018f}, {x * (half - 0.035f), half, z * (half + 0.009f)}, x + z);
            add({0.018f, size, 0.07f}, {x * (half + 0.009f), half, z * (half - 0.035f)}, x - z);
        }
    return mesh;
}

Image flameGradient()
{
    return bakeColor({8, 64}, [](glm::vec2 uv) {
        // Brightest below the middle; cooler, so redder and dimmer, towards the tip.
        const float up = uv.y;
        const glm::vec3 root(0.55f, 0.30f, 0.16f), heart(1.0f, 0.62f, 0.24f);
        const glm::vec3 tip(0.45f, 0.10f, 0.015f);
        return up < 0.35f ? glm::mix(root, heart, up / 0.35f)
                          : glm::mix(heart, tip, glm::smoothstep(0.35f, 1.0f, up));
    });
}

MaterialImages puddleImages()
{
    return bake({{256, 256}, {1.6f, 1.6f}, true}, [](glm::vec2 uv) {
        const glm::vec2 p = (uv - 0.5f) * 2.0f;
        const glm::vec3 direction(glm::normalize(p + 1e-4f) * 1.1f, 4.0f);
        const float shore = 0.62f + 0.55f * fbm(direction, 4, 2u);
        Texel t;
        t.color = glm::vec3(0.018f, 0.016f, 0.013f);
        t.alpha = 0.92f * (1.0f - glm::smoothstep(shore - 0.16f, shore, glm::length(p)));
        t.roughness = 0.02f;
        t.height = 0.0002f * noise(uv * 5.0f, {5, 5}, 3u);  // the air is never quite still
        return t;
    });
}

MaterialImages grateImages()
{
    return bake({{256, 256}, {0.75f, 0.75f}, true}, [](glm::vec2 uv) {
        const glm::vec2 cell = glm::abs(glm::fract(uv * 4.0f) - 0.5f);
        const float bar = std::max(cell.x, cell.y);  // 0.5 in the middle of a bar
        const float rust = fbm(uv * 12.0f, {12, 12}, 4, 5u);
        Texel t;
        t.alpha = glm::smoothstep(0.395f, 0.415f, bar);
        t.color = glm::mix(srgb(0x3a3632), srgb(0x6b3f26), glm::smoothstep(0.0f, 0.4f, rust));
        const float across = std::min(1.0f, (0.5f - bar) / 0.095f);
        t.height = 0.006f * std::sqrt(std::max(0.0f, 1 - across * across)) + 0.001f * rust;
        t.roughness = 0.55f + 0.3f * rust;
        t.metallic = rust > 0.15f ? 0.2f : 0.9f;
        return t;
    });
}

}  // namespace gp::make_scene
