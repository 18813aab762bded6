#include "corridor.h"
#include "noise.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp::make_scene {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

void addStone(Mesh& mesh, glm::vec3 size, const glm::mat4& place, Random& random)
{
    // Hewn by hand: no two alike, none quite straight.
    const glm::vec3 hewn = size * (1.0f + glm::vec3(random.uniform(-0.06f, 0.06f),
                                                    random.uniform(-0.01f, 0.0f),
                                                    random.uniform(-0.06f, 0.06f)));
    Mesh stone = box(hewn, 0.018f, 2);
    stone.scaleUv(glm::vec2(0.5f), {random.uniform(), random.uniform()});
    const glm::mat4 tilt = rotationY(random.uniform(-0.02f, 0.02f)) *
                           rotationZ(random.uniform(-0.012f, 0.012f));
    mesh.append(stone.transform(place * tilt));
}

}  // namespace

Mesh stoneRib(std::uint32_t seed)
{
    Random random(seed);
    Mesh rib;
    const float deep = 0.42f, out = 0.22f;
    constexpr int courses = 5, wedges = 15;
    const float course = corridorSpring / courses;
    for (const float side : {-1.0f, 1.0f}) {
        for (int i = 0; i < courses; ++i) {
            const float wide = i == 0 ? 1.25f : 1.0f;  // the foot is broader
            addStone(rib, {out * wide + 0.1f, course, deep * wide},
                     translation(side * (corridorHalfWidth - 0.5f * out * wide + 0.05f),
                                 course * (static_cast<float>(i) + 0.5f), 0),
                     random);
        }
        addStone(rib, {out + 0.22f, 0.12f, deep + 0.12f},  // the capital
                 translation(side * (corridorHalfWidth - 0.5f * out + 0.02f), corridorSpring, 0),
                 random);
    }
    const float middle = corridorHalfWidth - 0.5f * out + 0.05f;
    const float arc = pi * middle / wedges;
    for (int i = 0; i < wedges; ++i) {
        const float angle = pi * (static_cast<float>(i) + 0.5f) / wedges;
        const float key = i == wedges / 2 ? 1.25f : 1.0f;
        addStone(rib, {(out + 0.1f) * key, arc * 1.02f, deep * (key > 1 ? 1.12f : 1.0f)},
                 translation(middle * std::cos(angle),
                             corridorSpring + middle * std::sin(angle), 0) * rotationZ(angle),
                 random);
    }
    return rib;
}

Door door(std::uint32_t seed)
{
    Random random(seed);
    Door d;
    const float width = 1.06f, height = 2.02f;
    constexpr int planks = 6;
    for (int i = 0; i < planks; ++i) {
        const float w = width / planks;
        Mesh plank = box({0.05f, height, w - 0.004f}, 0.006f, 2);
        plank.scaleUv({1 / 1.2f, 1 / 0.4f}, {random.uniform(), random.uniform()});
        d.planks.append(plank.transform(translation(
            0.05f + random.uniform(0, 0.006f), height / 2,
            -width / 2 + w * (static_cast<float>(i) + 0.5f))));
    }
    for (const float y : {0.38f, 1.02f, 1.66f}) {
        Mesh band = box({0.012f, 0.075f, width * 0.94f}, 0.003f, 1);
        d.iron.append(band.transform(translation(0.084f, y, 0)));
        for (int i = 0; i < planks; ++i) {
            Mesh nail = sphere(0.014f, 14, 8);
            d.iron.append(nail.transform(translation(
                0.090f, y, -width / 2 + width / planks * (static_cast<float>(i) + 0.5f))));
        }
    }
    Mesh ring = torus(0.062f, 0.009f, 36, 12);
    d.iron.append(ring.transform(translation(0.108f, 0.98f, 0.38f) * rotationZ(pi / 2 + 0.2f)));
    for (const float side : {-1.0f, 1.0f})
        for (int i = 0; i < 5; ++i) {
            const float deep = i % 2 == 0 ? 0.27f : 0.20f;  // quoins: long and short in turn
            addStone(d.frame, {0.16f, height / 5, deep},
                     translation(0.06f, height / 5 * (static_cast<float>(i) + 0.5f),
                                 side * (width / 2 + 0.5f * deep)),
                     random);
        }
    addStone(d.frame, {0.20f, 0.28f, width + 0.62f}, translation(0.07f, height + 0.14f, 0), random);
    return d;
}

}  // namespace gp::make_scene
