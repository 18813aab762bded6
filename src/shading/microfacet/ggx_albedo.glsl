// Directional albedo of a GGX reflection (height-correlated Smith, one scattering) as fits: what a
// layer lets through to the one below, and how probable a lobe is. Our own fits to quadratures of
// 192 x 192 visible normals at 23 widths and 41 cosines; tests/statistics has the largest errors.
#ifndef GP_SHADING_MICROFACET_GGX_ALBEDO_GLSL
#define GP_SHADING_MICROFACET_GGX_ALBEDO_GLSL

// E = f0 * (white - schlick) + f90 * schlick, where white is the albedo with F = 1 and schlick
// the part of it that is weighted by (1 - cos)^5.
struct GgxAlbedo {
    float white;
    float schlick;
};

// Errors: white 0.0062, schlick 0.0039. Rational in v = cos / |stretched direction|, in which the
// drop towards grazing angles has the same place for every alpha.
GgxAlbedo ggx_albedo(float cos_o, float alpha) {
    float s = sqrt(cos_o * cos_o + alpha * alpha * (1.0f - cos_o * cos_o));
    float v = cos_o / s;
    float a = alpha;
    float p0 = 0.993932f + a * (-1.19937f + a * (0.50566f + a * 0.00302307f));
    float p1 = 0.161609f + a * (0.92706f - a * 0.625361f);
    float p2 = -1.11725f + a * 0.38148f;
    float q0 = 1.0f + a * (-1.20583f + a * 0.511184f);
    float q1 = 0.326852f + a * 1.25517f;
    GgxAlbedo e;
    e.white = (p0 + v * (p1 + v * (p2 + v * 0.214073f))) / (q0 + v * (q1 - v * 1.07324f));
    float b0 = 0.945643f + s * (-0.572247f + s * (-0.175817f + s * (0.710348f - s * 0.294508f)));
    float b1 = -0.622946f + s * (-3.36028f + s * (1.63993f - s * 0.661215f));
    float b2 = 0.255374f + s * (4.99574f - s * 0.344229f);
    float b3 = -0.646538f - s * 2.35063f;
    float d0 = 1.0f + s * (12.5469f + s * 0.630951f);
    float d1 = -0.519619f - s * 11.7775f;
    float schlick = (b0 + v * (b1 + v * (b2 + v * (b3 + v * 0.474444f))))
                  / (d0 + v * (d1 - v * 0.0731079f));
    e.white = clamp(e.white, 0.0f, 1.0f);
    e.schlick = clamp(schlick, 0.0f, e.white);
    return e;
}

// The same averaged over the hemisphere, 2 * integral of E cos d(cos). Errors: 0.0017 and 0.0009.
GgxAlbedo ggx_albedo_average(float alpha) {
    float a = alpha;
    GgxAlbedo e;
    e.white = 1.0017f + a * (-0.139648f + a * (-1.821281f + a * (2.194002f - a * 0.827322f)));
    e.schlick = 0.048482f + a * (-0.162825f + a * (0.206011f - a * 0.088618f));
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
