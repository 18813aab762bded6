#include "scene/sea_shape.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace gp {

void SeaShape::read(const Ocean& ocean) {
    const OceanSettings& s = ocean.settings();
    cascades_.resize(s.cascades);
    for (uint32_t c = 0; c < s.cascades; ++c) {
        Cascade& cascade = cascades_[c];
        cascade.length = s.lengths[c];
        cascade.levels.resize(1 + size_t(std::lround(std::log2(s.size))));
        for (size_t l = 0; l < cascade.levels.size(); ++l) {
            Level& level = cascade.levels[l];
            const uint32_t n = level.size = s.size >> l;
            level.texels.resize(size_t(n) * n);
            const Level* finer = l == 0 ? nullptr : &cascade.levels[l - 1];
            tbb::parallel_for(0u, n, [&](uint32_t y) {
                for (uint32_t x = 0; x < n; ++x) {
                    glm::vec3& texel = level.texels[size_t(y) * n + x];
                    if (!finer) {
                        texel = ocean.gridPoint(c, int(x), int(y)).displacement;
                        continue;
                    }
                    const glm::vec3* from = &finer->texels[(size_t(y) * 2 * n + x) * 2];
                    texel = (from[0] + from[1] + from[2 * n] + from[2 * n + 1]) * 0.25f;
                }
            });
        }
    }
}

// Bilinear. Texel i of level l stands in the middle of the 2^l grid points that it is the mean of.
glm::vec3 SeaShape::texelsAt(const Cascade& cascade, const Level& level, uint32_t index,
                             glm::vec2 rest) {
    const float perGrid = float(1u << index);
    const float points = float(level.size) * perGrid;
    const auto place = [&](float x) {
        const float turns = x / cascade.length;
        return ((turns - std::floor(turns)) * points - 0.5f * (perGrid - 1)) / perGrid;
    };
    const float x = place(rest.x), y = place(rest.y);
    const float fx = std::floor(x), fy = std::floor(y);
    const uint32_t mask = level.size - 1;
    const uint32_t x0 = uint32_t(int(fx)) & mask, y0 = uint32_t(int(fy)) & mask;
    const uint32_t x1 = (x0 + 1) & mask, y1 = (y0 + 1) & mask;
    const glm::vec3* t = level.texels.data();
    const size_t n = level.size;
    return glm::mix(glm::mix(t[y0 * n + x0], t[y0 * n + x1], x - fx),
                    glm::mix(t[y1 * n + x0], t[y1 * n + x1], x - fx), y - fy);
}

glm::vec3 SeaShape::at(glm::vec2 rest, float cell) const {
    glm::vec3 sum(0);
    for (const Cascade& cascade : cascades_) {
        const float texel = cascade.length / float(cascade.levels[0].size);
        const float wanted = std::max(std::log2(std::max(cell, 1e-6f) / texel), 0.0f);
        const auto last = uint32_t(cascade.levels.size()) - 1;
        if (wanted >= float(last)) continue;  // its mean is 0
        const uint32_t l = uint32_t(wanted);
        const glm::vec3 fine = texelsAt(cascade, cascade.levels[l], l, rest);
        const glm::vec3 coarse =
            l + 1 == last ? glm::vec3(0) : texelsAt(cascade, cascade.levels[l + 1], l + 1, rest);
        sum += glm::mix(fine, coarse, wanted - float(l));
    }
    return sum;
}

}  // namespace gp
