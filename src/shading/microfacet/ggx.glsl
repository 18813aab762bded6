// The GGX (Trowbridge-Reitz) distribution of microfacets with the masking of Smith, anisotropic.
// `alpha_x`, `alpha_y`: widths along the tangent and the bitangent. Directions are local, z along
// the normal. Works in float32 for widths from 1e-4 to 1 at any angle.
#ifndef GP_SHADING_MICROFACET_GGX_GLSL
#define GP_SHADING_MICROFACET_GGX_GLSL
#include "shading/constants.glsl"

// Microfacets per solid angle. From x and y rather than 1 - z^2, which has no digits for narrow
// lobes. [Walter et al. 2007, EGSR, equation 33; anisotropic: Burley 2012]
float ggx_d(vec3 wm, float alpha_x, float alpha_y) {
    float x = wm.x / alpha_x;
    float y = wm.y / alpha_y;
    float e = x * x + y * y + wm.z * wm.z;
    return wm.z > 0.0f ? INV_PI / (alpha_x * alpha_y * e * e) : 0.0f;
}

// The length of w after stretching: |z| sqrt(1 + alpha^2 tan^2). Everything of Smith's masking
// follows from it without dividing by the cosine: Lambda = (stretched / |z| - 1) / 2.
float ggx_stretched(vec3 w, float alpha_x, float alpha_y) {
    float x = alpha_x * w.x;
    float y = alpha_y * w.y;
    return sqrt(x * x + y * y + w.z * w.z);
}

// [Heitz 2014, JCGT 3(2), equations 72 and 86], in the form that does not cancel for small alpha
// and does not overflow at the horizon
float ggx_lambda(vec3 w, float alpha_x, float alpha_y) {
    float x = alpha_x * w.x;
    float y = alpha_y * w.y;
    float z = abs(w.z);
    return 0.5f * (x * x + y * y) / (z * (z + ggx_stretched(w, alpha_x, alpha_y)));
}

// The visible share of the microfacets that face w. [Heitz 2014, equation 43]
float ggx_g1(vec3 w, float alpha_x, float alpha_y) {
    float z = abs(w.z);
    return 2.0f * z / (z + ggx_stretched(w, alpha_x, alpha_y));
}

// Masking and shadowing as if the two were independent. [Heitz 2014, equation 98]
float ggx_g2_separable(vec3 wo, vec3 wi, float alpha_x, float alpha_y) {
    return ggx_g1(wo, alpha_x, alpha_y) * ggx_g1(wi, alpha_x, alpha_y);
}

// Both depend on the height of the microfacet, on the same side. [Heitz 2014, equation 99]
float ggx_g2_correlated(vec3 wo, vec3 wi, float alpha_x, float alpha_y) {
    float zo = abs(wo.z);
    float zi = abs(wi.z);
    float so = ggx_stretched(wo, alpha_x, alpha_y);
    float si = ggx_stretched(wi, alpha_x, alpha_y);
    return 2.0f * zo * zi / (zo * si + zi * so);
}

// The density of the normals that wo sees, per solid angle of wm.
// [Heitz 2018, JCGT 7(4), equation 1]
float ggx_vndf_pdf(vec3 wo, vec3 wm, float alpha_x, float alpha_y) {
    float visible = max(dot(wo, wm), 0.0f);
    float so = ggx_stretched(wo, alpha_x, alpha_y);
    return 2.0f * visible * ggx_d(wm, alpha_x, alpha_y) / (abs(wo.z) + so);
}

// A normal from that density; wo.z > 0. For the stretched direction the reflected directions of a
// uniform hemisphere of normals fill a spherical cap evenly.
// [Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps", listing 3]
vec3 ggx_sample_vndf(vec3 wo, float alpha_x, float alpha_y, vec2 u) {
    vec3 w = normalize(vec3(alpha_x * wo.x, alpha_y * wo.y, wo.z));
    // The cap's height z = height - w.z, and sin^2 = (1 - z) (1 + z) from factors without
    // cancellation; 1 - w.z is taken from the sine for the same reason.
    float one_minus_z = (w.x * w.x + w.y * w.y) / (1.0f + w.z);
    float height = (1.0f - u.y) * (1.0f + w.z);
    float sin_theta = sqrt(max(u.y * (1.0f + w.z) * (height + one_minus_z), 0.0f));
    float phi = TWO_PI * u.x;
    vec3 h = vec3(w.x + sin_theta * cos(phi), w.y + sin_theta * sin(phi), height);
    return normalize(vec3(alpha_x * h.x, alpha_y * h.y, max(h.z, 1.0e-7f)));
}

#endif
