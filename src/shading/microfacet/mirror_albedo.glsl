// What a rough mirror of any distribution returns after one scattering, by quadrature when a
// material is made: its loss, and the part of its albedo that Schlick's term adds.
//
// With t the tangent of a normal and phi its azimuth from the view's,
//
//   E = integral of D G cos_h / cos_o dw_m,   dw_m = t^2 cos^3 d(log t) dphi,
//
// over the normals that reflect to above the horizon, cos_h > cos_o / (2 cos_m).
#ifndef GP_SHADING_MICROFACET_MIRROR_ALBEDO_GLSL
#define GP_SHADING_MICROFACET_MIRROR_ALBEDO_GLSL
#include "shading/fresnel.glsl"
#include "shading/microfacet/ggx_albedo.glsl"
#include "shading/microfacet/multiple_scattering.glsl"
#include "shading/microfacet/smith_quadrature.glsl"

// Errors of E at these: 0.0012 (tests/statistics/mirror_albedo_test.cpp).
#define MIRROR_ALBEDO_SLOPES 96
#define MIRROR_ALBEDO_AZIMUTHS 12

// One view of a mirror, in the plane y = 0.
struct MirrorView {
    vec3 wo;
    float lambda_o;
    uint masking;
};

// `masking` is one of the four that keep energy.
float mirror_masking(IN(Distribution) d, IN(MirrorView) view, vec3 wi, float h, float cos_h) {
    return view.masking == MASKING_V_CAVITY
        ? masking_v_cavity(view.wo.z, wi.z, h, cos_h)
        : masking_smith(view.masking, view.lambda_o, distribution_lambda(d, wi), view.wo, wi);
}

MirrorView mirror_view(IN(Distribution) d, uint masking, vec3 wo) {
    MirrorView view;
    view.wo = wo;
    view.masking = masking;
    view.lambda_o = masking == MASKING_V_CAVITY ? 0.0f : distribution_lambda(d, wo);
    return view;
}

// The azimuth at which cos_h has a value.
float mirror_azimuth(IN(MirrorView) view, float sin_m, float cos_m, float cos_h) {
    float across = max(view.wo.x * sin_m, 1.0e-12f);
    return acos(clamp((cos_h - view.wo.z * cos_m) / across, -1.0f, 1.0f));
}

// Without D, over a piece of the azimuths.
GgxAlbedo mirror_albedo_piece(IN(Distribution) d, IN(MirrorView) view, float sin_m, float cos_m,
                              vec2 piece) {
    float step_phi = (piece.y - piece.x) / float(MIRROR_ALBEDO_AZIMUTHS);
    GgxAlbedo e;
    e.white = 0.0f;
    e.schlick = 0.0f;
    if (step_phi <= 0.0f) {
        return e;
    }
    for (int j = 0; j < MIRROR_ALBEDO_AZIMUTHS; ++j) {
        float phi = piece.x + (float(j) + 0.5f) * step_phi;
        vec3 wm = vec3(sin_m * cos(phi), sin_m * sin(phi), cos_m);
        float cos_h = min(dot(view.wo, wm), 1.0f);
        vec3 wi = 2.0f * cos_h * wm - view.wo;
        if (cos_h > 0.0f && wi.z > 0.0f) {
            float part = mirror_masking(d, view, wi, cos_m, cos_h) * cos_h / view.wo.z * step_phi;
            e.white += part;
            e.schlick += part * schlick_weight(cos_h);
        }
    }
    return e;
}

// E, and the part of it that is weighted by (1 - cos_h)^5; d is isotropic.
GgxAlbedo mirror_albedo(IN(Distribution) d, uint masking, float cos_o) {
    float c = clamp(cos_o, 1.0e-6f, 1.0f);
    float sin_o = sqrt((1.0f - c) * (1.0f + c));
    MirrorView view = mirror_view(d, masking, vec3(sin_o, 0.0f, c));
    // Flatter slopes have less than 1e-4 of the area; steeper ones reflect to below the horizon.
    float first = log(d.alpha_x) - 5.0f;
    float last = min(log((1.0f + sin_o) / c), log(steepest_slope(d, d.alpha_x)));
    float step_log = max(last - first, 0.0f) / float(MIRROR_ALBEDO_SLOPES);
    GgxAlbedo sum;
    sum.white = 0.0f;
    sum.schlick = 0.0f;
    for (int i = 0; i < MIRROR_ALBEDO_SLOPES; ++i) {
        float t = exp(first + (float(i) + 0.5f) * step_log);
        float cos_m = inversesqrt(1.0f + t * t);
        float sin_m = t * cos_m;
        // Both azimuths count twice. Where light grazes, masking drops within a narrow piece at
        // the end, which has a rule of its own.
        float end = mirror_azimuth(view, sin_m, cos_m, 0.5f * c / cos_m);
        float drop = mirror_azimuth(view, sin_m, cos_m, c * max(2.0f * cos_m, 1.0f / cos_m));
        float area = 2.0f * isotropic_d(d, vec3(sin_m, 0.0f, cos_m), d.alpha_x)
                   * t * t * cos_m * cos_m * cos_m * step_log;
        GgxAlbedo wide = mirror_albedo_piece(d, view, sin_m, cos_m, vec2(0.0f, drop));
        GgxAlbedo narrow = mirror_albedo_piece(d, view, sin_m, cos_m, vec2(drop, end));
        sum.white += area * (wide.white + narrow.white);
        sum.schlick += area * (wide.schlick + narrow.schlick);
    }
    sum.white = min(sum.white, 1.0f);
    sum.schlick = min(sum.schlick, sum.white);
    return sum;
}

// Lambda at the horizon times the cotangent. [Heitz 2014, JCGT 3(2), equations 66 and 72, limits]
float mirror_mean_slope(IN(Distribution) d) {
    switch (d.kind) {
    case DISTRIBUTION_GGX: return 0.5f * d.alpha_x;
    case DISTRIBUTION_BECKMANN: return 0.5f * INV_SQRT_PI * d.alpha_x;
    case DISTRIBUTION_EXPONENTIAL_POWER: return exponential_power_fit(d.alpha_x, d.shape).low.x;
    default: break;
    }
    return d.fit.low.x;
}

// 2 * integral of the loss times the cosine, by midpoints of its root.
float scattering_loss_integral(IN(ScatteringLoss) l) {
    float sum = 0.0f;
    for (int i = 0; i < 64; ++i) {
        float x = (float(i) + 0.5f) / 64.0f;
        sum += x * x * x * scattering_loss(l, x * x);
    }
    return sum / 16.0f;
}

// Errors below 0.004, of very long tails (exponential power below 1/2) 0.01.
ScatteringLoss scattering_loss_by_quadrature(IN(Distribution) d, uint masking) {
    ScatteringLoss l;
    l.width = clamp(4.0f * mirror_mean_slope(d), 1.0e-4f, 4.0f);
    l.root = false;
    l.loss = chebyshev_none();
    for (int k = 0; k < 12; ++k) {
        float cos_k = albedo_column_cosine(chebyshev_node(k, 12), l.width, l.root);
        l.loss = chebyshev_with_node(l.loss, 1.0f - mirror_albedo(d, masking, cos_k).white, k, 12);
    }
    l.average = scattering_loss_integral(l);
    return l;
}

// The mean of (1 - cos_h)^5 over what is reflected, as the fifth power of a polynomial: of a smooth
// mirror that is (1 - cos_o)^5 itself.
struct SchlickShare {
    Chebyshev fifth_root;
    float average;  // 2 * integral of E times it times the cosine
};

float schlick_share(IN(SchlickShare) s, float cos_o) {
    float column = albedo_column(clamp(cos_o, 0.0f, 1.0f), 0.3f, true);
    float r = clamp(chebyshev_value(s.fifth_root, column), 0.0f, 1.0f);
    return schlick_weight(1.0f - r);
}

// Errors of E times it below 0.004 but for grazing cosines below 0.002.
SchlickShare schlick_share_by_quadrature(IN(Distribution) d, uint masking,
                                         IN(ScatteringLoss) losses) {
    SchlickShare s;
    s.fifth_root = chebyshev_none();
    for (int k = 0; k < 8; ++k) {
        float cos_k = albedo_column_cosine(chebyshev_node(k, 8), 0.3f, true);
        GgxAlbedo e = mirror_albedo(d, masking, cos_k);
        float share = clamp(e.schlick / max(e.white, 1.0e-9f), 1.0e-20f, 1.0f);
        s.fifth_root = chebyshev_with_node(s.fifth_root, pow(share, 0.2f), k, 8);
    }
    s.average = 0.0f;
    for (int i = 0; i < 64; ++i) {
        float x = (float(i) + 0.5f) / 64.0f;
        float white = 1.0f - scattering_loss(losses, x * x);
        s.average += x * x * x * white * schlick_share(s, x * x) / 16.0f;
    }
    return s;
}

#endif
