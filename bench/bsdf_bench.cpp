// Nanoseconds for one evaluation and one sample of every model of models.def with its defaults, on
// one core, over views and lights that change with every call; and what terms cost that are off.
// scripts/bench --only bsdf writes it down. Every row is checked first: no result may be NaN or
// infinite.
#include <array>
#include <bit>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "shading/shading.h"
#include "statistics/measured_example.h"

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

const std::vector<Input>& inputs() {
    static const std::vector<Input> made = makeInputs();
    return made;
}

// set_disney_sheen(m, 0.5f) and all the others, wherever parameters.def keeps them.
#define BSDF_PARAMETER(number, accessor, name, type, slot, initial, minimum, maximum, outside, \
                       unit, text) \
    [[maybe_unused]] void set_##accessor(BsdfParams& m, auto value) { \
        BSDF_SET_##type(m.slot, value) \
    }
#include "shading/bsdf/parameters.def"
#undef BSDF_PARAMETER

using Eval = BsdfValue (*)(const BsdfParams&, vec3, vec3);
using Sample = BsdfSample (*)(const BsdfParams&, vec3, float, vec2);
using Known = void (*)(BsdfParams&);

void nothing(BsdfParams&) {}

// `known` writes parameters behind the optimiser's veil: their terms are compiled out, as if the
// model had never had them.
template <Eval eval, Known known = nothing>
void evaluate(benchmark::State& state, BsdfParams m) {
    std::size_t i = 0;
    for (auto _ : state) {
        const Input& in = inputs()[i++ % 4096];
        benchmark::DoNotOptimize(m);
        BsdfParams local = m;
        known(local);
        BsdfValue v = eval(local, in.wo, in.wi);
        benchmark::DoNotOptimize(v);
    }
}

// What bsdf_prepared does once for a material.
void prepare(benchmark::State& state, BsdfParams m) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(m);
        BsdfParams made = bsdf_prepared(m);
        benchmark::DoNotOptimize(made);
    }
}

template <Sample sampleOf>
void sample(benchmark::State& state, BsdfParams m) {
    std::size_t i = 0;
    for (auto _ : state) {
        const Input& in = inputs()[i++ % 4096];
        benchmark::DoNotOptimize(m);
        BsdfSample s = sampleOf(m, in.wo, in.u.x, vec2(in.u.y, in.u.z));
        benchmark::DoNotOptimize(s);
    }
}

// -fno-trapping-math leaves NaN alone, but not so the exponent of a compiler that is told of finite
// numbers only: bits are the same everywhere.
bool finite(float x) {
    return (std::bit_cast<uint>(x) & 0x7f800000u) != 0x7f800000u;
}

bool finite(vec3 v) {
    return finite(v.x) && finite(v.y) && finite(v.z);
}

bool staysFinite(const BsdfParams& m) {
    for (const Input& in : inputs()) {
        const BsdfValue v = bsdf_eval(m, in.wo, in.wi);
        const BsdfSample s = bsdf_sample(m, in.wo, in.u.x, vec2(in.u.y, in.u.z));
        if (!finite(v.f_cos) || !finite(v.pdf) || !finite(s.weight) || !finite(s.pdf)) {
            return false;
        }
    }
    return true;
}

struct Row {
    const char* name;
    uint model;
    uint flags;
};

constexpr Row rows[] = {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    {#name, number, flags},
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
};

BsdfParams paramsOf(uint model) {
    return bsdf_prepared(bsdf_params_of(model));
}

bool registerModels() {
    bool good = true;
    for (const Row& row : rows) {
        BsdfParams m = paramsOf(row.model);
        if ((row.flags & BSDF_FROM_FILE) != 0u) {
            m.table = gp::test::measuredExample()->address();
        }
        if (!staysFinite(m)) {
            fmt::print(stderr, "bsdf_bench: {} is not finite\n", row.name);
            good = false;
        }
        benchmark::RegisterBenchmark(fmt::format("eval/{}", row.name).c_str(),
                                     evaluate<bsdf_eval>, m);
        benchmark::RegisterBenchmark(fmt::format("sample/{}", row.name).c_str(),
                                     sample<bsdf_sample>, m);
    }
    return good;
}

// What everyone starts with: half a metal, half matte.
BsdfValue ggx_and_lambert_eval(const BsdfParams& m, vec3 wo, vec3 wi) {
    const BsdfValue metal = ggx_conductor_eval(m, wo, wi);
    const BsdfValue matte = lambert_eval(m, wo, wi);
    BsdfValue v;
    v.f_cos = 0.5f * (metal.f_cos + matte.f_cos);
    v.pdf = 0.5f * (metal.pdf + matte.pdf);
    return v;
}

// Three times the same model: with the term, with it switched off, and without it in the code.
template <Eval eval, Known off>
void registerTerm(const char* name, const BsdfParams& on) {
    BsdfParams without = on;
    off(without);
    const auto called = [&](const char* how) { return fmt::format("term/{}/{}", name, how); };
    benchmark::RegisterBenchmark(called("on").c_str(), evaluate<eval>, on);
    benchmark::RegisterBenchmark(called("off").c_str(), evaluate<eval>, without);
    benchmark::RegisterBenchmark(called("absent").c_str(), evaluate<eval, off>, without);
}

void withoutFilm(BsdfParams& m) { m.iridescence = 0.0f; }
void withoutMultiple(BsdfParams& m) { set_kulla_conty_multiple(m, 0.0f); }
void withoutDiffraction(BsdfParams& m) { set_two_scale_sigma_um(m, 0.0f); }
void withoutSheen(BsdfParams& m) { set_disney_sheen(m, 0.0f); }
void withoutCoat(BsdfParams& m) { set_disney_clearcoat(m, 0.0f); }

void registerTerms() {
    BsdfParams film = paramsOf(MODEL_GLTF);
    film.iridescence = 0.5f;
    registerTerm<gltf_eval, withoutFilm>("thin film (gltf)", film);
    registerTerm<kulla_conty_eval, withoutMultiple>("multiple scattering (kulla_conty)",
                                                    paramsOf(MODEL_KULLA_CONTY));
    registerTerm<two_scale_eval, withoutDiffraction>("diffraction (holzschuch_pacanowski)",
                                                     paramsOf(MODEL_TWO_SCALE));
    BsdfParams disney = paramsOf(MODEL_DISNEY);
    set_disney_sheen(disney, 0.5f);
    set_disney_clearcoat(disney, 0.5f);
    registerTerm<disney_eval, withoutSheen>("sheen (disney)", disney);
    registerTerm<disney_eval, withoutCoat>("clearcoat (disney)", disney);
    benchmark::RegisterBenchmark("plain/disney", evaluate<disney_eval>, paramsOf(MODEL_DISNEY));
    benchmark::RegisterBenchmark("plain/ggx and lambert", evaluate<ggx_and_lambert_eval>,
                                 paramsOf(MODEL_GGX_CONDUCTOR));
}

// Models that derive numbers from their parameters, with and without tables of them.
void registerPreparations() {
    const auto add = [](const char* name, uint model, float distribution, float diffuse) {
        BsdfParams m = bsdf_params_of(model);
        if (model == MODEL_KULLA_CONTY) {
            set_kulla_conty_distribution(m, distribution);
            set_kulla_conty_diffuse(m, vec3(diffuse));
        } else {
            set_microfacet_distribution(m, distribution);
        }
        benchmark::RegisterBenchmark(fmt::format("prepare/{}", name).c_str(), prepare, m);
    };
    add("microfacet, gtr", MODEL_MICROFACET, float(DISTRIBUTION_GTR), 0.0f);
    add("kulla_conty, ggx", MODEL_KULLA_CONTY, float(DISTRIBUTION_GGX), 0.0f);
    add("kulla_conty, ggx, matte base", MODEL_KULLA_CONTY, float(DISTRIBUTION_GGX), 0.5f);
    add("kulla_conty, gtr", MODEL_KULLA_CONTY, float(DISTRIBUTION_GTR), 0.0f);
    add("kulla_conty, gtr, matte base", MODEL_KULLA_CONTY, float(DISTRIBUTION_GTR), 0.5f);
}

// What evaluation reads of tables: nothing; and what making a material does.
void addSizes() {
    const std::size_t albedo = 4 * sizeof(std::array<float, ALBEDO_TABLE_COSINES
                                                            * ALBEDO_TABLE_WIDTHS>)
                             + 4 * sizeof(std::array<float, ALBEDO_AVERAGE_WIDTHS>);
    benchmark::AddCustomContext("bytes_of_albedo_tables", std::to_string(albedo));
    benchmark::AddCustomContext("bytes_of_a_material", std::to_string(sizeof(BsdfParams)));
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    if (!registerModels()) {
        return 1;
    }
    registerTerms();
    registerPreparations();
    addSizes();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
