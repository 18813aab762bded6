// Fresnel reflectance: the share of light that a smooth boundary reflects. `cos_o` is the cosine
// between the direction and the (microfacet) normal, at least 0; `eta` is the index of refraction
// behind the boundary over the one in front of it.
#ifndef GP_SHADING_FRESNEL_GLSL
#define GP_SHADING_FRESNEL_GLSL

// sqrt(eta^2 - sin^2): eta times the cosine behind the boundary; 0 from the critical angle on.
// eta^2 - 1 is written as a product, since near eta = 1 the difference would cancel.
float fresnel_g(float cos_o, float eta) {
    return sqrt(max((eta - 1.0f) * (eta + 1.0f) + cos_o * cos_o, 0.0f));
}

// Unpolarised light on a dielectric, exact; 1 at total internal reflection.
// [Cook and Torrance 1982, ACM TOG 1(1), section "Reflectance"]
float fresnel_dielectric(float cos_o, float eta) {
    float g = fresnel_g(cos_o, eta);
    if (g <= 0.0f) {
        return 1.0f;
    }
    // (g - c) (g + c) = eta^2 - 1 keeps the digits that g - c loses where eta is near 1.
    float sum = g + cos_o;
    float difference = (eta - 1.0f) * (eta + 1.0f) / sum;
    float s = difference / sum;
    float p = (cos_o * sum - 1.0f) / (cos_o * difference + 1.0f);
    return min(0.5f * s * s * (1.0f + p * p), 1.0f);
}

// 1 - F from the cosines on both sides, as a product: near the critical angle the difference has no
// digits left, and this way it is the same number whichever way the light goes.
// [Born and Wolf 1999, "Principles of Optics", section 1.5.2, transmissivity]
float fresnel_transmittance(float cos_o, float cos_t, float eta) {
    float s = cos_o + eta * cos_t;
    float p = eta * cos_o + cos_t;
    return 2.0f * eta * cos_o * cos_t * (1.0f / (s * s) + 1.0f / (p * p));
}

// Unpolarised light on a conductor with the complex index eta + i k, exact; eta = k = 0 is never a
// material. [Born and Wolf 1999, "Principles of Optics", section 14.2]
vec3 fresnel_conductor(float cos_o, vec3 eta, vec3 k) {
    float cos2 = cos_o * cos_o;
    float sin2 = 1.0f - cos2;
    vec3 eta2 = eta * eta;
    vec3 k2 = k * k;
    vec3 t = eta2 - k2 - vec3(sin2);
    vec3 a2_plus_b2 = sqrt(t * t + 4.0f * eta2 * k2);
    vec3 a = sqrt(max(0.5f * (a2_plus_b2 + t), vec3(0.0f)));
    vec3 s0 = a2_plus_b2 + vec3(cos2);
    vec3 s1 = 2.0f * cos_o * a;
    vec3 r_s = (s0 - s1) / (s0 + s1);
    vec3 p0 = cos2 * a2_plus_b2 + vec3(sin2 * sin2);
    vec3 p1 = s1 * sin2;
    vec3 r_p = r_s * (p0 - p1) / (p0 + p1);
    return 0.5f * (r_s + r_p);
}

// (1 - cos)^5. [Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering"]
float schlick_weight(float cos_o) {
    float x = clamp(1.0f - cos_o, 0.0f, 1.0f);
    float x2 = x * x;
    return x2 * x2 * x;
}

// From f0 at normal incidence to f90 at grazing. [Schlick 1994, equation 15]
float fresnel_schlick(float f0, float f90, float cos_o) {
    return f0 + (f90 - f0) * schlick_weight(cos_o);
}

vec3 fresnel_schlick(vec3 f0, vec3 f90, float cos_o) {
    return f0 + (f90 - f0) * schlick_weight(cos_o);
}

// With the exponent free, as MaterialX has it: 5 is Schlick's own.
// [MaterialX specification 1.38, generalized_schlick_bsdf]
vec3 fresnel_schlick_generalised(vec3 f0, vec3 f90, float exponent, float cos_o) {
    return f0 + (f90 - f0) * pow(clamp(1.0f - cos_o, 0.0f, 1.0f), exponent);
}

// Reflectance at normal incidence; an index of 0 counts as infinite, as KHR_materials_ior has it.
// [Born and Wolf 1999, "Principles of Optics", section 1.5.2]
float f0_from_ior(float ior) {
    float r = (ior - 1.0f) / (ior + 1.0f);
    return r * r;
}

// The larger of the two indices that reflect f0; f0 is kept below 1, where it would be infinite.
float ior_from_f0(float f0) {
    float r = sqrt(clamp(f0, 0.0f, 0.9999f));
    return (1.0f + r) / (1.0f - r);
}

// The other ray of a refraction: wo and the microfacet normal wm on the same side, eta as above,
// g = fresnel_g(dot(wo, wm), eta) > 0.
vec3 refracted(vec3 wo, vec3 wm, float eta, float g) {
    return (wm * (dot(wo, wm) - g) - wo) / eta;
}

#endif
