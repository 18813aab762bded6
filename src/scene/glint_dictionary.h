// The dictionary of glints in the form in which shading/glint reads it.
#pragma once

#include <glm/glm.hpp>

namespace gp {

// What Glint::dictionary wants: the address of the table, valid until the program ends. The first
// call makes it, GLINT_WORDS floats (1.6 MB) in some hundredths of a second on all cores; the same
// numbers every time. Thread-safe. Throws std::bad_alloc.
glm::uvec2 glintDictionary();

}  // namespace gp
