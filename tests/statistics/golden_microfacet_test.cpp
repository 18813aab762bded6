// Distributions, masking and Fresnel terms against golden_brdf.csv, evaluated in double from the
// BRDFs of wdas/brdf. Where those differ from the literature we follow the literature, and the
// factor between the two stands beside the row.
#include <gtest/gtest.h>

#include "shading/shading.h"
#include "statistics/golden.h"

namespace gp::test {
namespace {

using namespace gp::shading;

// What a row is made of; cosines in the names of masking.glsl.
struct Point {
    const std::string& params;
    vec3 l, v, h;
    float i, o, nh, oh;
    float number(const char* key) const { return jsonNumber(params, key); }
    bool flag(const char* key) const {
        const std::size_t at = params.find('"' + std::string(key) + '"');
        return at != std::string::npos && params.find("true", at) == params.find(':', at) + 1;
    }
};

struct GoldenFunction {
    const char* model;
    double (*value)(const Point&);
    int rows = 225;  // some have fewer, as the peer gives NaN
};

// The visibility functions of the peer are optionally divided by both cosines.
double masked(const Point& p, float g) {
    return p.flag("includeInvNdotLNdotV") ? double(g) / (double(p.i) * double(p.o)) : double(g);
}

double phongNormalised(const Point& p) {
    const float n = p.number("n");
    const vec3 r(-p.l.x, -p.l.y, p.l.z);
    // Of the angle, since cosines near 1 have no digits: 1 - cos is half of the squared distance.
    const vec3 d = r - p.v;
    const double lobe = std::exp(double(n) * std::log1p(-0.5 * double(dot(d, d))));
    if (dot(r, p.v) <= 0.0f) return 0.0;
    return p.flag("normalized") ? lobe * (double(n) + 2.0) / (2.0 * M_PI) : lobe;
}

double blinnPhong(const Point& p) {
    // Ours has the area one; the peer's other form has the value one at the normal.
    const float alpha = blinn_phong_alpha(p.number("n"));
    const double d = double(blinn_phong_d(p.h, alpha));
    return p.flag("normalized") ? d : d * M_PI * double(alpha) * double(alpha);
}

double exponential(const Point& p) {
    const float c = p.number("c");
    const double d = double(exponential_angle_d(p.h, c));
    return p.flag("normalized") ? d / double(exponential_angle_area(c)) : d;
}

double trowbridgeReitz(const Point& p) {
    const double c = double(p.number("c"));
    const double d = double(trowbridge_reitz_d(p.h, float(c)));
    return p.flag("normalized") ? d / (M_PI * c * c) : d;
}

// [Blinn 1977]: D of the angle, V-cavities, over the viewer's cosine only.
double blinn(const Point& p) {
    const float d = gaussian_angle_d(p.h, 1.0f / p.number("n"));
    const float f = p.flag("include_Fresnel") ? fresnel_dielectric(p.oh, p.number("ior")) : 1.0f;
    const double value = double(d * f * masking_v_cavity(p.o, p.i, p.nh, p.oh)) / double(p.o);
    return p.flag("divide_by_NdotL") ? value / double(p.i) : value;
}

// D F G / (4 o i) times 4 pi, which the peer leaves out; its switch include_G drops the G.
double cookTorrance(const Point& p) {
    const float m = p.number("m");
    const float f = p.flag("include_F") ? fresnel_schlick(p.number("f0"), 1.0f, p.oh) : 1.0f;
    const float g = p.flag("include_G") ? 1.0f : masking_v_cavity(p.o, p.i, p.nh, p.oh);
    const double ours = double(beckmann_d(p.h, m, m) * f * g) / (4.0 * double(p.o) * double(p.i));
    return ours * 4.0 * M_PI;
}

double walter(const Point& p) {
    const float a = p.number("alphaG");
    const float f = p.flag("useFresnel") ? fresnel_dielectric(p.oh, p.number("ior")) : 1.0f;
    const float g = ggx_g2_separable(p.v, p.l, a, a);
    const double specular = double(ggx_d(p.h, a, a) * f * g) / (4.0 * double(p.o) * double(p.i));
    return double(p.number("Kd")) / M_PI + double(p.number("Ks")) * specular;
}

// The first visibility function that is on, over o i; the peer divides the two of Smith's by 4 as
// well, Cook and Torrance's by pi, and has 1 where none is on.
double compareMasking(const Point& p) {
    const float m = p.number("specwidth");
    const double oi = double(p.o) * double(p.i);
    if (p.flag("useSmithG")) return double(ggx_g2_separable(p.v, p.l, m, m)) / (4.0 * oi);
    if (p.flag("useSchlickG")) return double(masking_schlick(p.o, p.i, m)) / (4.0 * oi);
    if (p.flag("useWardG")) return double(masking_ward(p.o, p.i)) / oi;
    if (p.flag("useNeumannG")) return double(masking_neumann(p.o, p.i)) / oi;
    if (p.flag("useAshikhminShirleyG")) {
        return double(masking_ashikhmin_shirley(p.o, p.i, p.oh)) / oi;
    }
    if (p.flag("useAshikhminPremozeG")) return double(masking_ashikhmin_premoze(p.o, p.i)) / oi;
    if (p.flag("useCookTorranceG")) {
        return double(masking_v_cavity(p.o, p.i, p.nh, p.oh)) / (M_PI * oi);
    }
    if (p.flag("useKurtG")) {
        return double(masking_kurt(p.o, p.i, p.oh, p.number("kurtAlpha"))) / oi;
    }
    if (p.flag("useKelemenG")) return double(masking_kelemen(p.o, p.i, p.oh)) / oi;
    if (p.flag("useDuerG")) return double(masking_duer(p.o, p.i, p.nh, p.oh)) / (4.0 * oi);
    return 1.0;
}

// Ours is 0 outside of the disk; the peer raises the negative number to the power, which survives
// for even exponents only and is then that of its opposite.
double edwards(const Point& p) {
    BsdfParams m = bsdf_params_of(MODEL_HALFWAY_DISK);
    m.slot_a = vec4(p.number("n"), p.number("R"), 1.0f, 0.0f);
    return double(bsdf_eval(m, p.v, p.l).f_cos.x) / double(p.i);
}

// The peer's switch `kajiya` has the light in the viewer's place as well. Ours is 0 where the
// cosine is negative; the peer's power of it survives for even exponents only.
double fibres(const Point& p) {
    BsdfParams m = bsdf_params_of(MODEL_KAJIYA_KAY);
    m.slot_a = vec4(p.number("roughness"), p.flag("clampLights") ? p.number("falloff") : 0.0f,
                    p.flag("orient") ? 1.0f : 0.0f, 1.0f);
    m.slot_b.x = p.flag("kajiya") ? 1.0f : 0.0f;
    return double(bsdf_eval(m, p.v, p.l).f_cos.x) / double(p.i);
}

// Kd without 1 / pi and in red only, D F G without 1 / 4: the peer's picture of the choices.
double compare(const Point& p) {
    const float m = p.number("specwidth");
    const double d = p.flag("useBeckmannD") ? double(beckmann_d(p.h, m, m))
                   : p.flag("useTrowbridgeReitzD") ? double(ggx_d(p.h, m, m)) : 1.0;
    const float f = p.flag("useSchlickF") ? fresnel_schlick(p.number("F0"), 1.0f, p.oh) : 1.0f;
    return double(p.number("Kd")) + double(p.number("Ks") * f) * d * compareMasking(p);
}

const GoldenFunction functions[] = {
    {"d_beckmann", [](const Point& p) {
         return double(beckmann_d(p.h, p.number("m"), p.number("m"))); }},
    {"d_ggx", [](const Point& p) {
         return double(ggx_d(p.h, p.number("alpha"), p.number("alpha"))); }},
    {"d_blinnphong", blinnPhong},
    {"d_exponential", exponential},
    {"d_gaussian", [](const Point& p) { return double(gaussian_angle_d(p.h, p.number("c"))); }},
    {"d_nishino", [](const Point& p) {
         return double(nishino_d(p.nh, p.number("k"), p.number("n"))); }},
    {"d_phong", phongNormalised},
    {"d_trowbridge_reitz", trowbridgeReitz},
    {"f_cooktorrance", [](const Point& p) {
         return double(fresnel_dielectric(p.oh, p.number("ior"))); }},
    {"f_schlick", [](const Point& p) {
         return double(fresnel_schlick(f0_from_ior(p.number("ior")), 1.0f, p.oh)); }},
    {"f_schlick_f0", [](const Point& p) {
         return double(fresnel_schlick(p.number("f0"), 1.0f, p.oh)); }},
    {"schlick", [](const Point& p) {
         return double(fresnel_schlick(p.number("f0"), 1.0f, p.oh)); }},
    {"g_cooktorrance", [](const Point& p) {
         return masked(p, masking_v_cavity(p.o, p.i, p.nh, p.oh)); }},
    {"g_walter07", [](const Point& p) {
         return masked(p, ggx_g2_separable(p.v, p.l, p.number("alphaG"), p.number("alphaG"))); }},
    {"g_schlick", [](const Point& p) {
         return masked(p, masking_schlick(p.o, p.i, p.number("m"))); }},
    {"g_kelemen", [](const Point& p) { return masked(p, masking_kelemen(p.o, p.i, p.oh)); }},
    {"g_neumann", [](const Point& p) { return masked(p, masking_neumann(p.o, p.i)); }},
    {"g_kurt10", [](const Point& p) {
         return masked(p, masking_kurt(p.o, p.i, p.oh, p.number("alpha"))); }},
    {"g_ward", [](const Point& p) { return masked(p, masking_ward(p.o, p.i)); }},
    {"g_ap07", [](const Point& p) { return masked(p, masking_ashikhmin_premoze(p.o, p.i)); }},
    {"g_as00", [](const Point& p) {
         return masked(p, masking_ashikhmin_shirley(p.o, p.i, p.oh)); }},
    // The peer's is G / (4 o i), and its switch multiplies by o i instead of dividing.
    {"g_duer", [](const Point& p) {
         const double g = double(masking_duer(p.o, p.i, p.nh, p.oh)) / 4.0;
         return p.flag("includeInvNdotLNdotV") ? g : g / (double(p.o) * double(p.i)); }},
    {"blinn", blinn},
    {"cooktorrance", cookTorrance},
    {"walter", walter},
    {"compare", compare},
    {"edwards06", edwards, 143},
    {"dAniso", fibres, 191},
};

// The narrowest width of a row; 1 for functions without.
float widthOf(const Point& p) {
    float width = 1.0f;
    for (const char* key : {"m", "alpha", "alphaG", "c", "specwidth"}) {
        const float value = p.number(key);
        if (value > 0.0f) width = std::min(width, value);
    }
    const float n = p.number("n");
    return n > 0.0f ? std::min(width, blinn_phong_alpha(n)) : width;
}

TEST(GoldenMicrofacet, RowsAreMatched) {
    const std::vector<GoldenRow> rows = readGolden("golden_brdf.csv");
    GP_SKIP_WITHOUT(rows, "golden_brdf.csv");
    std::map<std::string, int> compared;
    for (const GoldenRow& row : rows) {
        const auto function = std::find_if(std::begin(functions), std::end(functions),
            [&](const GoldenFunction& f) { return row.at("model") == f.model; });
        if (function == std::end(functions)) continue;
        const vec3 l(number(row, "lx"), number(row, "ly"), number(row, "lz"));
        const vec3 v(number(row, "vx"), number(row, "vy"), number(row, "vz"));
        const vec3 h = normalize(l + v);
        const Point p{row.at("params"), l, v, h, l.z, v.z, h.z, dot(v, h)};
        const float width = widthOf(p);
        const bool hard = width < 0.01f || std::min(l.z, v.z) < 0.01f;
        for (const char* channel : {"r", "g", "b"}) {
            const bool redOnly = row.at("model") == "compare" && *channel != 'r';
            const double ours = function->value(p) - (redOnly ? double(p.number("Kd")) : 0.0);
            const double golden = std::strtod(row.at(channel).c_str(), nullptr);
            EXPECT_NEAR(ours, golden, (hard ? 1e-2 : 1e-3) * golden + 1e-5)
                << row.at("model") << " " << row.at("params") << " " << l.z << " " << v.z;
        }
        ++compared[row.at("model")];
    }
    for (const GoldenFunction& f : functions) EXPECT_EQ(compared[f.model], f.rows) << f.model;
}

// The model `microfacet` against golden_bbm.csv: names are DISTRIBUTION_iso|aniso_MASKING, F exact.
BsdfParams paramsOfBbm(const GoldenRow& row) {
    const std::string& model = row.at("model");
    const auto has = [&](const char* word) { return model.find(word) != std::string::npos; };
    BsdfParams m = bsdf_params_of(MODEL_MICROFACET);
    m.alpha_x = jsonNumber(row.at("params"), "alpha_x");
    m.alpha_y = jsonNumber(row.at("params"), "alpha_y");
    m.ior = jsonNumber(row.at("params"), "ior");
    const uint masking = has("vcavity") ? MASKING_V_CAVITY
                       : has("heightcorr") ? MASKING_CORRELATED : MASKING_SEPARABLE;
    const uint distribution = has("ggx") ? DISTRIBUTION_GGX : DISTRIBUTION_BECKMANN;
    m.slot_a = vec4(float(distribution), float(masking), float(FRESNEL_CHOICE_DIELECTRIC), 2.0f);
    m.slot_d.w = has("rational") ? 1.0f : 0.0f;
    return m;
}

TEST(GoldenMicrofacet, ModelMatchesBbm) {
    const std::vector<GoldenRow> rows = readGolden("golden_bbm.csv");
    GP_SKIP_WITHOUT(rows, "golden_bbm.csv");
    int compared = 0;
    for (const GoldenRow& row : rows) {
        if (row.at("model") == "orennayar_qualitative") continue;
        const BsdfParams m = paramsOfBbm(row);
        const vec3 l(number(row, "lx"), number(row, "ly"), number(row, "lz"));
        const vec3 v(number(row, "vx"), number(row, "vy"), number(row, "vz"));
        const double value = double(bsdf_eval(m, v, l).f_cos.x) / double(l.z);
        const double golden = std::strtod(row.at("r").c_str(), nullptr);
        const bool hard = std::min({m.alpha_x, m.alpha_y, l.z, v.z}) < 0.01f;
        EXPECT_NEAR(value, golden, (hard ? 1e-2 : 1e-3) * golden + 1e-5)
            << row.at("model") << " row " << compared;
        ++compared;
    }
    EXPECT_EQ(compared, 1600);
}

// The peer's `walter` without its diffuse part is the model with Smith's separable masking.
TEST(GoldenMicrofacet, ModelMatchesWalter) {
    const std::vector<GoldenRow> rows = readGolden("golden_brdf.csv");
    GP_SKIP_WITHOUT(rows, "golden_brdf.csv");
    int compared = 0;
    for (const GoldenRow& row : rows) {
        if (row.at("model") != "walter") continue;
        const std::string& json = row.at("params");
        BsdfParams m = bsdf_params_of(MODEL_MICROFACET);
        m.alpha_x = m.alpha_y = jsonNumber(json, "alphaG");
        m.ior = jsonNumber(json, "ior");
        const bool fresnel = json.find("\"useFresnel\":true") != std::string::npos;
        m.slot_a.y = float(MASKING_SEPARABLE);
        m.slot_a.z = float(fresnel ? FRESNEL_CHOICE_DIELECTRIC : FRESNEL_CHOICE_NONE);
        const vec3 l(number(row, "lx"), number(row, "ly"), number(row, "lz"));
        const vec3 v(number(row, "vx"), number(row, "vy"), number(row, "vz"));
        const double value = double(jsonNumber(json, "Kd")) / M_PI + double(jsonNumber(json, "Ks"))
                           * double(bsdf_eval(m, v, l).f_cos.x) / double(l.z);
        const double golden = std::strtod(row.at("r").c_str(), nullptr);
        const bool hard = std::min({m.alpha_x, l.z, v.z}) < 0.01f;
        EXPECT_NEAR(value, golden, (hard ? 1e-2 : 1e-3) * golden + 1e-5) << json;
        ++compared;
    }
    EXPECT_EQ(compared, 225);
}

}  // namespace
}  // namespace gp::test
