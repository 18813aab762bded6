// What the classic models share: mirror direction, densities of reflections about half vectors, and
// the choice between a diffuse part and a lobe.
#ifndef GP_SHADING_BSDF_CLASSIC_LOBES_GLSL
#define GP_SHADING_BSDF_CLASSIC_LOBES_GLSL
#include "shading/sampling/cosine_power.glsl"
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

// Formulas that divide by a cosine alone have no limit at the horizon; below this cosine they are
// kept at what they are here, so that nothing becomes infinite.
#define GRAZING_COSINE 1.0e-6f

vec3 mirror_direction(vec3 w) {
    return vec3(-w.x, -w.y, w.z);
}

// The half vector with its cosine to both directions, from the length of their sum: a scalar
// product has no digits where both are grazing and opposite, and would not be the same both ways.
struct HalfVector {
    vec3 wm;
    float cos_h;
    float sum2;  // |wo + wi|^2
};

HalfVector half_vector(vec3 wo, vec3 wi) {
    vec3 sum = wo + wi;
    HalfVector h;
    // Opposite directions in the horizon: the square leaves the range of floats, the vector not.
    float largest = max(max(abs(sum.x), abs(sum.y)), max(abs(sum.z), 1.0e-37f));
    h.wm = normalize(sum / largest);
    h.sum2 = max(dot(sum, sum), 1.0e-30f);
    h.cos_h = 0.5f * sqrt(h.sum2);
    return h;
}

// The density of wi where half vectors have the density pdf_h.
// [Walter et al. 2007, EGSR, equation 14]
float reflection_pdf(float pdf_h, float cos_h) {
    return pdf_h / (4.0f * cos_h);
}

// With which chance a lobe of the weight `lobe` is sampled beside one of the weight `rest`.
float lobe_share(float lobe, float rest) {
    return lobe > 0.0f ? lobe / (lobe + rest) : 0.0f;
}

// Both on the outside: the only place where an opaque surface is not black.
bool above_horizon(vec3 wo, vec3 wi) {
    return wo.z > 0.0f && wi.z > 0.0f;
}

// Schlick's transmittance over 1 - f0, 1 - (1 - c)^5, without the cancellation at c = 0.
float schlick_through(float c) {
    return c * (5.0f - c * (10.0f - c * (10.0f - c * (5.0f - c))));
}

// Lambert plus a power of the cosine to an axis:
// f = diffuse / pi + specular (n + 2) / (2 pi) cos^n.
struct PowerLobe {
    vec3 diffuse;
    vec3 specular;
    vec3 axis;
    float exponent;
};

// At grazing angles half of the lobe is lost below the horizon, and cos_i is small in the rest.
float power_lobe_share(IN(PowerLobe) l) {
    float height = 0.1f + 0.9f * max(l.axis.z, 0.0f);
    return lobe_share(max_component(l.specular) * height, max_component(l.diffuse));
}

// [Lafortune and Willems 1994, "Using the Modified Phong Reflectance Model for Physically Based
// Rendering"]
BsdfValue power_lobe_eval(IN(PowerLobe) l, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    float power = cosine_power(l.axis, wi, l.exponent);
    float p = power_lobe_share(l);
    BsdfValue v;
    v.f_cos = l.diffuse * (INV_PI * wi.z)
            + l.specular * ((l.exponent + 2.0f) * INV_TWO_PI * power * wi.z);
    v.pdf = p * cosine_power_pdf(power, l.exponent) + (1.0f - p) * cosine_hemisphere_pdf(wi);
    return v;
}

BsdfSample power_lobe_sample(IN(PowerLobe) l, vec3 wo, float u_lobe, vec2 u) {
    bool glossy = u_lobe < power_lobe_share(l);
    vec3 wi = glossy ? square_to_cosine_power_about(l.axis, u, l.exponent)
                     : square_to_cosine_hemisphere(u);
    return bsdf_sample_of(wi, power_lobe_eval(l, wo, wi), glossy ? LOBE_GLOSSY : LOBE_DIFFUSE);
}

// A narrow lobe's albedo is its cosine; a wide one's is nearer to a constant, but less of it is
// above the horizon.
vec3 power_lobe_albedo(IN(PowerLobe) l, float cos_o) {
    return cos_o > 0.0f ? l.diffuse + l.specular * max(l.axis.z, 0.0f) : vec3(0.0f);
}

#endif
