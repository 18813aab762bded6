#include "rock.h"

#include "noise.h"
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace gp::make_scene {

Mesh rock(int subdivisions, std::uint32_t seed)
{
    Mesh mesh = cubeSphere(subdivisions);
    const float offset = static_cast<float>(seed) * 17.3f;
    for (glm::vec3& p : mesh.positions) {
        const glm::vec3 q = p * 1.3f + offset;
        const float ridge = 1.0f - std::abs(noise(q * 2.1f, seed));
        const float radius = 0.72f + 0.55f * fbm(q, 4, seed) + 0.16f * ridge * ridge +
                             0.03f * fbm(q * 9.0f, 3, seed + 7u);
        p *= std::max(0.2f, radius) * glm::vec3(1.0f, 0.72f, 0.9f);
    }
    mesh.computeSmoothNormals();
    return mesh;
}

}  // namespace gp::make_scene
