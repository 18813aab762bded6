// The displacement of a sea at one time, in levels of detail: what triangles of a given size can
// show of it. Finer waves would turn into noise at the vertices; shading has them.
#pragma once

#include <cstdint>
#include <vector>

#include "ocean/ocean.h"

namespace gp {

class SeaShape {
    struct Level;

public:
    // What cells of one size show: of each cascade two levels, and how much of the coarser one.
    struct Detail {
        struct Part {
            float perLength = 0;            // 1 / metres of the cascade
            const Level* levels[2] = {};    // null: its mean, which is 0
            float shares[2] = {};
        };
        Part parts[oceanMostCascades];
        uint32_t count = 0;
    };

    // As the sea is now.
    void read(const Ocean& ocean);
    // For cells of this side; of use until the next read.
    Detail detail(float cell) const;
    // Displacement (x, y, up) of the point at rest, without what the cells cannot show.
    static glm::vec3 at(glm::vec2 rest, const Detail& detail);

private:
    // A vector is added up at once.
    typedef float Texel __attribute__((vector_size(16)));
    struct Level {
        uint32_t index = 0, size = 0;
        std::vector<Texel> texels;      // level 0: grid points; each other one means of four
    };
    struct Cascade {
        float length = 1;
        std::vector<Level> levels;      // down to one texel
    };
    static Texel texelsAt(const Level& level, float perLength, glm::vec2 rest);

    std::vector<Cascade> cascades_;
};

}  // namespace gp
