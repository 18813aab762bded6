// The settings with which the models of the library are tested, beside their defaults: model, name
// of the case, parameters as on the command line, and what holds for these values although not for
// all. A case is some seconds of chi-square tests: choose values at which formulas change.
#pragma once

#include "shading/shading.h"

namespace gp::test {
namespace {

struct LibraryCase {
    const char* model;
    const char* name;
    const char* settings;
    shading::uint flags = 0;
    bool onlyLong = false;  // in long runs only (GP_LONG_TESTS)
};

const LibraryCase libraryCases[] = {
    {"half_lambert", "lambert", "wrap=0 exponent=1 base_color=1",
     BSDF_RECIPROCAL | BSDF_CONSERVING},
    {"half_lambert", "flat", "wrap=1"},
    {"half_lambert", "steep", "wrap=0.1 exponent=8"},
};

}  // namespace
}  // namespace gp::test
