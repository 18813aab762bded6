// Nanoseconds for one evaluation and one sample of the reflectance models, over views and lights
// that change with every call.
#include <vector>

#include <benchmark/benchmark.h>

#include "shading/shading.h"

namespace {

using namespace gp::shading;

struct Input {
    vec3 wo;
    vec3 wi;
    vec3 u;
};

std::vector<Input> makeInputs() {
    std::vector<Input> inputs(4096);
    uint index = 0;
    const auto uniform = [&] { return float(hash_u32(index++) >> 8u) * EXP2_MINUS_24; };
    for (Input& in : inputs) {
        const float a = uniform(), b = uniform(), c = uniform(), d = uniform();
        in.wo = square_to_cosine_hemisphere(vec2(a, b));
        in.wi = square_to_cosine_hemisphere(vec2(c, d));
        in.u = vec3(uniform(), uniform(), uniform());
    }
    return inputs;
}

BsdfParams paramsOf(uint model) {
    BsdfParams m = bsdf_params_of(model);
    m.base_color = vec3(0.8f, 0.6f, 0.3f);
    m.alpha_x = m.alpha_y = 0.2f;
    return m;
}

BsdfParams everything() {
    BsdfParams m = paramsOf(MODEL_GLTF);
    m.metallic = 0.3f;
    m.coat = 0.5f;
    m.coat_alpha = 0.05f;
    m.sheen_color = vec3(0.3f);
    m.sheen_alpha = 0.3f;
    m.transmission = 0.5f;
    m.iridescence = 0.5f;
    return m;
}

void evaluate(benchmark::State& state, BsdfParams m) {
    const std::vector<Input> inputs = makeInputs();
    std::size_t i = 0;
    for (auto _ : state) {
        const Input& in = inputs[i++ % inputs.size()];
        benchmark::DoNotOptimize(m);
        BsdfValue v = bsdf_eval(m, in.wo, in.wi);
        benchmark::DoNotOptimize(v);
    }
}

void sample(benchmark::State& state, BsdfParams m) {
    const std::vector<Input> inputs = makeInputs();
    std::size_t i = 0;
    for (auto _ : state) {
        const Input& in = inputs[i++ % inputs.size()];
        benchmark::DoNotOptimize(m);
        BsdfSample s = bsdf_sample(m, in.wo, in.u.x, vec2(in.u.y, in.u.z));
        benchmark::DoNotOptimize(s);
    }
}

BsdfParams metal() {
    BsdfParams m = paramsOf(MODEL_GLTF);
    m.metallic = 1.0f;
    return m;
}

#define GP_BSDF_BENCH(name, params)             \
    BENCHMARK_CAPTURE(evaluate, name, params);  \
    BENCHMARK_CAPTURE(sample, name, params);

GP_BSDF_BENCH(lambert, paramsOf(MODEL_LAMBERT))
GP_BSDF_BENCH(ggx_conductor, paramsOf(MODEL_GGX_CONDUCTOR))
GP_BSDF_BENCH(beckmann_conductor, paramsOf(MODEL_BECKMANN_CONDUCTOR))
GP_BSDF_BENCH(ggx_dielectric, paramsOf(MODEL_GGX_DIELECTRIC))
GP_BSDF_BENCH(gltf_plain, paramsOf(MODEL_GLTF))
GP_BSDF_BENCH(gltf_metal, metal())
GP_BSDF_BENCH(gltf_everything, everything())

}  // namespace

BENCHMARK_MAIN();
