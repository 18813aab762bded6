// Clear coat: a thin colourless dielectric film of index 1.5 over everything else, with a roughness
// and a normal of its own.
#ifndef GP_SHADING_BSDF_COAT_GLSL
#define GP_SHADING_BSDF_COAT_GLSL
#include "shading/frame.glsl"
#include "shading/fresnel.glsl"
#include "shading/microfacet/ggx_albedo.glsl"
#include "shading/bsdf/ggx_lobe.glsl"

// [KHR_materials_clearcoat: index of refraction 1.5]
#define COAT_F0 0.04f

// Azimuth has no meaning for the isotropic coat, so any frame around its normal will do; the usual
// normal needs none.
Frame coat_frame(IN(BsdfParams) m) {
    return frame_from_normal(m.coat_normal);
}

bool coat_is_flat(IN(BsdfParams) m) {
    return m.coat_normal.z >= 1.0f;
}

// The share of light from w that the coat reflects, w on the outside.
float coat_albedo(IN(BsdfParams) m, vec3 w) {
    float cos_w = clamp(dot(m.coat_normal, w), 1.0e-4f, 1.0f);
    GgxAlbedo e = ggx_albedo(cos_w, m.coat_alpha);
    return m.coat * ggx_albedo_fresnel(e, COAT_F0, 1.0f);
}

// The cosine is that with the coat's own normal. Black where its normal faces away from wo or wi.
// [KHR_materials_clearcoat, "Layering"; Fresnel term at the microfacet, not at the normal]
BsdfValue coat_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    vec3 o = wo;
    vec3 i = wi;
    if (!coat_is_flat(m)) {
        Frame frame = coat_frame(m);
        o = local_from_world(frame, wo);
        i = local_from_world(frame, wi);
    }
    if (o.z <= 0.0f || i.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    GgxLobe lobe = ggx_reflection(o, i, m.coat_alpha, m.coat_alpha);
    BsdfValue v;
    v.f_cos = vec3(m.coat * fresnel_schlick(COAT_F0, 1.0f, lobe.cos_h) * lobe.f_cos);
    v.pdf = lobe.pdf;
    return v;
}

// The mean of f cos over the disc of a light about wi, disc: 1 - cos of its angular radius. A lobe
// that would be brighter in its middle than the disc in a mirror shows the disc, sharp; wider ones
// take it for a point. pdf: 0.
BsdfValue coat_eval_disc(IN(BsdfParams) m, vec3 wo, vec3 wi, float disc) {
    float sin_squared = disc * (2.0f - disc);
    float cos_o = dot(m.coat_normal, wo);
    // GGX's middle is 1 / (4 pi alpha^2), the disc's 1 / (pi sin^2).
    if (4.0f * m.coat_alpha * m.coat_alpha >= sin_squared) {
        return coat_eval(m, wo, wi);
    }
    BsdfValue v = bsdf_no_value();
    vec3 chord = m.coat_normal * (2.0f * cos_o) - wo - wi;
    if (cos_o > 0.0f && dot(m.coat_normal, wi) > 0.0f && wi.z > 0.0f
        && dot(chord, chord) <= 2.0f * disc) {
        v.f_cos = vec3(m.coat * fresnel_schlick(COAT_F0, 1.0f, cos_o) / (PI * sin_squared));
    }
    return v;
}

uint coat_lobe(IN(BsdfParams) m) {
    return alpha_is_specular(m.coat_alpha, m.coat_alpha) ? LOBE_SPECULAR : LOBE_GLOSSY;
}

// A direction from the coat's lobe; below the horizon, z <= 0, where there is none.
vec3 coat_sample_direction(IN(BsdfParams) m, vec3 wo, vec2 u) {
    if (coat_is_flat(m)) {
        return reflect(-wo, ggx_sample_vndf(wo, m.coat_alpha, m.coat_alpha, u));
    }
    Frame frame = coat_frame(m);
    vec3 o = local_from_world(frame, wo);
    if (o.z <= 0.0f) {
        return vec3(0.0f, 0.0f, -1.0f);
    }
    vec3 i = reflect(-o, ggx_sample_vndf(o, m.coat_alpha, m.coat_alpha, u));
    return i.z > 0.0f ? world_from_local(frame, i) : vec3(0.0f, 0.0f, -1.0f);
}

#endif
