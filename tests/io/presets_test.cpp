// Presets: ours are whole and say nothing out of range, metals reflect what their index says; files
// of any content give a line with file, line and thing.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/bsdf_source.h"
#include "io/file_error.h"
#include "scene/bsdf_evaluate.h"

namespace gp::io {
namespace {

glm::vec3 valueOf(const BsdfSettings& s, const std::string& name) {
    const BsdfParameterInfo& p = findBsdfParameter(*s.model, name);
    return s.values[size_t(&p - s.model->parameters.data())];
}

TEST(Presets, OursAreWhole) {
    EXPECT_GE(builtInPresets().size(), 40u);
    for (const Preset& preset : builtInPresets()) {
        SCOPED_TRACE(preset.name);
        EXPECT_FALSE(preset.title.empty());
        EXPECT_FALSE(preset.group.empty());
        const BsdfSettings settings = bsdfFromName(BsdfDialect::own, preset.name, {});
        EXPECT_TRUE(settings.notices.empty()) << settings.notices[0];
        const BsdfReading reading =
            evaluateBsdf(settings, glm::normalize(glm::vec3(0.1f, 0, 1)), glm::vec3(0, 0, 1));
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(reading.f[c]) && reading.f[c] >= 0);
        // A preset's name must not hide a model's.
        for (const BsdfModelInfo& model : bsdfModels()) EXPECT_NE(model.name, preset.name);
    }
}

// [Born and Wolf, "Principles of Optics": ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2)]
TEST(Presets, GoldReflectsRed) {
    const BsdfSettings gold = bsdfFromName(BsdfDialect::own, "gold", {{"masking", "none"}});
    const glm::vec3 n = valueOf(gold, "eta"), k = valueOf(gold, "k");
    const glm::vec3 below = n - 1.0f, above = n + 1.0f;
    const glm::vec3 expected = (below * below + k * k) / (above * above + k * k);
    EXPECT_GT(expected.x, 0.9f);
    EXPECT_LT(expected.z, 0.45f);
    const glm::vec3 up(0, 0, 1);
    const glm::vec3 f = evaluateBsdf(gold, up, up).f;
    for (int c = 1; c < 3; ++c) EXPECT_NEAR(f[c] / f[0], expected[c] / expected[0], 1e-4f);
}

TEST(Presets, StacksAreTheParametersInBetween) {
    const BsdfSettings iron = bsdfFromName(BsdfDialect::own, "clean_iron", {});
    const BsdfSettings rust = bsdfFromName(BsdfDialect::own, "rust", {});
    const BsdfSettings both = bsdfFromName(BsdfDialect::own, "rusty_iron", {{"sheen", "0.25"}});
    for (const char* name : {"base_color", "metallic", "roughness", "specular"})
        for (int c = 0; c < 3; ++c)
            EXPECT_FLOAT_EQ(valueOf(both, name)[c],
                            0.45f * valueOf(iron, name)[c] + 0.55f * valueOf(rust, name)[c]);
    EXPECT_EQ(valueOf(both, "sheen").x, 0.25f);
}

TEST(Presets, AFilesOwn) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "glitterpath_presets";
    std::filesystem::create_directories(folder);
    const std::string path = (folder / "mine.toml").string();
    std::ofstream(path) << "[base]\npreset = \"gold\"\nset = { alpha_x = 0.5 }\n"
                           "[masked]\nlayers = [{ preset = \"base\" },\n"
                           " { preset = \"silver\", mask = \"m.png\", channel = \"g\" }]\n";
    EXPECT_EQ(valueOf(bsdfFromName(BsdfDialect::own, path + "#base", {}), "alpha_x").x, 0.5f);
    const Preset masked = stackFromName(path + "#masked");
    ASSERT_EQ(masked.layers.size(), 2u);
    EXPECT_EQ(masked.layers[1].maskPath, (folder / "m.png").string());
    EXPECT_EQ(masked.layers[1].channel, 1u);
    EXPECT_THROW(bsdfFromName(BsdfDialect::own, path + "#masked", {}), BsdfError);
    EXPECT_THROW(stackFromName(path), FileError);          // which of the two?
    EXPECT_THROW(stackFromName(path + "#mask"), FileError);
    EXPECT_THROW(stackFromName((folder / "none.toml").string()), FileError);
    std::filesystem::remove_all(folder);
}

TEST(Presets, HostileFiles) {
    const std::pair<const char*, const char*> rows[] = {
        {"[a", "f.toml:1"},
        {"a = 1", "f.toml:1: a is no table"},
        {"[a]\ntitle = 3\nmodel = \"phong\"", "f.toml:2: title is no string"},
        {"[a]", "f.toml:1: a: either model or preset"},
        {"[a]\nmodel = \"phong\"\npreset = \"gold\"", "either model or preset"},
        {"[a]\nmodel = \"phongg\"", "a: unknown model 'phongg' (did you mean phong?)"},
        {"[a]\npreset = \"golt\"", "a: unknown preset 'golt' (did you mean gold?)"},
        {"[a]\npreset = \"a\"", "unknown preset 'a'"},
        {"[a]\nmodl = \"phong\"", "f.toml:2: unknown key 'modl' (did you mean model?)"},
        {"[a]\nmodel = \"phong\"\nset = 5", "f.toml:3: a: set is no table"},
        {"[a]\nmodel = \"phong\"\nset = { exponent = [] }", "exponent: '' is not a finite number"},
        {"[a]\nmodel = \"phong\"\nset = { exponent = inf }", "not a finite number"},
        {"[a]\nmodel = \"phong\"\nset = { exponent = { x = 1 } }", "f.toml:3: a value is"},
        {"[a]\nmodel = \"phong\"\nset = { exponnt = 1 }", "(did you mean exponent?)"},
        {"[a]\nmodel = \"measured\"", "a: measured is made from a file"},
        {"[a]\nlayers = []", "f.toml:2: a: layers is no list"},
        {"[a]\nmodel = \"phong\"\nlayers = [{ preset = \"gold\" }]", "belong into them"},
        {"[a]\nlayers = [{ preset = \"gold\" }, { preset = \"felt\" }]",
         "oren_nayar cannot be blended over microfacet"},
        {"[a]\nlayers = [{ preset = \"gold\" }, { preset = \"gold\", weight = 2 }]",
         "weight is no number from 0 to 1"},
        {"[a]\nlayers = [{ preset = \"gold\", weight = 0.5 }]", "the bottom layer has no weight"},
        {"[a]\nlayers = [{ preset = \"gold\" }, { preset = \"gold\", channel = \"rg\" }]",
         "channel is 'rg'"},
    };
    std::string deep = "a";
    for (int i = 0; i < 100000; ++i) deep += i % 2 ? ".a" : " .\t\"a = 1\"";
    const std::string deepHeader = "b = 1\n[" + deep + "]\nmodel = \"phong\"";
    const std::string deepInline = "[a]\nset = { " + deep + " = 1 }";
    std::vector<std::pair<const char*, const char*>> all(std::begin(rows), std::end(rows));
    all.emplace_back(deepHeader.c_str(), "f.toml:2: a key of more than 16 parts");
    all.emplace_back(deepInline.c_str(), "f.toml:2: a key of more than 16 parts");
    for (const auto& [text, message] : all) {
        try {
            parsePresets(text, "f.toml");
            ADD_FAILURE() << text;
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos)
                << error.what() << "\nexpected: " << message;
        }
    }
}

}  // namespace
}  // namespace gp::io
