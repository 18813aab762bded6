// A measured material in the form in which the shading functions read it: the cells of its file,
// and densities by which it is sampled (shading/measured).
#pragma once

#include <memory>
#include <string>

#include <glm/glm.hpp>

#include "scene/large_pages.h"

namespace gp {

struct MeasuredBrdf {
    std::string name;          // the file's
    LargeVector<float> words;  // MEASURED_WORDS of them

    // What BsdfParams::table wants: valid as long as this lives.
    glm::uvec2 address() const;
};

// `cells`: red, green and blue of merl::cellCount cells, f in 1/sr, finite; negative where nothing
// was measured. Takes some hundredths of a second, most of it for the densities.
std::shared_ptr<const MeasuredBrdf> makeMeasuredBrdf(std::string name, LargeVector<float> cells);

}  // namespace gp
