// Any distribution of normals by its number: D, normals to sample with their density, and Smith's
// Lambda (some have no closed form of it: smith_fit.glsl).
//
// Those that are only known isotropic become anisotropic by stretching their surface, which
// is exact for D and for Lambda alike: the isotropic surface of the width sqrt(alpha_x alpha_y) is
// made wider along one axis and narrower along the other. [Heitz 2014, JCGT 3(2), section 5.3]
#ifndef GP_SHADING_MICROFACET_DISTRIBUTION_GLSL
#define GP_SHADING_MICROFACET_DISTRIBUTION_GLSL
#include "shading/microfacet/abc.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/microfacet/blinn_phong.glsl"
#include "shading/microfacet/exponential_power.glsl"
#include "shading/microfacet/ggx.glsl"
#include "shading/microfacet/gtr.glsl"
#include "shading/microfacet/masking.glsl"
#include "shading/microfacet/shifted_gamma.glsl"
#include "shading/microfacet/smith_fit.glsl"

// The order of the names in parameters.def.
#define DISTRIBUTION_GGX 0u
#define DISTRIBUTION_BECKMANN 1u
#define DISTRIBUTION_GTR 2u
#define DISTRIBUTION_BERRY 3u
#define DISTRIBUTION_BLINN_PHONG 4u
#define DISTRIBUTION_EXPONENTIAL_POWER 5u
#define DISTRIBUTION_SHIFTED_GAMMA 6u
#define DISTRIBUTION_ABC 7u
#define DISTRIBUTION_COUNT 8u

struct Distribution {
    uint kind;
    float alpha_x;
    float alpha_y;
    float shape;   // gamma of GTR, p of exponential power and shifted gamma, c of ABC
    SmithFit fit;  // for Lambda, by smith_fit_of; distribution_needs_fit says who needs it
};

bool distribution_needs_fit(uint kind) {
    return kind >= DISTRIBUTION_GTR && kind != DISTRIBUTION_EXPONENTIAL_POWER;
}

// Long tails are no mirror, however narrow the peak.
bool distribution_has_short_tail(uint kind) {
    return kind <= DISTRIBUTION_BECKMANN || kind == DISTRIBUTION_BLINN_PHONG;
}

float distribution_mean_alpha(IN(Distribution) d) {
    return d.alpha_x == d.alpha_y ? d.alpha_x : sqrt(d.alpha_x * d.alpha_y);
}

float isotropic_d(IN(Distribution) d, vec3 wm, float alpha) {
    switch (d.kind) {
    case DISTRIBUTION_GTR: return gtr_d(wm, alpha, d.shape);
    case DISTRIBUTION_BERRY: return gtr_d(wm, alpha, 1.0f);
    case DISTRIBUTION_BLINN_PHONG: return blinn_phong_d(wm, alpha);
    case DISTRIBUTION_EXPONENTIAL_POWER: return exponential_power_d(wm, alpha, d.shape);
    case DISTRIBUTION_SHIFTED_GAMMA: return shifted_gamma_d(wm, alpha, d.shape);
    case DISTRIBUTION_ABC: return abc_d(wm, alpha, d.shape);
    default: break;
    }
    return d.kind == DISTRIBUTION_GGX ? ggx_d(wm, alpha, alpha) : beckmann_d(wm, alpha, alpha);
}

float isotropic_lambda(IN(Distribution) d, vec3 w, float alpha) {
    switch (d.kind) {
    case DISTRIBUTION_GGX: return ggx_lambda(w, alpha, alpha);
    case DISTRIBUTION_BECKMANN: return beckmann_lambda(w, alpha, alpha);
    case DISTRIBUTION_EXPONENTIAL_POWER:
        return smith_fit_lambda(exponential_power_fit(alpha, d.shape), w);
    default: break;
    }
    return smith_fit_lambda(d.fit, w);
}

// sin^2 and cos^2 of a normal; tan^2 from 0 to infinity becomes both without a difference.
vec2 sin2_cos2_of_tan2(float tan2) {
    float cos2 = 1.0f / (1.0f + tan2);
    return vec2(tan2 * cos2, cos2);
}

vec2 sin2_cos2_of_sin2(float sin2) {
    return vec2(sin2, 1.0f - sin2);
}

vec2 isotropic_sample(IN(Distribution) d, float alpha, float u) {
    switch (d.kind) {
    case DISTRIBUTION_GTR: return sin2_cos2_of_sin2(gtr_sample_sin2(alpha, d.shape, u));
    case DISTRIBUTION_BERRY: return sin2_cos2_of_sin2(gtr_sample_sin2(alpha, 1.0f, u));
    case DISTRIBUTION_BLINN_PHONG: return sin2_cos2_of_sin2(blinn_phong_sample_sin2(alpha, u));
    case DISTRIBUTION_EXPONENTIAL_POWER:
        return sin2_cos2_of_tan2(exponential_power_sample_tan2(alpha, d.shape, u));
    case DISTRIBUTION_SHIFTED_GAMMA:
        return sin2_cos2_of_tan2(shifted_gamma_sample_tan2(alpha, d.shape, u));
    case DISTRIBUTION_ABC: {
        float e = abc_sample_one_minus_cos(alpha, d.shape, u);
        return vec2(e * (2.0f - e), (1.0f - e) * (1.0f - e));
    }
    default: break;
    }
    // [Walter et al. 2007, EGSR, equations 28 and 35]
    float tan2 = d.kind == DISTRIBUTION_GGX ? u / (1.0f - u) : -log(max(1.0f - u, 1.0e-20f));
    return sin2_cos2_of_tan2(alpha * alpha * tan2);
}

// The density of isotropic_sample per solid angle: D cos but for the two without an inverse.
float isotropic_sample_pdf(IN(Distribution) d, vec3 wm, float alpha) {
    if (d.kind == DISTRIBUTION_SHIFTED_GAMMA) {
        return shifted_gamma_sample_pdf(wm, alpha, d.shape);
    }
    if (d.kind == DISTRIBUTION_ABC) {
        return abc_sample_pdf(wm, alpha, d.shape);
    }
    return isotropic_d(d, wm, alpha) * wm.z;
}

// A normal of the stretched surface as the normal of the isotropic one, times a length.
vec3 unstretched_normal(IN(Distribution) d, vec3 wm, float alpha) {
    return vec3(wm.x * (alpha / d.alpha_x), wm.y * (alpha / d.alpha_y), wm.z);
}

// A direction that sees of the isotropic surface what w sees of the stretched one.
vec3 unstretched_direction(IN(Distribution) d, vec3 w, float alpha) {
    return normalize(vec3(w.x * (d.alpha_x / alpha), w.y * (d.alpha_y / alpha), w.z));
}

// Microfacets per solid angle; their projected area is one.
float distribution_d(IN(Distribution) d, vec3 wm) {
    if (d.alpha_x == d.alpha_y) {
        return isotropic_d(d, wm, d.alpha_x);
    }
    float alpha = distribution_mean_alpha(d);
    vec3 n = unstretched_normal(d, wm, alpha);
    float length2 = dot(n, n);
    return isotropic_d(d, n * inversesqrt(length2), alpha) / (length2 * length2);
}

float distribution_lambda(IN(Distribution) d, vec3 w) {
    if (d.alpha_x == d.alpha_y) {
        return isotropic_lambda(d, w, d.alpha_x);
    }
    float alpha = distribution_mean_alpha(d);
    return isotropic_lambda(d, unstretched_direction(d, w, alpha), alpha);
}

// A normal with a density near D cos, whatever the view.
vec3 distribution_sample(IN(Distribution) d, vec2 u) {
    float alpha = distribution_mean_alpha(d);
    vec2 squares = isotropic_sample(d, alpha, u.x);
    float r = sqrt(squares.x);
    float phi = TWO_PI * u.y;
    // Never quite edge-on, where the density would be 0.
    vec3 n = vec3(r * cos(phi), r * sin(phi), max(sqrt(squares.y), 1.0e-6f));
    return normalize(vec3(n.x * (d.alpha_x / alpha), n.y * (d.alpha_y / alpha), n.z));
}

float distribution_sample_pdf(IN(Distribution) d, vec3 wm) {
    if (wm.z <= 0.0f) {
        return 0.0f;
    }
    float alpha = distribution_mean_alpha(d);
    vec3 n = unstretched_normal(d, wm, alpha);
    float length2 = dot(n, n);
    // Stretching keeps the area of slopes, which is dw / cos^3.
    return isotropic_sample_pdf(d, n * inversesqrt(length2), alpha)
         / (length2 * sqrt(length2));
}

#endif
