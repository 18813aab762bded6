#include "noise.h"

#include <algorithm>
#include <cmath>

namespace gp::make_scene {
namespace {

// A period of 0 means none.
int wrap(int value, int period)
{
    return period > 0 ? ((value % period) + period) % period : value;
}

// [Perlin 2002, "Improving noise", eq. 4]: second derivative zero at both ends, no visible lattice.
float fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

float gradientDot(int x, int y, std::uint32_t seed, glm::vec2 offset)
{
    const float angle = hash01(x, y, seed) * 6.2831853f;
    return std::cos(angle) * offset.x + std::sin(angle) * offset.y;
}

float gradientDot(glm::ivec3 cell, std::uint32_t seed, glm::vec3 offset)
{
    const std::uint32_t plane = hash(static_cast<std::uint32_t>(cell.z) ^ seed);
    const float z = hash01(cell.x, cell.y, plane) * 2.0f - 1.0f;
    const float angle = hash01(cell.x, cell.y, plane + 1u) * 6.2831853f;
    const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
    return glm::dot(glm::vec3(r * std::cos(angle), r * std::sin(angle), z), offset);
}

}  // namespace

std::uint32_t hash(std::uint32_t value)
{
    // [Jarzynski and Olano 2020, JCGT 9(3), "Hash functions for GPU rendering", listing "pcg"]
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

float hash01(int x, int y, std::uint32_t seed)
{
    const std::uint32_t row = hash(static_cast<std::uint32_t>(y) + hash(seed));
    return static_cast<float>(hash(static_cast<std::uint32_t>(x) + row) >> 8) * 0x1p-24f;
}

float noise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed)
{
    const glm::vec2 base = glm::floor(p);
    const glm::vec2 f = p - base;
    const int x0 = wrap(static_cast<int>(base.x), period.x), x1 = wrap(x0 + 1, period.x);
    const int y0 = wrap(static_cast<int>(base.y), period.y), y1 = wrap(y0 + 1, period.y);
    const float bottom = glm::mix(gradientDot(x0, y0, seed, f),
                                  gradientDot(x1, y0, seed, f - glm::vec2(1, 0)), fade(f.x));
    const float top = glm::mix(gradientDot(x0, y1, seed, f - glm::vec2(0, 1)),
                               gradientDot(x1, y1, seed, f - glm::vec2(1, 1)), fade(f.x));
    return 1.41421356f * glm::mix(bottom, top, fade(f.y));
}

float noise(glm::vec3 p, std::uint32_t seed)
{
    const glm::vec3 base = glm::floor(p);
    const glm::vec3 f = p - base;
    const glm::ivec3 cell(base);
    float plane[2];
    for (int k = 0; k < 2; ++k) {
        float row[2];
        for (int j = 0; j < 2; ++j) {
            const glm::ivec3 left = cell + glm::ivec3(0, j, k), right = cell + glm::ivec3(1, j, k);
            row[j] = glm::mix(gradientDot(left, seed, f - glm::vec3(0, j, k)),
                              gradientDot(right, seed, f - glm::vec3(1, j, k)), fade(f.x));
        }
        plane[k] = glm::mix(row[0], row[1], fade(f.y));
    }
    return 1.2f * glm::mix(plane[0], plane[1], fade(f.z));
}

float fbm(glm::vec2 p, glm::ivec2 period, int octaves, std::uint32_t seed)
{
    float sum = 0.0f, height = 0.5f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += height * noise(p, period, seed + static_cast<std::uint32_t>(octave) * 101u);
        p *= 2.0f;
        period *= 2;
        height *= 0.5f;
    }
    return sum;
}

float fbm(glm::vec3 p, int octaves, std::uint32_t seed)
{
    float sum = 0.0f, height = 0.5f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += height * noise(p, seed + static_cast<std::uint32_t>(octave) * 101u);
        p *= 2.03f;  // not quite 2, or the zeros of all octaves fall on one lattice
        height *= 0.5f;
    }
    return sum;
}

Cells cells(glm::vec2 p, glm::ivec2 period, std::uint32_t seed)
{
    // [Worley 1996, "A cellular texture basis function"]
    const glm::vec2 base = glm::floor(p);
    Cells result;
    result.nearest = result.second = 1e9f;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const int x = wrap(static_cast<int>(base.x) + i, period.x);
            const int y = wrap(static_cast<int>(base.y) + j, period.y);
            const glm::vec2 point(hash01(x, y, seed), hash01(x, y, seed + 1u));
            const float d = glm::length(base + glm::vec2(i, j) + point - p);
            if (d < result.nearest) {
                result.second = result.nearest;
                result.nearest = d;
                result.id = hash01(x, y, seed + 2u);
            } else {
                result.second = std::min(result.second, d);
            }
        }
    return result;
}

}  // namespace gp::make_scene
