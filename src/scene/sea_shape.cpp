#include "scene/sea_shape.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "ocean/grid_place.h"

namespace gp {

void SeaShape::read(const Ocean& ocean) {
    const OceanSettings& s = ocean.settings();
    cascades_.resize(s.cascades);
    for (uint32_t c = 0; c < s.cascades; ++c) {
        Cascade& cascade = cascades_[c];
        cascade.length = s.lengths[c];
        cascade.levels.resize(1 + size_t(std::lround(std::log2(s.size))));
        for (uint32_t l = 0; l < cascade.levels.size(); ++l) {
            Level& level = cascade.levels[l];
            level.index = l;
            const uint32_t n = level.size = s.size >> l;
            level.texels.resize(size_t(n) * n);
            const Level* finer = l == 0 ? nullptr : &cascade.levels[l - 1];
            tbb::parallel_for(0u, n, [&](uint32_t y) {
                for (uint32_t x = 0; x < n; ++x) {
                    Texel& texel = level.texels[size_t(y) * n + x];
                    if (!finer) {
                        const glm::vec3 d = ocean.gridPoint(c, int(x), int(y)).displacement;
                        texel = Texel{d.x, d.y, d.z, 0};
                        continue;
                    }
                    const Texel* from = &finer->texels[(size_t(y) * 2 * n + x) * 2];
                    texel = (from[0] + from[1] + from[2 * n] + from[2 * n + 1]) * 0.25f;
                }
            });
        }
    }
}

SeaShape::Detail SeaShape::detail(float cell) const {
    Detail detail;
    for (const Cascade& cascade : cascades_) {
        const float texel = cascade.length / float(cascade.levels[0].size);
        const float wanted = std::max(std::log2(std::max(cell, 1e-6f) / texel), 0.0f);
        const auto last = uint32_t(cascade.levels.size()) - 1;
        if (wanted >= float(last)) continue;  // its mean is 0
        const auto l = uint32_t(wanted);
        const float coarser = wanted - float(l);
        const bool both = coarser > 0 && l + 1 < last;
        detail.parts[detail.count++] = {
            1 / cascade.length,
            {&cascade.levels[l], both ? &cascade.levels[l + 1] : nullptr},
            {1 - coarser, coarser}};
    }
    return detail;
}

// Bilinear. Texel i of level l stands in the middle of the 2^l grid points that it is the mean of.
SeaShape::Texel SeaShape::texelsAt(const Level& level, float perLength, glm::vec2 rest) {
    const float middle = 0.5f - 0.5f / float(1u << level.index);
    const GridCorners c = gridCorners(gridPosition(rest, perLength, level.size) - middle);
    const uint32_t mask = level.size - 1;
    const size_t x0 = uint32_t(c.x) & mask, x1 = uint32_t(c.x + 1) & mask;
    const Texel* low = &level.texels[(uint32_t(c.y) & mask) * size_t(level.size)];
    const Texel* high = &level.texels[(uint32_t(c.y + 1) & mask) * size_t(level.size)];
    return c.weights[0] * low[x0] + c.weights[1] * low[x1] + c.weights[2] * high[x0]
         + c.weights[3] * high[x1];
}

glm::vec3 SeaShape::at(glm::vec2 rest, const Detail& detail) {
    Texel sum{};
    for (uint32_t i = 0; i < detail.count; ++i) {
        const Detail::Part& part = detail.parts[i];
        sum += part.shares[0] * texelsAt(*part.levels[0], part.perLength, rest);
        if (part.levels[1])
            sum += part.shares[1] * texelsAt(*part.levels[1], part.perLength, rest);
    }
    return {sum[0], sum[1], sum[2]};
}

}  // namespace gp
