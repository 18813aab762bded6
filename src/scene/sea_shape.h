// The displacement of a sea at one time, in levels of detail: what triangles of a given size can
// show of it. Finer waves would turn into noise at the vertices; shading has them.
#pragma once

#include <cstdint>
#include <vector>

#include "ocean/ocean.h"

namespace gp {

class SeaShape {
public:
    // As the sea is now.
    void read(const Ocean& ocean);
    // Displacement (x, y, up) of the point at rest, without what cells of this side cannot show.
    glm::vec3 at(glm::vec2 rest, float cell) const;

private:
    struct Level {
        uint32_t size = 0;
        std::vector<glm::vec3> texels;  // level 0: grid points; each other one means of four
    };
    struct Cascade {
        float length = 1;
        std::vector<Level> levels;      // down to one texel
    };
    static glm::vec3 texelsAt(const Cascade& cascade, const Level& level, uint32_t index,
                              glm::vec2 rest);

    std::vector<Cascade> cascades_;
};

}  // namespace gp
