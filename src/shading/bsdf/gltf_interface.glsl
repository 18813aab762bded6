// The microfacet interface of the glTF material: the Fresnel terms of its dielectric and its
// metal, reflection, and transmission through a sheet or into a solid body. gltf.glsl adds the
// other lobes.
#ifndef GP_SHADING_BSDF_GLTF_INTERFACE_GLSL
#define GP_SHADING_BSDF_GLTF_INTERFACE_GLSL
#include "shading/fresnel.glsl"
#include "shading/iridescence.glsl"
#include "shading/bsdf/ggx_lobe.glsl"
#include "shading/bsdf/ggx_dielectric.glsl"

// What the interface does at one microfacet: the reflectance of the mix of dielectric and metal,
// and the share that is refracted.
struct GltfFresnel {
    vec3 reflected;
    vec3 transmitted;
};

// [KHR_materials_ior; KHR_materials_specular, "Implementation"]
vec3 gltf_dielectric_f0(IN(BsdfParams) m) {
    return m.specular * min(f0_from_ior(m.ior) * m.specular_color, vec3(1.0f));
}

// The part of the material that transmits; 0 for the usual opaque one.
float gltf_transmissive_share(IN(BsdfParams) m) {
    return (1.0f - m.metallic) * m.transmission;
}

// The film's reflectance, kept at most 1 (fresnel_iridescence).
vec3 gltf_film(IN(BsdfParams) m, vec3 f0, float cos_h) {
    vec3 f = fresnel_iridescence(1.0f, m.iridescence_ior, cos_h, m.iridescence_thickness_nm, f0);
    return min(f, vec3(1.0f));
}

// cos_h is the cosine at the microfacet on the outside, where Schlick's approximation holds.
// [glTF 2.0 specification, appendix B.3.5; KHR_materials_iridescence, "Implementation Notes"]
vec3 gltf_dielectric_fresnel(IN(BsdfParams) m, float cos_h) {
    vec3 f0 = gltf_dielectric_f0(m);
    vec3 f = fresnel_schlick(f0, vec3(m.specular), cos_h);
    return m.iridescence > 0.0f ? mix(f, gltf_film(m, f0, cos_h), m.iridescence) : f;
}

vec3 gltf_metal_fresnel(IN(BsdfParams) m, float cos_h) {
    vec3 f = fresnel_schlick(m.base_color, vec3(1.0f), cos_h);
    return m.iridescence > 0.0f ? mix(f, gltf_film(m, m.base_color, cos_h), m.iridescence) : f;
}

// Both are linear in f0 and f90, so the usual material needs the mix of those and one weight.
vec3 gltf_reflectance(IN(BsdfParams) m, float cos_h) {
    if (m.iridescence > 0.0f) {
        return mix(gltf_dielectric_fresnel(m, cos_h), gltf_metal_fresnel(m, cos_h), m.metallic);
    }
    vec3 f0 = mix(gltf_dielectric_f0(m), m.base_color, m.metallic);
    vec3 f90 = vec3(mix(m.specular, 1.0f, m.metallic));
    return fresnel_schlick(f0, f90, cos_h);
}

// The cosine on the outside for a cosine on wo's side; 0 past the critical angle.
float gltf_outside_cosine(IN(BsdfParams) m, float cos_h, float eta) {
    return eta < 1.0f && m.thin == 0u ? fresnel_g(cos_h, eta) / eta : cos_h;
}

// Schlick's term is taken at the angle on the outside, wherever wo is, which makes it equal for
// both ways of the light. A cosine of 0 reflects everything, as does the critical angle inside.
// [Schlick 1994, section 3, with the larger of the two angles]
GltfFresnel gltf_interface_fresnel(IN(BsdfParams) m, float cos_outside, bool inside) {
    GltfFresnel f;
    if (inside && cos_outside <= 0.0f) {
        f.reflected = vec3(1.0f);
        f.transmitted = vec3(0.0f);
        return f;
    }
    f.reflected = gltf_reflectance(m, cos_outside);
    float share = gltf_transmissive_share(m);
    f.transmitted = vec3(0.0f);
    if (share > 0.0f) {
        float kept = 1.0f - max_component(gltf_dielectric_fresnel(m, cos_outside));
        f.transmitted = m.base_color * (share * max(kept, 0.0f));
    }
    return f;
}

// With which probability a sampled microfacet reflects.
float gltf_reflection_probability(IN(GltfFresnel) f) {
    float r = max_component(f.reflected);
    float t = max_component(f.transmitted);
    return t > 0.0f ? r / (r + t) : 1.0f;
}

// o.z > 0 (mirrored if the view is from below); i.z of either sign. eta as seen from o's side.
// [KHR_materials_transmission, "Implementation Notes"; KHR_materials_volume, "Refraction"]
BsdfValue gltf_interface_eval(IN(BsdfParams) m, vec3 o, vec3 i, float eta) {
    bool transmits = i.z < 0.0f;
    GgxLobe lobe;
    float cos_outside;
    if (transmits && m.thin == 0u) {
        lobe = ggx_refraction(o, i, m.alpha_x, m.alpha_y, eta);
        cos_outside = eta < 1.0f ? lobe.cos_t : lobe.cos_h;
    } else {
        lobe = ggx_reflection(o, transmits ? mirrored_z(i) : i, m.alpha_x, m.alpha_y);
        cos_outside = gltf_outside_cosine(m, lobe.cos_h, eta);
    }
    GltfFresnel f = gltf_interface_fresnel(m, cos_outside, eta < 1.0f);
    float p = gltf_reflection_probability(f);
    BsdfValue v;
    v.f_cos = (transmits ? f.transmitted : f.reflected) * lobe.f_cos;
    v.pdf = (transmits ? 1.0f - p : p) * lobe.pdf;
    return v;
}

// A direction by the interface, or zero where the microfacet sends the light to the wrong side.
vec3 gltf_interface_sample(IN(BsdfParams) m, vec3 o, float eta, float u_lobe, vec2 u) {
    vec3 wm = ggx_sample_vndf(o, m.alpha_x, m.alpha_y, u);
    vec3 i = reflect(-o, wm);
    if (gltf_transmissive_share(m) <= 0.0f) {
        return i.z > 0.0f ? i : vec3(0.0f);
    }
    float cos_h = dot(o, wm);
    float cos_outside = gltf_outside_cosine(m, cos_h, eta);
    GltfFresnel f = gltf_interface_fresnel(m, cos_outside, eta < 1.0f);
    if (u_lobe < gltf_reflection_probability(f)) {
        return i.z > 0.0f ? i : vec3(0.0f);
    }
    if (m.thin != 0u) {
        return i.z > 0.0f ? mirrored_z(i) : vec3(0.0f);
    }
    i = refracted(o, wm, eta, fresnel_g(cos_h, eta));
    return i.z < 0.0f ? i : vec3(0.0f);
}

#endif
