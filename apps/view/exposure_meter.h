// How bright the viewer shows things: as chosen, or by itself as eyes do.
#pragma once

#include <glitterpath/glitterpath.h>

#include <vector>

namespace gp::tool::view {

class ExposureMeter {
public:
    // The exposure of a picture of RGBA radiance, taken `seconds` after the last one. The first is
    // met at once, later ones are followed as eyes adapt.
    float adapt(const std::vector<float>& rgba, double seconds);
    float ev() const { return m_ev; }

private:
    float m_ev = 0;
    bool m_hasSeen = false;
};

}  // namespace gp::tool::view
