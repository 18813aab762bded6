// Fruit skins and leaves.
#include "noise.h"
#include "textures.h"

#include <algorithm>
#include <cmath>

namespace gp::make_scene {
namespace {

float saturate(float x) { return std::clamp(x, 0.0f, 1.0f); }

float fbmUv(glm::vec2 uv, glm::ivec2 frequency, int octaves, std::uint32_t seed)
{
    return fbm(uv * glm::vec2(frequency), frequency, octaves, seed);
}

// Inside a leaf with a stalk at the origin, pointing along +y, `length` long: 0..1, else below 0.
float leafShape(glm::vec2 p, float length)
{
    const float t = p.y / length;
    if (t <= 0.0f || t >= 1.0f)
        return -1.0f;
    // Widest at a third, pointed at the tip, three shallow lobes.
    const float width = 0.42f * length * std::pow(t, 0.45f) * std::pow(1 - t, 0.8f) *
                        (1.0f + 0.22f * std::cos(t * 15.0f));
    return 1 - std::abs(p.x) / std::max(width, 1e-4f);
}

}  // namespace

TexelFunction appleSkin(glm::vec3 blush, glm::vec3 ground, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const float streak = fbmUv(uv, {46, 3}, 3, seed);
        const float patch = fbmUv(uv, {3, 2}, 3, seed + 1u);
        const float pole = glm::smoothstep(0.84f, 0.97f, uv.y) +
                           1.0f - glm::smoothstep(0.03f, 0.16f, uv.y);
        const float red = saturate(0.78f + 1.1f * streak + 1.0f * patch - 1.1f * pole);
        const Cells spot = cells(uv * glm::vec2(44, 30), {44, 30}, seed + 2u);
        const float dot = 1 - glm::smoothstep(0.05f, 0.11f, spot.nearest);
        Texel t;
        t.color = glm::mix(ground, blush * (1 + 0.35f * streak), red);
        t.color = glm::mix(t.color, ground * 1.15f, 0.55f * dot);
        t.height = 0.00012f * fbmUv(uv, {12, 8}, 3, seed + 3u);
        t.roughness = 0.34f + 0.1f * dot;
        return t;
    };
}

TexelFunction citrusSkin(glm::vec3 color, float dimples, std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const Cells pore = cells(uv * glm::vec2(90, 45), {90, 45}, seed);
        const float dent = 1 - glm::smoothstep(0.0f, 0.5f, pore.nearest);
        const float tone = fbmUv(uv, {4, 3}, 3, seed + 1u);
        Texel t;
        t.color = color * (1 + 0.18f * tone) * (1 - 0.16f * dent);
        t.height = -dimples * dent + 0.0006f * fbmUv(uv, {6, 4}, 3, seed + 2u);
        t.roughness = 0.38f + 0.1f * dent;
        return t;
    };
}

TexelFunction pearSkin(std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        const Cells spot = cells(uv * glm::vec2(60, 60), {60, 60}, seed);
        const float freckle = 1 - glm::smoothstep(0.08f, 0.18f, spot.nearest);
        const float patch = fbmUv(uv, {3, 3}, 4, seed + 1u);
        const float russet = glm::smoothstep(0.82f, 0.98f, uv.y + 0.12f * patch);
        Texel t;
        const glm::vec3 green = srgb(0xb9b545), yellow = srgb(0xdcc25a), brown = srgb(0x8a6233);
        t.color = glm::mix(green, yellow, saturate(0.5f + 1.4f * patch));
        t.color = glm::mix(t.color, srgb(0xc98a50), saturate(2.0f * patch - 0.2f) * 0.6f);
        t.color = glm::mix(t.color, brown, saturate(0.55f * freckle + russet));
        t.roughness = 0.46f + 0.25f * russet;
        t.height = 0.00015f * freckle + 0.0004f * patch;
        return t;
    };
}

TexelFunction ivy(std::uint32_t seed)
{
    return [=](glm::vec2 uv) {
        Texel t;
        t.alpha = 0.0f;
        t.color = srgb(0x3c5a22);  // also where it is cut away: filtering must not draw a rim
        t.roughness = 0.45f;
        const glm::vec2 p(uv.x - 0.5f - 0.03f * std::sin(uv.y * 12.566f), uv.y);
        if (std::abs(p.x) < 0.008f) {
            t.alpha = 1.0f;
            t.color = srgb(0x4a3a22);
        }
        constexpr int leaves = 14;
        for (int i = 0; i < leaves; ++i) {
            const float side = i % 2 == 0 ? 1.0f : -1.0f;
            const float at = (static_cast<float>(i) + 0.5f) / leaves;
            const float angle = side * (0.9f + 0.7f * hash01(i, 1, seed));
            const float length = 0.20f + 0.12f * hash01(i, 2, seed);
            glm::vec2 q = p - glm::vec2(0.0f, at);
            q.y -= std::round(q.y);  // leaves at one end reach into the next repeat
            // Pictures are taller than wide by four: undo it, or leaves are squashed.
            q.y *= 4.0f;
            const glm::vec2 local(q.x * std::cos(angle) - q.y * std::sin(angle),
                                  q.x * std::sin(angle) + q.y * std::cos(angle));
            const float inside = leafShape(local, length * 1.5f);
            if (inside <= 0.0f)
                continue;
            const float vein = 1 - glm::smoothstep(0.0f, 0.1f, 1 - inside);
            t.alpha = 1.0f;
            t.color = glm::mix(srgb(0x2f5a20), srgb(0x6f8f38), hash01(i, 3, seed)) *
                      (0.8f + 0.35f * vein);
            t.height = -0.001f * (1 - inside) * (1 - inside);
        }
        return t;
    };
}

}  // namespace gp::make_scene
