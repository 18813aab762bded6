// glitterpath brdf plot: the numbers behind its curves, its pictures, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>

#include "csv_table.h"

namespace gp::test {
namespace {

// Runs `brdf plot` with a table, and gives that.
Table plotted(const TestFolder& folder, std::vector<std::string> words) {
    std::vector<std::string> all = {"brdf", "plot", "-o", folder("plot.png"), "--csv",
                                    folder("plot.csv")};
    all.insert(all.end(), words.begin(), words.end());
    const ToolResult result = runTool(all);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    unsigned width = 0, height = 0;
    readPicture(folder("plot.png"), width, height);
    EXPECT_EQ(width, 900u);
    EXPECT_EQ(height, 600u);
    return Table(readText(folder("plot.csv")));
}

TEST(BrdfPlot, ThetaVHasTheMirrorAtPlusThetaI) {
    const TestFolder folder;
    const Table table = plotted(folder, {"ward:base_color=0", "--kind", "theta-v", "--theta-i",
                                         "20", "50", "--channel", "rgb"});
    for (const double thetaI : {20.0, 50.0}) {
        double best = 0, where = 0;
        for (const Table::Row& row : table.rows()) {
            // Ward's lobe of 1992 rises again at the horizon.
            if (row.number("theta_i") == thetaI && std::abs(row.number("theta_v")) < 80 &&
                row.number("f_g") > best) {
                best = row.number("f_g");
                where = row.number("theta_v");
            }
        }
        EXPECT_NEAR(where, thetaI, 3.0);
        EXPECT_GT(best, 1.0);
    }
}

TEST(BrdfPlot, SetsWhatAModelKnowsAndHasNotSetItself) {
    const TestFolder folder;
    const Table table =
        plotted(folder, {"lambert:base_color=1,0.5,0", "lambert", "phong", "--set",
                         "base_color=0.25", "exponent=0", "--kind", "theta-d", "--phi-d", "0"});
    int rows = 0;
    for (const Table::Row& row : table.rows()) {
        if (row.text("f_r").empty()) {
            continue;  // below the horizon
        }
        if (row.text("model") == "lambert") {
            EXPECT_NEAR(row.number("f_r"), 0.25 / M_PI, 1e-6);
        } else if (row.text("model") == "phong") {
            // (cos of the mirror's angle)^0, over the light's cosine
            const double cosine = std::cos(row.number("theta_d") * M_PI / 180);
            EXPECT_NEAR(row.number("f_b") * cosine, 0.25, 1e-4);
        } else {
            EXPECT_EQ(row.text("model"), "lambert:base_color=1,0.5,0");
            EXPECT_NEAR(row.number("f_g"), 0.5 / M_PI, 1e-6);
        }
        ++rows;
    }
    EXPECT_GT(rows, 900);
}

TEST(BrdfPlot, HalfAnglesEndAtTheHorizon) {
    const TestFolder folder;
    const Table table = plotted(folder, {"lambert", "--kind", "theta-h", "--theta-d", "30",
                                         "--phi-d", "0", "--times-cos"});
    for (const Table::Row& row : table.rows()) {
        // In one plane: the light stands at theta_h + theta_d.
        const double light = row.number("theta_h") + 30.0;
        EXPECT_EQ(row.text("fcos_r").empty(), light > 90.0) << light;
        if (light < 90.0) {
            EXPECT_NEAR(row.number("fcos_r"), std::cos(light * M_PI / 180) / M_PI, 1e-6);
        }
    }
}

TEST(BrdfPlot, AlbedoKnowsItsError) {
    const TestFolder folder;
    const Table table = plotted(folder, {"lambert:base_color=0.3", "ggx_conductor",
                                         "ggx_dielectric", "--set", "alpha_x=1",
                                         "alpha_y=1", "--kind", "albedo"});
    for (const Table::Row& row : table.rows()) {
        if (row.text("model")[0] == 'l') {
            EXPECT_NEAR(row.number("r"), 0.3, 1e-6);
            EXPECT_LT(row.number("error_r"), 1e-6);
        } else if (row.text("model") == "ggx_conductor" && row.number("theta_o") == 0) {
            // [MATERIALS.md] GGX of width 1, height-correlated, no Fresnel: 1 - ln 2
            EXPECT_NEAR(row.number("g"), 1 - std::log(2.0), 5 * row.number("error_g") + 1e-6);
            EXPECT_GT(row.number("error_g"), 0);
            EXPECT_LT(row.number("error_g"), 1e-3);
        } else if (row.text("model") == "ggx_dielectric" && row.number("theta_o") < 10) {
            // Energy, not radiance: nothing is divided by the square of the index.
            EXPECT_GT(row.number("b"), 0.8);
            EXPECT_LT(row.number("b"), 1.0);
        }
    }
}

TEST(BrdfPlot, DrawsEveryKind) {
    const TestFolder folder;
    for (const char* kind : {"polar", "theta-v", "theta-h", "theta-d", "albedo", "3d"}) {
        for (const char* file : {"plot.png", "plot.svg"}) {
            std::vector<std::string> words = {"brdf", "plot",   "ward", "ggx_dielectric",
                                              "--kind", kind, "-o",   folder(file)};
            if (std::string(kind) != "albedo") {
                words.push_back("--log");
            }
            const ToolResult result = runTool(words);
            EXPECT_EQ(result.exitCode, 0) << kind << ": " << result.err;
            EXPECT_EQ(result.out + result.err, "") << kind;
            EXPECT_GT(readText(folder(file)).size(), 5000u) << kind;
        }
    }
}

TEST(BrdfPlot, LobeIsGivenAsATable) {
    const TestFolder folder;
    const Table table = plotted(folder, {"lambert", "--kind", "3d"});
    EXPECT_GT(table.rows().size(), 5000u);
    for (const Table::Row& row : table.rows()) {
        const bool grazing = row.number("theta_v") > 89.99;
        EXPECT_NEAR(row.number("f_r"), grazing ? row.number("f_r") : 1 / M_PI, 1e-6);
    }
}

TEST(BrdfPlot, Refuses) {
    const TestFolder folder;
    const std::string out = folder("x.png");
    const auto plot = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"brdf", "plot", "-o", out});
        return runTool(words);
    };
    expectError(plot({"--kind", "polar"}), 2, "which MODEL?");
    expectError(plot({"ward"}), 2, "--kind");
    expectError(plot({"ward", "--kind", "4d"}), 2, "theta-h");
    expectError(plot({"wardd", "--kind", "polar"}), 2, "did you mean ward?");
    expectError(plot({"ward:alpha_z=1", "--kind", "polar"}), 2, "alpha_z");
    expectError(plot({"ward:alpha_x", "--kind", "polar"}), 2, "NAME=VALUE");
    expectError(plot({":alpha_x=1", "--kind", "polar"}), 2, "no name");
    expectError(plot({"ward", "phong", "--set", "sigma=1", "--kind", "polar"}), 2,
                "none of the models has a parameter 'sigma'");
    expectError(plot({"ward", "--set", "sigma=1", "--kind", "polar"}), 2, "sigma");
    expectError(plot({"ward", "--kind", "polar", "--theta-h", "3"}), 2, "--theta-h");
    expectError(plot({"ward", "--kind", "albedo", "--times-cos"}), 2, "--times-cos");
    expectError(plot({"ward", "--kind", "polar", "--samples", "1000"}), 2, "--samples");
    expectError(plot({"ward", "--kind", "theta-v", "--theta-i", "91"}), 2, "0..90");
    expectError(plot({"ward", "--kind", "3d", "--channel", "rgb"}), 2, "--channel");
    expectError(plot({"ward", "--kind", "polar", "--csv", folder("no/x.csv")}), 1, "no/x.csv");
    expectError(plot({"lambert:base_color=0", "--kind", "theta-v", "--log"}), 1, "nothing above 0");
    expectError(runTool({"brdf", "plot", "ward", "--kind", "polar", "-o", folder("x.jpg")}), 2,
                ".png or .svg");
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(BrdfEval, TakesParametersWithTheModel) {
    const ToolResult a = runTool({"brdf", "eval", "ward:alpha_x=0.3,base_color=0.8,0.5,0.3",
                                  "--wi", "0,0,1", "--wo", "1,0,1"});
    const ToolResult b = runTool({"brdf", "eval", "ward", "--set", "alpha_x=0.3",
                                  "base_color=0.8,0.5,0.3", "--wi", "0,0,1", "--wo", "1,0,1"});
    EXPECT_EQ(a.exitCode, 0) << a.err;
    EXPECT_EQ(a.out, b.out);
    expectError(runTool({"brdf", "eval", "ward", "phong", "--wi", "0,0,1", "--wo", "0,0,1"}), 2,
                "unexpected argument 'phong'");
}

}  // namespace
}  // namespace gp::test
