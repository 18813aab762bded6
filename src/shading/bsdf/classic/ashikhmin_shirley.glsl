// Ashikhmin-Shirley: an anisotropic power of the half vector's cosine, Schlick's Fresnel term, and
// below it a diffuse part that gets what is left. The lobe alone never gains light; with the
// coupled diffuse part the sum does not either.
#ifndef GP_SHADING_BSDF_CLASSIC_ASHIKHMIN_SHIRLEY_GLSL
#define GP_SHADING_BSDF_CLASSIC_ASHIKHMIN_SHIRLEY_GLSL
#include "shading/fresnel.glsl"
#include "shading/bsdf/classic/lobes.glsl"

#define ASHIKHMIN_COUPLED 0u
#define ASHIKHMIN_UNCOUPLED 1u

// The density of half vectors, hz^((nu hx^2 + nv hy^2) / (1 - hz^2)) with its factor. In the
// exponent sin^2 divides log(hz), which is finite for the normal itself.
// [Ashikhmin and Shirley 2000, "An Anisotropic Phong BRDF Model", equation 6]
float ashikhmin_shirley_pdf_h(IN(BsdfParams) m, vec3 wm) {
    float nu = ashikhmin_shirley_exponent_u(m);
    float nv = ashikhmin_shirley_exponent_v(m);
    float sin2 = wm.x * wm.x + wm.y * wm.y;
    float slope = sin2 > 1.0e-12f ? log_height(wm) / sin2 : -0.5f;
    float power = exp((nu * wm.x * wm.x + nv * wm.y * wm.y) * slope);
    return sqrt((nu + 1.0f) * (nv + 1.0f)) * INV_TWO_PI * power;
}

// "coupled" is the paper's:
// 28 / (23 pi) Rd (1 - Rs) (1 - (1 - cos_i / 2)^5) (1 - (1 - cos_o / 2)^5);
// "uncoupled" lacks (1 - Rs), as wdas/brdf has it with coupled_diffuse off; "lambert" is Lambert.
// [Ashikhmin and Shirley 2000, equation 5]
vec3 ashikhmin_shirley_diffuse(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    uint form = ashikhmin_shirley_diffuse_form(m);
    vec3 color = m.base_color * INV_PI;
    if (form == ASHIKHMIN_COUPLED) {
        color *= vec3(1.0f) - m.specular_color;
    } else if (form != ASHIKHMIN_UNCOUPLED) {
        return color;
    }
    return color * (28.0f / 23.0f * schlick_through(0.5f * wo.z) * schlick_through(0.5f * wi.z));
}

float ashikhmin_shirley_share(IN(BsdfParams) m, float cos_o) {
    float specular = max_component(fresnel_schlick(m.specular_color, vec3(1.0f), cos_o));
    return lobe_share(specular, max_component(m.base_color));
}

// f = pdf_h F / (4 cos_h max(cos_o, cos_i)) and the diffuse part.
// [Ashikhmin and Shirley 2000, equation 4]
BsdfValue ashikhmin_shirley_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!above_horizon(wo, wi)) {
        return bsdf_no_value();
    }
    HalfVector h = half_vector(wo, wi);
    float lobe = reflection_pdf(ashikhmin_shirley_pdf_h(m, h.wm), h.cos_h);
    vec3 f = fresnel_schlick(m.specular_color, vec3(1.0f), h.cos_h);
    float p = ashikhmin_shirley_share(m, wo.z);
    BsdfValue v;
    v.f_cos = f * (lobe * (wi.z / max(wo.z, wi.z))) + ashikhmin_shirley_diffuse(m, wo, wi) * wi.z;
    v.pdf = p * lobe + (1.0f - p) * cosine_hemisphere_pdf(wi);
    return v;
}

// [Ashikhmin and Shirley 2000, equations 9 and 10, for all quadrants at once: the azimuth is that
// of a circle stretched to an ellipse]
vec3 ashikhmin_shirley_sample_h(IN(BsdfParams) m, vec2 u) {
    float nu = ashikhmin_shirley_exponent_u(m);
    float nv = ashikhmin_shirley_exponent_v(m);
    float x = sqrt(nv + 1.0f) * cos(TWO_PI * u.y);
    float y = sqrt(nu + 1.0f) * sin(TWO_PI * u.y);
    float inv_length = inversesqrt(x * x + y * y);
    float cos_phi = x * inv_length;
    float sin_phi = y * inv_length;
    vec3 d = square_to_cosine_power(vec2(u.x, 0.0f),
                                    nu * cos_phi * cos_phi + nv * sin_phi * sin_phi);
    return vec3(d.x * cos_phi, d.x * sin_phi, d.z);
}

BsdfSample ashikhmin_shirley_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    if (u_lobe >= ashikhmin_shirley_share(m, wo.z)) {
        vec3 below = square_to_cosine_hemisphere(u);
        return bsdf_sample_of(below, ashikhmin_shirley_eval(m, wo, below), LOBE_DIFFUSE);
    }
    vec3 wm = ashikhmin_shirley_sample_h(m, u);
    if (dot(wo, wm) <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wi = reflect(-wo, wm);
    return bsdf_sample_of(wi, ashikhmin_shirley_eval(m, wo, wi), LOBE_GLOSSY);
}

// The lobe as if it lost nothing, the rest to the diffuse part.
vec3 ashikhmin_shirley_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    vec3 f = fresnel_schlick(m.specular_color, vec3(1.0f), cos_o);
    return f + m.base_color * (vec3(1.0f) - f);
}

bool ashikhmin_shirley_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
