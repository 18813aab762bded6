// Directional albedo of a GGX reflection (height-correlated Smith, one scattering) as fits: what a
// layer lets through to the one below, and how probable a lobe is. Our own fits to quadratures of
// 65,536 visible normals at 23 widths and 41 cosines; tests/statistics checks the stated errors.
#ifndef GP_SHADING_MICROFACET_GGX_ALBEDO_GLSL
#define GP_SHADING_MICROFACET_GGX_ALBEDO_GLSL

// E = f0 * (white - schlick) + f90 * schlick, where white is the albedo with F = 1 and schlick
// the part of it that is weighted by (1 - cos)^5.
struct GgxAlbedo {
    float white;
    float schlick;
};

// Errors: white 0.0060, schlick 0.0039. Rational in v = cos / |stretched direction|, in which the
// drop towards grazing angles has the same place for every alpha.
GgxAlbedo ggx_albedo(float cos_o, float alpha) {
    float s = sqrt(cos_o * cos_o + alpha * alpha * (1.0f - cos_o * cos_o));
    float v = cos_o / s;
    float a = alpha;
    float p0 = 0.997458f + a * (-1.24903f + a * (0.555325f - a * 0.00611128f));
    float p1 = 0.106957f + a * (1.02774f - a * 0.663652f);
    float p2 = -1.05688f + a * 0.331274f;
    float q0 = 1.0f + a * (-1.23984f + a * 0.539591f);
    float q1 = 0.282147f + a * 1.28777f;
    float white = p0 + v * (p1 + v * (p2 + v * 0.212245f));
    float white_q = q0 + v * (q1 - v * 1.0211f);
    float b0 = 0.946875f + s * (-0.554583f + s * (-0.164728f + s * (0.631211f - s * 0.244658f)));
    float b1 = -0.602312f + s * (-3.49149f + s * (1.80613f - s * 0.714561f));
    float b2 = 0.232324f + s * (5.06038f - s * 0.400872f);
    float b3 = -0.636727f - s * 2.34193f;
    float d0 = 1.0f + s * (12.6485f + s * 0.567802f);
    float d1 = -0.490287f - s * 11.9044f;
    float schlick = b0 + v * (b1 + v * (b2 + v * (b3 + v * 0.468341f)));
    float schlick_q = d0 + v * (d1 - v * 0.0999467f);
    // One division for both quotients.
    float inv = 1.0f / (white_q * schlick_q);
    GgxAlbedo e;
    e.white = clamp(white * schlick_q * inv, 0.0f, 1.0f);
    e.schlick = clamp(schlick * white_q * inv, 0.0f, e.white);
    return e;
}

// The same averaged over the hemisphere, 2 * integral of E cos d(cos). Errors: 0.0014 and 0.0009.
GgxAlbedo ggx_albedo_average(float alpha) {
    float a = alpha;
    GgxAlbedo e;
    e.white = 1.001419f + a * (-0.147424f + a * (-1.773762f + a * (2.114794f - a * 0.787296f)));
    e.schlick = 0.048478f + a * (-0.162862f + a * (0.206217f - a * 0.08881f));
    e.white = min(e.white, 1.0f);
    return e;
}

float ggx_albedo_fresnel(GgxAlbedo e, float f0, float f90) {
    return f0 * (e.white - e.schlick) + f90 * e.schlick;
}

vec3 ggx_albedo_fresnel(GgxAlbedo e, vec3 f0, vec3 f90) {
    return f0 * (e.white - e.schlick) + f90 * e.schlick;
}

#endif
