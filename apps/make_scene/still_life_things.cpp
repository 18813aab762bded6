#include "noise.h"
#include "shapes.h"
#include "still_life.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

struct Hull {
    float length, bottom, height, halfWidth;
    float bluntness;  // 2: an ellipse seen from the side; more: fuller
    float peak;       // where along the length it is highest, 0 to 1
};

float signedPower(float x, float exponent)
{
    return std::copysign(std::pow(std::abs(x), exponent), x);
}

// A streamlined body along X (front at -X), rounded at both ends.
Mesh hull(const Hull& h)
{
    return surface(57, 41, [=](glm::vec2 uv) {
        const float turn = uv.x >= 1.0f ? 0.0f : 2 * pi * uv.x;
        // Cosine spacing: the caps need the columns.
        const float t = uv.y >= 1.0f ? 1.0f : 0.5f - 0.5f * std::cos(pi * uv.y);
        const float s = std::abs(2 * t - 1);
        const float cap = std::pow(std::max(0.0f, 1 - std::pow(s, h.bluntness)),
                                   1.0f / h.bluntness);
        const float away = (t - h.peak) / (t < h.peak ? h.peak : 1 - h.peak);
        const float rise = cap * (1.0f - 0.35f * away * away);
        const float across = signedPower(-std::cos(turn), 0.75f);
        const float up = signedPower(std::sin(turn), 0.75f);
        return glm::vec3((t - 0.5f) * h.length,
                         h.bottom + 0.45f * h.height + up * h.height * (up > 0 ? 0.55f * rise
                                                                               : 0.45f * cap),
                         across * h.halfWidth * cap);
    });
}

Mesh wheelRim(float radius)
{
    // A domed disc with a raised boss, turned around the axle.
    return lathe(smoothProfile({{0, -0.003f},
                                {radius * 0.62f, -0.003f, true},
                                {radius * 0.62f, 0.0015f, true},
                                {radius * 0.40f, 0.0005f},
                                {radius * 0.20f, 0.0040f},
                                {0, 0.0052f}},
                               5),
                 40);
}

}  // namespace

ToyCar toyCar()
{
    ToyCar car;
    car.paint = hull({0.200f, 0.014f, 0.046f, 0.034f, 2.6f, 0.62f});
    car.glass = hull({0.092f, 0.036f, 0.044f, 0.0245f, 2.3f, 0.45f});
    car.glass.transform(translation(0.014f, 0, 0));
    Mesh roof = hull({0.082f, 0.060f, 0.0225f, 0.0225f, 2.2f, 0.45f});
    car.paint.append(roof.transform(translation(0.015f, 0, 0)));
    const float radius = 0.0195f;
    for (const float side : {-1.0f, 1.0f})
        for (const float x : {-0.058f, 0.056f}) {
            const glm::mat4 axle = translation(x, radius, side * 0.036f) *
                                   rotationX(side * pi / 2);
            Mesh tyre = torus(radius * 0.74f, radius * 0.26f, 48, 20);
            car.rubber.append(tyre.transform(axle * scaling({1, 1.25f, 1})));
            car.chrome.append(wheelRim(radius).transform(axle));
            Mesh fender = sphere(1.0f, 40, 24);
            fender.transform(translation(x, radius + 0.008f, side * 0.031f) *
                             scaling({0.034f, 0.0215f, 0.0125f}));
            car.paint.append(fender);
        }
    for (const float side : {-1.0f, 1.0f}) {
        Mesh lamp = sphere(0.0066f, 28, 16);
        lamp.transform(translation(-0.083f, 0.042f, side * 0.0195f) *
                       scaling({1.5f, 1.0f, 1.0f}));
        car.chrome.append(lamp);
    }
    Mesh front = tube({{-0.094f, 0.020f, -0.036f}, {-0.104f, 0.020f, -0.020f},
                       {-0.106f, 0.020f, 0.0f}, {-0.104f, 0.020f, 0.020f},
                       {-0.094f, 0.020f, 0.036f}},
                      {0.0024f}, 12);
    car.chrome.append(front);
    return car;
}

Book book()
{
    // 0.21 x 0.15 m, 32 mm thick, the spine towards -X.
    Book b;
    const float thick = 0.032f, board = 0.003f;
    Mesh pages = box({0.146f, thick - 2 * board, 0.198f}, 0.0008f, 1);
    b.pages = pages.transform(translation(0, thick / 2, 0));
    for (const float y : {board / 2, thick - board / 2}) {
        Mesh cover = box({0.154f, board, 0.21f}, 0.0012f, 2);
        b.cover.append(cover.transform(translation(0.002f, y, 0)));
    }
    Mesh spine = cylinder(thick / 2, -0.105f, 0.105f, 40, 0.001f);
    b.cover.append(spine.transform(translation(-0.073f, thick / 2, 0) * rotationX(pi / 2) *
                                   scaling({0.45f, 1, 1})));
    for (int i = 0; i < 4; ++i) {
        Mesh band = cylinder(thick / 2 + 0.0012f, -0.0022f, 0.0022f, 40, 0.0008f);
        const float z = -0.066f + 0.044f * static_cast<float>(i);
        b.bands.append(band.transform(translation(-0.073f, thick / 2, z) * rotationX(pi / 2) *
                                      scaling({0.46f, 1, 1})));
    }
    return b;
}

Mesh cloth(float edge)
{
    constexpr float width = 0.30f, back = 0.0f, hanging = 0.25f, bend = 0.014f;
    return surface(91, 111, [=](glm::vec2 uv) {
        const float flat = edge - back, corner = bend * pi / 2;
        // The far corner lies askew, or the piece looks cut out with a ruler.
        const float s = uv.y * (flat + corner + hanging) * (1 - 0.06f * uv.x * uv.y);
        const float x0 = (uv.x - 0.5f) * width;
        // Folds run along the length; they deepen where the cloth was pushed together (at the
        // back) and where nothing holds it (over the edge).
        const float bunch = std::exp(-s / 0.10f);
        const float free = glm::smoothstep(flat - 0.10f, flat + 0.10f, s);
        const float wander =
            0.9f * std::sin(s * 9.0f) + 1.5f * fbm(glm::vec3(x0 * 7, s * 6, 1), 3, 4u);
        const float wave = 0.5f + 0.5f * std::sin(uv.x * 21.0f + 1.4f * wander + 2.2f * bunch);
        const float crumple = fbm(glm::vec3(x0 * 24.0f, s * 20.0f, 3.0f), 3, 6u);
        const float fold = (0.0045f + 0.034f * bunch + 0.034f * free) * wave +
                           (0.004f + 0.010f * bunch) * std::max(0.0f, crumple + 0.25f);
        const float hem = 0.012f * std::sin(uv.x * 9.0f + 1.0f);
        const float gather = 1.0f - 0.16f * bunch - 0.14f * free;
        const float x = x0 * gather + 0.05f * (s - flat) + 0.02f * std::sin(s * 7.0f);
        const float lift = 0.0018f + fold;
        if (s < flat)
            return glm::vec3(x, lift, back + s + hem * bunch);
        if (s < flat + corner) {
            const float a = (s - flat) / bend;
            return glm::vec3(x, -bend + (bend + lift) * std::cos(a),
                             edge + (bend + lift) * std::sin(a));
        }
        const float drop = s - flat - corner;
        return glm::vec3(x, -bend - drop + hem * free, edge + bend + lift);
    });
}

}  // namespace gp::make_scene
