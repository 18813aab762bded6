// Chi-square tests (common/chi2) as our tests use them.
#pragma once

#include "chi2/grids.h"
#include "statistics/random.h"

namespace gp::test {

using gp::Chi2Result;
using gp::SphereDomain;
using gp::chi2Rectangle;
using gp::chi2Sphere;

struct Chi2Options : gp::Chi2Options {
    Chi2Options() {
        if (longTests()) samples = 10'000'000;
        tableFolder = GP_BINARY_DIR "/chi2_tables";
    }
};

}  // namespace gp::test
