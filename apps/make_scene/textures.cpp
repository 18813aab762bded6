#include "textures.h"

#include "noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float tau = 2.0f * std::numbers::pi_v<float>;

float saturate(float x) { return std::clamp(x, 0.0f, 1.0f); }
float smooth(float low, float high, float x) { return glm::smoothstep(low, high, x); }

float fbmUv(glm::vec2 uv, glm::ivec2 frequency, int octaves, std::uint32_t seed)
{
    return fbm(uv * glm::vec2(frequency), frequency, octaves, seed);
}

// One stone of a coursed wall, with the joint around it.
struct Stone {
    glm::ivec2 index;
    float edge;   // 0 in the joint's middle, 1 well inside the stone
    float tone;   // random number of the stone
};
Stone stoneAt(glm::vec2 uv, int rows, int columns, float joint, float offset, std::uint32_t seed)
{
    // Bending the coordinates makes the joints wander as hewn ones do.
    const glm::vec2 bend(fbmUv(uv, {8, 8}, 3, seed), fbmUv(uv, {8, 8}, 3, seed + 9u));
    const glm::vec2 p = uv + 0.012f * bend;
    Stone stone;
    const float y = p.y * static_cast<float>(rows);
    stone.index.y = static_cast<int>(std::floor(y));
    const int row = (stone.index.y % rows + rows) % rows;
    const float shift = offset * static_cast<float>(row % 2) +
                        0.3f * hash01(row, 3, seed);
    const float x = p.x * static_cast<float>(columns) + shift;
    stone.index.x = static_cast<int>(std::floor(x));
    const int column = (stone.index.x % columns + columns) % columns;
    const float dx = std::min(x - std::floor(x), 1 - (x - std::floor(x))) /
                     static_cast<float>(columns);
    const float dy = std::min(y - std::floor(y), 1 - (y - std::floor(y))) /
                     static_cast<float>(rows);
    // Rounded corners: the two distances blend where both are small.
    const float a = saturate(1 - dx / joint), b = saturate(1 - dy / joint);
    stone.edge = saturate(1 - std::sqrt(a * a + b * b));
    stone.index = glm::ivec2(column, row);
    stone.tone = hash01(column, row, seed + 5u);
    return stone;
}

}  // namespace

TexelFunction wood(WoodColors colors, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const float drift = fbmUv(uv, {2, 3}, 4, seed);
        const float ring = uv.y * 9.0f + 2.6f * drift + 0.25f * fbmUv(uv, {6, 24}, 2, seed + 1u);
        const float phase = ring - std::floor(ring);
        // A ring darkens slowly and ends sharply, as a year of growth does.
        const float late = smooth(0.25f, 0.9f, phase) * (1 - smooth(0.93f, 1.0f, phase));
        const float fibre = fbmUv(uv, {12, 220}, 3, seed + 2u);
        const float pore = smooth(0.28f, 0.42f, fbmUv(uv, {20, 170}, 2, seed + 3u));
        const float blotch = fbmUv(uv, {3, 4}, 3, seed + 4u);
        Texel t;
        t.color = glm::mix(colors.early, colors.late, saturate(0.75f * late + 0.35f * fibre));
        t.color *= (1 + 0.35f * blotch) * (1 - 0.5f * pore);
        t.height = -0.00022f * pore - 0.00007f * late + 0.00004f * fibre;
        t.roughness = saturate(colors.roughness + 0.12f * fibre + 0.2f * pore + 0.14f * blotch);
        return t;
    };
}

TexelFunction stoneBlocks(glm::vec3 color, int rows, int columns, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const Stone stone = stoneAt(uv, rows, columns, 0.016f, 0.5f, seed);
        const float solid = smooth(0.25f, 0.75f, stone.edge);
        const float rough = fbmUv(uv, {24, 24}, 4, seed + 1u);
        const float pits = smooth(0.2f, 0.5f, fbmUv(uv, {48, 48}, 3, seed + 2u));
        const float stain = fbmUv(uv, {4, 4}, 4, seed + 3u);
        Texel t;
        const glm::vec3 warm = color * glm::vec3(1.12f, 1.0f, 0.86f);
        const glm::vec3 face = glm::mix(color, warm, stone.tone) *
                               (0.72f + 0.5f * hash01(stone.index.x, stone.index.y, seed + 8u));
        const glm::vec3 mortar = color * glm::vec3(0.62f, 0.6f, 0.56f);
        t.color = glm::mix(mortar, face, solid) * (1 + 0.45f * rough + 0.35f * stain);
        t.color *= 1 - 0.35f * pits * solid;
        t.height = 0.010f * smooth(0.0f, 1.0f, stone.edge) + 0.006f * rough -
                   0.0022f * pits * solid + 0.004f * stone.tone * solid;
        t.roughness = saturate(0.82f + 0.2f * rough);
        return t;
    };
}

TexelFunction flagstones(glm::vec3 color, int rows, int columns, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const Stone stone = stoneAt(uv, rows, columns, 0.010f, 0.45f, seed);
        const float solid = smooth(0.3f, 0.8f, stone.edge);
        const float rough = fbmUv(uv, {20, 20}, 5, seed + 1u);
        const float wear = fbmUv(uv, {3, 3}, 4, seed + 2u);
        Texel t;
        const glm::vec3 face = color * (0.75f + 0.45f * stone.tone);
        t.color = glm::mix(color * 0.4f, face, solid) * (1 + 0.35f * rough + 0.3f * wear);
        t.height = 0.005f * smooth(0.0f, 1.0f, stone.edge) + 0.0028f * rough +
                   0.003f * stone.tone * solid;
        // Feet polish the middle of the stones.
        t.roughness = saturate(0.58f + 0.3f * rough - 0.5f * wear * solid + 0.25f * (1 - solid));
        return t;
    };
}

TexelFunction plaster(glm::vec3 color, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const float trowel = fbmUv(uv, {5, 9}, 4, seed);
        const float grain = fbmUv(uv, {90, 90}, 2, seed + 1u);
        Texel t;
        t.color = color * (1 + 0.05f * trowel + 0.03f * grain);
        t.height = 0.0016f * trowel + 0.00035f * grain;
        t.roughness = 0.9f;
        return t;
    };
}

TexelFunction weave(glm::vec3 color, int threads, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const glm::vec2 p = uv * static_cast<float>(threads);
        const glm::ivec2 cell(glm::floor(p));
        const glm::vec2 f = p - glm::floor(p) - 0.5f;
        // Plain weave: warp and weft take turns on top.
        const bool warp = ((cell.x + cell.y) & 1) == 0;
        const float across = warp ? f.x : f.y, along = warp ? f.y : f.x;
        const float bulge = std::sqrt(std::max(0.0f, 1 - 4 * across * across)) *
                            (0.6f + 0.4f * std::cos(along * tau * 0.5f));
        Texel t;
        const float tone = hash01(warp ? cell.x : cell.y, warp ? 1 : 2, seed);
        t.color = color * (0.72f + 0.3f * bulge) * (0.92f + 0.16f * tone);
        t.height = 0.00025f * bulge;
        t.roughness = 0.85f;
        return t;
    };
}

TexelFunction leather(glm::vec3 color, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const Cells grain = cells(uv * 40.0f, {40, 40}, seed);
        const float crease = 1 - smooth(0.0f, 0.22f, grain.second - grain.nearest);
        const float wear = fbmUv(uv, {3, 3}, 4, seed + 4u);
        Texel t;
        t.color = color * (1 - 0.35f * crease + 0.5f * wear);
        t.height = -0.00018f * crease;
        t.roughness = saturate(0.42f + 0.2f * crease + 0.25f * wear);
        return t;
    };
}

TexelFunction foliage(glm::vec3 color, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const float patch = fbmUv(uv, {6, 6}, 5, seed);
        const float tufts = fbmUv(uv, {60, 60}, 3, seed + 1u);
        Texel t;
        t.color = glm::mix(color, color * glm::vec3(1.5f, 1.15f, 0.7f), saturate(0.5f + patch));
        t.color *= 1 + 0.7f * tufts;
        t.height = 0.05f * tufts;
        t.roughness = 0.95f;
        return t;
    };
}

}  // namespace gp::make_scene
