#include "scene/bsdf_dialect.h"

#include <charconv>
#include <sstream>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "scene/find_by_name.h"

namespace gp {
namespace {

constexpr BsdfDialect wdas = BsdfDialect::wdas;
constexpr BsdfDialect bbm = BsdfDialect::bbm;

// A word that is no number stays as it is, for the registry to refuse.
std::string radiansOfDegrees(std::string_view text) {
    double degrees = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), degrees);
    if (error != std::errc() || stop != text.data() + text.size()) return std::string(text);
    return fmt::format("{}", degrees * glm::pi<double>() / 180.0);
}

// Their switch leaves out (1 - Rs), not the rest of the coupling.
std::string diffuseOfCoupled(std::string_view text) {
    if (text == "true" || text == "1") return "coupled";
    if (text == "false" || text == "0") return "uncoupled";
    return std::string(text);
}

std::vector<DialectModel> makeModels() {
    std::vector<DialectModel> models = {
        {wdas, "lambert", "lambert", "", {{"reflectance", "base_color"}}},
        {wdas, "phong", "phong", "exponent=100",
         {{"n", "exponent"}, {"divide_by_NdotL", "divide_by_cosine"}}},
        {wdas, "modifiedphong", "modified_phong", "base_color=0 specular_color=1 exponent=1",
         {{"n", "exponent"}}},
        {wdas, "blinnphong", "blinn_phong", "exponent=100",
         {{"n", "exponent"}, {"divide_by_NdotL", "divide_by_cosine"}}},
        {wdas, "stretchedphong", "stretched_phong", "exponent=1",
         {{"Ks", "base_color"}, {"n", "exponent"}, {"p", "power"}}},
        {wdas, "minnaert", "minnaert", "k=1", {{"k", "k"}}},
        {wdas, "orennayar", "oren_nayar", "base_color=0.9 sigma=0.5235987755982988",
         {{"rho", "base_color"}, {"sigma", "sigma", radiansOfDegrees}}},
        {wdas, "ward", "ward", "base_color=1 specular_color=1",
         {{"alpha_x", "alpha_x"}, {"alpha_y", "alpha_y"}, {"Cs", "specular_color"},
          {"Cd", "base_color"}, {"isotropic", "alpha_y", nullptr, "alpha_x"}}},
        {wdas, "ashikhman_shirley", "ashikhmin_shirley", "base_color=1",
         {{"Rs", "specular_color"}, {"Rd", "base_color"}, {"nu", "exponent_u"},
          {"nv", "exponent_v"}, {"isotropic", "exponent_v", nullptr, "exponent_u"},
          {"coupled_diffuse", "diffuse", diffuseOfCoupled}}},
        {bbm, "orennayar_qualitative", "oren_nayar", "form=qualitative",
         {{"sigma_rad", "sigma"}, {"albedo", "base_color"}}},
    };
    for (DialectModel& model : microfacetDialectModels()) models.push_back(std::move(model));
    return models;
}

const char* dialectName(BsdfDialect dialect) {
    return dialect == wdas ? "wdas" : dialect == bbm ? "bbm" : "own";
}

const DialectModel& findModel(BsdfDialect dialect, const std::string& name) {
    std::vector<std::string> names;
    for (const DialectModel& model : dialectModels()) {
        if (model.dialect != dialect) continue;
        if (model.name == name) return model;
        names.push_back(model.name);
    }
    throwUnknown(fmt::format("model of dialect {}", dialectName(dialect)), name, names);
}

const DialectParameter& findParameter(const DialectModel& model, const std::string& name) {
    std::vector<std::string> names;
    for (const DialectParameter& parameter : model.parameters) {
        if (name == parameter.theirs) return parameter;
        names.emplace_back(parameter.theirs);
    }
    throwUnknown(fmt::format("parameter of {}", model.name), name, names);
}

void setAll(BsdfSettings& settings, const std::string& assignments) {
    std::istringstream stream(assignments);
    for (std::string word; stream >> word;) {
        const std::size_t sign = word.find('=');
        settings.set(word.substr(0, sign), word.substr(sign + 1));
    }
}

std::string textOf(const BsdfSettings& settings, const std::string& name) {
    const BsdfParameterInfo& parameter = findBsdfParameter(*settings.model, name);
    const auto index = static_cast<std::size_t>(&parameter - settings.model->parameters.data());
    return bsdfValueText(parameter, settings.values[index]);
}

bool isTrue(const DialectModel& model, const std::string& name, const std::string& text) {
    if (text == "true" || text == "1") return true;
    if (text == "false" || text == "0") return false;
    throw BsdfError(fmt::format("{}: {}: '{}' is neither true nor false", model.name, name, text));
}

}  // namespace

const std::vector<DialectModel>& dialectModels() {
    static const std::vector<DialectModel> models = makeModels();
    return models;
}

BsdfSettings bsdfFromWords(BsdfDialect dialect, const std::string& model, const BsdfWords& words) {
    if (dialect == BsdfDialect::own) {
        BsdfSettings settings(findBsdfModel(model));
        for (const auto& [name, text] : words) settings.set(name, text);
        return settings;
    }
    const DialectModel& theirs = findModel(dialect, model);
    BsdfSettings settings(findBsdfModel(theirs.ours));
    setAll(settings, theirs.settings);
    if (theirs.rewrite != nullptr) {
        for (const auto& [name, text] : words) findParameter(theirs, name);
        for (const auto& [name, text] : theirs.rewrite(words)) settings.set(name, text);
        return settings;
    }
    std::vector<const DialectParameter*> copies;
    for (const auto& [name, text] : words) {
        const DialectParameter& parameter = findParameter(theirs, name);
        if (parameter.equalTo != nullptr) {
            if (isTrue(theirs, name, text)) copies.push_back(&parameter);
        } else {
            settings.set(parameter.ours, parameter.convert ? parameter.convert(text) : text);
        }
    }
    // Last, whatever the order in the file.
    for (const DialectParameter* copy : copies) {
        settings.set(copy->ours, textOf(settings, copy->equalTo));
    }
    return settings;
}

}  // namespace gp
