#include "scene/sky_pyramid.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "shading/shading.h"

namespace gp {
namespace {

// Irradiance turns slowly: from faces of 16 texels, read bilinearly, it is off by 0.4 % of its
// mean, and by less because light is taken from texels of faces of 32.
constexpr uint32_t irradianceSize = 16, irradianceSource = 32;

// Over the solid angle of the whole sphere that a texel in the middle of a face has.
float solidAngle(uint32_t size, uint32_t x, uint32_t y) {
    const float s = (float(x) + 0.5f) * 2.0f / float(size) - 1.0f;
    const float t = (float(y) + 0.5f) * 2.0f / float(size) - 1.0f;
    const float square = 1.0f + s * s + t * t;
    return 1.0f / (square * std::sqrt(square));
}

glm::vec3 towards(uint32_t size, uint32_t face, float x, float y) {
    return shading::cube_direction(face, {(x + 0.5f) / float(size), (y + 0.5f) / float(size)});
}

struct Faces {
    SkyLevel& level;

    size_t row() const { return level.size + 2; }
    // x, y: -1 to size
    glm::vec3& at(uint32_t face, int x, int y) const {
        return level.texels[(face * row() + size_t(y + 1)) * row() + size_t(x + 1)];
    }

    // The texel on the other side of the edge: a hair beyond it, so that it is the one that is
    // next to the edge there.
    glm::vec3 beyond(uint32_t face, int x, int y) const {
        constexpr float hair = 1e-4f;
        const int n = int(level.size);
        const auto edge = [&](int i) {
            return i < 0 ? -0.5f - hair : i == n ? float(n) - 0.5f + hair : float(i);
        };
        const shading::CubePoint p =
            shading::cube_point(towards(level.size, face, edge(x), edge(y)));
        const auto texel = [&](float st) { return std::clamp(int(st * float(n)), 0, n - 1); };
        return at(p.face, texel(p.st.x), texel(p.st.y));
    }

    void fillBorders() const {
        const int n = int(level.size);
        for (uint32_t face = 0; face < 6; ++face) {
            for (int i = 0; i < n; ++i) {
                at(face, -1, i) = beyond(face, -1, i), at(face, n, i) = beyond(face, n, i);
                at(face, i, -1) = beyond(face, i, -1), at(face, i, n) = beyond(face, i, n);
            }
            // Three faces meet: each sees the mean of all there.
            for (const int x : {-1, n})
                for (const int y : {-1, n}) {
                    const int ix = std::clamp(x, 0, n - 1), iy = std::clamp(y, 0, n - 1);
                    at(face, x, y) = (at(face, ix, iy) + at(face, x, iy) + at(face, ix, y)) / 3.0f;
                }
        }
    }
};

SkyLevel emptyLevel(uint32_t size) {
    SkyLevel level;
    level.size = size;
    level.texels.assign(size_t(6) * (size + 2) * (size + 2), glm::vec3(0));
    return level;
}

SkyLevel levelOf(const CubeMap& cube) {
    SkyLevel level = emptyLevel(cube.size);
    const Faces faces{level};
    size_t next = 0;
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < cube.size; ++y)
            for (uint32_t x = 0; x < cube.size; ++x)
                faces.at(face, int(x), int(y)) = cube.texels[next++];
    faces.fillBorders();
    return level;
}

SkyLevel halved(SkyLevel& fine) {
    SkyLevel level = emptyLevel(fine.size / 2);
    const Faces from{fine}, to{level};
    tbb::parallel_for(0u, 6 * level.size, [&](uint32_t row) {
        const uint32_t face = row / level.size, y = row % level.size;
        for (uint32_t x = 0; x < level.size; ++x) {
            glm::vec3 sum(0);
            float weights = 0;
            for (uint32_t i = 0; i < 4; ++i) {
                const uint32_t fx = 2 * x + i % 2, fy = 2 * y + i / 2;
                const float w = solidAngle(fine.size, fx, fy);
                sum += from.at(face, int(fx), int(fy)) * w;
                weights += w;
            }
            to.at(face, int(x), int(y)) = sum / weights;
        }
    });
    to.fillBorders();
    return level;
}

struct Ray {
    glm::vec3 direction;
    float weight;
    glm::vec3 light;
};

std::vector<Ray> raysOf(SkyLevel& level) {
    const Faces faces{level};
    std::vector<Ray> rays;
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < level.size; ++y)
            for (uint32_t x = 0; x < level.size; ++x)
                rays.push_back({glm::normalize(towards(level.size, face, float(x), float(y))),
                                solidAngle(level.size, x, y), faces.at(face, int(x), int(y))});
    return rays;
}

// Divided by what a uniform sky would give, so that it gives just that.
SkyLevel irradianceOf(SkyLevel& source) {
    const std::vector<Ray> rays = raysOf(source);
    SkyLevel level = emptyLevel(irradianceSize);
    const Faces to{level};
    tbb::parallel_for(0u, 6 * level.size, [&](uint32_t row) {
        const uint32_t face = row / level.size, y = row % level.size;
        for (uint32_t x = 0; x < level.size; ++x) {
            const glm::vec3 n = glm::normalize(towards(level.size, face, float(x), float(y)));
            glm::vec3 sum(0);
            float weights = 0;
            for (const Ray& ray : rays) {
                const float w = std::max(glm::dot(n, ray.direction), 0.0f) * ray.weight;
                sum += ray.light * w;
                weights += w;
            }
            to.at(face, int(x), int(y)) = weights > 0 ? sum / weights : glm::vec3(0);
        }
    });
    to.fillBorders();
    return level;
}

}  // namespace

SkyPyramid makeSkyPyramid(const CubeMap& cube) {
    SkyPyramid pyramid;
    pyramid.levels.push_back(levelOf(cube));
    while (pyramid.levels.back().size > 1)
        pyramid.levels.push_back(halved(pyramid.levels.back()));
    for (SkyLevel& level : pyramid.levels)
        if (level.size <= irradianceSource) {
            pyramid.irradiance = irradianceOf(level);
            break;
        }
    return pyramid;
}

}  // namespace gp
