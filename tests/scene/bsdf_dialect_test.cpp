// Other programs' names of models and parameters.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "scene/bsdf_dialect.h"

namespace gp {
namespace {

std::string valueOf(const BsdfSettings& settings, const std::string& name) {
    const BsdfParameterInfo& p = findBsdfParameter(*settings.model, name);
    return bsdfValueText(p, settings.values[std::size_t(&p - settings.model->parameters.data())]);
}

TEST(BsdfDialect, RowsNameWhatThereIs) {
    for (const DialectModel& row : dialectModels()) {
        const BsdfSettings plain = bsdfFromWords(row.dialect, row.name, {});
        EXPECT_STREQ(plain.model->name.c_str(), row.ours) << row.name;
        EXPECT_TRUE(plain.notices.empty()) << row.name;
        for (const DialectParameter& p : row.parameters) {
            EXPECT_NO_THROW(findBsdfParameter(*plain.model, p.ours)) << row.name << " " << p.theirs;
            if (p.equalTo != nullptr) {
                EXPECT_NO_THROW(findBsdfParameter(*plain.model, p.equalTo)) << row.name;
            }
        }
    }
}

TEST(BsdfDialect, SwitchesCopyWhateverTheOrder) {
    for (const BsdfWords& words :
         {BsdfWords{{"isotropic", "true"}, {"nv", "7"}, {"nu", "30"}},
          BsdfWords{{"nu", "30"}, {"nv", "7"}, {"isotropic", "true"}}}) {
        const BsdfSettings s = bsdfFromWords(BsdfDialect::wdas, "ashikhman_shirley", words);
        EXPECT_EQ(valueOf(s, "exponent_u"), "30");
        EXPECT_EQ(valueOf(s, "exponent_v"), "30");
    }
    const BsdfWords words = {{"nv", "7"}, {"isotropic", "false"}};
    const BsdfSettings s = bsdfFromWords(BsdfDialect::wdas, "ashikhman_shirley", words);
    EXPECT_EQ(valueOf(s, "exponent_v"), "7");
}

TEST(BsdfDialect, ConvertsUnits) {
    const BsdfSettings s =
        bsdfFromWords(BsdfDialect::wdas, "orennayar", {{"sigma", "90"}, {"rho", "0.5"}});
    EXPECT_NEAR(std::stod(valueOf(s, "sigma")), 1.5707963, 1e-6);
    EXPECT_EQ(valueOf(s, "base_color"), "0.5");
    EXPECT_EQ(valueOf(bsdfFromWords(BsdfDialect::bbm, "orennayar_qualitative", {}), "form"),
              "qualitative");
}

std::string errorOf(BsdfDialect dialect, const std::string& model, const BsdfWords& words) {
    try {
        bsdfFromWords(dialect, model, words);
    } catch (const BsdfError& error) {
        return error.what();
    }
    return "";
}

TEST(BsdfDialect, RefusesWithOneLine) {
    EXPECT_EQ(errorOf(BsdfDialect::wdas, "oren_nayar", {}),
              "unknown model of dialect wdas 'oren_nayar' (did you mean orennayar?)");
    EXPECT_EQ(errorOf(BsdfDialect::own, "orennayar", {}),
              "unknown model 'orennayar' (did you mean oren_nayar?)");
    EXPECT_EQ(errorOf(BsdfDialect::wdas, "phong", {{"exponent", "3"}}),
              "unknown parameter of phong 'exponent' (there are: n, divide_by_NdotL)");
    EXPECT_EQ(errorOf(BsdfDialect::wdas, "ward", {{"isotropic", "maybe"}}),
              "ward: isotropic: 'maybe' is neither true nor false");
    EXPECT_EQ(errorOf(BsdfDialect::wdas, "orennayar", {{"sigma", "wide"}}),
              "oren_nayar: sigma: 'wide' is not a finite number");
}

}  // namespace
}  // namespace gp
