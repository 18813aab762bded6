// glitterpath brdf export: models as measured files, and measured files as models.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tool_runner.h"

namespace gp::test {
namespace {

constexpr const char* kHead = "model,params,lx,ly,lz,vx,vy,vz\n";

std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line) {
        quoted = quoted != (c == '"');
        if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

// The columns r, g, b and pdf of a table's rows.
std::vector<std::array<double, 4>> evaluateRows(const TestFolder& folder, const std::string& rows) {
    writeText(folder("in.csv"), kHead + rows);
    const ToolResult result =
        runTool({"brdf", "eval", "--csv", folder("in.csv"), "-o", folder("out.csv")});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    std::vector<std::array<double, 4>> values;
    for (const std::string& line : linesOf(readText(folder("out.csv")))) {
        const std::vector<std::string> fields = fieldsOf(line);
        if (fields[0] == "model") {
            continue;
        }
        values.push_back({std::stod(fields[8]), std::stod(fields[9]), std::stod(fields[10]),
                          std::stod(fields[11])});
    }
    return values;
}

// Pairs of directions well above the horizon, the same for every test.
std::vector<std::string> someDirections() {
    std::vector<std::string> list;
    for (int i = 0; i < 60; ++i) {
        const double a = 0.37 * i, b = 1.3 * i, r = 0.1 + 0.013 * i, s = 0.85 - 0.012 * i;
        char text[160];
        std::snprintf(text, sizeof text, "%.6f,%.6f,%.6f,%.6f,%.6f,%.6f", r * std::cos(a),
                      r * std::sin(a), std::sqrt(1 - r * r), s * std::cos(b), s * std::sin(b),
                      std::sqrt(1 - s * s));
        list.emplace_back(text);
    }
    return list;
}

// The largest difference over the larger value, and the mean one.
struct Errors {
    double largest = 0, mean = 0;
};
Errors compareWithItsFile(const TestFolder& folder, const std::string& model,
                          const std::vector<std::string>& settings, const std::string& params) {
    std::vector<std::string> arguments = {"brdf", "export", model, "-o", folder("m.binary")};
    if (!settings.empty()) {
        arguments.push_back("--set");
    }
    arguments.insert(arguments.end(), settings.begin(), settings.end());
    const ToolResult result = runTool(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "");
    std::string analytic, measured;
    for (const std::string& directions : someDirections()) {
        analytic += model + "," + params + "," + directions + "\n";
        measured += folder("m.binary") + ",{}," + directions + "\n";
    }
    const auto expected = evaluateRows(folder, analytic), got = evaluateRows(folder, measured);
    Errors errors;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = expected[i][c], b = got[i][c];
            const double relative = a == b ? 0 : std::abs(a - b) / std::max(a, b);
            errors.largest = std::max(errors.largest, relative);
            errors.mean += relative / (3.0 * static_cast<double>(expected.size()));
        }
        EXPECT_GT(got[i][3], 0);
    }
    return errors;
}

TEST(BrdfExport, LambertComesBackExactly) {
    const TestFolder folder;
    const Errors errors = compareWithItsFile(folder, "lambert", {"base_color=0.8,0.4,0.1"},
                                             "\"{\"\"base_color\"\":[0.8,0.4,0.1]}\"");
    EXPECT_LT(errors.largest, 1e-6);  // some units of a float's last place
    EXPECT_EQ(readText(folder("m.binary")).size(), 34'992'012u);
    EXPECT_EQ(folder.fileCount(), 3u);  // with the two tables: no temporary file is left
    const ToolResult json = runTool({"brdf", "eval", folder("m.binary"), "--set",
                                     "interpolation=nearest", "base_color=0.5", "--wi", "1,1,2",
                                     "--wo", "-3,0,1", "--json"});
    ASSERT_EQ(json.exitCode, 0) << json.err;
    const nlohmann::json values = nlohmann::json::parse(json.out);
    EXPECT_EQ(values.at("model"), "measured");
    EXPECT_EQ(values.at("file"), folder("m.binary"));
    EXPECT_NEAR(values.at("f")[0].get<double>(), 0.5 * 0.8 / M_PI, 1e-7);
}

// Between the centres of cells trilinear look-up is a chord: of a lobe of this width it is off by
// the squares of the steps, which are widest (2 degrees) far from the highlight.
TEST(BrdfExport, AGlossyMetalComesBackNearly) {
    const TestFolder folder;
    const Errors errors = compareWithItsFile(
        folder, "ggx_conductor", {"alpha_x=0.3", "alpha_y=0.3", "base_color=0.9,0.7,0.4"},
        "\"{\"\"alpha_x\"\":0.3,\"\"alpha_y\"\":0.3,\"\"base_color\"\":[0.9,0.7,0.4]}\"");
    EXPECT_LT(errors.mean, 2e-3);
    EXPECT_LT(errors.largest, 1e-2);
}

TEST(BrdfExport, SaysWhatTheFormatCannotHold) {
    const TestFolder folder;
    const ToolResult ward = runTool({"brdf", "export", "ward", "--set", "alpha_x=0.5",
                                     "alpha_y=0.1", "-o", folder("w.binary")});
    EXPECT_EQ(ward.exitCode, 0) << ward.err;
    EXPECT_NE(ward.err.find("ward is anisotropic: a cell is the mean of 32 azimuths"),
              std::string::npos) << ward.err;
    const ToolResult phong = runTool({"brdf", "export", "phong", "-o", folder("p.binary")});
    EXPECT_EQ(phong.exitCode, 0) << phong.err;
    EXPECT_NE(phong.err.find("phong is not reciprocal: a cell is the mean of both ways"),
              std::string::npos) << phong.err;
    const ToolResult sheet =
        runTool({"brdf", "export", "thin_dielectric", "-o", folder("t.binary")});
    EXPECT_NE(sheet.err.find("thin_dielectric: only what is reflected is kept"),
              std::string::npos) << sheet.err;
}

TEST(BrdfExport, RefusesWhatItCannotDo) {
    const TestFolder folder;
    const std::string out = folder("x.binary");
    expectRefusal(runTool({"brdf", "export", "lambert"}), 2, "-o");
    expectRefusal(runTool({"brdf", "export", "lambert", "-o", folder("x.bin")}), 2,
                "does not end with .binary");
    expectRefusal(runTool({"brdf", "export", "lambrt", "-o", out}), 2, "did you mean lambert?");
    expectRefusal(runTool({"brdf", "export", "lambert", "-o", folder("no/x.binary")}), 1,
                "no folder");
    expectRefusal(runTool({"brdf", "export", "measured", "-o", out}), 2, "is made from a file");
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(BrdfExport, BadFilesAreOneLine) {
    const TestFolder folder;
    const auto eval = [&](const std::string& name) {
        return runTool({"brdf", "eval", folder(name), "--wi", "0,0,1", "--wo", "0,0,1"});
    };
    expectRefusal(eval("none.binary"), 1, "none.binary: no such file");
    writeText(folder("short.binary"), "short");
    expectRefusal(eval("short.binary"), 1, "short.binary: has only 5 bytes: no MERL file");
    std::string head(12, '\0');
    const std::int32_t sizes[3] = {90, 90, 360};
    std::memcpy(head.data(), sizes, sizeof sizes);
    writeText(folder("wide.binary"), head);
    expectRefusal(eval("wide.binary"), 1, "its dimensions are 90 x 90 x 360");
}

}  // namespace
}  // namespace gp::test
