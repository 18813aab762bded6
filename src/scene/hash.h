// 64-bit hashes that are the same in every run and on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gp {

uint64_t hashBytes(const void* bytes, size_t count, uint64_t seed = 0);

}  // namespace gp
