// Complex numbers as vec2(real, imaginary), for waves: exp(-i omega t) in time, so that absorbing
// media have the index n + i k and a wave that goes a length further gains exp(+i phase).
#ifndef GP_SHADING_COMPLEX_GLSL
#define GP_SHADING_COMPLEX_GLSL

vec2 complex_multiply(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

vec2 complex_divide(vec2 a, vec2 b) {
    return vec2(a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y) / dot(b, b);
}

// The root with a real part of at least 0; for an imaginary part of at least 0 this is also the
// wave that decays inside of a medium. The larger half is found first, as the other one would be a
// difference of nearly equal numbers.
vec2 complex_sqrt(vec2 z) {
    float half_sum = 0.5f * (length(z) + abs(z.x));
    if (half_sum <= 0.0f) {
        return vec2(0.0f);
    }
    float larger = sqrt(half_sum);
    float smaller = 0.5f * abs(z.y) / larger;
    float sign_y = z.y < 0.0f ? -1.0f : 1.0f;
    return z.x >= 0.0f ? vec2(larger, sign_y * smaller) : vec2(smaller, sign_y * larger);
}

// exp(i z)
vec2 complex_exp_i(vec2 z) {
    float size = exp(-z.y);
    return vec2(size * cos(z.x), size * sin(z.x));
}

#endif
