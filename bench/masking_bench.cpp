// What masking costs a highlight of Gaussian slopes about a mean: the whole reflectance f cos, with
// Smith's masking, with sheared and tilted V-cavities, and with none. The numbers in docs/water.md.
#include <vector>

#include <benchmark/benchmark.h>

#include "chi2/random.h"
#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/slope/sheared_cavity.glsl"
#include "shading/slope/smith_slopes.glsl"
#include "shading/slope/tilted_cavity.glsl"
GP_SHADING_END

namespace {

using namespace gp::shading;

enum class Masking { none, smith, sheared, tilted };

struct Case {
    Slopes slopes;
    vec3 wo, wi;
};

// As water has them: views up to 85 degrees, lights near the reflection.
std::vector<Case> cases() {
    gp::Random random(1);
    std::vector<Case> all;
    while (all.size() < 4096) {
        Case c;
        c.slopes.mean = (vec2(random.uniform(), random.uniform()) - 0.5f) * 0.6f;
        c.slopes.var_x = 0.002f + 0.05f * random.uniform();
        c.slopes.var_y = 0.002f + 0.05f * random.uniform();
        c.slopes.cov = (random.uniform() - 0.5f) * sqrt(c.slopes.var_x * c.slopes.var_y);
        const float theta = 1.48f * random.uniform(), phi = 6.2831853f * random.uniform();
        c.wo = vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
        c.wi = reflect(-c.wo, facet_of(slopes_sample(c.slopes, vec2(random.uniform(),
                                                                    random.uniform()))));
        if (slope_facing(c.slopes.mean, c.wo) > 0.0f && c.wi.z > 0.0f) all.push_back(c);
    }
    return all;
}

template <Masking masking>
float f_cos(const Case& c) {
    const vec3 h = normalize(c.wo + c.wi);
    const vec2 s = slope_of(h);
    float g2 = 1.0f;
    if (masking == Masking::smith) g2 = slopes_smith_g2(c.slopes, c.wo, c.wi);
    if (masking == Masking::sheared) g2 = sheared_cavity_g2(c.slopes.mean, s, c.wo, c.wi);
    if (masking == Masking::tilted) g2 = tilted_cavity_g2(c.slopes.mean, s, c.wo, c.wi);
    const float z2 = h.z * h.z;
    return slopes_p22(c.slopes, s) * g2 / (4.0f * z2 * z2 * slope_facing(c.slopes.mean, c.wo));
}

template <Masking masking>
void reflectance(benchmark::State& state) {
    const std::vector<Case> all = cases();
    for (auto unused : state) {
        float sum = 0.0f;
        for (const Case& c : all) sum += f_cos<masking>(c);
        benchmark::DoNotOptimize(sum);
        static_cast<void>(unused);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(all.size()));
}

BENCHMARK(reflectance<Masking::none>);
BENCHMARK(reflectance<Masking::smith>);
BENCHMARK(reflectance<Masking::sheared>);
BENCHMARK(reflectance<Masking::tilted>);

}  // namespace

BENCHMARK_MAIN();
