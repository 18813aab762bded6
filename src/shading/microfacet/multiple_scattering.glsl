// What a rough mirror loses because light is followed to one microfacet only, given back as one
// more lobe that depends on the two cosines alone; and the same shape for a diffuse base that gets
// what the mirror above lets through.
//
// Based on: Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks", after
// Kelemen and Szirmay-Kalos 2001. Different here: the colour factor F_ms has F_avg squared, where
// the slides have it once. Light of this lobe has met two microfacets or more, so that its share
// can never exceed F^2; with F_avg once it does (tests/statistics/multiple_scattering_test.cpp).
//
// `surface` is ROUGH_MIRROR_…, a distribution with its masking. Off means not called: nothing else
// in the library knows of these tables, which are read when a material is made.
#ifndef GP_SHADING_MICROFACET_MULTIPLE_SCATTERING_GLSL
#define GP_SHADING_MICROFACET_MULTIPLE_SCATTERING_GLSL
#include "shading/constants.glsl"
#include "shading/microfacet/albedo_tables.glsl"
#include "shading/microfacet/chebyshev.glsl"
#include "shading/microfacet/table_lookup.glsl"

#define ROUGH_MIRROR_GGX_SEPARABLE 0u
#define ROUGH_MIRROR_GGX_CORRELATED 1u
#define ROUGH_MIRROR_BECKMANN_SEPARABLE 2u
#define ROUGH_MIRROR_BECKMANN_CORRELATED 3u

float single_scattering_loss_entry(uint surface, int i) {
    switch (surface) {
    case ROUGH_MIRROR_GGX_SEPARABLE: return ggx_separable_loss_entry(i);
    case ROUGH_MIRROR_GGX_CORRELATED: return ggx_correlated_loss_entry(i);
    case ROUGH_MIRROR_BECKMANN_SEPARABLE: return beckmann_separable_loss_entry(i);
    default: break;
    }
    return beckmann_correlated_loss_entry(i);
}

float single_scattering_average_entry(uint surface, int i) {
    switch (surface) {
    case ROUGH_MIRROR_GGX_SEPARABLE: return ggx_separable_average_entry(i);
    case ROUGH_MIRROR_GGX_CORRELATED: return ggx_correlated_average_entry(i);
    case ROUGH_MIRROR_BECKMANN_SEPARABLE: return beckmann_separable_average_entry(i);
    default: break;
    }
    return beckmann_correlated_average_entry(i);
}

// 1 - E, what one scattering loses of the light from an angle, with F = 1. Error below 3e-4; alpha
// in [0, 1], wider surfaces have the loss of alpha = 1.
float single_scattering_loss(uint surface, float cos_o, float alpha) {
    float a = clamp(alpha, 1.0e-4f, 1.0f);
    bool root = surface == ROUGH_MIRROR_GGX_CORRELATED;
    float column = albedo_column(clamp(cos_o, 0.0f, 1.0f), a, root);
    CubicStencil x = cubic_stencil(column, ALBEDO_TABLE_COSINES);
    CubicStencil y = cubic_stencil(albedo_row(a), ALBEDO_TABLE_WIDTHS);
    float sum = 0.0f;
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            int at = (y.first + j) * ALBEDO_TABLE_COSINES + x.first + i;
            sum += y.weight[j] * x.weight[i] * single_scattering_loss_entry(surface, at);
        }
    }
    return clamp(sum, 0.0f, 1.0f);
}

// 1 - E_avg = 2 * integral of (1 - E) cos d(cos). Error below 2e-4.
float single_scattering_loss_average(uint surface, float alpha) {
    float a = clamp(alpha, 1.0e-4f, 1.0f);
    CubicStencil y = cubic_stencil(albedo_row(a), ALBEDO_AVERAGE_WIDTHS);
    float sum = 0.0f;
    for (int j = 0; j < 4; ++j) {
        sum += y.weight[j] * single_scattering_average_entry(surface, y.first + j);
    }
    return clamp(a * sum, 0.0f, 1.0f);
}

// The losses of one surface, made once a material, from the tables or by quadrature
// (mirror_albedo.glsl): Chebyshev coefficients over albedo_column. Evaluation thus needs no table,
// whose constants some GLSL compilers copy for every read (llvmpipe takes minutes over them).
struct ScatteringLoss {
    Chebyshev loss;  // 1 - E
    float average;   // 1 - E_avg
    float width;     // of albedo_column, with `root`
    bool root;
};

// From the tables; the coefficients add an error below 3e-4.
ScatteringLoss scattering_loss_of(uint surface, float alpha) {
    ScatteringLoss l;
    l.width = clamp(alpha, 1.0e-4f, 1.0f);
    l.root = surface == ROUGH_MIRROR_GGX_CORRELATED;
    l.average = single_scattering_loss_average(surface, alpha);
    l.loss = chebyshev_none();
    for (int k = 0; k < 12; ++k) {
        float cos_k = albedo_column_cosine(chebyshev_node(k, 12), l.width, l.root);
        float value = single_scattering_loss(surface, cos_k, l.width);
        l.loss = chebyshev_with_node(l.loss, value, k, 12);
    }
    return l;
}

// 1 - E at an angle.
float scattering_loss(IN(ScatteringLoss) l, float cos_o) {
    float column = albedo_column(clamp(cos_o, 0.0f, 1.0f), l.width, l.root);
    return clamp(chebyshev_value(l.loss, column), 0.0f, 1.0f);
}

// The lobe f_ms from the losses towards wo and wi and their average; its integral with cos_i is
// loss_o. Where nothing is lost there is nothing to give back. [Kulla and Conty 2017, "Missing
// energy"; Kelemen and Szirmay-Kalos 2001, equation 5]
float multiple_scattering(float loss_o, float loss_i, float loss_average) {
    return loss_average > 1.0e-7f ? INV_PI * loss_o * loss_i / loss_average : 0.0f;
}

// Its colour: the share of light that two and more reflections with the mean reflectance leave,
// F^2 E (1 + F (1 - E) + F^2 (1 - E)^2 + ...), over what F = 1 leaves. [Kulla and Conty 2017,
// "Energy conservation: colour", with one more F_avg, as Hill 2018 has it too]
vec3 multiple_scattering_color(vec3 f_average, float loss_average) {
    return f_average * f_average * (1.0f - loss_average)
         / max(vec3(1.0f) - f_average * loss_average, vec3(1.0e-6f));
}

// F_avg = 2 * integral of F cos d(cos) of Schlick's term. [Kulla and Conty 2017, the integral of
// Schlick 1994, equation 15]
vec3 fresnel_schlick_average(vec3 f0, vec3 f90) {
    return f0 + (f90 - f0) / 21.0f;
}

// The same of the exact dielectric term, from outside (eta > 1) and from inside. Errors: 0.007 up
// to eta = 3, and 0.001 down to 1/3. [Kulla and Conty 2017, fits of the Fresnel average]
float fresnel_dielectric_average(float eta) {
    float outside = (eta - 1.0f) / (4.08567f + 1.00071f * eta);
    float inside = 0.997118f + eta * (0.1014f - eta * (0.965241f + eta * 0.130607f));
    return clamp(eta >= 1.0f ? outside : inside, 0.0f, 1.0f);
}

// A diffuse base under a mirror: what the mirror, F included, lets through on the way in and out.
// through: 1 - E_s at an angle; through_average: 1 - E_s,avg. A white base makes all of it white.
// [Kelemen and Szirmay-Kalos 2001, equation 5; Kulla and Conty 2017, "Diffuse"]
vec3 coupled_diffuse(vec3 reflectance, vec3 through_o, vec3 through_i, vec3 through_average) {
    return reflectance * INV_PI * through_o * through_i / max(through_average, vec3(1.0e-6f));
}

#endif
