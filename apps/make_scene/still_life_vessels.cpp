#include "shapes.h"
#include "still_life.h"

#include "noise.h"

#include <algorithm>

namespace gp::make_scene {

Vessel carafe()
{
    const Profile outside = smoothProfile({{0, 0},
                                           {0.050f, 0, true},
                                           {0.057f, 0.006f},
                                           {0.070f, 0.045f},
                                           {0.072f, 0.080f},
                                           {0.060f, 0.130f},
                                           {0.034f, 0.178f},
                                           {0.0245f, 0.215f},
                                           {0.0255f, 0.250f},
                                           {0.0355f, 0.290f},
                                           {0.0372f, 0.2945f}},
                                          6);
    const Profile inside = smoothProfile({{0.0372f, 0.2945f},
                                          {0.0362f, 0.2962f},
                                          {0.0348f, 0.2945f},
                                          {0.0232f, 0.250f},
                                          {0.0222f, 0.215f},
                                          {0.0314f, 0.178f},
                                          {0.0572f, 0.130f},
                                          {0.0690f, 0.080f},
                                          {0.0668f, 0.045f},
                                          {0.0500f, 0.013f},
                                          {0, 0.010f}},
                                         6);
    Profile shell = outside;
    shell.insert(shell.end(), inside.begin() + 1, inside.end());

    // The water follows the inside upwards. The gap keeps the two boundaries apart: a ray then
    // always leaves one medium before it enters the other.
    constexpr float gap = 0.0003f, level = 0.128f;
    Profile water;
    for (auto it = inside.rbegin(); it != inside.rend() && it->height < level; ++it)
        water.push_back({std::max(0.0f, it->radius - gap), it->height + gap});
    const float edge = water.back().radius;
    water.push_back({edge - 0.0004f, level, true});
    water.push_back({edge - 0.0035f, level - 0.0012f});  // the meniscus climbs the glass
    water.push_back({edge - 0.009f, level - 0.0016f});
    water.push_back({0, level - 0.0016f});
    return {lathe(shell, 96), lathe(water, 96)};
}

Mesh bowl()
{
    return lathe(smoothProfile({{0, 0.006f},
                                {0.040f, 0.004f},
                                {0.044f, 0, true},
                                {0.050f, 0, true},
                                {0.051f, 0.010f},
                                {0.060f, 0.018f},
                                {0.104f, 0.034f},
                                {0.140f, 0.066f},
                                {0.156f, 0.100f},
                                {0.1575f, 0.1035f},
                                {0.155f, 0.1055f},
                                {0.1525f, 0.1035f},
                                {0.135f, 0.070f},
                                {0.100f, 0.041f},
                                {0.050f, 0.024f},
                                {0, 0.020f}},
                               4),
                 112);
}

Image bowlPainting()
{
    const glm::vec3 glaze = srgb(0xede6d6), blue = srgb(0x1f3f86);
    return bakeColor({1024, 512}, [=](glm::vec2 uv) {
        const float wobble = 0.004f * noise(uv * glm::vec2(24, 6), {24, 6}, 5u);
        const float v = uv.y + wobble;
        const auto band = [v](float from, float to) {
            return glm::smoothstep(from - 0.002f, from + 0.002f, v) *
                   (1 - glm::smoothstep(to - 0.002f, to + 0.002f, v));
        };
        // By arc length the foot ends near 0.13, the rim lies about 0.53.
        float ink = band(0.485f, 0.505f) + band(0.455f, 0.461f) + band(0.20f, 0.206f);
        // A row of leaves around the belly, painted with a brush: darker where it set down.
        const float turn = uv.x * 26.0f;
        const float petal = turn - std::floor(turn) - 0.5f;
        const float along = (v - 0.30f) / 0.13f;
        if (along > 0.0f && along < 1.0f) {
            const float width = 0.36f * std::pow(along, 0.6f) * (1 - along) * 2.6f;
            const float inside = 1 - std::abs(petal) / std::max(width, 1e-3f);
            ink += glm::smoothstep(0.0f, 0.12f, inside) * (0.65f + 0.35f * along);
        }
        ink += band(0.575f, 0.583f);
        const float wash = 0.75f + 0.25f * fbm(uv * glm::vec2(40, 20), {40, 20}, 3, 8u);
        const float speck = fbm(uv * glm::vec2(90, 60), {90, 60}, 2, 9u) > 0.42f ? 0.75f : 1.0f;
        return glm::mix(glaze * speck, blue, std::min(ink, 1.0f) * wash);
    });
}

Mesh goblet()
{
    return lathe(smoothProfile({{0, 0.004f},
                                {0.036f, 0.001f},
                                {0.042f, 0, true},
                                {0.0435f, 0.003f, true},
                                {0.030f, 0.009f},
                                {0.012f, 0.022f},
                                {0.0075f, 0.045f},
                                {0.0085f, 0.058f},
                                {0.0165f, 0.066f},
                                {0.0085f, 0.074f},
                                {0.0095f, 0.084f},
                                {0.030f, 0.103f},
                                {0.041f, 0.130f},
                                {0.0425f, 0.165f},
                                {0.0455f, 0.196f},
                                {0.0448f, 0.1975f},
                                {0.0437f, 0.196f},
                                {0.0407f, 0.165f},
                                {0.0390f, 0.130f},
                                {0.0270f, 0.107f},
                                {0, 0.096f}},
                               4),
                 104);
}

}  // namespace gp::make_scene
