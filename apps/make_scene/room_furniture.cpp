#include "noise.h"
#include "room.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace gp::make_scene {
namespace {

void addBoard(Mesh& mesh, glm::vec3 size, glm::vec3 centre, glm::vec2 grain, float edge = 0.004f)
{
    Mesh board = box(size, edge, 2);
    grainUv(board, grain);
    mesh.append(board.transform(translation(centre)));
}

void addLeg(Mesh& mesh, glm::vec3 foot, glm::vec3 top, float footRadius, float topRadius)
{
    Mesh leg = tube({foot, top}, {footRadius, topRadius}, 20);
    grainUv(leg, {foot.x, foot.z});
    mesh.append(leg);
}

}  // namespace

void grainUv(Mesh& mesh, glm::vec2 offset) { mesh.scaleUv({1 / 1.2f, 1 / 0.4f}, offset); }

Mesh diningTable()
{
    Mesh mesh;
    for (int i = 0; i < 5; ++i)
        addBoard(mesh, {1.6f, 0.032f, 0.178f},
                 {0, 0.724f, -0.358f + 0.179f * static_cast<float>(i)},
                 {0.31f * static_cast<float>(i), 0.17f * static_cast<float>(i)});
    for (const float z : {-0.34f, 0.34f})
        addBoard(mesh, {1.34f, 0.08f, 0.022f}, {0, 0.668f, z}, {0.2f, z});
    for (const float x : {-0.67f, 0.67f})
        addBoard(mesh, {0.022f, 0.08f, 0.66f}, {x, 0.668f, 0}, {0.6f, x});
    for (const float x : {-0.68f, 0.68f})
        for (const float z : {-0.35f, 0.35f})
            addLeg(mesh, {x * 1.06f, 0, z * 1.06f}, {x, 0.71f, z}, 0.020f, 0.033f);
    return mesh;
}

Mesh chair()
{
    Mesh mesh;
    addBoard(mesh, {0.43f, 0.03f, 0.42f}, {0, 0.445f, 0}, {0.1f, 0.2f}, 0.012f);
    for (const float x : {-0.17f, 0.17f}) {
        addLeg(mesh, {x * 1.12f, 0, 0.19f}, {x, 0.44f, 0.16f}, 0.012f, 0.019f);
        addLeg(mesh, {x * 1.12f, 0, -0.22f}, {x, 0.44f, -0.17f}, 0.012f, 0.019f);
        // The back leans away a little more towards the top.
        std::vector<glm::vec3> post;
        for (int i = 0; i <= 6; ++i) {
            const float t = static_cast<float>(i) / 6.0f;
            post.push_back({x * (1.0f + 0.06f * t), 0.45f + 0.41f * t,
                            -0.175f - 0.05f * t - 0.05f * t * t});
        }
        Mesh bent = tube(post, {0.016f}, 16);
        grainUv(bent, {x, 0.4f});
        mesh.append(bent);
        addLeg(mesh, {x * 1.05f, 0.22f, 0.17f}, {x * 1.05f, 0.22f, -0.19f}, 0.008f, 0.008f);
    }
    for (int i = 0; i < 3; ++i) {
        const float t = 0.42f + 0.26f * static_cast<float>(i);
        Mesh slat = surface(13, 2, [](glm::vec2 uv) {
            const float a = (uv.x - 0.5f) * 2.0f;
            return glm::vec3(a * 0.172f, (uv.y - 0.5f) * 0.07f, -0.03f * (1 - a * a));
        });
        // A curved slat of 14 mm: the front, the back, and the rims between them.
        Mesh back = slat;
        back.transform(translation(0, 0, -0.014f));
        back.flip();
        for (const float y : {-0.035f, 0.035f}) {
            Mesh rim = surface(13, 2, [y](glm::vec2 uv) {
                const float a = (uv.x - 0.5f) * 2.0f;
                return glm::vec3(a * 0.172f, y, -0.03f * (1 - a * a) - 0.014f * uv.y);
            });
            if (y < 0)
                rim.flip();
            slat.append(rim);
        }
        slat.append(back);
        slat.scaleUv({0.29f, 0.17f}, {0.2f * t, t});
        mesh.append(slat.transform(translation(0, 0.45f + 0.41f * t,
                                               -0.168f - 0.05f * t - 0.05f * t * t)));
    }
    return mesh;
}

Mesh shelf()
{
    Mesh mesh;
    for (const float x : {-0.588f, 0.588f})
        addBoard(mesh, {0.024f, 2.0f, 0.3f}, {x, 1.0f, 0.15f}, {x, 0.1f});
    for (int i = 0; i < 6; ++i)
        addBoard(mesh, {1.152f, 0.024f, 0.29f}, {0, 0.06f + 0.385f * static_cast<float>(i), 0.15f},
                 {0.17f * static_cast<float>(i), 0.3f});
    addBoard(mesh, {1.152f, 1.95f, 0.008f}, {0, 1.0f, 0.006f}, {0.5f, 0.5f}, 0.001f);
    return mesh;
}

std::array<Mesh, bookColors> shelfBooks(std::uint32_t seed)
{
    std::array<Mesh, bookColors> books;
    Random random(seed);
    for (int row = 0; row < 5; ++row) {
        const float floor = 0.072f + 0.385f * static_cast<float>(row);
        float x = -0.57f;
        const float end = random.uniform(0.15f, 0.55f);  // the rest of the row stays free
        while (x < end) {
            const float thick = random.uniform(0.016f, 0.048f);
            const float height = random.uniform(0.20f, 0.30f);
            const float deep = random.uniform(0.15f, 0.21f);
            Mesh cover = box({thick, height, deep}, 0.003f, 2);
            // Now and then one leans on its neighbour; its lower corner stays on the board.
            const float lean = random.uniform() > 0.88f ? 0.16f : 0.0f;
            const float lift = 0.5f * (height * std::cos(lean) + thick * std::sin(lean));
            cover.transform(translation(x + 0.5f * thick + 0.5f * height * std::sin(lean),
                                        floor + lift, 0.04f + 0.5f * deep) *
                            rotationZ(lean));
            books[static_cast<std::size_t>(random.below(bookColors))].append(cover);
            x += thick + 0.0015f + height * std::sin(lean);
        }
    }
    return books;
}

FloorLamp floorLamp()
{
    FloorLamp lamp;
    lamp.metal = lathe(smoothProfile({{0, 0},
                                      {0.15f, 0, true},
                                      {0.15f, 0.012f, true},
                                      {0.13f, 0.020f},
                                      {0.03f, 0.030f},
                                      {0.012f, 0.05f, true},
                                      {0.011f, 1.42f, true},
                                      {0.022f, 1.43f},
                                      {0.022f, 1.47f},
                                      {0, 1.475f}},
                                     5),
                       48);
    lamp.shade = lathe({{0.235f, 1.36f, true},
                        {0.155f, 1.68f, true},
                        {0.152f, 1.68f, true},
                        {0.232f, 1.36f, true},
                        {0.235f, 1.36f, true}},
                       72);
    lamp.bulb = sphere(0.045f, 32, 20);
    lamp.bulb.transform(translation(0, 1.52f, 0));
    return lamp;
}

}  // namespace gp::make_scene
