// Disney's principled BRDF: one colour and ten scalars, all of them from 0 to 1. Where the course
// notes are silent, the shader that came with them (disney.brdf of Disney's BRDF Explorer) decides.
// `version` is the specular masking: 2014 by the widths of the lobe (the notes' addendum), 2012
// from a remapped roughness. The colour is linear; the Explorer's shader raises it to 2.2 first.
//
// By design it may return more light than it gets: the diffuse part is not darkened by what the
// specular part reflects, and sheen and clearcoat come on top.
#ifndef GP_SHADING_BSDF_DISNEY_GLSL
#define GP_SHADING_BSDF_DISNEY_GLSL
#include "shading/fresnel.glsl"
#include "shading/microfacet/ggx.glsl"
#include "shading/microfacet/gtr.glsl"
#include "shading/microfacet/masking.glsl"
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

#define DISNEY_2014 0u
#define DISNEY_2012 1u

// The narrowest lobe. [Burley 2012, disney.brdf]
#define DISNEY_MIN_ALPHA 1.0e-3f
// Masking of the clearcoat. [Burley 2012, section 5.4: GGX of roughness 1/4]
#define DISNEY_COAT_MASKING_ALPHA 0.25f
// Of the specular lobe's share in sampling: its tail must be met even where Fresnel's term is 0.
#define DISNEY_LEAST_SPECULAR 0.05f

// The cosines of a pair of directions: o and i with the normal, h between one and the half vector.
struct DisneyAngles {
    float o;
    float i;
    float h;
};

struct DisneyWidths {
    float x;
    float y;
};

// [Burley 2012, section 5.4]
DisneyWidths disney_widths(float roughness, float anisotropic) {
    float aspect = sqrt(1.0f - 0.9f * anisotropic);
    float alpha = roughness * roughness;
    DisneyWidths w;
    w.x = max(alpha / aspect, DISNEY_MIN_ALPHA);
    w.y = max(alpha * aspect, DISNEY_MIN_ALPHA);
    return w;
}

// The colour at luminance 1, approximately; white for black. [Burley 2012, disney.brdf]
vec3 disney_tint(vec3 color) {
    float luminance = 0.3f * color.x + 0.6f * color.y + 0.1f * color.z;
    return luminance > 0.0f ? color / luminance : vec3(1.0f);
}

// [Burley 2012, section 5.3: cos_d is that of the difference angle]
float disney_diffuse_fresnel(DisneyAngles a, float f90) {
    float at_i = fresnel_schlick(1.0f, f90, a.i);
    float at_o = fresnel_schlick(1.0f, f90, a.o);
    return at_i * at_o;
}

// Retro-reflecting at grazing angles if rough, darker there if smooth.
float disney_diffuse_lobe(DisneyAngles a, float roughness) {
    return INV_PI * disney_diffuse_fresnel(a, 0.5f + 2.0f * roughness * a.h * a.h);
}

// After the Hanrahan-Krueger model of thin layers; 1.25 keeps the albedo.
// [Burley 2012, section 5.3]
float disney_subsurface_lobe(DisneyAngles a, float roughness) {
    float f = disney_diffuse_fresnel(a, roughness * a.h * a.h);
    return INV_PI * 1.25f * (f * (1.0f / (a.o + a.i) - 0.5f) + 0.5f);
}

vec3 disney_sheen_color(IN(BsdfParams) m) {
    return disney_sheen(m) * mix(vec3(1.0f), disney_tint(m.base_color), disney_sheen_tint(m));
}

// At normal incidence; only the dielectric part is tinted.
vec3 disney_specular_f0(IN(BsdfParams) m) {
    vec3 tint = mix(vec3(1.0f), disney_tint(m.base_color), disney_specular_tint(m));
    return mix(0.08f * disney_specular(m) * tint, m.base_color, m.metallic);
}

// Masking over 4 cos_o cos_i, which stays finite at the horizon.
// [Burley 2012, section 5.6; 2014: addendum "Specular G revisited"]
float disney_visibility(IN(BsdfParams) m, DisneyWidths w, vec3 wo, vec3 wi) {
    if (disney_version(m) == DISNEY_2012) {
        w.x = masking_disney_alpha(disney_roughness(m));
        w.y = w.x;
    }
    return 1.0f / ((wo.z + ggx_stretched(wo, w.x, w.y)) * (wi.z + ggx_stretched(wi, w.x, w.y)));
}

// [Burley 2012, section 5.4]
float disney_coat_alpha(IN(BsdfParams) m) {
    return mix(0.1f, 0.001f, disney_clearcoat_gloss(m));
}

// A quarter of a lobe of index 1.5, over everything. [Burley 2012, section 5.4]
float disney_coat(IN(BsdfParams) m, vec3 wo, vec3 wi, float coat_d, float cos_h) {
    float a = DISNEY_COAT_MASKING_ALPHA;
    float g = 1.0f / ((wo.z + ggx_stretched(wo, a, a)) * (wi.z + ggx_stretched(wi, a, a)));
    return 0.25f * disney_clearcoat(m) * g * fresnel_schlick(0.04f, 1.0f, cos_h) * coat_d;
}

// How probable each lobe is, by what it reflects roughly; the diffuse one has the rest.
struct DisneyShares {
    float specular;
    float coat;
    float uniform_part;  // of the diffuse lobe
};

DisneyShares disney_shares(IN(BsdfParams) m, float cos_o) {
    float weight = schlick_weight(cos_o);
    vec3 base = m.base_color + 0.2f * disney_sheen_color(m);
    float diffuse = (1.0f - m.metallic) * max_component(base);
    float specular = max(max_component(disney_specular_f0(m)) * (1.0f - weight) + weight,
                         DISNEY_LEAST_SPECULAR);
    float coat = 0.25f * disney_clearcoat(m) * mix(0.04f, 1.0f, weight);
    float inv_sum = 1.0f / (diffuse + specular + coat);
    DisneyShares s;
    s.specular = specular * inv_sum;
    s.coat = coat * inv_sum;
    // Subsurface light grows where both cosines vanish, faster than cosine sampling goes there.
    s.uniform_part = 0.5f * disney_subsurface(m);
    return s;
}

// [Burley 2012, "Physically Based Shading at Disney"]
BsdfValue disney_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    vec3 h = wo + wi;
    float h_length = length(h);
    vec3 wm = h / h_length;
    DisneyAngles a;
    a.o = wo.z;
    a.i = wi.z;
    a.h = 0.5f * h_length;
    float roughness = disney_roughness(m);
    DisneyWidths w = disney_widths(roughness, disney_anisotropic(m));
    float d = ggx_d(wm, w.x, w.y);
    // What is off costs nothing.
    float coat_d = disney_clearcoat(m) > 0.0f ? gtr_d(wm, disney_coat_alpha(m), 1.0f) : 0.0f;
    float weight = schlick_weight(a.h);
    vec3 f0 = disney_specular_f0(m);

    float base = disney_diffuse_lobe(a, roughness);
    if (disney_subsurface(m) > 0.0f) {
        base = mix(base, disney_subsurface_lobe(a, roughness), disney_subsurface(m));
    }
    vec3 f = (1.0f - m.metallic) * (base * m.base_color + weight * disney_sheen_color(m));
    f += (f0 + (vec3(1.0f) - f0) * weight) * (d * disney_visibility(m, w, wo, wi));
    if (coat_d > 0.0f) {
        f += vec3(disney_coat(m, wo, wi, coat_d, a.h));
    }

    DisneyShares s = disney_shares(m, wo.z);
    float diffuse_pdf = mix(cosine_hemisphere_pdf(wi), uniform_hemisphere_pdf(wi), s.uniform_part);
    BsdfValue v;
    v.f_cos = f * wi.z;
    v.pdf = (1.0f - s.specular - s.coat) * diffuse_pdf
          + s.specular * 0.5f * d / (wo.z + ggx_stretched(wo, w.x, w.y))
          + s.coat * coat_d * wm.z / (4.0f * a.h);
    return v;
}

BsdfSample disney_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    DisneyShares s = disney_shares(m, wo.z);
    float glossy = s.specular + s.coat;
    vec3 wi;
    uint lobe = LOBE_GLOSSY;
    if (u_lobe < s.specular) {
        DisneyWidths w = disney_widths(disney_roughness(m), disney_anisotropic(m));
        wi = reflect(-wo, ggx_sample_vndf(wo, w.x, w.y, u));
    } else if (u_lobe < glossy) {
        wi = reflect(-wo, gtr_sample(disney_coat_alpha(m), 1.0f, u));
    } else {
        bool flat_part = u_lobe - glossy < s.uniform_part * (1.0f - glossy);
        wi = flat_part ? square_to_uniform_hemisphere(u) : square_to_cosine_hemisphere(u);
        lobe = LOBE_DIFFUSE;
    }
    return bsdf_sample_of(wi, disney_eval(m, wo, wi), lobe);
}

vec3 disney_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    vec3 specular = fresnel_schlick(disney_specular_f0(m), vec3(1.0f), cos_o);
    float coat = 0.25f * disney_clearcoat(m) * fresnel_schlick(0.04f, 1.0f, cos_o);
    // What grazing angles lose to masking and gain by retro-reflection is left out.
    return min((1.0f - m.metallic) * m.base_color + specular + vec3(coat), vec3(1.0f));
}

bool disney_is_specular(IN(BsdfParams) m) {
    DisneyWidths w = disney_widths(disney_roughness(m), disney_anisotropic(m));
    return m.metallic >= 1.0f && disney_clearcoat(m) <= 0.0f && w.x <= DISNEY_MIN_ALPHA;
}

#endif
