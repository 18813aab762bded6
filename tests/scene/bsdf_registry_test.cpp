// The registry of reflectance models: every row reaches its model, words are read or refused.
#include <array>
#include <bit>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "shading/shading.h"
#include "scene/bsdf_registry.h"
#include "scene/bsdf_settings.h"

namespace gp {
namespace {

using Words = std::array<uint32_t, sizeof(shading::BsdfParams) / sizeof(uint32_t)>;

Words wordsOf(const BsdfSettings& settings) {
    return std::bit_cast<Words>(bareBsdfParams(settings));
}

// A value that differs from the default in every component.
std::string otherValue(const BsdfParameterInfo& p) {
    switch (p.type) {
    case BsdfParameterType::boolean: return p.initial.x > 0.5f ? "false" : "true";
    case BsdfParameterType::choice: return p.initial.x > 0.5f ? p.choices[0] : p.choices.back();
    case BsdfParameterType::number:
    case BsdfParameterType::color: break;
    }
    const float middle = 0.5f * (p.minimum + p.maximum);
    return fmt::format("{}", p.initial.x == middle ? p.maximum : middle);
}

TEST(BsdfRegistry, RowsAreWhole) {
    std::set<std::string> names;
    std::set<uint32_t> numbers;
    std::ifstream file(GP_SOURCE_DIR "/docs/references.md");
    std::ostringstream references;
    references << file.rdbuf();
    for (const BsdfModelInfo& model : bsdfModels()) {
        EXPECT_TRUE(names.insert(model.name).second) << model.name;
        EXPECT_TRUE(numbers.insert(model.number).second) << model.name;
        EXPECT_NE(references.str().find('`' + model.reference + '`'), std::string::npos)
            << model.name << ": " << model.reference << " is not in docs/references.md";
        EXPECT_FALSE(model.text.empty()) << model.name;
        EXPECT_FALSE(model.parameters.empty()) << model.name;
        std::set<std::string> parameters;
        for (const BsdfParameterInfo& p : model.parameters) {
            EXPECT_TRUE(parameters.insert(p.name).second) << model.name << " " << p.name;
            EXPECT_FALSE(p.text.empty()) << model.name << " " << p.name;
            EXPECT_LT(p.minimum, p.maximum) << model.name << " " << p.name;
            if (p.type == BsdfParameterType::choice) {
                EXPECT_GT(p.choices.size(), 1u) << model.name << " " << p.name;
                EXPECT_LT(p.initial.x, float(p.choices.size())) << model.name << " " << p.name;
            } else {
                EXPECT_GE(p.initial.x, p.minimum) << model.name << " " << p.name;
                EXPECT_LE(p.initial.x, p.maximum) << model.name << " " << p.name;
            }
        }
    }
}

// Each parameter changes words of BsdfParams, and no word belongs to two.
TEST(BsdfRegistry, ParametersHaveTheirOwnPlaces) {
    for (const BsdfModelInfo& model : bsdfModels()) {
        const Words before = wordsOf(BsdfSettings(model));
        std::set<std::size_t> taken;
        for (const BsdfParameterInfo& p : model.parameters) {
            BsdfSettings settings(model);
            settings.set(p.name, otherValue(p));
            const Words after = wordsOf(settings);
            std::size_t changed = 0;
            for (std::size_t i = 0; i < before.size(); ++i) {
                if (after[i] == before[i]) continue;
                ++changed;
                EXPECT_TRUE(taken.insert(i).second) << model.name << " " << p.name;
            }
            EXPECT_EQ(changed, p.type == BsdfParameterType::color ? 3u : 1u)
                << model.name << " " << p.name << "=" << otherValue(p);
            // What is said of a value can be set again.
            const auto index = static_cast<std::size_t>(&p - model.parameters.data());
            BsdfSettings again(model);
            again.set(p.name, bsdfValueText(p, settings.values[index]));
            EXPECT_EQ(wordsOf(again), after) << model.name << " " << p.name;
            EXPECT_TRUE(settings.notices.empty()) << model.name << " " << p.name;
        }
        EXPECT_EQ(bsdfParamsFrom(BsdfSettings(model)).model, model.number);
    }
}

TEST(BsdfRegistry, ReadsWords) {
    BsdfSettings settings(findBsdfModel("half_lambert"));
    settings.set("base_color", "0.1,+0.2,3e-1");
    settings.set("wrap", "0.25");
    const shading::BsdfParams m = bsdfParamsFrom(settings);
    EXPECT_EQ(m.base_color, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(shading::half_lambert_wrap(m), 0.25f);
    settings.set("base_color", "0.5");
    EXPECT_EQ(bsdfParamsFrom(settings).base_color, glm::vec3(0.5f));
    BsdfSettings gltf(findBsdfModel("gltf"));
    gltf.set("thin", "false");
    EXPECT_EQ(bsdfParamsFrom(gltf).thin, 0u);
}

TEST(BsdfRegistry, ClampsAndSaysSoOnce) {
    BsdfSettings settings(findBsdfModel("half_lambert"));
    settings.set("exponent", "99");
    settings.set("exponent", "70");
    ASSERT_EQ(settings.notices.size(), 1u);
    EXPECT_EQ(settings.notices[0],
              "half_lambert: exponent: 70 is outside of 1..8; 8 is used");
    EXPECT_EQ(shading::half_lambert_exponent(bsdfParamsFrom(settings)), 8.0f);
    settings.set("exponent", "2");
    EXPECT_EQ(shading::half_lambert_exponent(bsdfParamsFrom(settings)), 2.0f);
    EXPECT_TRUE(settings.notices.empty());
}

template <class Call>
std::string errorOf(const Call& call) {
    try {
        call();
    } catch (const BsdfError& error) {
        return error.what();
    }
    return "";
}

TEST(BsdfRegistry, RefusesWithOneLine) {
    EXPECT_EQ(errorOf([] { findBsdfModel("half_lambrt"); }),
              "unknown model 'half_lambrt' (did you mean half_lambert?)");
    EXPECT_NE(errorOf([] { findBsdfModel("qqqq"); }).find("there are: lambert, "),
              std::string::npos);
    BsdfSettings s(findBsdfModel("half_lambert"));
    EXPECT_EQ(errorOf([&] { s.set("wrp", "1"); }),
              "unknown parameter of half_lambert 'wrp' (did you mean wrap?)");
    for (const char* word : {"", "x", "1,2", "1x", "nan", "inf", "1e99"}) {
        EXPECT_EQ(errorOf([&] { s.set("wrap", word); }),
                  fmt::format("half_lambert: wrap: '{}' is not a finite number", word));
    }
    EXPECT_EQ(errorOf([&] { s.set("base_color", "1,2"); }),
              "half_lambert: base_color: '1,2' is neither one number nor three with commas");
    BsdfSettings gltf(findBsdfModel("gltf"));
    EXPECT_EQ(errorOf([&] { gltf.set("thin", "2"); }),
              "gltf: thin: '2' is neither true nor false");
    EXPECT_EQ(wordsOf(s), wordsOf(BsdfSettings(findBsdfModel("half_lambert"))));
}

}  // namespace
}  // namespace gp
