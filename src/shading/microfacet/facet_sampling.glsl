// Reflections at the facets of any distribution: a normal as the viewer sees them where that has a
// closed form, else without regard to the viewer; and the density of the direction it reflects to.
#ifndef GP_SHADING_MICROFACET_FACET_SAMPLING_GLSL
#define GP_SHADING_MICROFACET_FACET_SAMPLING_GLSL
#include "shading/microfacet/distribution.glsl"

// A normal as wo sees them between grooves: seen from the side, one of the two slopes of a groove
// hides the other. [Heitz and d'Eon 2014, EGSR, "V-cavities"]
vec3 facet_sample_cavity(IN(Distribution) d, vec3 wo, float u_side, vec2 u) {
    vec3 wm = distribution_sample(d, u);
    vec3 mirrored = vec3(-wm.x, -wm.y, wm.z);
    float seen = max(dot(wo, wm), 0.0f);
    float mirrored_seen = max(dot(wo, mirrored), 0.0f);
    return u_side * (seen + mirrored_seen) < mirrored_seen ? mirrored : wm;
}

// cavities: masking is that of V-cavities. u_side serves for them only.
vec3 facet_sample(IN(Distribution) d, bool cavities, vec3 wo, float u_side, vec2 u) {
    if (cavities) {
        return facet_sample_cavity(d, wo, u_side, u);
    }
    if (d.kind == DISTRIBUTION_GGX) {
        return ggx_sample_vndf(wo, d.alpha_x, d.alpha_y, u);
    }
    if (d.kind == DISTRIBUTION_BECKMANN) {
        return beckmann_sample_vndf(wo, d.alpha_x, d.alpha_y, u);
    }
    return distribution_sample(d, u);
}

// The density of wi, from d_value = D at its half vector.
// [Walter et al. 2007, EGSR, equation 14; visible normals: Heitz and d'Eon 2014, EGSR, equation 2]
float facet_reflection_pdf(IN(Distribution) d, bool cavities, vec3 wo, vec3 wm, float cos_h,
                           float d_value) {
    if (cavities) {
        // wm and its mirror image share their chance. [Heitz and d'Eon 2014, EGSR]
        float mirrored = max(dot(wo, vec3(-wm.x, -wm.y, wm.z)), 0.0f);
        return distribution_sample_pdf(d, wm) / (2.0f * (cos_h + mirrored));
    }
    if (d.kind == DISTRIBUTION_GGX) {
        return 0.5f * d_value / (wo.z + ggx_stretched(wo, d.alpha_x, d.alpha_y));
    }
    if (d.kind == DISTRIBUTION_BECKMANN) {
        return 0.25f * d_value * beckmann_g1(wo, d.alpha_x, d.alpha_y) / wo.z;
    }
    return distribution_sample_pdf(d, wm) / (4.0f * cos_h);
}

#endif
