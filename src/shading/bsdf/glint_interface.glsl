// The facets of the glint model: their Fresnel terms, reflection, refraction into a solid body,
// transmission through a sheet. glint.glsl adds the matte base and the sampling.
#ifndef GP_SHADING_BSDF_GLINT_INTERFACE_GLSL
#define GP_SHADING_BSDF_GLINT_INTERFACE_GLSL
#include "shading/fresnel.glsl"
#include "shading/glint/counting.glsl"
#include "shading/glint/glint.glsl"
#include "shading/glint/zirr.glsl"
#include "shading/slope/sheared_cavity.glsl"
#include "shading/slope/smith_slopes.glsl"
#include "shading/slope/tilted_cavity.glsl"
#include "shading/bsdf/gltf_interface.glsl"

// The order of the names in parameters.def.
#define GLINT_SMOOTH 0u      // the Gaussian: LEADR
#define GLINT_DICTIONARY 1u
#define GLINT_COUNTING 2u
#define GLINT_ZIRR 3u

#define GLINT_MASKING_V_CAVITY 0u
#define GLINT_MASKING_SMITH 1u
#define GLINT_MASKING_TILTED 2u

vec2 glint_mean(IN(BsdfParams) m) {
    return vec2(glint_mean_x(m), glint_mean_y(m));
}

// Of the material alone.
Slopes glint_material_slopes(IN(BsdfParams) m) {
    Slopes d;
    d.mean = glint_mean(m);
    d.var_x = 0.5f * m.alpha_x * m.alpha_x;
    d.var_y = 0.5f * m.alpha_y * m.alpha_y;
    d.cov = 0.5f * glint_correlation(m) * m.alpha_x * m.alpha_y;
    return d;
}

// As rough as a texel of glTF's metallic-roughness textures says, of a factor's share.
BsdfParams glint_with_roughness(BsdfParams m, float share) {
    float stretched = (m.alpha_x - m.alpha_y) / max(1.0f - m.alpha_y, 1.0e-6f);
    m.alpha_y = max(m.alpha_y * share * share, BSDF_MIN_ALPHA);
    m.alpha_x = max(m.alpha_y + (1.0f - m.alpha_y) * stretched, BSDF_MIN_ALPHA);
    return m;
}

// All that is smaller than the footprint but the pixel's kernel, in the material's place.
BsdfParams glint_with_slopes(BsdfParams m, IN(Slopes) d) {
    m.alpha_x = sqrt(2.0f * d.var_x);
    m.alpha_y = sqrt(2.0f * d.var_y);
    m.slot_a.x = d.mean.x;
    m.slot_a.y = d.mean.y;
    // One map can have all its slopes along a line.
    m.slot_a.z = clamp(d.cov * inversesqrt(max(d.var_x * d.var_y, 1.0e-30f)), -0.999f, 0.999f);
    return m;
}

// The point that is seen, with everything that is smaller than the footprint. kernel: the changes
// of the half vector along both axes of the pixel.
Glint glint_of(IN(BsdfParams) m, vec4 kernel) {
    Glint g;
    g.k0 = vec2(kernel.x, kernel.y);
    g.k1 = vec2(kernel.z, kernel.w);
    g.slopes = glint_kernel_added(glint_material_slopes(m), g.k0, g.k1);
    g.uv = vec2(m.slot_c.x, m.slot_c.y);
    g.d0 = vec2(m.slot_d.x, m.slot_d.y);
    g.d1 = vec2(m.slot_d.z, m.slot_d.w);
    g.log_density = LN_TWO * log2_above_0(max(glint_facet_density(m), 1.0e-20f));
    g.area = glint_area(m);
    g.jitter = glint_jitter(m);
    g.dictionary = m.table;
    g.seed = uint(glint_seed(m));
    return g;
}

Glint glint_of(IN(BsdfParams) m) {
    return glint_of(m, m.slot_e);
}

// Density of slopes, and the one by which they are drawn: the same, but for facets that are counted
// where there are so few that a pixel has more or less of them than one would expect.
struct GlintDensity {
    float value;
    float drawn;
};

GlintDensity glint_density(uint method, IN(Glint) g, vec2 s) {
    GlintDensity d;
    if (method == GLINT_COUNTING || method == GLINT_ZIRR) {
        CountedFacets c;
        if (method == GLINT_COUNTING) {
            c = glint_counting(g, s);
        } else {
            c = glint_zirr(g, s);
        }
        d.value = c.p22;
        d.drawn = c.whole > 0.0f ? c.p22 / c.whole : slopes_p22(g.slopes, s);
        return d;
    }
    d.value = method == GLINT_DICTIONARY ? glint_p22(g, s) : slopes_p22(g.slopes, s);
    d.drawn = d.value;
    return d;
}

// A slope by the density `drawn`; u_facet chooses the facet.
vec2 glint_slope_sample(uint method, IN(Glint) g, vec2 u, float u_facet) {
    if (method == GLINT_DICTIONARY) { return glint_sample(g, u, u_facet); }
    if (method == GLINT_COUNTING) { return glint_counting_sample(g, u, u_facet); }
    return method == GLINT_ZIRR ? glint_zirr_sample(g, u, u_facet) : slopes_sample(g.slopes, u);
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
        vec3 mirrored = vec3(1.0f - through);
        if (m.iridescence > 0.0f && !lost) {
            vec3 film = gltf_film(m, gltf_dielectric_f0(m), cos_outside);
            mirrored = mix(mirrored, film, m.iridescence);
            // Not one less that: near grazing angles few digits of it would be left.
            through = mix(through, 1.0f - max_component(film), m.iridescence);
        }
        // By component: GLM's max of vectors is a call where much else is inlined.
        vec3 sum = f.reflected + clear * (mirrored - schlick);
        f.reflected = vec3(max(sum.x, 0.0f), max(sum.y, 0.0f), max(sum.z, 0.0f));
        // slot_c.w: the share that never comes back, which a renderer fills in for deep water.
        f.transmitted = m.base_color * (clear * through * (1.0f - m.slot_c.w));
    }
    return f;
}

// Behind a facet, of light that may enter there.
float glint_cos_behind(IN(BsdfParams) m, float cos_h, float eta) {
    return gltf_transmissive_share(m) > 0.0f ? fresnel_g(cos_h, eta) / eta : 0.0f;
}

// A facet that turns light from i to o, and what it does but for its Fresnel term and how many of
// its slope there are: both numbers are times the density of slopes.
struct GlintFacet {
    vec2 slope;
    float f_cos;  // 0: no facet does that
    float pdf;
    float cos_h;  // at the facet, on the side of o
    float cos_t;  // behind it; only of a refraction
};

// Masking of a facet of slope s from both sides of the surface: before it (i too), or i behind it.
float glint_masking_g2(uint masking, IN(Slopes) d, vec2 s, vec3 o, vec3 i) {
    if (masking == GLINT_MASKING_SMITH) {
        return slopes_smith_g2(d, o, i);
    }
    return masking == GLINT_MASKING_TILTED ? tilted_cavity_g2(d.mean, s, o, i)
                                           : sheared_cavity_g2(d.mean, s, o, i);
}

// What hides light before the surface and behind it are different parts of a facet: the product.
float glint_masking_through(uint masking, IN(Slopes) d, vec2 s, vec3 o, vec3 i) {
    if (masking == GLINT_MASKING_SMITH) {
        return slopes_smith_g1(d, o) * slopes_smith_g1(d, -i);
    }
    if (masking == GLINT_MASKING_TILTED) {
        return tilted_cavity_g1(s, o) * tilted_cavity_g1_light(d.mean, s, -i);
    }
    return sheared_cavity_g1(d.mean, s, o) * sheared_cavity_g1(d.mean, s, -i);
}

GlintFacet glint_no_facet() {
    GlintFacet facet;
    facet.slope = vec2(0.0f);
    facet.f_cos = 0.0f;
    facet.pdf = 0.0f;
    facet.cos_h = 0.0f;
    facet.cos_t = 0.0f;
    return facet;
}

// o and i before the mesosurface. Without branches, so that loops become vectors.
// [Walter et al. 2007, EGSR, equation 20; per projected area: Dupuy et al. 2013, equation 9]
GlintFacet glint_reflection(uint masking, IN(Slopes) d, vec3 o, vec3 i) {
    vec3 h = o + i;
    float h_length = length(h);
    bool above = h.z > 1.0e-6f * h_length;
    vec3 wm = above ? h / h_length : vec3(0.0f, 0.0f, 1.0f);
    float z2 = wm.z * wm.z;
    float scale = above ? 0.25f / (z2 * z2 * slope_facing(d.mean, o)) : 0.0f;
    GlintFacet facet;
    facet.slope = slope_of(wm);
    facet.cos_h = above ? min(0.5f * h_length, 1.0f) : 0.0f;
    facet.cos_t = 0.0f;
    facet.pdf = scale * sheared_cavity_g1(d.mean, facet.slope, o);
    facet.f_cos = scale * glint_masking_g2(masking, d, facet.slope, o, i);
    return facet;
}

// o before and i behind the mesosurface; radiance, so that there is no eta^2 in the value.
// [Walter et al. 2007, EGSR, equations 17 and 21]
GlintFacet glint_refraction(IN(BsdfParams) m, IN(Slopes) d, vec3 o, vec3 i, float eta) {
    vec3 h = o + eta * i;
    float square = dot(h, h);
    if (!(square > 0.0f)) {
        return glint_no_facet();
    }
    vec3 wm = h * (h.z > 0.0f ? inversesqrt(square) : -inversesqrt(square));
    float cos_oh = dot(o, wm);
    float cos_ih = dot(i, wm);
    if (!(wm.z > 1.0e-6f) || cos_oh <= 0.0f || cos_ih >= 0.0f) {
        return glint_no_facet();
    }
    float z2 = wm.z * wm.z;
    float root = cos_oh + eta * cos_ih;
    float scale = -cos_ih * cos_oh / (root * root * z2 * z2 * slope_facing(d.mean, o));
    GlintFacet facet;
    facet.slope = slope_of(wm);
    facet.cos_h = cos_oh;
    facet.cos_t = -cos_ih;
    facet.pdf = scale * sheared_cavity_g1(d.mean, facet.slope, o) * eta * eta;
    facet.f_cos = scale * glint_masking_through(glint_masking(m), d, facet.slope, o, i);
    return facet;
}

#endif
