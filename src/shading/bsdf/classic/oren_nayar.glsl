// Oren-Nayar: Lambertian facets in V-cavities whose slopes are Gaussian, the rough diffuse surface
// that looks flat when lit from the viewer. Both forms of the paper: the full one, with the light
// that facets send to each other, and the qualitative one.
#ifndef GP_SHADING_BSDF_CLASSIC_OREN_NAYAR_GLSL
#define GP_SHADING_BSDF_CLASSIC_OREN_NAYAR_GLSL
#include "shading/bsdf/classic/lobes.glsl"

// What both forms are made of. The azimuth has no meaning for a direction along the normal; all of
// its terms then have a factor of 0, so that any value is right as long as it is finite.
struct OrenNayarAngles {
    float cos_phi;
    float low;          // the smaller angle with the normal, beta
    float high;         // the larger one, alpha
    float sin_high;
    float tan_low;
    float tan_mean;     // tan((alpha + beta) / 2)
};

OrenNayarAngles oren_nayar_angles(vec3 wo, vec3 wi) {
    float sin_o = sqrt(wo.x * wo.x + wo.y * wo.y);
    float sin_i = sqrt(wi.x * wi.x + wi.y * wi.y);
    float both = sin_o * sin_i;
    bool o_low = wo.z > wi.z;
    float sin_low = o_low ? sin_o : sin_i;
    float cos_low = o_low ? wo.z : wi.z;
    OrenNayarAngles a;
    a.cos_phi = both > 0.0f ? clamp((wo.x * wi.x + wo.y * wi.y) / both, -1.0f, 1.0f) : 1.0f;
    a.sin_high = o_low ? sin_i : sin_o;
    // From sine and cosine: an arc cosine has no digits near the normal.
    a.low = atan(sin_low, cos_low);
    a.high = atan(a.sin_high, o_low ? wi.z : wo.z);
    a.tan_low = sin_low / max(cos_low, GRAZING_COSINE);
    a.tan_mean = (sin_low + a.sin_high) / max(wo.z + wi.z, GRAZING_COSINE);
    return a;
}

// f pi / rho, sigma in radians.
// [Oren and Nayar 1994, "Generalization of Lambert's Reflectance Model", equation 30]
float oren_nayar_qualitative(OrenNayarAngles a, float sigma) {
    float s2 = sigma * sigma;
    float b = 0.45f * s2 / (s2 + 0.09f);
    return 1.0f - 0.5f * s2 / (s2 + 0.33f) + b * max(a.cos_phi, 0.0f) * a.sin_high * a.tan_low;
}

// f pi. [Oren and Nayar 1994, equations 27 to 29]
vec3 oren_nayar_full(OrenNayarAngles a, float sigma, vec3 rho) {
    float s2 = sigma * sigma;
    float low = 2.0f * INV_PI * a.low;  // in right angles
    float high = 2.0f * INV_PI * a.high;
    float c1 = 1.0f - 0.5f * s2 / (s2 + 0.33f);
    float c2 = 0.45f * s2 / (s2 + 0.09f)
             * (a.sin_high - (a.cos_phi >= 0.0f ? 0.0f : low * low * low));
    float c3 = 0.125f * s2 / (s2 + 0.09f) * (high * low) * (high * low);
    float direct = c1 + a.cos_phi * c2 * a.tan_low + (1.0f - abs(a.cos_phi)) * c3 * a.tan_mean;
    float twice = 0.17f * s2 / (s2 + 0.13f) * (1.0f - a.cos_phi * low * low);
    return max(rho * direct + rho * rho * twice, vec3(0.0f));
}

BsdfValue oren_nayar_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    OrenNayarAngles a = oren_nayar_angles(wo, wi);
    float sigma = oren_nayar_sigma(m);
    BsdfValue v;
    v.pdf = cosine_hemisphere_pdf(wi);
    v.f_cos = v.pdf * (oren_nayar_form(m) == 0u ? oren_nayar_full(a, sigma, m.base_color)
                                                : m.base_color * oren_nayar_qualitative(a, sigma));
    return v;
}

BsdfSample oren_nayar_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_cosine_hemisphere(u);
    return bsdf_sample_of(wi, oren_nayar_eval(m, wo, wi), LOBE_DIFFUSE);
}

// Near to Lambert's.
vec3 oren_nayar_albedo(IN(BsdfParams) m, float cos_o) {
    return cos_o > 0.0f ? m.base_color : vec3(0.0f);
}

bool oren_nayar_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
