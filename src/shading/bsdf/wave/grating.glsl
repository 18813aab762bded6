// A metal with grooves, like an optical disc or engraved steel: a mirror image (order 0) and,
// beside it, every other order as a fan of wavelengths. All of them are blurred by `spread`, the
// standard deviation of wo + wi along the surface, which irregularities of the grooves cause.
//
// f cos_i is a density over (u, v) = (wo + wi).xy, for which du dv = cos_i dwi. Along u an order is
// the spectrum itself, wavelength = u period / m; its own width is far larger than the blur, which
// it therefore gets along v only.
#ifndef GP_SHADING_BSDF_WAVE_GRATING_GLSL
#define GP_SHADING_BSDF_WAVE_GRATING_GLSL
#include "shading/fresnel.glsl"
#include "shading/grating.glsl"
#include "shading/spectrum.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/bsdf/params.glsl"

// The mean wavelength of each channel of rgb_of_wavelength, for what has no colour of its own.
#define GRATING_RED_NM 601.2f
#define GRATING_GREEN_NM 540.7f
#define GRATING_BLUE_NM 451.8f

Grating grating_of(IN(BsdfParams) m) {
    Grating g;
    g.profile = grating_profile(m);
    g.period_nm = grating_period_nm(m);
    g.depth_nm = grating_depth_nm(m);
    g.duty = grating_duty(m);
    return g;
}

// A normal distribution with the standard deviation `spread`: its density, and a value.
float grating_blur(float x, float spread) {
    float t = x / spread;
    return 0.5f * SQRT_TWO * INV_SQRT_PI / spread * exp(-0.5f * t * t);
}

float grating_blur_sample(float spread, float u) {
    return spread * SQRT_TWO * erf_inverse(clamp(2.0f * u - 1.0f, -0.9999999f, 0.9999999f));
}

// The mirror image: what of each channel goes there, and how often a sample does. The latter is the
// mean of the channels, but never almost always or never, and of the view alone.
struct GratingMirror {
    vec3 share;
    float probability;
};

GratingMirror grating_mirror(IN(Grating) g, vec3 wo, vec3 wi) {
    vec3 share = vec3(0.0f);
    float sum = 0.0f;
    for (int i = 0; i < 3; ++i) {
        float nm = i == 0 ? GRATING_RED_NM : i == 1 ? GRATING_GREEN_NM : GRATING_BLUE_NM;
        float total = grating_total(g, wo, nm);
        share[i] = grating_order_share(g, wo, wi, 0, nm, total, grating_total(g, wi, nm));
        sum += grating_order_efficiency(g, wo, 0, nm) / max(total, 1.0e-6f);
    }
    GratingMirror r;
    r.share = share;
    r.probability = clamp(sum / 3.0f, 0.1f, 0.9f);
    return r;
}

bool grating_order_leaves(IN(Grating) g, vec3 w, int order, float nm) {
    return order <= grating_highest_order(g, w, nm) && order >= grating_lowest_order(g, w, nm);
}

// The orders but 0, without Fresnel's term and cos_i; the density lacks these and the choice
// between them and the mirror image.
BsdfValue grating_side_orders(IN(Grating) g, vec3 wo, vec3 wi, float spread) {
    BsdfValue v = bsdf_no_value();
    float u = wo.x + wi.x;
    float path = abs(u) * g.period_nm;
    float blur = grating_blur(wo.y + wi.y, spread);
    int last = int(floor(path / SPECTRUM_FIRST_NM));
    for (int n = max(int(ceil(path / SPECTRUM_LAST_NM)), 1); n <= last; ++n) {
        float nm = path / float(n);
        int order = u < 0.0f ? -n : n;
        if (!grating_order_leaves(g, wo, order, nm)) {
            continue;
        }
        // Nanometres per unit of u, times the blur.
        float density = g.period_nm / float(n) * blur;
        float side = grating_side_total(g, wo, nm);
        v.pdf += grating_order_efficiency(g, wo, order, nm) / max(side, 1.0e-20f)
               * density / (SPECTRUM_LAST_NM - SPECTRUM_FIRST_NM);
        // The blur may carry light to where the order itself does not come from: cut, as the light
        // of the opposite way is.
        if (grating_order_leaves(g, wi, order, nm)) {
            float total = side + grating_order_efficiency(g, wo, 0, nm);
            float share = grating_order_share(g, wo, wi, order, nm, total,
                                              grating_total(g, wi, nm));
            v.f_cos += rgb_of_wavelength(nm) * (share * density);
        }
    }
    return v;
}

// [Magnusson and Gaylord 1978, Goodman 2005 for the orders; Fresnel as for a microfacet]
BsdfValue grating_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    Grating g = grating_of(m);
    float spread = grating_spread(m);
    BsdfValue v = grating_side_orders(g, wo, wi, spread);
    float mirror = grating_blur(wo.x + wi.x, spread) * grating_blur(wo.y + wi.y, spread);
    GratingMirror r = grating_mirror(g, wo, wi);
    float cos_h = sqrt(clamp(0.5f + 0.5f * dot(wo, wi), 0.0f, 1.0f));
    vec3 f = fresnel_schlick(m.base_color, vec3(1.0f), cos_h);
    v.f_cos = f * (v.f_cos + r.share * mirror) * wi.z;
    v.pdf = mix(v.pdf, mirror, r.probability) * wi.z;
    // Far out in the blur the density ends a little earlier than the value.
    if (v.pdf <= 0.0f) {
        return bsdf_no_value();
    }
    return v;
}

// An order but 0, in proportion to the efficiencies; 0 if there is none.
int grating_choose_order(IN(Grating) g, vec3 wo, float nm, float u) {
    float rest = u * grating_side_total(g, wo, nm);
    int last = grating_highest_order(g, wo, nm);
    int chosen = 0;
    for (int order = grating_lowest_order(g, wo, nm); order <= last; ++order) {
        float share = order == 0 ? 0.0f : grating_order_efficiency(g, wo, order, nm);
        if (share > 0.0f) {
            chosen = order;
            rest -= share;
            if (rest < 0.0f) {
                break;
            }
        }
    }
    return chosen;
}

BsdfSample grating_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    Grating g = grating_of(m);
    float spread = grating_spread(m);
    float mirror = grating_mirror(g, wo, wo).probability;
    float x = -wo.x;
    if (u_lobe < mirror) {
        x += grating_blur_sample(spread, u.x);
    } else {
        float nm = mix(SPECTRUM_FIRST_NM, SPECTRUM_LAST_NM, u.x);
        int order = grating_choose_order(g, wo, nm, (u_lobe - mirror) / (1.0f - mirror));
        if (order == 0) {
            return bsdf_no_sample();
        }
        x += float(order) * nm / g.period_nm;
    }
    float y = grating_blur_sample(spread, u.y) - wo.y;
    float z2 = 1.0f - x * x - y * y;
    if (z2 <= 0.0f) {
        return bsdf_no_sample();
    }
    vec3 wi = vec3(x, y, sqrt(z2));
    return bsdf_sample_of(wi, grating_eval(m, wo, wi), LOBE_GLOSSY);
}

vec3 grating_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    // Half way between along and across the grooves.
    float side = sqrt(0.5f * max(1.0f - cos_o * cos_o, 0.0f));
    float total = grating_total(grating_of(m), vec3(side, side, cos_o), GRATING_GREEN_NM);
    return fresnel_schlick(m.base_color, vec3(1.0f), cos_o) * min(total, 1.0f);
}

bool grating_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
