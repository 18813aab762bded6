// A metal with roughness of two sizes: facets far larger than the wavelength reflect light like
// mirrors, roughness of about the wavelength on top of them diffracts some of it far to the side.
//
// Based on: Holzschuch and Pacanowski 2017, ACM TOG 36(4). f = A D G F / (4 cos cos) + what is
// diffracted. Different here, so that no angle returns more than it gets and both ways are alike:
// - The mirrors' A has the largest of the cosines of wo, of wi and of the angle between wo and the
//   half vector; the diffraction's 1 - A has the smaller cosine of wo and wi, and is divided by the
//   larger visible share. With the published cos_o + cos_i a grazing view would be diffracted to
//   the normal by more than the mirror lost.
// - The polarisation factor is Fresnel's F at the half vector, as the paper has it where it
//   convolves with D; nano_polarisation has no bound for metals.
// - The convolution is nano_blurred_length, with the blur that facets have at normal incidence.
#ifndef GP_SHADING_BSDF_WAVE_TWO_SCALE_GLSL
#define GP_SHADING_BSDF_WAVE_TWO_SCALE_GLSL
#include "shading/fresnel.glsl"
#include "shading/sampling/warps.glsl"
#include "shading/microfacet/distribution.glsl"
#include "shading/microfacet/nano_roughness.glsl"
#include "shading/bsdf/params.glsl"

// The wavelengths of the channels in micrometres. [Holzschuch and Pacanowski 2017]
#define TWO_SCALE_RED_UM 0.645f
#define TWO_SCALE_GREEN_UM 0.526f
#define TWO_SCALE_BLUE_UM 0.444f

Distribution two_scale_facets(IN(BsdfParams) m) {
    Distribution d;
    d.kind = DISTRIBUTION_EXPONENTIAL_POWER;
    d.alpha_x = two_scale_beta(m);
    d.alpha_y = d.alpha_x;
    d.shape = two_scale_power(m);
    d.fit = smith_fit_none();  // this distribution has its Lambda in closed terms
    return d;
}

// The diffraction at one wavelength and one pair of directions, without F and G.
struct TwoScaleChannel {
    float mirror;     // A of the facets' reflection
    float diffracted; // (1 - A) times the lobe
    float density;    // of samples of the lobe, per (wo + wi).xy
};

// The share of the lobe's samples that is taken from it, the others from the cosine: most samples
// of a wide lobe would fall below the horizon. At normal incidence this is the visible share.
float two_scale_lobe_probability(float blurred, float c) {
    return 1.0f - nano_spectrum_beyond(1.0f, blurred, c);
}

// The visible share falls with the angle, so that the largest of several is that of the largest
// cosine.
TwoScaleChannel two_scale_channel(IN(BsdfParams) m, vec3 wo, vec3 wi, float cos_h, float um) {
    float sigma = two_scale_sigma_um(m) / um;
    float b = two_scale_b_um(m) / um;
    TwoScaleChannel s;
    s.mirror = 1.0f;
    s.diffracted = 0.0f;
    s.density = 0.0f;
    if (sigma <= 0.0f) {
        return s;
    }
    float c = two_scale_c(m);
    float low = min(wo.z, wi.z);
    float either = max(wo.z, wi.z);
    float high = max(cos_h, either);
    float blurred = nano_blurred_length(b, c, two_scale_beta(m), two_scale_power(m));
    float x = wo.x + wi.x;
    float y = wo.y + wi.y;
    float lobe = nano_spectrum(x * x + y * y, blurred, c);
    float sigma_high = sigma * sqrt(nano_visible_share(high, b, c));
    float sigma_low = sigma * sqrt(nano_visible_share(low, b, c));
    s.mirror = nano_specular_share(sigma_high, high, high);
    s.diffracted = (1.0f - nano_specular_share(sigma_low, low, low))
                 * lobe / nano_visible_share(either, blurred, c);
    s.density = mix(INV_PI, lobe, two_scale_lobe_probability(blurred, c));
    return s;
}

// How often a sample is a facet's mirror image: about A.
float two_scale_mirror_probability(IN(BsdfParams) m, float cos_o) {
    float sigma = two_scale_sigma_um(m) / TWO_SCALE_GREEN_UM;
    if (sigma <= 0.0f) {
        return 1.0f;
    }
    float b = two_scale_b_um(m) / TWO_SCALE_GREEN_UM;
    float share = two_scale_lobe_probability(b, two_scale_c(m));
    return clamp(nano_specular_share(sigma * sqrt(share), cos_o, cos_o), 0.1f, 0.95f);
}

BsdfValue two_scale_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    Distribution d = two_scale_facets(m);
    vec3 wm = normalize(wo + wi);
    float cos_h = clamp(dot(wo, wm), 1.0e-6f, 1.0f);
    TwoScaleChannel r = two_scale_channel(m, wo, wi, cos_h, TWO_SCALE_RED_UM);
    TwoScaleChannel g = two_scale_channel(m, wo, wi, cos_h, TWO_SCALE_GREEN_UM);
    TwoScaleChannel b = two_scale_channel(m, wo, wi, cos_h, TWO_SCALE_BLUE_UM);
    float masking = masking_van_ginneken(distribution_lambda(d, wo), distribution_lambda(d, wi),
                                         azimuth_between(wo, wi));
    float facets = 0.25f * distribution_d(d, wm) / wo.z;
    vec3 mirror = vec3(r.mirror, g.mirror, b.mirror) * facets;
    vec3 diffracted = vec3(r.diffracted, g.diffracted, b.diffracted) * wi.z;
    BsdfValue v;
    v.f_cos = fresnel_conductor(cos_h, two_scale_eta(m), two_scale_k(m))
            * (masking * (mirror + diffracted));
    float density = (r.density + g.density + b.density) / 3.0f * wi.z;
    v.pdf = mix(density, 0.25f * distribution_sample_pdf(d, wm) / cos_h,
                two_scale_mirror_probability(m, wo.z));
    return v;
}

// A direction of the diffracted lobe of one channel; below the horizon where it fell there.
vec3 two_scale_sample_diffracted(IN(BsdfParams) m, vec3 wo, float u_channel, vec2 u) {
    float at = 3.0f * u_channel;
    float um = at < 1.0f ? TWO_SCALE_RED_UM : at < 2.0f ? TWO_SCALE_GREEN_UM : TWO_SCALE_BLUE_UM;
    float c = two_scale_c(m);
    float blurred = nano_blurred_length(two_scale_b_um(m) / um, c, two_scale_beta(m),
                                        two_scale_power(m));
    if (at - floor(at) >= two_scale_lobe_probability(blurred, c)) {
        return square_to_cosine_hemisphere(u);
    }
    vec2 moved = nano_spectrum_sample(blurred, c, u);
    float x = moved.x - wo.x;
    float y = moved.y - wo.y;
    float z2 = 1.0f - x * x - y * y;
    return z2 > 0.0f ? vec3(x, y, sqrt(z2)) : vec3(0.0f, 0.0f, -1.0f);
}

BsdfSample two_scale_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    float mirror = two_scale_mirror_probability(m, wo.z);
    if (u_lobe < mirror) {
        vec3 wm = distribution_sample(two_scale_facets(m), u);
        if (dot(wo, wm) <= 0.0f) {
            return bsdf_no_sample();
        }
        vec3 wi = reflect(-wo, wm);
        return bsdf_sample_of(wi, two_scale_eval(m, wo, wi), LOBE_GLOSSY);
    }
    vec3 wi = two_scale_sample_diffracted(m, wo, (u_lobe - mirror) / (1.0f - mirror), u);
    return bsdf_sample_of(wi, two_scale_eval(m, wo, wi), LOBE_DIFFUSE);
}

// What the mirror loses is diffracted, all but what masking takes.
vec3 two_scale_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    return fresnel_conductor(cos_o, two_scale_eta(m), two_scale_k(m));
}

bool two_scale_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
