// Banded ("toon") shading: Lambert's cosine rounded down to one of n steps. Not reciprocal, and no
// physical reflectance, but darker than Lambert everywhere.
#ifndef GP_SHADING_BSDF_CLASSIC_BANDED_GLSL
#define GP_SHADING_BSDF_CLASSIC_BANDED_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

// floor(n cos) / n in place of the cosine.
// [Lake, Marshall, Harris and Blackstein 2000, "Stylized Rendering Techniques for Scalable
// Real-Time 3D Animation", with equal steps]
BsdfValue banded_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    float n = floor(banded_steps(m) + 0.5f);
    BsdfValue v;
    v.f_cos = m.base_color * (INV_PI * floor(wi.z * n) / n);
    v.pdf = cosine_hemisphere_pdf(wi);
    return v;
}

BsdfSample banded_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_cosine_hemisphere(u);
    return bsdf_sample_of(wi, banded_eval(m, wo, wi), LOBE_DIFFUSE);
}

// Twice the integral of the steps, (n - 1) / n.
vec3 banded_albedo(IN(BsdfParams) m, float cos_o) {
    float n = floor(banded_steps(m) + 0.5f);
    return cos_o > 0.0f ? m.base_color * ((n - 1.0f) / n) : vec3(0.0f);
}

bool banded_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
