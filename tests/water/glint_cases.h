// Glints that the tests of src/shading/glint share, and sums over the plane of slopes.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "scene/glint_dictionary.h"
#include "shading/lang.h"
#include "statistics/random.h"

GP_SHADING_BEGIN
#include "shading/glint/glint.glsl"
#include "shading/slope/sheared_cavity.glsl"
GP_SHADING_END

namespace gp::test {
namespace {  // the shading functions and their types have internal linkage

// A surface of 10^7 facets per unit of uv, seen by a pixel of a thousandth of it; about one facet.
inline shading::Glint exampleGlint() {
    shading::Glint g{};
    g.slopes.mean = {0.1f, -0.05f};
    g.slopes.var_x = 0.04f;
    g.slopes.var_y = 0.02f;
    g.slopes.cov = 0.012f;
    g.uv = {0.3f, 0.7f};
    g.d0 = {0.001f, 0.0003f};
    g.d1 = {-0.0002f, 0.0007f};
    g.log_density = std::log(1e7f);
    g.area = 1.0f;
    g.dictionary = glintDictionary();
    g.seed = 5u;
    return g;
}

struct NamedGlint {
    std::string name;
    shading::Glint glint;
};

inline std::vector<NamedGlint> glintCases() {
    std::vector<NamedGlint> all(9, {"", exampleGlint()});
    all[0].name = "few facets";
    all[1].name = "many facets";
    all[1].glint.log_density = std::log(1e10f);
    all[2].name = "long footprint";
    all[2].glint.d0 = {0.02f, 0.011f};
    all[3].name = "smaller than a facet";
    all[3].glint.d0 = all[3].glint.d1 = {1e-6f, 1e-6f};
    all[4].name = "shared with a smooth surface";
    all[4].glint.area = 0.3f;
    all[5].name = "single flakes";
    all[5].glint.area = 0.01f;
    all[5].glint.log_density = std::log(1e6f);
    all[6].name = "jittered";
    all[6].glint.jitter = 2.0f;
    all[7].name = "with a kernel";
    all[7].glint.k0 = {0.12f, 0.02f};
    all[7].glint.k1 = {-0.03f, 0.08f};
    all[7].glint.slopes =
        shading::glint_kernel_added(all[7].glint.slopes, all[7].glint.k0, all[7].glint.k1);
    all[8].name = "nothing but a kernel";
    all[8].glint.k0 = {2.0f, 0.0f};
    all[8].glint.k1 = {0.0f, 1.0f};
    all[8].glint.slopes =
        shading::glint_kernel_added(all[8].glint.slopes, all[8].glint.k0, all[8].glint.k1);
    return all;
}

// The integral of f(slope) P22 over all slopes: a grid `perDeviation` points apart in standard
// deviations, out to where the corners of the dictionary's squares reach.
template <class F>
double slopeIntegral(const shading::Glint& g, int perDeviation, F f) {
    const shading::Whitening w = shading::whitening_of(shading::glint_slopes_within(g));
    const int reach = int(5.7 * perDeviation) + 1;
    double sum = 0.0;
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            const glm::vec2 at = glm::vec2(float(x), float(y)) / float(perDeviation);
            const glm::vec2 s = g.slopes.mean + shading::unwhitened(w, at);
            sum += double(shading::glint_p22(g, s)) * double(f(s));
        }
    }
    return sum / (double(perDeviation) * perDeviation * double(w.xx * w.yy));
}

// Another place of the surface, as far as all cells are concerned.
inline void moveGlint(shading::Glint& g, Random& random) {
    g.uv = 100.0f * glm::vec2(random.uniform(), random.uniform());
}

}  // namespace
}  // namespace gp::test
