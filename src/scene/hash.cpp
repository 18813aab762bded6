#include "scene/hash.h"

#define XXH_INLINE_ALL  // header only: nothing more to link
#include <xxhash.h>

namespace gp {

uint64_t hashBytes(const void* bytes, size_t count, uint64_t seed) {
    return XXH3_64bits_withSeed(bytes, count, seed);
}

}  // namespace gp
