// Cubic interpolation in a table on an even grid: where to read and with which weights.
#ifndef GP_SHADING_MICROFACET_TABLE_LOOKUP_GLSL
#define GP_SHADING_MICROFACET_TABLE_LOOKUP_GLSL

// Four neighbours: the first index, and Lagrange's weights of all of them.
struct CubicStencil {
    int first;
    vec4 weight;
};

// x in [0, 1] among `count` >= 4 nodes. At the ends the stencil stays inside and only x leaves its
// middle interval, which costs a little accuracy there and needs no nodes outside.
// [Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", equation 25.2.13]
CubicStencil cubic_stencil(float x, int count) {
    float at = clamp(x, 0.0f, 1.0f) * float(count - 1);
    CubicStencil s;
    s.first = clamp(int(floor(at)) - 1, 0, count - 4);
    float t = at - float(s.first + 1);
    s.weight = vec4(t * (t - 1.0f) * (2.0f - t) / 6.0f, 0.5f * (t + 1.0f) * (t - 1.0f) * (t - 2.0f),
                    0.5f * (t + 1.0f) * t * (2.0f - t), (t + 1.0f) * t * (t - 1.0f) / 6.0f);
    return s;
}

#endif
