// A function on [0, 1] as up to twelve coefficients in Chebyshev polynomials, from its values at as
// many nodes.
#ifndef GP_SHADING_MICROFACET_CHEBYSHEV_GLSL
#define GP_SHADING_MICROFACET_CHEBYSHEV_GLSL
#include "shading/constants.glsl"

struct Chebyshev {
    vec4 low;  // coefficients 0 to 3, 4 to 7, 8 to 11
    vec4 middle;
    vec4 high;
};

Chebyshev chebyshev_none() {
    Chebyshev c;
    c.low = vec4(0.0f);
    c.middle = vec4(0.0f);
    c.high = vec4(0.0f);
    return c;
}

// The angle of node k of `count`; the node itself is 1/2 + 1/2 of its cosine.
float chebyshev_angle(int k, int count) {
    return PI / float(count) * (float(k) + 0.5f);
}

float chebyshev_node(int k, int count) {
    return 0.5f + 0.5f * cos(chebyshev_angle(k, count));
}

// Adds the value at node k: all `count` of them, 4, 8 or 12, make the coefficients.
// [Press et al. 2007, "Numerical Recipes", section 5.8]
Chebyshev chebyshev_with_node(IN(Chebyshev) c, float value, int k, int count) {
    float angle = chebyshev_angle(k, count);
    float v = value * 2.0f / float(count);
    Chebyshev r = c;
    for (int j = 0; j < 4; ++j) {
        r.low[j] += (j == 0 ? 0.5f : 1.0f) * v * cos(float(j) * angle);
        r.middle[j] += count > 4 ? v * cos(float(j + 4) * angle) : 0.0f;
        r.high[j] += count > 8 ? v * cos(float(j + 8) * angle) : 0.0f;
    }
    return r;
}

// Clenshaw's recurrence, of the even and of the odd polynomials: both obey the same one in
// 2 (2 x^2 - 1), step by step beside each other.
// [Press et al. 2007, "Numerical Recipes", section 5.8]
float chebyshev_value(IN(Chebyshev) c, float x) {
    float t = 2.0f * x - 1.0f;
    float y = 4.0f * t * t - 2.0f;
    vec2 last = vec2(c.high.z, c.high.w);
    vec2 a = vec2(c.high.x, c.high.y) + y * last;
    vec2 b = vec2(c.middle.z, c.middle.w) + y * a - last;
    a = vec2(c.middle.x, c.middle.y) + y * b - a;
    b = vec2(c.low.z, c.low.w) + y * a - b;
    return c.low.x + 0.5f * y * b.x - a.x + t * (c.low.y + y * b.y - a.y - b.y);
}

#endif
