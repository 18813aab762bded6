// The dictionary of glints in the form in which shading/glint reads it.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

// GLINT_WORDS words, as shading/glint/dictionary.glsl lays them out. The first call makes them, in
// some milliseconds; the same numbers every time. They live until the program ends. Thread-safe.
// Throws std::bad_alloc.
const std::vector<uint32_t>& glintWords();

// Their address, what Glint::dictionary wants.
glm::uvec2 glintDictionary();

}  // namespace gp
