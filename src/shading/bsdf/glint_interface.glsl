// The facets of the glint model: their Fresnel terms, reflection, refraction into a solid body,
// transmission through a sheet. glint.glsl adds the matte base and the sampling.
#ifndef GP_SHADING_BSDF_GLINT_INTERFACE_GLSL
#define GP_SHADING_BSDF_GLINT_INTERFACE_GLSL
#include "shading/fresnel.glsl"
#include "shading/glint/glint.glsl"
#include "shading/slope/sheared_cavity.glsl"
#include "shading/bsdf/gltf_interface.glsl"

#define GLINT_MAX_CORRELATION 0.99f

vec2 glint_mean(IN(BsdfParams) m) {
    return vec2(glint_mean_x(m), glint_mean_y(m));
}

// Of all that is smaller than the footprint: the material's facets, and what a renderer adds.
Slopes glint_slopes(IN(BsdfParams) m) {
    Slopes d;
    d.mean = glint_mean(m);
    d.var_x = 0.5f * m.alpha_x * m.alpha_x;
    d.var_y = 0.5f * m.alpha_y * m.alpha_y;
    float rho = clamp(glint_correlation(m), -GLINT_MAX_CORRELATION, GLINT_MAX_CORRELATION);
    d.cov = rho * 0.5f * m.alpha_x * m.alpha_y;
    return d;
}

Glint glint_of(IN(BsdfParams) m) {
    Glint g;
    g.slopes = glint_slopes(m);
    g.uv = vec2(0.0f);
    g.d0 = vec2(0.0f);
    g.d1 = vec2(0.0f);
    g.log_density = 0.0f;
    g.area = 1.0f;
    g.jitter = 0.0f;
    g.k0 = vec2(0.0f);
    g.k1 = vec2(0.0f);
    g.dictionary = uvec2(0u);
    g.seed = 0u;
    return g;
}

// To the normal of the mesosurface, of length >= 1.
vec3 mesosurface_normal(vec2 mean) {
    return vec3(-mean.x, -mean.y, 1.0f);
}

// w seen from the other side of a sheet: behind the mesosurface as far as it was before it.
vec3 mesosurface_mirrored(vec2 mean, vec3 w) {
    vec3 n = mesosurface_normal(mean);
    return w - n * (2.0f * slope_facing(mean, w) / dot(n, n));
}

// From below a sheet is what it is from above; a solid body's facets are seen from their backs:
// both directions are negated, and the slopes stay.
vec3 glint_turned(IN(BsdfParams) m, vec3 w) {
    return m.thin != 0u ? mesosurface_mirrored(glint_mean(m), w) : -w;
}

// The cosine with the normal of the mesosurface.
float mesosurface_cosine(vec2 mean, vec3 w) {
    vec3 n = mesosurface_normal(mean);
    return clamp(slope_facing(mean, w) * inversesqrt(dot(n, n)), -1.0f, 1.0f);
}

// cos_h on the side of the view and cos_t behind the facet, 0 past the critical angle; eta as seen
// from the view.
GltfFresnel glint_fresnel(IN(BsdfParams) m, float cos_h, float cos_t, float eta) {
    float clear = gltf_transmissive_share(m);
    float cos_outside = gltf_outside_cosine(m, cos_h, eta);
    bool lost = eta < 1.0f && m.thin == 0u && cos_outside <= 0.0f;
    GltfFresnel f;
    f.reflected = lost ? vec3(1.0f) : gltf_reflectance(m, cos_outside);
    f.transmitted = vec3(0.0f);
    if (clear > 0.0f) {
        vec3 schlick = lost ? vec3(1.0f) : gltf_dielectric_fresnel(m, cos_outside);
        float through = cos_t > 0.0f ? fresnel_transmittance(cos_h, cos_t, eta) : 0.0f;
        f.reflected = max(f.reflected + clear * (vec3(1.0f - through) - schlick), vec3(0.0f));
        f.transmitted = m.base_color * (clear * through);
    }
    return f;
}

// Behind a facet, of light that may enter there.
float glint_cos_behind(IN(BsdfParams) m, float cos_h, float eta) {
    return gltf_transmissive_share(m) > 0.0f ? fresnel_g(cos_h, eta) / eta : 0.0f;
}

// One facet's light without its Fresnel term: value and density, and the cosine at the facet.
struct GlintLobe {
    float f_cos;
    float pdf;
    float cos_h;
    float cos_t;  // behind the facet; only of a refraction
};

float glint_masking_g2(vec2 mean, vec2 s, vec3 wo, vec3 wi) {
    return sheared_cavity_g2(mean, s, wo, wi);
}

GlintLobe glint_no_lobe() {
    GlintLobe lobe;
    lobe.f_cos = 0.0f;
    lobe.pdf = 0.0f;
    lobe.cos_h = 0.0f;
    lobe.cos_t = 0.0f;
    return lobe;
}

// o and i before the mesosurface.
// [Walter et al. 2007, EGSR, equation 20; per projected area: Dupuy et al. 2013, equation 9]
GlintLobe glint_reflection(IN(Glint) g, vec3 o, vec3 i) {
    vec3 h = o + i;
    float h_length = length(h);
    if (!(h.z > 1.0e-6f * h_length)) {
        return glint_no_lobe();
    }
    vec3 wm = h / h_length;
    vec2 s = slope_of(wm);
    float z2 = wm.z * wm.z;
    float visible = 0.25f * glint_p22(g, s) / (z2 * z2 * slope_facing(g.slopes.mean, o));
    GlintLobe lobe;
    lobe.cos_h = min(0.5f * h_length, 1.0f);
    lobe.cos_t = 0.0f;
    lobe.pdf = visible * sheared_cavity_g1(g.slopes.mean, s, o);
    lobe.f_cos = visible * glint_masking_g2(g.slopes.mean, s, o, i);
    return lobe;
}

// o before and i behind the mesosurface; radiance, so that there is no eta^2 in the value. What
// hides light before the surface and behind it are different parts of a facet: the product.
// [Walter et al. 2007, EGSR, equations 17 and 21]
GlintLobe glint_refraction(IN(Glint) g, vec3 o, vec3 i, float eta) {
    vec3 h = o + eta * i;
    float square = dot(h, h);
    if (!(square > 0.0f)) {
        return glint_no_lobe();
    }
    vec3 wm = h * (h.z > 0.0f ? inversesqrt(square) : -inversesqrt(square));
    float cos_oh = dot(o, wm);
    float cos_ih = dot(i, wm);
    if (!(wm.z > 1.0e-6f) || cos_oh <= 0.0f || cos_ih >= 0.0f) {
        return glint_no_lobe();
    }
    vec2 mean = g.slopes.mean;
    vec2 s = slope_of(wm);
    float z2 = wm.z * wm.z;
    float root = cos_oh + eta * cos_ih;
    float visible = sheared_cavity_g1(mean, s, o) * cos_oh * glint_p22(g, s) /
                    (z2 * z2 * slope_facing(mean, o));
    float jacobian = -cos_ih / (root * root);
    GlintLobe lobe;
    lobe.cos_h = cos_oh;
    lobe.cos_t = -cos_ih;
    lobe.pdf = visible * jacobian * eta * eta;
    lobe.f_cos = visible * jacobian * sheared_cavity_g1(mean, s, -i);
    return lobe;
}

#endif
