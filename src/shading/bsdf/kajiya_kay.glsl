// Kajiya and Kay's highlight of fibres that lie on the surface: mirrors around the fibre reflect
// into the cone of the incoming light, a power of the cosine widens the cone. No energy is kept.
// `falloff` fades light that grazes the surface, as the fibres' neighbours would.
#ifndef GP_SHADING_BSDF_KAJIYA_KAY_GLSL
#define GP_SHADING_BSDF_KAJIYA_KAY_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

#define KAJIYA_KAY_ALONG_Y 0u
#define KAJIYA_KAY_ALONG_X 1u

// The sine of the angle between w and the plane across the fibre.
float kajiya_kay_sine(IN(BsdfParams) m, vec3 w) {
    return kajiya_kay_fibre(m) == KAJIYA_KAY_ALONG_X ? w.x : w.y;
}

// The square of its cosine; from the other components, since near the fibre 1 - sin^2 is rounding.
float kajiya_kay_cosine2(IN(BsdfParams) m, vec3 w) {
    float across = kajiya_kay_fibre(m) == KAJIYA_KAY_ALONG_X ? w.y : w.x;
    return max(across * across + w.z * w.z, 1.0e-20f);
}

// That angle; by the tangent, since some compilers' asin is off by 1e-4.
float kajiya_kay_angle(IN(BsdfParams) m, vec3 w) {
    return atan(kajiya_kay_sine(m, w), sqrt(kajiya_kay_cosine2(m, w)));
}

// cos(theta_o + theta_i)^(1 / roughness), 0 from 90 degrees on.
// [Kajiya and Kay 1989, SIGGRAPH, "Rendering Fur with Three Dimensional Textures"]
float kajiya_kay_lobe(float sin_o, float sin_i, float roughness, bool even_power) {
    float cos_o = sqrt(max((1.0f - sin_o) * (1.0f + sin_o), 0.0f));
    float cos_i = sqrt(max((1.0f - sin_i) * (1.0f + sin_i), 0.0f));
    // sin(theta_o + theta_i), which has the digits that a cosine near 1 has lost.
    float s = sin_o * cos_i + cos_o * sin_i;
    float c = cos_o * cos_i - sin_o * sin_i;
    return c > 0.0f || even_power ? exp(0.5f * log(max(1.0f - s * s, 1.0e-37f)) / roughness) : 0.0f;
}

// A smooth step in the angle over the horizon; its width is a share of 90 degrees.
float kajiya_kay_fade(float cos_i, float falloff) {
    if (falloff <= 0.0f) {
        return 1.0f;
    }
    float elevation = atan(cos_i, sqrt(max((1.0f - cos_i) * (1.0f + cos_i), 0.0f)));
    float t = clamp(elevation / (falloff * HALF_PI), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// The width of a logistic distribution with the variance of the lobe, which is `roughness` nearly.
float kajiya_kay_scale(float roughness) {
    return 0.551328895421792049f * sqrt(roughness);  // sqrt(3) / pi
}

// What the logistic distribution has below x.
float kajiya_kay_share_below(float x, float scale) {
    return 1.0f / (1.0f + exp(clamp(-x / scale, -80.0f, 80.0f)));
}

// Forms of other programs, which shine in other places: sampled by the cosine only.
bool kajiya_kay_is_altered(IN(BsdfParams) m) {
    return kajiya_kay_even(m) || kajiya_kay_light_twice(m);
}

// Density of sampling: logistic in theta_o + theta_i, cosine-like around the fibre.
float kajiya_kay_pdf(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (kajiya_kay_is_altered(m)) {
        return cosine_hemisphere_pdf(wi);
    }
    float theta_o = kajiya_kay_angle(m, wo);
    float scale = kajiya_kay_scale(kajiya_kay_roughness(m));
    float first = kajiya_kay_share_below(theta_o - HALF_PI, scale);
    float last = kajiya_kay_share_below(theta_o + HALF_PI, scale);
    float below = kajiya_kay_share_below(theta_o + kajiya_kay_angle(m, wi), scale);
    float logistic = below * (1.0f - below) / (scale * max(last - first, 1.0e-20f));
    return logistic * 0.5f * wi.z / kajiya_kay_cosine2(m, wi);
}

BsdfValue kajiya_kay_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    float sin_i = kajiya_kay_sine(m, wi);
    float sin_o = kajiya_kay_light_twice(m) ? sin_i : kajiya_kay_sine(m, wo);
    float lobe = kajiya_kay_lobe(sin_o, sin_i, kajiya_kay_roughness(m), kajiya_kay_even(m));
    BsdfValue v;
    v.pdf = kajiya_kay_pdf(m, wo, wi);
    v.f_cos = m.base_color * (lobe * kajiya_kay_fade(wi.z, kajiya_kay_falloff(m)) * wi.z);
    if (v.pdf <= 0.0f) {
        return bsdf_no_value();
    }
    return v;
}

BsdfSample kajiya_kay_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    if (kajiya_kay_is_altered(m)) {
        vec3 any = square_to_cosine_hemisphere(u);
        return bsdf_sample_of(any, kajiya_kay_eval(m, wo, any), LOBE_GLOSSY);
    }
    float theta_o = kajiya_kay_angle(m, wo);
    float scale = kajiya_kay_scale(kajiya_kay_roughness(m));
    float first = kajiya_kay_share_below(theta_o - HALF_PI, scale);
    float last = kajiya_kay_share_below(theta_o + HALF_PI, scale);
    float below = clamp(mix(first, last, u.x), 1.0e-30f, ONE_MINUS_EPSILON);
    float theta_i = clamp(scale * log(below / (1.0f - below)) - theta_o, -HALF_PI, HALF_PI);
    // Around the fibre by the cosine with the normal.
    float side = 1.0f - 2.0f * u.y;
    float up = 2.0f * sqrt(max(u.y * (1.0f - u.y), 0.0f));
    float r = cos(theta_i);
    float s = sin(theta_i);
    vec3 wi = kajiya_kay_fibre(m) == KAJIYA_KAY_ALONG_X ? vec3(s, r * side, r * up)
                                                        : vec3(r * side, s, r * up);
    return bsdf_sample_of(wi, kajiya_kay_eval(m, wo, wi), LOBE_GLOSSY);
}

// Integral of a Gaussian of the lobe's variance; for fibres across the view.
vec3 kajiya_kay_albedo(IN(BsdfParams) m, float cos_o) {
    float white = 2.0f * sqrt(TWO_PI * kajiya_kay_roughness(m));
    return cos_o > 0.0f ? min(white, 1.0f) * m.base_color : vec3(0.0f);
}

bool kajiya_kay_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
