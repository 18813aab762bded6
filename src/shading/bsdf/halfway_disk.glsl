// Edwards' BRDF from a density on the halfway vector disk: the half vector, scaled so that its
// height is the viewer's cosine, meets a plane in a point of a disk, and a "lump" of area one lies
// on that disk. What leaves is what arrives, less what the lump sends below the horizon; the price
// is that wo and wi play different parts. (`even_power` is not Edwards': it loses all that.)
#ifndef GP_SHADING_BSDF_HALFWAY_DISK_GLSL
#define GP_SHADING_BSDF_HALFWAY_DISK_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

// (n + 1) / (pi R^2) (1 - r^2 / R^2)^n, nothing outside of R.
// [Edwards et al. 2006, ACM TOG 25(1), "The Halfway Vector Disk for BRDF Modeling"]
float halfway_disk_lump(float r2, float radius, float n, bool even_power) {
    float x = 1.0f - r2 / (radius * radius);
    x = even_power ? abs(x) : x;
    return x > 0.0f ? (n + 1.0f) * INV_PI / (radius * radius) * exp(n * log(x)) : 0.0f;
}

// From the area of the disk to the solid angle of wi: heights scale the slope's plane by cos_o^2.
// [Edwards et al. 2006, "scaling projection"]
BsdfValue halfway_disk_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    vec3 h = wo + wi;
    float length2 = dot(h, h);
    float scale = wo.z / h.z;
    float r2 = scale * scale * (h.x * h.x + h.y * h.y);
    // cos_o^2 / (4 cos_oh cos_h^3) with the half vector's length cancelled where it can be.
    float jacobian = scale * scale * length2 / (2.0f * h.z);
    BsdfValue v;
    float lump = halfway_disk_lump(r2, halfway_disk_radius(m), halfway_disk_exponent(m),
                                   halfway_disk_even(m));
    v.pdf = halfway_disk_even(m) ? cosine_hemisphere_pdf(wi) : lump * jacobian;
    v.f_cos = m.base_color * (lump * jacobian);
    return v;
}

// A point of the lump makes the half vector: every weight is the base colour.
BsdfSample halfway_disk_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    if (halfway_disk_even(m)) {
        vec3 any = square_to_cosine_hemisphere(u);
        return bsdf_sample_of(any, halfway_disk_eval(m, wo, any), LOBE_GLOSSY);
    }
    float power = exp(log(max(1.0f - u.x, 1.0e-20f)) / (halfway_disk_exponent(m) + 1.0f));
    float r = halfway_disk_radius(m) * sqrt(1.0f - power);
    float phi = TWO_PI * u.y;
    vec3 wm = normalize(vec3(r * cos(phi), r * sin(phi), wo.z));
    vec3 wi = reflect(-wo, wm);
    if (dot(wo, wm) <= 0.0f) {
        return bsdf_no_sample();
    }
    return bsdf_sample_of(wi, halfway_disk_eval(m, wo, wi), LOBE_GLOSSY);
}

vec3 halfway_disk_albedo(IN(BsdfParams) m, float cos_o) {
    return cos_o > 0.0f ? m.base_color : vec3(0.0f);
}

bool halfway_disk_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
