// The differential test: each function of the shading language is evaluated for the same random
// inputs by the C++ compiler and, through SPIR-V, by a Vulkan compute shader; the numbers must
// agree. A row of a table (differential/*.def, which says how to write one) is one function.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace gp::test {

// |a - b| <= relative * max(|a|, |b|) + absolute, for all but a share `outliers` of the inputs.
// A vector is compared as a whole, by its length. Where a row needs more than the default, it says
// why: `absolute` for values that cancel to zero, `outliers` for functions that jump.
struct Tolerance {
    double relative = 1e-4;
    double absolute = 0.0;
    double outliers = 0.0;
};
constexpr Tolerance within(double relative, double absolute = 0.0, double outliers = 0.0) {
    return {relative, absolute, outliers};
}
constexpr Tolerance exactly() { return {0.0, 0.0, 0.0}; }

struct DifferentialRow {
    const char* name;
    const char* domain;  // what the input words are, see parseDomain in differential.cpp
    Tolerance tolerance;
    void (*evaluate)();  // the body as C++ compiled it
    const char* body;    // and its text, for the GLSL compiler
};

struct DifferentialTable {
    const char* name;
    const DifferentialRow* rows;
    size_t size;
};
// Registers a table when the program starts; gtest makes a test of each.
bool registerTable(const DifferentialTable& table);

// What in_*() and put_*() of a body reach while it runs in C++.
constexpr uint32_t maxOutputs = 64;
struct EvaluationWords {
    const uint32_t* input = nullptr;
    uint32_t inputCount = 0;
    uint32_t output[maxOutputs] = {};
    // Per output word: 0 not written, 'u' integer, 'f' float, '2' to '4' the start of a vector,
    // '+' its continuation.
    char kind[maxOutputs] = {};
};
extern EvaluationWords evaluation;

float readFloat(int index);
uint32_t readUint(int index);
glm::uvec2 glintAddress();  // of scene/glint_dictionary.h, likewise
glm::uvec2 tableAddress();  // of statistics/measured_example.h; the shader has a copy of it
void writeUint(int index, uint32_t value);
void writeFloats(int index, const float* values, int count);

}  // namespace gp::test
