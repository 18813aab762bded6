#include "noise.h"
#include "shapes.h"
#include "still_life.h"

#include <cmath>

namespace gp::make_scene {
namespace {

// No fruit is a solid of revolution: swell it a little, the same everywhere around the seam.
void makeIrregular(Mesh& mesh, float amount, std::uint32_t seed)
{
    for (glm::vec3& p : mesh.positions) {
        const float swell = 1.0f + amount * fbm(p * 22.0f + 5.0f, 2, seed);
        p = glm::vec3(p.x * swell, p.y, p.z * swell);
    }
    mesh.computeSmoothNormals();
}

}  // namespace

Mesh apple()
{
    Mesh mesh = lathe(smoothProfile({{0, 0.008f},
                                     {0.008f, 0.005f},
                                     {0.015f, 0.0005f},
                                     {0.025f, 0.005f},
                                     {0.036f, 0.024f},
                                     {0.0395f, 0.044f},
                                     {0.035f, 0.062f},
                                     {0.024f, 0.0705f},
                                     {0.012f, 0.0685f},
                                     {0.005f, 0.062f},
                                     {0, 0.058f}},
                                    6),
                      72);
    for (glm::vec3& p : mesh.positions) {
        // Five weak ribs, strongest at the flower end.
        const float angle = std::atan2(p.z, p.x);
        const float rib = 1.0f + 0.018f * std::cos(5 * angle) * (1.0f - p.y / 0.08f);
        p = glm::vec3(p.x * rib, p.y, p.z * rib);
    }
    makeIrregular(mesh, 0.10f, 3u);
    return mesh;
}

Mesh pear()
{
    Mesh mesh = lathe(smoothProfile({{0, 0.005f},
                                     {0.010f, 0.002f},
                                     {0.018f, 0.0008f},
                                     {0.033f, 0.014f},
                                     {0.0385f, 0.034f},
                                     {0.033f, 0.056f},
                                     {0.021f, 0.078f},
                                     {0.0155f, 0.094f},
                                     {0.010f, 0.105f},
                                     {0, 0.107f}},
                                    6),
                      72);
    makeIrregular(mesh, 0.14f, 13u);
    return mesh;
}

Mesh lemon()
{
    Mesh mesh = lathe(smoothProfile({{0, 0},
                                     {0.004f, 0.0015f},
                                     {0.009f, 0.008f},
                                     {0.021f, 0.020f},
                                     {0.0275f, 0.040f},
                                     {0.023f, 0.060f},
                                     {0.011f, 0.074f},
                                     {0.0065f, 0.081f},
                                     {0, 0.0835f}},
                                    6),
                      72);
    makeIrregular(mesh, 0.08f, 23u);
    return mesh;
}

Mesh stem(float length, float radius)
{
    std::vector<glm::vec3> path;
    std::vector<float> radii;
    for (int i = 0; i <= 6; ++i) {
        const float t = static_cast<float>(i) / 6.0f;
        path.push_back(length * glm::vec3(0.30f * t * t, t, 0.08f * std::sin(3 * t)));
        radii.push_back(radius * (1.0f - 0.35f * t + (i == 6 ? 0.55f : 0.0f)));
    }
    return tube(path, radii, 10);
}

Mesh grapes(std::uint32_t seed)
{
    // Darts thrown into half an ellipsoid lying on the table; whoever hits a neighbour is out.
    Random random(seed);
    std::vector<glm::vec3> centres;
    const glm::vec3 extent(0.082f, 0.040f, 0.044f);
    const float radius = 0.0112f;
    for (int layer = 0; layer < 4; ++layer)
        for (int tries = 0; tries < 3000; ++tries) {
            const float height = radius + 0.0165f * static_cast<float>(layer);
            const glm::vec3 p(extent.x * random.uniform(-1, 1), height,
                              extent.z * random.uniform(-1, 1));
            // Narrower towards the tip, as a bunch is.
            const float taper = 0.75f - 0.25f * p.x / extent.x;
            const glm::vec3 q = p / (extent * glm::vec3(1, 1, taper));
            bool free = glm::dot(q, q) < 1.0f;
            for (const glm::vec3& other : centres)
                free = free && glm::length(p - other) > 1.86f * radius;
            if (free)
                centres.push_back(p);
        }
    Mesh mesh;
    for (const glm::vec3& centre : centres) {
        Mesh berry = sphere(radius * random.uniform(0.9f, 1.06f), 24, 14);
        const glm::vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), 0.4f);
        berry.transform(translation(centre) * rotationFromY(axis) *
                        scaling(glm::vec3(1.0f, random.uniform(1.0f, 1.12f), 1.0f)));
        mesh.append(berry);
    }
    return mesh;
}

Mesh grapeStalk()
{
    return tube({{-0.02f, 0.050f, 0}, {-0.055f, 0.056f, 0.004f}, {-0.085f, 0.054f, 0.010f},
                 {-0.105f, 0.046f, 0.020f}},
                {0.0016f, 0.0019f, 0.0022f, 0.0028f}, 10);
}

}  // namespace gp::make_scene
