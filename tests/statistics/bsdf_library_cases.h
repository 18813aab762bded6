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
    {"kulla_conty", "coarse", "mirror=ggx_separable alpha=1"},
    {"kulla_conty", "smooth", "mirror=beckmann_correlated alpha=0.02"},
    {"kulla_conty", "beckmann", "mirror=beckmann_separable alpha=0.7"},
    {"kulla_conty", "single", "multiple=0 alpha=0.4", 0u, true},
    {"iridescent_mirror", "metal", "base_ior=0.9 base_kappa=2.5 film_ior=1.8 alpha_x=0.4"},
    {"iridescent_mirror", "thick", "thickness_nm=1500 terms=10 alpha_x=0.01 alpha_y=0.01"},
    {"grating", "deep", "profile=sinusoidal period_nm=600 depth_nm=300 spread=0.2"},
    {"grating", "mirror", "depth_nm=0 spread=0.05", 0u, true},
    {"grating", "fine", "period_nm=500 spread=0.01", 0u, true},
    {"holzschuch_pacanowski", "rough", "eta=0.05 k=9 beta=0.3 p=0.5 sigma_um=0.1 c=1.3", 0u, true},
    {"holzschuch_pacanowski", "gaussian", "eta=0.05 k=9 beta=0.15 p=1 sigma_um=0.05 b_um=0.3 c=3",
     0u, true},
    {"holzschuch_pacanowski", "smooth", "sigma_um=0 beta=0.2 p=2", 0u, true},
    {"holzschuch_pacanowski", "no_mirror", "eta=0.05 k=9 sigma_um=1 b_um=5", 0u, true},
};

}  // namespace
}  // namespace gp::test
