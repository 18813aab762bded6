// glitterpath brdf sphere and sweep: spheres with known answers, labels, and what they refuse.
#include <gtest/gtest.h>

#include <cmath>

#include "csv_table.h"

namespace gp::test {
namespace {

struct Radiance {
    unsigned width = 0, height = 0;
    std::vector<float> rgba;
    float green(unsigned x, unsigned y) const { return rgba[4 * (std::size_t{y} * width + x) + 1]; }
};

Radiance spheres(std::vector<std::string> words) {
    const TestFolder folder;
    words.insert(words.begin(), {"brdf", "sphere", "-o", folder("s.exr")});
    const ToolResult result = runTool(words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "");
    Radiance picture;
    picture.rgba = readPicture(folder("s.exr"), picture.width, picture.height);
    return picture;
}

TEST(BrdfSphere, IsLitFromWhereItIsTold) {
    const Radiance front = spheres({"lambert", "lambert:base_color=0.5", "--light", "0,0", "--size",
                                    "32", "--samples", "16"});
    ASSERT_EQ(front.width, 64u);
    ASSERT_EQ(front.height, 32u);
    EXPECT_NEAR(front.green(16, 16), 1.0, 0.01);
    EXPECT_NEAR(front.green(48, 16), 0.5, 0.01);
    // A pixel is 2.1 / 32 wide: this one lies at 0.69 of the radius.
    EXPECT_NEAR(front.green(26, 16), std::sqrt(1 - 0.69 * 0.69), 0.02);
    EXPECT_EQ(front.green(0, 0), 0.0f);
    const Radiance right = spheres({"lambert", "--light", "90,0", "--size", "32", "--samples",
                                    "16"});
    EXPECT_NEAR(right.green(26, 16), 0.69, 0.02);
    EXPECT_EQ(right.green(8, 16), 0.0f);
    const Radiance above = spheres({"lambert", "--light", "0,90", "--size", "32", "--samples",
                                    "16"});
    EXPECT_NEAR(above.green(16, 5), 0.69, 0.03);
    EXPECT_EQ(above.green(16, 26), 0.0f);
}

// The tangent runs to the right: rough along it, the highlight is drawn out along it.
TEST(BrdfSphere, HasItsTangents) {
    const auto spread = [](const Radiance& picture, int dx, int dy) {
        return picture.green(static_cast<unsigned>(24 + dx), static_cast<unsigned>(24 + dy));
    };
    const Radiance picture = spheres({"ggx_conductor:alpha_x=0.5,alpha_y=0.05", "--light", "0,0",
                                      "--size", "48", "--samples", "64"});
    EXPECT_GT(spread(picture, 8, 0), 20 * spread(picture, 0, 8));
}

TEST(BrdfSphere, WhiteOneVanishesInAFurnace) {
    const TestFolder folder;
    writePicture(folder("furnace.exr"), 16, 8, uniformRgba(16, 8, 0.5f, 0.5f, 0.5f));
    const Radiance picture = spheres({"lambert", "kulla_conty", "--env", folder("furnace.exr"),
                                      "--size", "24", "--samples", "64"});
    for (std::size_t i = 1; i < picture.rgba.size(); i += 4) {
        ASSERT_NEAR(picture.rgba[i], 0.5, 0.15);  // noise
    }
    double sum = 0;
    for (std::size_t i = 1; i < picture.rgba.size(); i += 4) {
        sum += picture.rgba[i];
    }
    EXPECT_NEAR(sum / (24 * 48), 0.5, 0.003);
}

TEST(BrdfSphere, DrawsLabelsAndExposure) {
    const TestFolder folder;
    const auto sphere = [&](const char* file, const char* exposure) {
        return runTool({"brdf", "sphere", "ward:form=duer", "disney", "-o", folder(file), "--size",
                        "128", "--samples", "2", "--exposure", exposure});
    };
    EXPECT_EQ(sphere("s.svg", "0").exitCode, 0);
    const std::string svg = readText(folder("s.svg"));
    EXPECT_NE(svg.find("disney"), std::string::npos);
    EXPECT_NE(svg.find("ward:form=duer"), std::string::npos);
    double means[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(sphere("s.png", i == 0 ? "-3" : "0").exitCode, 0);
        unsigned width = 0, height = 0;
        for (const float x : readPicture(folder("s.png"), width, height)) {
            means[i] += x;
        }
    }
    EXPECT_LT(means[0], means[1]);
}

TEST(BrdfSweep, TellsItsValues) {
    const TestFolder folder;
    const ToolResult result =
        runTool({"brdf", "sweep", "disney", "--param", "roughness", "version", "--steps", "5", "-o",
                 folder("s.svg"), "--size", "48", "--samples", "1"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const std::string svg = readText(folder("s.svg"));
    for (const char* text : {"0.25", "0.75", "roughness", "2014", "2012", "disney"}) {
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    }
    const ToolResult factors = runTool({"brdf", "sweep", "phong", "--param", "exponent", "--steps",
                                        "3", "-o", folder("s.svg"), "--size", "48", "--samples",
                                        "1"});
    EXPECT_EQ(factors.exitCode, 0) << factors.err;
    EXPECT_NE(readText(folder("s.svg")).find("316.2"), std::string::npos);  // of 1 to 100,000
}

TEST(BrdfSphere, IsInterrupted) {
    const TestFolder folder;
    const ToolResult result = runTool({"brdf", "sphere", "disney", "-o", folder("s.png"), "--size",
                                       "1024", "--samples", "100000"}, 1.0);
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_NE(result.err.find("nothing saved"), std::string::npos) << result.err;
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(BrdfSphere, Refuses) {
    const TestFolder folder;
    const auto run = [&](const char* command, std::vector<std::string> words) {
        words.insert(words.begin(), {"brdf", command, "-o", folder("x.png")});
        return runTool(words);
    };
    expectError(run("sphere", {}), 2, "which MODEL?");
    expectError(run("sphere", {"lambert", "--light", "3"}), 2, "AZIMUTH,ELEVATION");
    expectError(run("sphere", {"lambert", "--light", "3,91"}), 2, "-90..90");
    expectError(run("sphere", {"lambert", "--env", folder("none.hdr")}), 1, "none.hdr");
    expectError(run("sphere", {"lambert", "--samples", "0"}), 2, "--samples");
    expectError(runTool({"brdf", "sphere", "lambert", "-o", folder("x.exr"), "--exposure", "1"}), 2,
                "--exposure");
    expectError(runTool({"brdf", "sphere", "lambert", "-o", folder("x.bmp")}), 2, ".png or .svg");
    expectError(run("sweep", {"disney"}), 2, "--param");
    expectError(run("sweep", {"disney", "--param", "base_color"}), 2, "is a colour");
    expectError(run("sweep", {"disney", "--param", "roughnes"}), 2, "did you mean roughness?");
    expectError(run("sweep", {"disney", "--param", "roughness", "--to", "2"}), 2, "from 0 to 1");
    expectError(run("sweep", {"disney", "--param", "version", "--to", "2"}), 2, "is no number");
    expectError(run("sweep", {"disney", "--param", "roughness", "--steps", "1"}), 2, "--steps");
    EXPECT_EQ(folder.fileCount(), 0u);
}

}  // namespace
}  // namespace gp::test
