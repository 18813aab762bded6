// Hashes and noises that the textures and the displaced meshes are made of. All of them are
// pure functions of their arguments, so that a scene comes out the same every time.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace gp::make_scene {

std::uint32_t hash(std::uint32_t value);
float hash01(int x, int y, std::uint32_t seed);  // in [0, 1)

// Gradient noise, about in [-1, 1]; the lattice repeats after `period` cells, so that a texture
// whose coordinates run over one period tiles without a seam.
float noise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed);
float noise(glm::vec3 p, std::uint32_t seed);

// Octaves of it, each of twice the frequency and half the height of the one before.
float fbm(glm::vec2 p, glm::ivec2 period, int octaves, std::uint32_t seed);
float fbm(glm::vec3 p, int octaves, std::uint32_t seed);

// Distances to the nearest and the second nearest of one random point a cell.
struct Cells {
    float nearest = 0.0f;
    float second = 0.0f;
    float id = 0.0f;  // random number of the nearest point, in [0, 1)
};
Cells cells(glm::vec2 p, glm::ivec2 period, std::uint32_t seed);

// A stream of random numbers for placing things.
class Random {
public:
    explicit Random(std::uint32_t seed) : m_state(hash(seed)) {}
    float uniform() { return static_cast<float>(next() >> 8) * 0x1p-24f; }
    float uniform(float low, float high) { return low + (high - low) * uniform(); }
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint32_t>(count)); }

private:
    std::uint32_t next() { return hash(m_state++); }
    std::uint32_t m_state;
};

}  // namespace gp::make_scene
