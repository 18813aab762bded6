// glitterpath brdf check: verdicts on models whose faults and virtues are known.
#include <gtest/gtest.h>

#include <cmath>

#include "csv_table.h"

namespace gp::test {
namespace {

using Json = nlohmann::json;

Json checked(std::vector<std::string> words, int exitCode = 0) {
    words.insert(words.begin(), {"brdf", "check", "--json", "--samples", "50000"});
    const ToolResult result = runTool(words);
    EXPECT_EQ(result.exitCode, exitCode) << result.err << result.out;
    EXPECT_EQ(result.err, "");
    return Json::parse(result.out);
}

Json entryOf(const Json& report, const std::string& name) {
    for (const Json& check : report.at("checks")) {
        if (check.at("name") == name) {
            return check;
        }
    }
    ADD_FAILURE() << name << " is missing";
    return {};
}

TEST(BrdfCheck, LambertIsWithoutFault) {
    const Json report = checked({"lambert:base_color=0.5"});
    EXPECT_TRUE(report.at("passed").get<bool>());
    EXPECT_EQ(report.at("model"), "lambert");
    EXPECT_EQ(report.at("checks").size(), 6u);
    const Json reciprocity = entryOf(report, "reciprocity");
    EXPECT_EQ(reciprocity.at("verdict"), "ok");
    EXPECT_LT(reciprocity.at("largest_relative_error").get<double>(), 1e-5);
    EXPECT_EQ(entryOf(report, "positivity").at("not_finite"), 0);
    EXPECT_NEAR(entryOf(report, "albedo").at("largest").get<double>(), 0.5, 1e-5);
    const Json furnace = entryOf(report, "white furnace");
    EXPECT_EQ(furnace.at("set"), "base_color=1");
    EXPECT_NEAR(furnace.at("smallest").get<double>(), 1.0, 1e-5);
    EXPECT_EQ(entryOf(report, "weak white furnace").at("verdict"), "not applicable");
    const Json sampling = entryOf(report, "sampling");
    EXPECT_EQ(sampling.at("verdict"), "ok");
    EXPECT_GT(sampling.at("p_value").get<double>(), sampling.at("needed").get<double>());
    EXPECT_LT(sampling.at("integral_error").get<double>(), 0.01);
}

// Published so; their rows in the list do not claim what they break.
TEST(BrdfCheck, FindsWhatOldModelsBreak) {
    const Json phong = checked({"phong"});
    EXPECT_EQ(entryOf(phong, "reciprocity").at("verdict"), "not claimed");
    EXPECT_GT(entryOf(phong, "reciprocity").at("largest_relative_error").get<double>(), 0.2);
    const Json half = checked({"half_lambert"});
    EXPECT_EQ(entryOf(half, "albedo").at("verdict"), "not claimed");
    EXPECT_GT(entryOf(half, "albedo").at("largest").get<double>(), 1.1);
}

TEST(BrdfCheck, WhiteFurnaceHasItsClosedForm) {
    const Json report = checked({"microfacet:alpha_x=1,alpha_y=1,fresnel=schlick"});
    const Json furnace = entryOf(report, "white furnace");
    EXPECT_EQ(furnace.at("set"), "base_color=1 fresnel=none");
    // [MATERIALS.md] at the normal 1 - ln 2; nothing leaves darker than that.
    EXPECT_NEAR(furnace.at("smallest").get<double>(), 1 - std::log(2.0), 2e-3);
    EXPECT_EQ(furnace.at("smallest_theta"), 0);
}

TEST(BrdfCheck, WeakWhiteFurnaceKnowsSmith) {
    for (const char* words : {"microfacet:alpha_x=0.3,alpha_y=0.1",
                              "microfacet:distribution=beckmann,masking=smith_separable"}) {
        const Json weak = entryOf(checked({words}), "weak white furnace");
        EXPECT_EQ(weak.at("verdict"), "ok") << words;
        EXPECT_EQ(weak.at("views"), 6);
        EXPECT_LT(weak.at("largest_error").get<double>(), 0.002) << words;
    }
    const Json cavity = checked({"microfacet", "--set", "masking=v_cavity"});
    EXPECT_EQ(entryOf(cavity, "weak white furnace").at("verdict"), "not applicable");
}

TEST(BrdfCheck, MeasuresTheIndexOfGlass) {
    const Json report = checked({"ggx_dielectric:ior=1.5,alpha_x=0.3,alpha_y=0.3"});
    const Json reciprocity = entryOf(report, "reciprocity");
    EXPECT_EQ(reciprocity.at("verdict"), "ok");
    EXPECT_NEAR(reciprocity.at("squared_index").get<double>(), 2.25, 0.01);
    EXPECT_LT(entryOf(report, "albedo").at("largest").get<double>(), 1.005);
    EXPECT_GT(entryOf(report, "sampling").at("tests").get<int>(), 8);
}

// In several parts, as all of them take long.
class BrdfCheckAll : public testing::TestWithParam<std::size_t> {};
constexpr std::size_t kParts = 6;

TEST_P(BrdfCheckAll, ModelsKeepWhatTheyClaim) {
    const Json models = Json::parse(runTool({"brdf", "list", "--json"}).out);
    EXPECT_GT(models.size(), 4 * kParts);
    for (std::size_t i = GetParam(); i < models.size(); i += kParts) {
        const auto name = models[i].at("name").get<std::string>();
        if (name == "measured") {
            continue;  // needs a file
        }
        const ToolResult result = runTool({"brdf", "check", name, "--samples", "20000"});
        EXPECT_EQ(result.exitCode, 0) << result.err << result.out;
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, BrdfCheckAll, testing::Range(std::size_t{0}, kParts));

TEST(BrdfCheck, PrintsAndRefuses) {
    const TestFolder folder;
    const ToolResult text = runTool({"brdf", "check", "ward", "-o", folder("ward.txt"), "--samples",
                                     "20000"});
    EXPECT_EQ(text.exitCode, 0) << text.err;
    EXPECT_EQ(linesOf(readText(folder("ward.txt"))).size(), 7u);
    expectError(runTool({"brdf", "check"}), 2, "which MODEL?");
    expectError(runTool({"brdf", "check", "ward", "phong"}), 2, "unexpected argument 'phong'");
    expectError(runTool({"brdf", "check", "ward", "--samples", "3"}), 2, "--samples");
    expectError(runTool({"brdf", "check", "ward:alpha_x=much"}), 2, "alpha_x");
    expectError(runTool({"brdf", "check", "ward", "-o", folder("no/x")}), 1, "no/x");
}

}  // namespace
}  // namespace gp::test
