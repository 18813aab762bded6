#include "shading/differential.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <span>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "shading/glsl_compiler.h"
#include "shading/vulkan_compute.h"
#include "scene/glint_dictionary.h"
#include "statistics/measured_example.h"
#include "statistics/random.h"

namespace gp::test {

EvaluationWords evaluation;

float readFloat(int index) { return std::bit_cast<float>(readUint(index)); }

uint32_t readUint(int index) {
    if (index < 0 || uint32_t(index) >= evaluation.inputCount) {
        throw std::out_of_range("the body reads input word " + std::to_string(index) +
                                ", which its domain does not have");
    }
    return evaluation.input[index];
}

glm::uvec2 tableAddress() { return measuredExample()->address(); }
glm::uvec2 glintAddress() { return glintDictionary(); }

void writeUint(int index, uint32_t value) {
    if (index < 0 || uint32_t(index) >= maxOutputs) {
        throw std::out_of_range("the body writes output word " + std::to_string(index));
    }
    evaluation.output[index] = value;
    evaluation.kind[index] = 'u';
}

void writeFloats(int index, const float* values, int count) {
    if (index < 0 || uint32_t(index + count) > maxOutputs) {
        throw std::out_of_range("the body writes output word " + std::to_string(index));
    }
    for (int i = 0; i < count; ++i) {
        evaluation.output[index + i] = std::bit_cast<uint32_t>(values[i]);
        evaluation.kind[index + i] = '+';
    }
    evaluation.kind[index] = count == 1 ? 'f' : char('0' + count);
}

namespace {

std::vector<DifferentialTable>& tables() {
    static std::vector<DifferentialTable> list;
    return list;
}

// One word of a domain: a name and up to two numbers, as in log(1e-3,10).
struct InputSpec {
    std::string kind;
    double a = 0.0;
    double b = 0.0;
};

std::vector<InputSpec> parseDomain(const std::string& domain) {
    std::vector<InputSpec> specs;
    std::istringstream stream(domain);
    std::string word;
    while (stream >> word) {
        InputSpec spec;
        const size_t paren = word.find('(');
        spec.kind = word.substr(0, paren);
        if (paren != std::string::npos &&
            std::sscanf(word.c_str() + paren, "(%lf,%lf)", &spec.a, &spec.b) != 2) {
            throw std::runtime_error("a domain wants NAME(A,B) without spaces: " + word);
        }
        specs.push_back(spec);
    }
    return specs;
}

class InputGenerator {
public:
    explicit InputGenerator(const char* seedText) {
        uint32_t seed = 2166136261u;  // FNV-1a: the same inputs on every machine
        for (const char* c = seedText; *c != 0; ++c) {
            seed = (seed ^ uint32_t(static_cast<unsigned char>(*c))) * 16777619u;
        }
        random_.seed(seed);
    }

    void append(const InputSpec& spec, std::vector<uint32_t>& words) {
        if (spec.kind == "bits") {
            words.push_back(uint32_t(random_()));
        } else if (spec.kind == "int") {
            words.push_back(uint32_t(spec.a + std::floor(uniform() * (spec.b - spec.a + 1.0))));
        } else if (spec.kind == "unit") {
            put(words, unit());
        } else if (spec.kind == "range") {
            put(words, spec.a + (spec.b - spec.a) * uniform());
        } else if (spec.kind == "log") {
            put(words, spec.a * std::pow(spec.b / spec.a, uniform()));
        } else if (spec.kind == "dir" || spec.kind == "updir") {
            appendDirection(words, spec.kind == "updir");
        } else {
            throw std::runtime_error("unknown domain: " + spec.kind);
        }
    }

private:
    double uniform() { return double(random_() >> 8) * 0x1p-24; }

    // Both ends are where a warp breaks first: each gets one input in 64.
    double unit() {
        const uint32_t pick = uint32_t(random_()) & 63u;
        return pick == 0 ? 0.0 : pick == 1 ? 1.0 - 0x1p-24 : uniform();
    }

    void appendDirection(std::vector<uint32_t>& words, bool up) {
        const double z = up ? 1e-3 + 0.999 * uniform() : 2.0 * uniform() - 1.0;
        const double r = std::sqrt(1.0 - z * z);
        const double phi = 6.283185307179586 * uniform();
        put(words, r * std::cos(phi));
        put(words, r * std::sin(phi));
        put(words, z);
    }

    static void put(std::vector<uint32_t>& words, double value) {
        words.push_back(std::bit_cast<uint32_t>(float(value)));
    }

    std::mt19937 random_;
};

// No row of the dispatch among all models has facets that are counted, by dictionary or by trees,
// and Mesa's CPU compiler takes over a quarter of an hour for them, once for each place where a
// model is dispatched: there that model is nothing. Other tables have its parts.
constexpr const char* withoutGlints =
    "#define GP_SHADING_BSDF_GLINT_GLSL\n"
    "#define glint_bsdf_eval(m, wo, wi) bsdf_no_value()\n"
    "#define glint_bsdf_sample(m, wo, u_lobe, u) bsdf_no_sample()\n"
    "#define glint_bsdf_albedo(m, cos_o) vec3(0.0f)\n"
    "#define glint_bsdf_is_specular(m) false\n"
    "#define glint_prepared(m) m\n";

std::string glslOf(const DifferentialTable& table) {
    std::ostringstream glsl;
    glsl << "#version 460\n#extension GL_GOOGLE_include_directive : require\n"
         << (std::string(table.name) == "dispatch" ? withoutGlints : "")
         << "#include \"shading/lang.glsl\"\n#include \"shading/shading.glsl\"\n"
            "layout(local_size_x = " << VulkanCompute::groupSize << ") in;\n"
            "layout(constant_id = 0) const uint diff_function = 0u;\n"
            "layout(push_constant) uniform Push { uint in_stride; uint out_stride; uint count; "
            "uint table_low; uint table_high; } "
            "diff_push;\n"
            "layout(std430, binding = 0) readonly buffer In { uint words[]; } diff_in;\n"
            "layout(std430, binding = 1) writeonly buffer Out { uint words[]; } diff_out;\n"
            "uint in_u(int k) { return diff_in.words[gl_GlobalInvocationID.x * "
            "diff_push.in_stride + uint(k)]; }\n"
            "float in_f(int k) { return uintBitsToFloat(in_u(k)); }\n"
            "vec2 in_v2(int k) { return vec2(in_f(k), in_f(k + 1)); }\n"
            "vec3 in_v3(int k) { return vec3(in_f(k), in_f(k + 1), in_f(k + 2)); }\n"
            "vec4 in_v4(int k) { return vec4(in_v3(k), in_f(k + 3)); }\n"
            "uvec2 in_table() { return uvec2(diff_push.table_low, diff_push.table_high); }\n"
            "uvec2 in_glints() { return in_table(); }\n"
            "void put_u(int k, uint v) { diff_out.words[gl_GlobalInvocationID.x * "
            "diff_push.out_stride + uint(k)] = v; }\n"
            "void put_f(int k, float v) { put_u(k, floatBitsToUint(v)); }\n"
            "void put_v2(int k, vec2 v) { put_f(k, v.x); put_f(k + 1, v.y); }\n"
            "void put_v3(int k, vec3 v) { put_v2(k, v.xy); put_f(k + 2, v.z); }\n"
            "void put_v4(int k, vec4 v) { put_v3(k, v.xyz); put_f(k + 3, v.w); }\n";
    for (size_t i = 0; i < table.size; ++i) {
        glsl << "void diff_" << table.rows[i].name << "() " << table.rows[i].body << "\n";
    }
    glsl << "void main() {\n    if (gl_GlobalInvocationID.x >= diff_push.count) { return; }\n"
            "    switch (diff_function) {\n";
    for (size_t i = 0; i < table.size; ++i) {
        glsl << "    case " << i << "u: diff_" << table.rows[i].name << "(); break;\n";
    }
    glsl << "    }\n}\n";
    return glsl.str();
}

struct Difference {
    double relative = 0.0;
    bool bad = false;
};

Difference compareWords(const uint32_t* cpp, const uint32_t* gpu, char kind, const Tolerance& t) {
    if (kind == 'u') {
        return {cpp[0] == gpu[0] ? 0.0 : 1.0, cpp[0] != gpu[0]};
    }
    const int count = kind == 'f' ? 1 : kind - '0';
    double a2 = 0.0, b2 = 0.0, d2 = 0.0;
    for (int i = 0; i < count; ++i) {
        const double a = std::bit_cast<float>(cpp[i]);
        const double b = std::bit_cast<float>(gpu[i]);
        a2 += a * a;
        b2 += b * b;
        d2 += a == b ? 0.0 : (a - b) * (a - b);  // equal infinities are equal
    }
    const double scale = std::sqrt(std::max(a2, b2));
    const double distance = std::sqrt(d2);
    Difference result;
    result.relative = distance == 0.0 ? 0.0 : std::max(distance - t.absolute, 0.0) / scale;
    result.bad = !(distance <= t.relative * scale + t.absolute);  // NaN on either side is bad
    return result;
}

std::string describe(const uint32_t* words, size_t count) {
    std::ostringstream text;
    text.precision(9);
    for (size_t i = 0; i < count; ++i) {
        text << (i == 0 ? "" : " ") << std::bit_cast<float>(words[i]) << "/0x" << std::hex
             << words[i] << std::dec;
    }
    return text.str();
}

// A row's inputs and what C++ makes of them. The first input decides which output words there are
// and of what kind; a body must write the same ones for every input.
struct CppRun {
    std::vector<uint32_t> input;
    std::vector<uint32_t> output;
    std::string kinds;
    uint32_t inputStride = 0;
};

CppRun runCpp(const DifferentialRow& row, uint32_t count) {
    CppRun run;
    InputGenerator generator(row.name);
    const std::vector<InputSpec> specs = parseDomain(row.domain);
    for (uint32_t i = 0; i < count; ++i) {
        for (const InputSpec& spec : specs) {
            generator.append(spec, run.input);
        }
    }
    run.inputStride = uint32_t(run.input.size() / count);
    for (uint32_t i = 0; i < count; ++i) {
        evaluation = {};
        evaluation.input = run.input.data() + size_t(i) * run.inputStride;
        evaluation.inputCount = run.inputStride;
        row.evaluate();
        const std::string kinds(evaluation.kind);
        if (i == 0) {
            run.kinds = kinds;
        } else if (kinds != run.kinds) {
            throw std::runtime_error("the body writes different words for different inputs");
        }
        run.output.insert(run.output.end(), evaluation.output, evaluation.output + kinds.size());
    }
    return run;
}

void compareRow(const DifferentialRow& row, const CppRun& run, const std::vector<uint32_t>& gpu,
                uint32_t count) {
    const size_t stride = run.kinds.size();
    ASSERT_GT(stride, 0u) << row.name << " writes nothing";
    double worst = 0.0;
    uint32_t bad = 0;
    std::string example;
    for (uint32_t i = 0; i < count; ++i) {
        bool inputBad = false;
        for (size_t k = 0; k < stride; ++k) {
            if (run.kinds[k] == '+') {
                continue;
            }
            const size_t at = i * stride + k;
            const Difference d =
                compareWords(&run.output[at], &gpu[at], run.kinds[k], row.tolerance);
            inputBad = inputBad || d.bad;
            worst = std::max(worst, d.relative);
        }
        if (inputBad && bad++ == 0) {
            example = "\n  input " + describe(&run.input[size_t(i) * run.inputStride],
                                              run.inputStride) +
                      "\n  C++   " + describe(&run.output[i * stride], stride) +
                      "\n  GLSL  " + describe(&gpu[i * stride], stride);
        }
    }
    const double share = double(bad) / double(count);
    std::printf("  %-36s largest relative difference %8.2e, outside %u of %u\n", row.name, worst,
                bad, count);
    EXPECT_LE(share, row.tolerance.outliers) << row.name << example;
}

// Enough for the corners that the domains aim at; a long run looks further.
uint32_t inputCount() { return longTests() ? 1u << 20 : 1u << 17; }

class Differential : public testing::TestWithParam<size_t> {};

TEST_P(Differential, CppEqualsVulkan) {
    std::unique_ptr<VulkanCompute> vulkan;
    try {
        vulkan = VulkanCompute::create();
    } catch (const std::runtime_error& error) {
        if (std::getenv("GP_ALLOW_NO_VULKAN") != nullptr) {
            GTEST_SKIP() << error.what();
        }
        FAIL() << error.what() << " (GP_ALLOW_NO_VULKAN=1 skips this test)";
    }
    const DifferentialTable& table = tables()[GetParam()];
    std::printf("  on %s\n", vulkan->deviceName().c_str());
    const std::vector<uint32_t> spirv = compileCompute(glslOf(table), table.name);
    for (size_t i = 0; i < table.size; ++i) {
        SCOPED_TRACE(table.rows[i].name);
        const CppRun run = runCpp(table.rows[i], inputCount());
        VulkanCompute::Job job;
        job.spirv = &spirv;
        job.function = uint32_t(i);
        job.input = &run.input;
        job.inputStride = run.inputStride;
        job.outputStride = uint32_t(run.kinds.size());
        job.count = inputCount();
        if (std::strstr(table.rows[i].body, "in_table()") != nullptr) {
            job.table = std::as_bytes(std::span(measuredExample()->words));
        }
        if (std::strstr(table.rows[i].body, "in_glints()") != nullptr) {
            job.table = std::as_bytes(std::span(glintWords()));
        }
        compareRow(table.rows[i], run, vulkan->run(job), job.count);
    }
}

INSTANTIATE_TEST_SUITE_P(Tables, Differential, testing::Range<size_t>(0, tables().size()),
                         [](const auto& test) { return std::string(tables()[test.param].name); });

}  // namespace

bool registerTable(const DifferentialTable& table) {
    tables().push_back(table);
    return true;
}

}  // namespace gp::test
