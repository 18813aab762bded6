// Disney's BSDF of 2015: the principled BRDF with glass and thin sheets.
//
//   mix(mix(dielectric, glass, spec_trans), metal, metallic) + clearcoat
//
// All of these share one GGX lobe; `thin` is a sheet that light leaves where it enters, with
// diffuse transmission, and with `flatness` towards subsurface scattering. Ours: the lobe's masking
// is height-correlated; the sheet's mirror-like part counts both faces; scattering below the
// surface of solid bodies (scatter distance) is left to media.
#ifndef GP_SHADING_BSDF_DISNEY_BSDF_GLSL
#define GP_SHADING_BSDF_DISNEY_BSDF_GLSL
#include "shading/bsdf/disney.glsl"
#include "shading/bsdf/ggx_lobe.glsl"
#include "shading/bsdf/thin_dielectric.glsl"

// The parameters that both versions have lie in the same slots: disney_roughness(m) and the like
// serve here too.

// A direction pair looked at from above, and how the interface looks from wo's side.
struct DisneySides {
    vec3 o;
    vec3 i;
    bool transmits;
    bool inside;  // wo in the solid body: everything opaque is black from there
    float eta;
};

DisneySides disney_sides(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    bool flip = wo.z < 0.0f;
    DisneySides s;
    s.o = flip ? mirrored_z(wo) : wo;
    s.i = flip ? mirrored_z(wi) : wi;
    s.transmits = s.i.z < 0.0f;
    s.inside = flip && m.thin == 0u;
    s.eta = relative_ior(m.ior, s.inside ? -1.0f : 1.0f);
    return s;
}

// Of the surface that is not metal: what a face reflects, for the sheet both.
float disney_glass_fresnel(IN(BsdfParams) m, float cos_h, float eta) {
    return m.thin != 0u ? thin_reflectance(cos_h, eta) : fresnel_dielectric(cos_h, eta);
}

// The lobe's reflectance. [Burley 2015, "Extending the Disney BRDF to a BSDF with Integrated
// Subsurface Scattering", section 4]
vec3 disney_reflectance(IN(BsdfParams) m, float cos_h, float eta, bool inside) {
    float f = disney_glass_fresnel(m, cos_h, eta);
    float share = (1.0f - m.metallic) * (inside ? disney_bsdf_spec_trans(m) : 1.0f);
    vec3 tint = mix(vec3(1.0f), disney_tint(m.base_color), disney_specular_tint(m));
    // Tints what reflects head-on, as in the version of 2012: at grazing angles all is white.
    vec3 dielectric = f * mix(tint, vec3(1.0f), schlick_weight(cos_h));
    vec3 metal = fresnel_schlick(m.base_color, vec3(1.0f), cos_h);
    return share * min(dielectric, vec3(1.0f)) + (inside ? 0.0f : m.metallic) * metal;
}

// What goes through glass; the square root, as light crosses two of a solid body's surfaces.
// [Burley 2015, section 4.3]
vec3 disney_transmittance(IN(BsdfParams) m, float one_minus_f) {
    float share = (1.0f - m.metallic) * disney_bsdf_spec_trans(m) * one_minus_f;
    return share * (m.thin != 0u ? m.base_color : sqrt(m.base_color));
}

// The width of what a sheet lets through, by its index. [Burley 2015, section 4.4]
float disney_thin_scale(float ior) {
    return clamp(0.65f * ior - 0.35f, 0.0f, 1.0f);
}

DisneyWidths disney_thin_widths(IN(BsdfParams) m) {
    return disney_widths(disney_roughness(m) * sqrt(disney_thin_scale(m.ior)),
                         disney_anisotropic(m));
}

// Without colour: Lambert darkened at grazing angles, and light sent back where it came from.
// [Burley 2015, equation 4 and its refactored diffuse model]
float disney_refactored_diffuse(DisneyAngles a, float roughness) {
    float fl = schlick_weight(a.i);
    float fv = schlick_weight(a.o);
    float rr = 2.0f * roughness * a.h * a.h;
    float lambert = (1.0f - 0.5f * fl) * (1.0f - 0.5f * fv);
    return INV_PI * (lambert + rr * (fl + fv + fl * fv * (rr - 1.0f)));
}

// The share of diffuse light, without colour: 0 inside of a body, and none left by glass and metal.
float disney_diffuse_weight(IN(BsdfParams) m, bool inside) {
    return inside ? 0.0f : (1.0f - m.metallic) * (1.0f - disney_bsdf_spec_trans(m));
}

float disney_through_share(IN(BsdfParams) m) {
    return m.thin != 0u ? 0.5f * disney_bsdf_diff_trans(m) : 0.0f;
}

// Diffuse light and sheen on wo's side of the surface.
vec3 disney_diffuse_value(IN(BsdfParams) m, DisneyAngles a) {
    float roughness = disney_roughness(m);
    float diffuse = disney_refactored_diffuse(a, roughness);
    if (m.thin != 0u) {
        diffuse = mix(diffuse, disney_subsurface_lobe(a, roughness), disney_bsdf_flatness(m));
    }
    return (1.0f - disney_through_share(m)) * diffuse * m.base_color
         + schlick_weight(a.h) * disney_sheen_color(m);
}

// How probable: clearcoat, diffuse light, and the rest for the lobe.
struct DisneyBsdfShares {
    float coat;
    float diffuse;
    float uniform_part;  // of the diffuse light
};

DisneyBsdfShares disney_bsdf_shares(IN(BsdfParams) m, float cos_o, bool inside, float eta) {
    float weight = schlick_weight(cos_o);
    vec3 base = m.base_color + 0.2f * disney_sheen_color(m);
    float diffuse = disney_diffuse_weight(m, inside) * max_component(base);
    float f = disney_glass_fresnel(m, cos_o, eta);
    float glossy = max_component(disney_reflectance(m, cos_o, eta, inside))
                 + max_component(disney_transmittance(m, 1.0f - f));
    float coat = inside ? 0.0f : 0.25f * disney_clearcoat(m) * mix(0.04f, 1.0f, weight);
    float inv_sum = 1.0f / (diffuse + coat + max(glossy, DISNEY_LEAST_SPECULAR));
    DisneyBsdfShares s;
    s.coat = coat * inv_sum;
    s.diffuse = diffuse * inv_sum;
    s.uniform_part = m.thin != 0u ? 0.5f * disney_bsdf_flatness(m) : 0.0f;
    return s;
}

// The lobe's chance to reflect rather than to go through, at a microfacet (a sheet: at the normal,
// since its two lobes differ in width).
float disney_reflect_chance(IN(BsdfParams) m, float cos_h, float eta, bool inside) {
    float r = max_component(disney_reflectance(m, cos_h, eta, inside));
    float t = max_component(disney_transmittance(m,
                                                 1.0f - disney_glass_fresnel(m, cos_h, eta)));
    bool glass = (1.0f - m.metallic) * disney_bsdf_spec_trans(m) > 0.0f;
    // Near the critical angle 1 - F is rounded to 0 before the light that goes through is.
    return glass ? clamp(r / max(r + t, 1.0e-20f), 0.05f, 0.999f) : 1.0f;
}

float disney_diffuse_pdf(IN(DisneyBsdfShares) s, vec3 w) {
    return mix(cosine_hemisphere_pdf(w), uniform_hemisphere_pdf(w), s.uniform_part);
}

// Both directions on one side.
BsdfValue disney_bsdf_reflection(IN(BsdfParams) m, IN(DisneySides) d) {
    DisneyBsdfShares s = disney_bsdf_shares(m, d.o.z, d.inside, d.eta);
    DisneyWidths w = disney_widths(disney_roughness(m), disney_anisotropic(m));
    GgxLobe lobe = ggx_reflection(d.o, d.i, w.x, w.y);
    float chance = disney_reflect_chance(m, m.thin != 0u ? d.o.z : lobe.cos_h, d.eta, d.inside);
    BsdfValue v;
    v.f_cos = disney_reflectance(m, lobe.cos_h, d.eta, d.inside) * lobe.f_cos;
    v.pdf = (1.0f - s.coat - s.diffuse) * chance * lobe.pdf;
    if (d.inside) {
        return v;
    }
    DisneyAngles a;
    a.o = d.o.z;
    a.i = d.i.z;
    a.h = lobe.cos_h;
    vec3 wm = normalize(d.o + d.i);
    float coat_d = gtr_d(wm, disney_coat_alpha(m), 1.0f);
    vec3 diffuse = disney_diffuse_weight(m, false) * disney_diffuse_value(m, a);
    v.f_cos += (diffuse + vec3(disney_coat(m, d.o, d.i, coat_d, a.h))) * d.i.z;
    v.pdf += s.coat * coat_d * wm.z / (4.0f * a.h)
           + s.diffuse * (1.0f - disney_through_share(m)) * disney_diffuse_pdf(s, d.i);
    return v;
}

BsdfValue disney_bsdf_transmission(IN(BsdfParams) m, IN(DisneySides) d) {
    DisneyBsdfShares s = disney_bsdf_shares(m, d.o.z, d.inside, d.eta);
    float glossy = 1.0f - s.coat - s.diffuse;
    BsdfValue v = bsdf_no_value();
    if (m.thin == 0u) {
        DisneyWidths w = disney_widths(disney_roughness(m), disney_anisotropic(m));
        GgxLobe lobe = ggx_refraction(d.o, d.i, w.x, w.y, d.eta);
        if (lobe.pdf <= 0.0f) {
            return v;
        }
        float t = fresnel_transmittance(lobe.cos_h, lobe.cos_t, d.eta);
        v.f_cos = disney_transmittance(m, t) * lobe.f_cos;
        v.pdf = glossy * (1.0f - disney_reflect_chance(m, lobe.cos_h, d.eta, d.inside)) * lobe.pdf;
        return v;
    }
    vec3 i = mirrored_z(d.i);
    DisneyWidths w = disney_thin_widths(m);
    GgxLobe lobe = ggx_reflection(d.o, i, w.x, w.y);
    float f = disney_glass_fresnel(m, lobe.cos_h, d.eta);
    float through = disney_through_share(m);
    v.f_cos = disney_transmittance(m, 1.0f - f) * lobe.f_cos
            + disney_diffuse_weight(m, false) * through * INV_PI * i.z * m.base_color;
    v.pdf = glossy * (1.0f - disney_reflect_chance(m, d.o.z, d.eta, d.inside)) * lobe.pdf
          + s.diffuse * through * disney_diffuse_pdf(s, i);
    return v;
}

BsdfValue disney_bsdf_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z == 0.0f || wi.z == 0.0f) {
        return bsdf_no_value();
    }
    DisneySides d = disney_sides(m, wo, wi);
    BsdfValue v = d.transmits ? disney_bsdf_transmission(m, d) : disney_bsdf_reflection(m, d);
    // Where no sample goes there is only what rounding has left.
    if (v.pdf <= 0.0f) {
        return bsdf_no_value();
    }
    return v;
}

// A direction of the lobe, o above; the zero vector where it ends on the wrong side.
vec3 disney_bsdf_sample_lobe(IN(BsdfParams) m, IN(DisneySides) d, float u_side, vec2 u) {
    DisneyWidths w = disney_widths(disney_roughness(m), disney_anisotropic(m));
    bool thin = m.thin != 0u;
    if (thin && u_side >= disney_reflect_chance(m, d.o.z, d.eta, d.inside)) {
        DisneyWidths t = disney_thin_widths(m);
        vec3 i = reflect(-d.o, ggx_sample_vndf(d.o, t.x, t.y, u));
        return i.z > 0.0f ? mirrored_z(i) : vec3(0.0f);
    }
    vec3 wm = ggx_sample_vndf(d.o, w.x, w.y, u);
    float cos_h = dot(d.o, wm);
    if (thin || u_side < disney_reflect_chance(m, cos_h, d.eta, d.inside)) {
        vec3 i = reflect(-d.o, wm);
        return i.z > 0.0f ? i : vec3(0.0f);
    }
    float g = fresnel_g(cos_h, d.eta);
    vec3 i = refracted(d.o, wm, d.eta, g);
    return g > 0.0f && i.z < 0.0f ? i : vec3(0.0f);
}

BsdfSample disney_bsdf_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z == 0.0f) {
        return bsdf_no_sample();
    }
    DisneySides d = disney_sides(m, wo, wo);
    DisneyBsdfShares s = disney_bsdf_shares(m, d.o.z, d.inside, d.eta);
    vec3 i;
    uint lobe = LOBE_GLOSSY;
    if (u_lobe < s.coat) {
        i = reflect(-d.o, gtr_sample(disney_coat_alpha(m), 1.0f, u));
        i = i.z > 0.0f ? i : vec3(0.0f);
    } else if (u_lobe < s.coat + s.diffuse) {
        float rest = clamp((u_lobe - s.coat) / s.diffuse, 0.0f, ONE_MINUS_EPSILON);
        float through = disney_through_share(m);
        bool below = rest < through;
        float inner = below ? rest / through : (rest - through) / (1.0f - through);
        i = inner < s.uniform_part ? square_to_uniform_hemisphere(u)
                                   : square_to_cosine_hemisphere(u);
        i = below ? mirrored_z(i) : i;
        lobe = LOBE_DIFFUSE;
    } else {
        float glossy = s.coat + s.diffuse;
        i = disney_bsdf_sample_lobe(m, d, (u_lobe - glossy) / (1.0f - glossy), u);
    }
    if (i.z == 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wi = wo.z < 0.0f ? mirrored_z(i) : i;
    uint side = i.z < 0.0f ? LOBE_TRANSMISSION : 0u;
    return bsdf_sample_of(wi, disney_bsdf_eval(m, wo, wi), lobe | side);
}

vec3 disney_bsdf_albedo(IN(BsdfParams) m, float cos_o) {
    bool inside = cos_o < 0.0f && m.thin == 0u;
    float c = abs(cos_o);
    float eta = relative_ior(m.ior, inside ? -1.0f : 1.0f);
    vec3 glossy = disney_reflectance(m, c, eta, inside)
                + disney_transmittance(m, 1.0f - disney_glass_fresnel(m, c, eta));
    return min(glossy + disney_diffuse_weight(m, inside) * m.base_color, vec3(1.0f));
}

bool disney_bsdf_is_specular(IN(BsdfParams) m) {
    DisneyWidths w = disney_widths(disney_roughness(m), disney_anisotropic(m));
    return disney_diffuse_weight(m, false) <= 0.0f && disney_clearcoat(m) <= 0.0f
        && w.x <= DISNEY_MIN_ALPHA;
}

#endif
