#include "noise.h"
#include "room.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// One long leaf that rises from the pot and bends outwards under its weight.
Mesh leaf(float length, float width, float droop)
{
    return surface(7, 17, [=](glm::vec2 uv) {
        const float t = uv.y;
        // Exactly 0 at both ends: the sine of a rounded pi is not.
        const float swell = t <= 0.0f || t >= 1.0f ? 0.0f : std::sin(pi * std::pow(t, 0.75f));
        const float half = width * swell * (uv.x - 0.5f);
        const float bend = droop * t * t;
        const float crease = 0.25f * std::abs(half);
        return glm::vec3(half, length * (t * std::cos(bend)) + crease,
                         length * t * std::sin(bend) + 0.02f * t);
    });
}

}  // namespace

PottedPlant pottedPlant(std::uint32_t seed)
{
    PottedPlant plant;
    plant.pot = lathe(smoothProfile({{0, 0.004f},
                                     {0.10f, 0, true},
                                     {0.115f, 0.006f},
                                     {0.150f, 0.24f},
                                     {0.158f, 0.25f, true},
                                     {0.158f, 0.285f, true},
                                     {0.143f, 0.285f, true},
                                     {0.136f, 0.22f},
                                     {0, 0.21f}},
                                    5),
                      56);
    plant.soil = cylinder(0.137f, 0.212f, 0.245f, 40);
    Random random(seed);
    for (int i = 0; i < 26; ++i) {
        const float turn = 2.39996f * static_cast<float>(i);  // the golden angle spreads them
        const float inner = static_cast<float>(i) / 26.0f;
        Mesh blade = leaf(random.uniform(0.55f, 0.85f) * (1.1f - 0.35f * inner),
                          random.uniform(0.07f, 0.11f), 0.35f + 1.1f * inner);
        blade.transform(translation(0.05f * std::sin(turn), 0.23f, 0.05f * std::cos(turn)) *
                        rotationY(turn) * rotationX(0.12f + 0.35f * inner));
        plant.leaves.append(blade);
    }
    return plant;
}

Mesh curtain(float width, float height, std::uint32_t seed)
{
    return surface(97, 25, [=](glm::vec2 uv) {
        const float down = uv.y;
        const float phase = uv.x * 44.0f + 1.2f * noise(glm::vec3(uv.x * 5, down * 1.5f, 0), seed);
        const float deep = 0.022f + 0.026f * down;
        return glm::vec3((uv.x - 0.5f) * width * (1.0f + 0.10f * down * down),
                         -height * down, deep * std::sin(phase));
    });
}

Image rugPattern()
{
    const glm::vec3 ground = srgb(0x7a2f28), cream = srgb(0xd9c7a0), ink = srgb(0x23304d);
    const glm::vec3 ochre = srgb(0xb98a3e);
    return bakeColor({768, 512}, [=](glm::vec2 uv) {
        const glm::vec2 metres = uv * glm::vec2(2.4f, 1.6f);
        const glm::vec2 rim = glm::min(metres, glm::vec2(2.4f, 1.6f) - metres);
        const float edge = std::min(rim.x, rim.y);
        const glm::vec2 knots = glm::floor(metres * 110.0f);  // rugs are made of knots
        const glm::vec2 p = (knots + 0.5f) / 110.0f;
        glm::vec3 color = ground;
        const glm::vec2 centre = glm::abs(p - glm::vec2(1.2f, 0.8f));
        const float diamond = centre.x / 0.72f + centre.y / 0.50f;
        const float star = std::abs(std::sin(p.x * 21.0f) * std::sin(p.y * 21.0f));
        if (diamond < 1.0f)
            color = diamond > 0.92f                           ? cream
                    : std::fmod(diamond * 6.0f, 1.0f) < 0.5f ? ink
                                                             : ochre;
        else if (star > 0.86f)
            color = ochre;
        if (edge < 0.24f) {
            const float along = rim.x < rim.y ? p.y : p.x;
            const float tooth = std::abs(std::fmod(along * 12.5f, 1.0f) - 0.5f) * 0.2f;
            color = edge < 0.03f || edge > 0.215f ? ink : (edge - 0.07f > tooth ? cream : ground);
            color = edge > 0.19f && edge < 0.215f ? ochre : color;
        }
        const float tone = hash01(static_cast<int>(knots.x), static_cast<int>(knots.y), 3u);
        return color * (0.78f + 0.34f * tone);
    });
}

Image landscapePainting()
{
    return bakeColor({256, 192}, [](glm::vec2 uv) {
        // Evening over a lake, in broad strokes.
        const glm::vec2 stroke(fbm(uv * 9.0f, {0, 0}, 3, 1u), fbm(uv * 7.0f, {0, 0}, 3, 2u));
        const glm::vec2 p = uv + 0.03f * stroke;
        const float horizon = 0.58f;
        const float sky = p.y < horizon ? p.y / horizon : 1.0f - (p.y - horizon) / (1 - horizon);
        const float glow = std::pow(std::max(sky, 0.0f), 1.6f);
        glm::vec3 color = glm::mix(srgb(0x33486e), srgb(0xf0a35a), glow);
        const float sun = glm::length((p - glm::vec2(0.64f, 0.46f)) * glm::vec2(1.33f, 1.0f));
        color = glm::mix(srgb(0xfff0c0), color, glm::smoothstep(0.03f, 0.06f, sun));
        const float crest = 0.44f + 0.16f * fbm(glm::vec2(p.x * 4.0f, 3.0f), {0, 0}, 4, 5u);
        if (p.y > crest && p.y < horizon)
            color = glm::mix(srgb(0x2a3148), srgb(0x6a4a52), (p.y - crest) / (horizon - crest));
        if (p.y > horizon)
            color *= 0.75f + 0.5f * std::max(0.0f, noise(p * glm::vec2(7, 40), {0, 0}, 7u));
        return color * (0.92f + 0.2f * fbm(uv * glm::vec2(40, 90), {0, 0}, 2, 9u));
    });
}

}  // namespace gp::make_scene
