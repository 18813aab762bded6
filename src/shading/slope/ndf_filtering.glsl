// Highlights narrower than what a pixel sees of a curved surface: the half vector moves within the
// pixel, and the distribution of normals is widened by how much, so that one sample shows what the
// mean over many would. Numbers in, numbers out: whoever knows the surface says how the half vector
// h, in the frame of the shading, changes along the two axes of the pixel's footprint.
// Widths are squares, alpha^2 = 2 variances of slopes, as (xx, yy, xy) where they have a direction.
// Based on: Kaplanyan et al. 2016, "Filtering Distributions of Normals for Shading Antialiasing",
// HPG; Tokuyoshi and Kaplanyan 2019, "Improved Geometric Specular Antialiasing", I3D, and 2021,
// "Stable Geometric Specular Antialiasing with Projected-Space NDF Filtering", JCGT 10(2). Ours:
// the ways from and to projected widths need no inverse of a matrix, so that none can be missing.
#ifndef GP_SHADING_SLOPE_NDF_FILTERING_GLSL
#define GP_SHADING_SLOPE_NDF_FILTERING_GLSL
#include "shading/slope/footprint.glsl"
#include "shading/slope/mean_slope.glsl"

#define NDF_FILTER_NONE 0u
#define NDF_FILTER_KAPLANYAN 1u
#define NDF_FILTER_TOKUYOSHI 2u
#define NDF_FILTER_DEFERRED 3u

// Variance of the pixel's Gaussian filter along an axis, pixels^2: 1 / (2 pi), of unit peak.
// [Tokuyoshi and Kaplanyan 2019, section 3]
#define NDF_PIXEL_VARIANCE 0.159154943f
// The most that is added to alpha^2: differences across silhouettes would blur all of a highlight.
// [Tokuyoshi and Kaplanyan 2019, listing 1]
#define NDF_LARGEST_KERNEL 0.18f
// The same of the older method: half of the footprint's sides in slopes. [Kaplanyan et al. 2016]
#define NDF_LARGEST_HALF_SIDE 0.3f

// The change of h = normalize(wo + wi) where wo and wi change by d_wo and d_wi.
vec3 half_vector_change(vec3 wo, vec3 wi, vec3 d_wo, vec3 d_wi) {
    vec3 v = wo + wi;
    float inv_length = inversesqrt(max(dot(v, v), 1.0e-12f));
    vec3 h = v * inv_length;
    vec3 d = (d_wo + d_wi) * inv_length;
    return d - h * dot(h, d);
}

// Twice the covariance of what moves by d0 and d1 from pixel to pixel, under the pixel's filter.
vec3 ndf_kernel(vec2 d0, vec2 d1) {
    return vec3(d0.x * d0.x + d1.x * d1.x, d0.y * d0.y + d1.y * d1.y, d0.x * d0.y + d1.x * d1.y)
         * (2.0f * NDF_PIXEL_VARIANCE);
}

// The kernel, made smaller as a whole if it is too large; its direction stays.
vec3 ndf_kernel_bounded(vec3 kernel) {
    float largest = max(kernel.x, kernel.y);
    return largest > NDF_LARGEST_KERNEL ? kernel * (NDF_LARGEST_KERNEL / largest) : kernel;
}

// Widths along the frame's axes by the rectangle about the footprint of the slopes, whose half
// sides are one deviation. alpha: squares go in and come out.
// [Kaplanyan et al. 2016, section 5, axis-aligned]
vec2 ndf_kaplanyan(vec2 alpha2, vec3 h, vec3 dh0, vec3 dh1) {
    vec2 s0 = slope_change(h, dh0);
    vec2 s1 = slope_change(h, dh1);
    float x = min(0.5f * (abs(s0.x) + abs(s1.x)), NDF_LARGEST_HALF_SIDE);
    float y = min(0.5f * (abs(s0.y) + abs(s1.y)), NDF_LARGEST_HALF_SIDE);
    return vec2(min(alpha2.x + 2.0f * x * x, 1.0f), min(alpha2.y + 2.0f * y * y, 1.0f));
}

// One width for all lights, from how the normal moves alone: for G-buffers. Given the changes of
// the half vector, it is the isotropic filter of one light.
// [Tokuyoshi and Kaplanyan 2019, section 5, listing 2]
float ndf_deferred(float alpha2, vec3 dn0, vec3 dn1) {
    float kernel = 2.0f * NDF_PIXEL_VARIANCE * (dot(dn0, dn0) + dot(dn1, dn1));
    return min(alpha2 + min(kernel, NDF_LARGEST_KERNEL), 1.0f);
}

// Squared widths of slopes (h.xy / h.z) as such of the projected half vector h.xy: A (1 - A)^-1,
// which is exact for GGX. Both widths must be below 1.
// [Tokuyoshi and Kaplanyan 2021, equation 4]
vec3 ndf_projected(vec3 a) {
    float det = a.x * a.y - a.z * a.z;
    float scale = 1.0f / max(1.0f - a.x - a.y + det, 1.0e-8f);
    return vec3(a.x - det, a.y - det, a.z) * scale;
}

// And back, P (1 + P)^-1. [Tokuyoshi and Kaplanyan 2021, equation 7]
vec3 ndf_from_projected(vec3 p) {
    float det = max(p.x * p.y - p.z * p.z, 0.0f);
    float scale = 1.0f / (1.0f + p.x + p.y + det);
    return vec3(p.x + det, p.y + det, p.z) * scale;
}

// Squared widths with those of the pixel added where derivatives are tame also at grazing angles:
// in h.xy. Given the changes of the normal, in the frame, it serves all lights.
// [Tokuyoshi and Kaplanyan 2021, equation 6]
vec3 ndf_tokuyoshi(vec3 alpha2, vec3 dh0, vec3 dh1) {
    // At 1 the projected width is infinite.
    vec3 a = vec3(min(alpha2.x, 0.9999f), min(alpha2.y, 0.9999f), alpha2.z);
    vec3 kernel = ndf_kernel_bounded(ndf_kernel(vec2(dh0.x, dh0.y), vec2(dh1.x, dh1.y)));
    return ndf_from_projected(ndf_projected(a) + kernel);
}

// The same of a distribution of slopes, whose covariance takes the kernel whatever its direction:
// added as it is, since for Gaussian slopes, which may be wider than 1, no projection is exact.
// [Tokuyoshi and Kaplanyan 2021, equation 9]
Slopes slopes_ndf_filtered(IN(Slopes) d, vec3 dh0, vec3 dh1) {
    vec3 kernel = ndf_kernel(vec2(dh0.x, dh0.y), vec2(dh1.x, dh1.y));
    return slopes_widened(d, ndf_kernel_bounded(kernel) * 0.5f);
}

// Widths along two axes at right angles, for models that have no covariance.
struct PrincipalWidths {
    vec2 axis;     // of alpha_x, in the frame; alpha_y is a quarter turn from it
    float alpha_x;
    float alpha_y;
};

// Of squared widths: the axes in which they are not correlated.
PrincipalWidths principal_widths(vec3 alpha2) {
    float mean = 0.5f * (alpha2.x + alpha2.y);
    float half_difference = 0.5f * (alpha2.x - alpha2.y);
    float radius = sqrt(half_difference * half_difference + alpha2.z * alpha2.z);
    PrincipalWidths w;
    w.alpha_x = sqrt(mean + radius);
    w.alpha_y = sqrt(max(mean - radius, 0.0f));
    w.axis = principal_axis(half_difference, alpha2.z, radius);
    return w;
}

#endif
