// From GLSL text to SPIR-V by glslangValidator, #include resolved against src/, for tests that run
// shaders. A process of its own: Debian's shaderc library does not link without glslang's insides.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gp::test {

// Throws std::runtime_error with the compiler's messages; the files then stay in the build tree,
// under differential/, where a person can read what was compiled.
std::vector<uint32_t> compileCompute(const std::string& source, const std::string& name);

}  // namespace gp::test
