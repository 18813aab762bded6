// Rows of the dialect table: distributions, masking, Fresnel terms, microfacet models, Disney's.
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "scene/bsdf_dialect.h"

namespace gp {
namespace {

constexpr BsdfDialect wdas = BsdfDialect::wdas;
constexpr BsdfDialect bbm = BsdfDialect::bbm;

std::optional<double> numberOf(std::string_view text) {
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
    return value;
}

// A word that is no number stays as it is, for the registry to refuse.
template <class F>
std::string mapped(std::string_view text, const F& f) {
    const std::optional<double> value = numberOf(text);
    return value ? fmt::format("{}", f(*value)) : std::string(text);
}

std::string inverse(std::string_view text) {
    return mapped(text, [](double v) { return 1.0 / v; });
}

std::string f0OfIor(std::string_view text) {
    return mapped(text, [](double n) { return (n - 1.0) * (n - 1.0) / ((n + 1.0) * (n + 1.0)); });
}

std::string overPi(std::string_view text) {
    return mapped(text, [](double v) { return v / M_PI; });
}

// Display-referred there: the shader raises the colour to the power of 2.2.
std::string linearColor(std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::string linear;
    for (std::string part; std::getline(stream, part, ',');) {
        linear += (linear.empty() ? "" : ",")
                + mapped(part, [](double v) { return std::pow(std::max(v, 0.0), 2.2); });
    }
    return linear;
}

// Both spellings of a true word; everything else is false, or refused by the caller.
bool isTrueWord(std::string_view text) { return text == "true" || text == "1"; }

std::string fresnelOfSwitch(std::string_view text) {
    return isTrueWord(text) ? "dielectric" : "none";
}

std::string divisorOfSwitch(std::string_view text) { return isTrueWord(text) ? "cosines" : "one"; }

// Blinn's divides by the viewer's cosine always.
std::string blinnDivisor(std::string_view text) {
    return isTrueWord(text) ? "cosines" : "viewer";
}

std::string schlickOfSwitch(std::string_view text) {
    return isTrueWord(text) ? "schlick" : "none";
}

// Their include_G leaves G out.
std::string cavityUnlessIncluded(std::string_view text) {
    return isTrueWord(text) ? "none" : "v_cavity";
}

// Theirs is G / (4 cosines), and the switch multiplies it by both cosines.
std::string duerDivisor(std::string_view text) { return isTrueWord(text) ? "one" : "cosines"; }

DialectModel masking(const char* name, const char* ours, std::vector<DialectParameter> more = {}) {
    more.push_back({"includeInvNdotLNdotV", "divisor", divisorOfSwitch});
    return {wdas, name, "formula",
            fmt::format("distribution=none divisor=one masking={}", ours), std::move(more)};
}

DialectModel distribution(const char* name, const char* settings,
                          std::vector<DialectParameter> parameters) {
    return {wdas, name, "formula", fmt::format("masking=none divisor=one {}", settings),
            std::move(parameters)};
}

DialectModel fresnel(const char* name, const char* settings, DialectParameter parameter) {
    return {wdas, name, "formula",
            fmt::format("distribution=none masking=none divisor=one {}", settings), {parameter}};
}

// What each visibility switch of `compare` means, in the order in which the shader asks for them;
// with theirs the two of Smith's have the 1 / 4 as well, Cook and Torrance's 1 / pi.
struct CompareMasking {
    const char* theirs;
    const char* ours;
    const char* divisor;
};
constexpr CompareMasking compareMaskings[] = {
    {"useSmithG", "smith_ggx", "four_cosines"},
    {"useSchlickG", "schlick", "four_cosines"},
    {"useWardG", "ward", "cosines"},
    {"useNeumannG", "neumann", "cosines"},
    {"useAshikhminShirleyG", "ashikhmin_shirley", "cosines"},
    {"useAshikhminPremozeG", "ashikhmin_premoze", "cosines"},
    {"useCookTorranceG", "v_cavity", "pi_cosines"},
    {"useKurtG", "kurt", "cosines"},
    {"useKelemenG", "kelemen", "cosines"},
    {"useDuerG", "duer", "four_cosines"},
};

// The first switch of each kind that is on; the diffuse part is red only.
BsdfWords rewriteCompare(const BsdfWords& words) {
    std::map<std::string, std::string> by(words.begin(), words.end());
    const auto on = [&](const char* name) { return isTrueWord(by[name]); };
    BsdfWords ours;
    const auto copy = [&](const char* theirs, const char* name) {
        if (!by[theirs].empty()) ours.emplace_back(name, by[theirs]);
    };
    if (!by["Kd"].empty()) ours.emplace_back("base_color", by["Kd"] + ",0,0");
    copy("Ks", "scale");
    copy("specwidth", "width");
    copy("F0", "f0");
    copy("kurtAlpha", "kurt_exponent");
    // What is not mentioned keeps the peer's default: Trowbridge-Reitz and Schlick.
    const bool ggx = by["useTrowbridgeReitzD"].empty() || on("useTrowbridgeReitzD");
    ours.emplace_back("distribution", on("useBeckmannD") ? "beckmann" : ggx ? "ggx" : "none");
    const bool schlick = by["useSchlickF"].empty() || on("useSchlickF");
    ours.emplace_back("fresnel", schlick ? "schlick" : "none");
    for (const CompareMasking& m : compareMaskings) {
        if (!on(m.theirs)) continue;
        ours.emplace_back("masking", m.ours);
        ours.emplace_back("divisor", m.divisor);
        break;
    }
    return ours;
}

DialectModel compareModel() {
    std::vector<DialectParameter> parameters = {
        {"Kd", "base_color"}, {"Ks", "scale"}, {"specwidth", "width"}, {"F0", "f0"},
        {"kurtAlpha", "kurt_exponent"}, {"useBeckmannD", "distribution"},
        {"useTrowbridgeReitzD", "distribution"}, {"useSchlickF", "fresnel"}};
    for (const CompareMasking& m : compareMaskings) parameters.push_back({m.theirs, "masking"});
    return {wdas, "compare", "formula",
            "base_color=0.1,0,0 scale=0.5 width=0.02 f0=0.01 masking=none "
            "divisor=one", std::move(parameters), rewriteCompare};
}

// `falloff` acts only with `clampLights`.
BsdfWords rewriteFibres(const BsdfWords& words) {
    std::map<std::string, std::string> by(words.begin(), words.end());
    BsdfWords ours;
    if (!by["roughness"].empty()) ours.emplace_back("roughness", by["roughness"]);
    if (isTrueWord(by["clampLights"])) {
        ours.emplace_back("falloff", by["falloff"].empty() ? "0.1" : by["falloff"]);
    }
    if (!by["orient"].empty()) {
        ours.emplace_back("fibre", isTrueWord(by["orient"]) ? "along_x" : "along_y");
    }
    if (!by["kajiya"].empty()) ours.emplace_back("light_twice", by["kajiya"]);
    return ours;
}

DialectModel bbmModel(const char* name, const char* settings) {
    return {bbm, name, "microfacet", fmt::format("fresnel=dielectric {}", settings),
            {{"alpha_x", "alpha_x"}, {"alpha_y", "alpha_y"}, {"ior", "ior"}}};
}

DialectModel disneyModel() {
    return {wdas, "disney", "disney", "base_color=0.6462,0.4143,0.01774",
            {{"baseColor", "base_color", linearColor}, {"metallic", "metallic"},
             {"subsurface", "subsurface"}, {"specular", "specular"}, {"roughness", "roughness"},
             {"specularTint", "specular_tint"}, {"anisotropic", "anisotropic"},
             {"sheen", "sheen"}, {"sheenTint", "sheen_tint"}, {"clearcoat", "clearcoat"},
             {"clearcoatGloss", "clearcoat_gloss"}}};
}

std::vector<DialectModel> wholeModels() {
    return {
        disneyModel(),
        compareModel(),
        {wdas, "walter", "formula", "fresnel=dielectric",
         {{"Kd", "base_color", overPi}, {"Ks", "scale"}, {"alphaG", "width"}, {"ior", "ior"},
          {"useFresnel", "fresnel", fresnelOfSwitch}}},
        {wdas, "cooktorrance", "formula",
         "distribution=beckmann fresnel=schlick divisor=cosines scale=3.14159265 masking=v_cavity",
         {{"m", "width"}, {"f0", "f0"}, {"include_F", "fresnel", schlickOfSwitch},
          {"include_G", "masking", cavityUnlessIncluded}}},
        {wdas, "blinn", "formula", "distribution=gaussian fresnel=dielectric masking=v_cavity "
         "divisor=cosines",
         {{"n", "width", inverse}, {"ior", "ior"}, {"include_Fresnel", "fresnel", fresnelOfSwitch},
          {"divide_by_NdotL", "divisor", blinnDivisor}}},
        {wdas, "edwards06", "halfway_disk", "even_power=true",
         {{"n", "exponent"}, {"R", "radius"}}},
        {wdas, "dAniso", "kajiya_kay", "even_power=true",
         {{"roughness", "roughness"}, {"clampLights", "falloff"}, {"falloff", "falloff"},
          {"orient", "fibre"}, {"kajiya", "light_twice"}}, rewriteFibres},
        bbmModel("ggx_iso_smith_heightcorr", "masking=smith_correlated"),
        bbmModel("ggx_iso_smith_separable", "masking=smith_separable"),
        bbmModel("ggx_iso_vcavity", "masking=v_cavity"),
        bbmModel("ggx_aniso_vcavity", "masking=v_cavity"),
        bbmModel("beckmann_iso_smithrational_heightcorr",
                 "distribution=beckmann rational_lambda=true masking=smith_correlated"),
        bbmModel("beckmann_iso_smithrational_separable",
                 "distribution=beckmann rational_lambda=true masking=smith_separable"),
        bbmModel("beckmann_aniso_smithrational_heightcorr",
                 "distribution=beckmann rational_lambda=true masking=smith_correlated"),
        bbmModel("beckmann_aniso_vcavity", "distribution=beckmann masking=v_cavity"),
    };
}

std::vector<DialectModel> terms() {
    const DialectParameter normalized = {"normalized", "normalized"};
    return {
        distribution("d_beckmann", "distribution=beckmann", {{"m", "width"}}),
        distribution("d_ggx", "distribution=ggx", {{"alpha", "width"}}),
        distribution("d_gaussian", "distribution=gaussian", {{"c", "width"}}),
        distribution("d_exponential", "distribution=exponential", {{"c", "width"}, normalized}),
        distribution("d_trowbridge_reitz", "distribution=trowbridge_reitz",
                     {{"c", "width"}, normalized}),
        distribution("d_blinnphong", "distribution=blinn_phong", {{"n", "exponent"}, normalized}),
        distribution("d_phong", "distribution=phong", {{"n", "exponent"}, normalized}),
        distribution("d_nishino", "distribution=nishino", {{"n", "exponent"}, {"k", "kappa"}}),
        fresnel("f_cooktorrance", "fresnel=dielectric", {"ior", "ior"}),
        fresnel("f_schlick", "fresnel=schlick", {"ior", "f0", f0OfIor}),
        fresnel("f_schlick_f0", "fresnel=schlick", {"f0", "f0"}),
        fresnel("schlick", "fresnel=schlick", {"f0", "f0"}),
        masking("g_cooktorrance", "v_cavity"),
        masking("g_walter07", "smith_ggx", {{"alphaG", "masking_width"}}),
        masking("g_schlick", "schlick", {{"m", "masking_width"}}),
        masking("g_kelemen", "kelemen"),
        masking("g_neumann", "neumann"),
        masking("g_kurt10", "kurt", {{"alpha", "kurt_exponent"}}),
        masking("g_ward", "ward"),
        masking("g_ap07", "ashikhmin_premoze"),
        masking("g_as00", "ashikhmin_shirley"),
        {wdas, "g_duer", "formula", "distribution=none masking=duer divisor=cosines scale=0.25",
         {{"includeInvNdotLNdotV", "divisor", duerDivisor}}},
    };
}

}  // namespace

std::vector<DialectModel> microfacetDialectModels() {
    std::vector<DialectModel> models = wholeModels();
    for (DialectModel& model : terms()) models.push_back(std::move(model));
    return models;
}

}  // namespace gp
