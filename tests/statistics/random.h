// The random numbers of the tests, and how long these may take.
#pragma once

#include <cstdlib>
#include <string>

#include "chi2/random.h"

namespace gp::test {

using gp::Random;

// GP_LONG_TESTS=1: more samples and more parameter sets, for scripts/test --long.
inline bool longTests() {
    const char* value = std::getenv("GP_LONG_TESTS");
    return value != nullptr && std::string(value) != "0" && std::string(value) != "";
}

}  // namespace gp::test
