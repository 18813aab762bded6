// What every reflectance model takes and returns. A model is four functions in a file of its own,
// a row in models.def and a row for each parameter in parameters.def; bsdf.glsl chooses among them.
//
// Frame: local, normal +Z, tangent +X. wo to the viewer, wi to the light, both leaving the surface,
// unit length. The outside is z > 0; wo.z < 0 is a view from inside of a solid transmissive body
// (or of the back of a thin one) and everything opaque is black from there.
//
// Radiance is what is transported: f of a transmission contains (eta_o / eta_i)^2, the indices of
// the media in which wo and wi lie, so that f(wo, wi) / eta_o^2 = f(wi, wo) / eta_i^2, and the
// weight of a camera path that enters glass is multiplied by 1 / eta^2 and by eta^2 on leaving.
#ifndef GP_SHADING_BSDF_PARAMS_GLSL
#define GP_SHADING_BSDF_PARAMS_GLSL
#include "shading/constants.glsl"

#define BSDF_MODEL_NUMBERS
#include "shading/bsdf/models.def"
#undef BSDF_MODEL_NUMBERS

// Below this width float32 directions are too coarse for the lobe; callers clamp alpha to it.
#define BSDF_MIN_ALPHA 1.0e-4f
// Below this width light sampling practically never hits the lobe.
#define BSDF_SPECULAR_ALPHA 1.0e-3f
// Closer to 1 the half vector of a refraction is lost in rounding errors.
#define BSDF_MIN_IOR_STEP 1.0e-3f

#define LOBE_DIFFUSE 1u
#define LOBE_GLOSSY 2u
#define LOBE_SPECULAR 4u
#define LOBE_TRANSMISSION 8u

// Properties of a model, for the tests that every row of models.def must pass.
#define BSDF_RECIPROCAL 1u    // f(wo, wi) / eta_o^2 = f(wi, wo) / eta_i^2
#define BSDF_CONSERVING 2u    // albedo at most 1
#define BSDF_TRANSMISSIVE 4u  // scatters to the other side
#define BSDF_FROM_FILE 8u     // black without the file that it is made from

struct BsdfParams {
    uint model;                      // MODEL_… of models.def
    vec3 base_color;                 // reflectance, f0 of metals, tint of transmission
    float metallic;
    float alpha_x;                   // microfacet width along the tangent
    float alpha_y;                   // … and along the bitangent
    float ior;                       // interior over exterior
    float specular;                  // weight of the dielectric reflection
    vec3 specular_color;             // tints its f0
    float coat;
    float coat_alpha;
    vec3 coat_normal;                // local; the coat may lie smooth on a bumpy base
    vec3 sheen_color;
    float sheen_alpha;
    float transmission;              // share of the diffuse base that is transmissive instead
    uint thin;                       // 1: a sheet, light leaves it where it enters; 0: a solid body
    float iridescence;
    float iridescence_ior;
    float iridescence_thickness_nm;
    // What only models of the library have: parameters.def says who keeps what where. Undefined,
    // and never written, for the renderer's own models.
    vec4 slot_a;
    vec4 slot_b;
    vec4 slot_c;
    vec4 slot_d;
    vec4 slot_e;
    vec4 slot_f;
    vec4 slot_g;
    vec4 slot_h;
    vec4 slot_i;
    vec4 slot_j;
    uvec2 table;                     // what a measured model looks up: an address, as in lang.h
};

// How the types of parameters.def are read and written.
#define BSDF_TYPE_FLOAT float
#define BSDF_TYPE_COLOR vec3
#define BSDF_TYPE_BOOL bool
#define BSDF_TYPE_CHOICE uint
#define BSDF_GET_FLOAT(where) where
#define BSDF_GET_COLOR(where) vec3(where)
#define BSDF_GET_BOOL(where) (where) > 0.5f
#define BSDF_GET_CHOICE(where) uint((where) + 0.5f)
#define BSDF_SET_FLOAT(where, value) where = value;
#define BSDF_SET_COLOR(where, value) \
    where.x = (value).x; where.y = (value).y; where.z = (value).z;
#define BSDF_SET_BOOL(where, value) where = value;
#define BSDF_SET_FLAG(where, value) where = uint(value);
#define BSDF_SET_CHOICE(where, value) where = value;

// phong_exponent(m) and all the others.
#define BSDF_PARAMETER(number, accessor, name, type, slot, initial, minimum, maximum, outside, \
                       unit, text) \
    BSDF_TYPE_##type accessor(IN(BsdfParams) m) { return BSDF_GET_##type(m.slot); }
#include "shading/bsdf/parameters.def"
#undef BSDF_PARAMETER

// f times |cos_i| and the density with which sample() chooses wi: one evaluation gives both.
struct BsdfValue {
    vec3 f_cos;
    float pdf;
};

// weight = f |cos_i| / pdf. A weight of zero is a sample that failed: the path ends.
struct BsdfSample {
    vec3 wi;
    float pdf;
    vec3 weight;
    uint lobe;
};

// The named fields, for the renderer: every feature is off. The slots are left undefined.
BsdfParams bsdf_fields_of(uint model) {
    BsdfParams m;
    m.model = model;
    m.base_color = vec3(1.0f);
    m.metallic = 0.0f;
    m.alpha_x = 1.0f;
    m.alpha_y = 1.0f;
    m.ior = 1.5f;
    m.specular = 1.0f;
    m.specular_color = vec3(1.0f);
    m.coat = 0.0f;
    m.coat_alpha = BSDF_MIN_ALPHA;
    m.coat_normal = vec3(0.0f, 0.0f, 1.0f);
    m.sheen_color = vec3(0.0f);
    m.sheen_alpha = BSDF_MIN_ALPHA;
    m.transmission = 0.0f;
    m.thin = 1u;
    m.iridescence = 0.0f;
    m.iridescence_ior = 1.3f;
    m.iridescence_thickness_nm = 400.0f;
    return m;
}

// A model of the library with its defaults. One without a width of its own counts as sharp: then
// no texture is blurred that the viewer might see in it.
BsdfParams bsdf_params_of(uint model) {
    BsdfParams m = bsdf_fields_of(model);
    m.alpha_x = BSDF_MIN_ALPHA;
    m.alpha_y = BSDF_MIN_ALPHA;
    m.slot_a = vec4(0.0f);
    m.slot_b = vec4(0.0f);
    m.slot_c = vec4(0.0f);
    m.slot_d = vec4(0.0f);
    m.slot_e = vec4(0.0f);
    m.slot_f = vec4(0.0f);
    m.slot_g = vec4(0.0f);
    m.slot_h = vec4(0.0f);
    m.slot_i = vec4(0.0f);
    m.slot_j = vec4(0.0f);
    m.table = uvec2(0u);
#define BSDF_FIELD(number, name, type, field, initial, minimum, maximum, outside, unit, text) \
    if (model == number) { BSDF_SET_##type(m.field, initial) }
#define BSDF_PARAMETER(number, accessor, name, type, slot, initial, minimum, maximum, outside, \
                       unit, text) \
    if (model == number) { BSDF_SET_##type(m.slot, initial) }
#include "shading/bsdf/parameters.def"
#undef BSDF_FIELD
#undef BSDF_PARAMETER
    return m;
}

BsdfValue bsdf_no_value() {
    BsdfValue v;
    v.f_cos = vec3(0.0f);
    v.pdf = 0.0f;
    return v;
}

BsdfSample bsdf_no_sample() {
    BsdfSample s;
    s.wi = vec3(0.0f, 0.0f, 1.0f);
    s.pdf = 0.0f;
    s.weight = vec3(0.0f);
    s.lobe = 0u;
    return s;
}

// The end of every sample function: weight and density come from eval, so they cannot disagree.
BsdfSample bsdf_sample_of(vec3 wi, IN(BsdfValue) v, uint lobe) {
    BsdfSample s;
    s.wi = wi;
    s.pdf = v.pdf;
    s.weight = v.pdf > 0.0f ? v.f_cos / v.pdf : vec3(0.0f);
    s.lobe = lobe;
    return s;
}

float max_component(vec3 v) {
    return max(v.x, max(v.y, v.z));
}

vec3 mirrored_z(vec3 w) {
    return vec3(w.x, w.y, -w.z);
}

bool alpha_is_specular(float alpha_x, float alpha_y) {
    return max(alpha_x, alpha_y) < BSDF_SPECULAR_ALPHA;
}

// LOBE_SPECULAR or LOBE_GLOSSY by the width, with the bits of `side`.
uint microfacet_lobe(IN(BsdfParams) m, uint side) {
    return side | (alpha_is_specular(m.alpha_x, m.alpha_y) ? LOBE_SPECULAR : LOBE_GLOSSY);
}

// One width for the fits of albedos, which know no direction. What single scattering loses grows
// with the variance of the slopes, so the squares are averaged.
float mean_alpha(IN(BsdfParams) m) {
    float square = 0.5f * (m.alpha_x * m.alpha_x + m.alpha_y * m.alpha_y);
    return m.alpha_x == m.alpha_y ? m.alpha_x : sqrt(square);
}

#endif
