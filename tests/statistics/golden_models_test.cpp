// Golden values of whole models: every row of ../shared/golden whose model the dialect table knows
// (scene/bsdf_dialect.h) is evaluated and compared.
#include <cmath>
#include <cstdlib>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/bsdf_dialect.h"
#include "scene/bsdf_evaluate.h"
#include "statistics/golden.h"

namespace gp::test {
namespace {

BsdfWords wordsOf(const std::string& params) {
    BsdfWords words;
    const auto json = nlohmann::ordered_json::parse(params);
    for (const auto& [name, value] : json.items()) {
        std::string text;
        const auto parts = value.is_array() ? value : nlohmann::ordered_json::array({value});
        for (const auto& part : parts) {
            text += (text.empty() ? "" : ",") + part.dump();
        }
        words.emplace_back(name, text);
    }
    return words;
}

// In double: a direction's third component from a file of 17 digits.
glm::vec3 direction(const GoldenRow& row, const std::string& prefix) {
    const glm::dvec3 d(std::stod(row.at(prefix + 'x')), std::stod(row.at(prefix + 'y')),
                       std::stod(row.at(prefix + 'z')));
    return glm::vec3(glm::normalize(d));
}

struct Comparison {
    int rows = 0;
    int wrong = 0;
    double worst = 0.0;  // in tolerances
    std::string example;
};

// The narrowest width of a row's lobes; 1 where it has none.
double narrowest(const GoldenRow& row) {
    const nlohmann::json params = nlohmann::json::parse(row.at("params"));
    double width = 1.0;
    for (const char* key : {"alpha_x", "alpha_y", "alpha", "alphaG", "m", "c", "specwidth"}) {
        width = std::min(width, params.value(key, 1.0));
    }
    if (row.at("model") == "disney") {
        // Disney's mappings: the square of the roughness, narrowed across by the anisotropy; the
        // coat's width is between 0.1 and 0.001.
        const double aspect = std::sqrt(1.0 - 0.9 * params.value("anisotropic", 0.0));
        width = std::pow(params.value("roughness", 0.5), 2.0) * aspect;
        const double coat = 0.1 - 0.099 * params.value("clearcoatGloss", 1.0);
        if (params.value("clearcoat", 0.0) > 0.0) width = std::min(width, coat);
    }
    return width;
}

// The README's tolerance for float arithmetic; its looser one where a cosine or a width is small.
double tolerance(const GoldenRow& row, double expected, float smallestCosine) {
    const bool loose = smallestCosine < 0.01f || narrowest(row) < 0.01;
    return (loose ? 1e-2 : 1e-3) * std::abs(expected) + 1e-5;
}

void compare(const GoldenRow& row, BsdfDialect dialect, Comparison& c) {
    const BsdfSettings settings =
        bsdfFromWords(dialect, row.at("model"), wordsOf(row.at("params")));
    EXPECT_TRUE(settings.notices.empty()) << settings.notices[0];
    const glm::vec3 wi = direction(row, "l"), wo = direction(row, "v");
    const BsdfReading reading = evaluateBsdf(settings, wi, wo);
    const char* const channels[] = {"r", "g", "b"};
    double worst = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double expected = std::strtod(row.at(channels[i]).c_str(), nullptr);
        const double allowed = tolerance(row, expected, std::min(wi.z, wo.z));
        worst = std::max(worst, std::abs(double(reading.f[i]) - expected) / allowed);
    }
    ++c.rows;
    c.worst = std::max(c.worst, worst);
    if (worst <= 1.0) return;
    if (c.wrong++ > 0) return;
    c.example = fmt::format("{} wi {} {} {} wo {} {} {}: {} {} {}, expected {} {} {}",
                            row.at("params"), wi.x, wi.y, wi.z, wo.x, wo.y, wo.z, reading.f.x,
                            reading.f.y, reading.f.z, row.at("r"), row.at("g"), row.at("b"));
}

class GoldenModels : public testing::TestWithParam<DialectModel> {};

TEST_P(GoldenModels, MatchEveryRow) {
    const DialectModel& model = GetParam();
    const char* file = model.dialect == BsdfDialect::wdas ? "golden_brdf.csv" : "golden_bbm.csv";
    static std::map<std::string, std::vector<GoldenRow>> files;
    if (!files.contains(file)) files[file] = readGolden(file);
    GP_SKIP_WITHOUT(files[file], file);
    Comparison c;
    for (const GoldenRow& row : files[file]) {
        if (row.at("model") == model.name) compare(row, model.dialect, c);
    }
    fmt::print("  {:24} {:5} rows, largest difference {:.3f} tolerances\n", model.name, c.rows,
               c.worst);
    EXPECT_GT(c.rows, 100);
    EXPECT_EQ(c.wrong, 0) << c.example;
}

std::string modelName(const testing::TestParamInfo<DialectModel>& info) {
    return (info.param.dialect == BsdfDialect::wdas ? "wdas_" : "bbm_") + info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Dialects, GoldenModels, testing::ValuesIn(dialectModels()), modelName);

}  // namespace

inline void PrintTo(const DialectModel& model, std::ostream* out) { *out << model.name; }

}  // namespace gp::test
