// Nanoseconds of one facet's light (Fresnel, density of slopes, V-cavity masking) of water under
// one light, on one core: with smooth slopes, with glints out of the dictionary for footprints of
// some shapes, and with the other two methods. scripts/bench --only glint writes it down. Every row
// is checked first: no result may be NaN, infinite or negative.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "scene/glint_dictionary.h"
#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/fresnel.glsl"
#include "shading/glint/counting.glsl"
#include "shading/glint/glint.glsl"
#include "shading/glint/zirr.glsl"
#include "shading/slope/sheared_cavity.glsl"
GP_SHADING_END

namespace {

using namespace gp::shading;

struct Input {
    Glint g;
    vec3 wo;
    vec3 wi;
    vec3 u;
};

struct Shape {
    const char* name;
    float ratio;        // of the footprint's axes
    float log_density;  // facets by unit of uv; footprints are 1/500 to 1/125 of it wide
    bool kernel;
};

// Facets and directions about a mirror direction, as a glitter path has them.
std::vector<Input> makeInputs(const Shape& shape) {
    std::vector<Input> inputs(4096);
    uint index = 0;
    const auto uniform = [&] { return float(hash_u32(index++) >> 8u) * 0x1p-24f; };
    for (Input& in : inputs) {
        in.g = Glint{};
        in.g.slopes.mean = vec2(uniform() - 0.5f, uniform() - 0.5f) * 0.2f;
        in.g.slopes.var_x = 0.02f;
        in.g.slopes.var_y = 0.015f;
        in.g.slopes.cov = 0.003f;
        in.g.uv = 10.0f * vec2(uniform(), uniform());
        const SinCos turn = sincos_turns(uniform());
        const float width = std::exp2(-9.0f + 2.0f * uniform());
        in.g.d1 = width * vec2(turn.c, turn.s);
        in.g.d0 = shape.ratio * width * vec2(-turn.s, turn.c);
        in.g.log_density = shape.log_density;
        in.g.area = 1.0f;
        in.g.k0 = shape.kernel ? 0.1f * vec2(uniform(), 0.2f) : vec2(0.0f);
        in.g.k1 = shape.kernel ? 0.1f * vec2(0.1f, uniform()) : vec2(0.0f);
        in.g.slopes = glint_kernel_added(in.g.slopes, in.g.k0, in.g.k1);
        in.g.dictionary = gp::glintDictionary();
        const vec2 offset = 0.3f * vec2(uniform() - 0.5f, uniform() - 0.5f);
        const vec3 wm = facet_of(in.g.slopes.mean + offset);
        in.wo = normalize(vec3(uniform() - 0.5f, 1.0f, 0.3f + uniform()));
        in.wi = reflect(-in.wo, wm);
        in.u = vec3(uniform(), uniform(), uniform());
    }
    return inputs;
}

using P22 = float (*)(const Glint&, vec2);

float smooth_p22(const Glint& g, vec2 s) { return slopes_p22(g.slopes, s); }
float counting_p22(const Glint& g, vec2 s) { return glint_counting(g, s).p22; }
float zirr_p22(const Glint& g, vec2 s) { return glint_zirr(g, s).p22; }

template <P22 p22>
float shade(const Input& in) {
    const vec3 wm = normalize(in.wo + in.wi);
    const vec2 s = slope_of(wm);
    const vec2 mean = in.g.slopes.mean;
    const float facing = std::max(slope_facing(mean, in.wo), 1e-3f);
    const float z2 = wm.z * wm.z;
    return fresnel_dielectric(dot(in.wo, wm), 1.33f) * p22(in.g, s)
         * sheared_cavity_g2(mean, s, in.wo, in.wi) / (4.0f * z2 * z2 * facing);
}

template <P22 p22>
void shader(benchmark::State& state, const std::vector<Input>& inputs) {
    for (const Input& in : inputs) {
        const float value = shade<p22>(in);
        if (!(value >= 0.0f && value < std::numeric_limits<float>::infinity())) {
            state.SkipWithError("a result is no number");
            return;
        }
    }
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(shade<p22>(inputs[i++ % 4096]));
}

void sampler(benchmark::State& state, const std::vector<Input>& inputs) {
    std::size_t i = 0;
    for (auto _ : state) {
        const Input& in = inputs[i++ % 4096];
        benchmark::DoNotOptimize(glint_sample(in.g, vec2(in.u), in.u.z));
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    const Shape shapes[] = {{"1 : 1", 1.0f, 18.0f, false},   {"2 : 1", 2.0f, 18.0f, false},
                            {"4 : 1", 4.0f, 18.0f, false},   {"1 : 1, kernel", 1.0f, 18.0f, true},
                            {"2 : 1, kernel", 2.0f, 18.0f, true},
                            {"4 : 1, kernel", 4.0f, 18.0f, true},
                            {"far away", 4.0f, 40.0f, true}};
    for (const Shape& shape : shapes) {
        const std::vector<Input> inputs = makeInputs(shape);
        const auto add = [&](const char* what, auto run) {
            const std::string name = fmt::format("{}/{}", what, shape.name);
            benchmark::RegisterBenchmark(name.c_str(), run, inputs);
        };
        add("smooth", shader<smooth_p22>);
        add("dictionary", shader<glint_p22>);
        add("counting", shader<counting_p22>);
        add("zirr", shader<zirr_p22>);
        add("sample", sampler);
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
