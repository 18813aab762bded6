// The C++ side of the shading language (the GLSL side is lang.glsl): what makes a file in the
// common subset compile as C++20. ARCHITECTURE.md, "Shading is written once", has the rules.
//
// Every translation unit gets the functions with internal linkage, through an unnamed namespace:
// the same file is compiled for several instruction sets, and a linker must never merge the copies.
#pragma once

#include <cstdint>

#define GLM_FORCE_INLINE
#include <glm/glm.hpp>

// A parameter that a function reads but does not copy, and the one kind that it may change.
#define IN(T) const T&
#define INOUT(T) T&
// A local name for what a function returns, without a copy where the language can.
#define LET_REF(T) const T&

// A function that the hot code only meets by way of exception: kept out of it. (Not gnu::cold: that
// would compile it for size.)
#define OUT_OF_LINE [[gnu::noinline]]
// A function of which a loop can only be turned into vectors where it is part of the loop.
#define IN_LOOPS [[gnu::always_inline]] inline
// An array of numbers that a function looks things up in.
#define CONST_TABLE static constexpr

// Included as  namespace gp::shading { namespace { using namespace glm;  …files…  } }
// by shading/shading.h; unused functions are the normal case.
#define GP_SHADING_BEGIN                                   \
    _Pragma("GCC diagnostic push")                         \
    _Pragma("GCC diagnostic ignored \"-Wunused-function\"") \
    namespace gp::shading { namespace { using namespace glm;
#define GP_SHADING_END \
    } }                \
    _Pragma("GCC diagnostic pop")

// Numbers in memory, for the models that look up more than a constant table can hold: a table is
// its 64-bit address in two words, the low one first; 0 is no table. Nothing else in src/shading
// touches memory; lang.glsl has the same functions.
namespace gp::shading {

static inline bool table_exists(glm::uvec2 table) {
    return (table.x | table.y) != 0u;
}

static inline float table_float(glm::uvec2 table, unsigned index) {
    const uint64_t address = uint64_t(table.x) | (uint64_t(table.y) << 32u);
    return reinterpret_cast<const float*>(static_cast<uintptr_t>(address))[index];
}

// Two words that follow each other. In loops too they are read one by one: what compilers make of
// it for vectors takes longer.
static inline glm::uvec2 table_uint2(glm::uvec2 table, unsigned index) {
    asm("" : "+r"(index));
    const uint64_t address = uint64_t(table.x) | (uint64_t(table.y) << 32u);
    const uint32_t* words = reinterpret_cast<const uint32_t*>(static_cast<uintptr_t>(address));
    glm::uvec2 both;
    __builtin_memcpy(&both, words + index, sizeof(both));
    return both;
}

}  // namespace gp::shading
