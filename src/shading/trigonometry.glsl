// Angles in turns (1 = 360 degrees), as a sampler wants them: a uniform number is an angle already,
// and no digit is lost in reducing it. Polynomials rather than sin, cos and atan: a renderer calls
// them several times a vertex, libm's take two to four times as long, and they are the same to a
// few units of the last place on every CPU and GPU.
#ifndef GP_SHADING_TRIGONOMETRY_GLSL
#define GP_SHADING_TRIGONOMETRY_GLSL
#include "shading/constants.glsl"

struct SinCos {
    float s;
    float c;
};

// Sine and cosine of up to an eighth of a turn to both sides. Chebyshev fits of our own of
// sin(2 pi r) / r and cos(2 pi r) in r^2.
IN_LOOPS SinCos sincos_eighth(float r) {
    float r2 = r * r;
    SinCos result;
    result.s = r * (6.28318529f + r2 * (-41.3416626f + r2 * (81.59254821f - r2 * 75.40184032f)));
    result.c = 1.0f + r2 * (-19.73920865f +
                            r2 * (64.93931617f + r2 * (-85.44284839f + r2 * 59.22028787f)));
    return result;
}

// Sine and cosine; the error is below 1.5e-7 for up to 1000 turns.
SinCos sincos_turns(float turns) {
    float quarter = floor(4.0f * turns + 0.5f);
    SinCos near = sincos_eighth(turns - 0.25f * quarter);
    float s = near.s;
    float c = near.c;
    uint quadrant = uint(int(quarter)) & 3u;
    bool swapped = (quadrant & 1u) != 0u;
    float sine = swapped ? c : s;
    float cosine = swapped ? s : c;
    SinCos result;
    result.s = quadrant >= 2u ? -sine : sine;
    result.c = quadrant == 1u || quadrant == 2u ? -cosine : cosine;
    return result;
}

// The angle of the vector (x, y) in turns, -0.5 to 0.5; 0 for the zero vector. Error below 3e-8.
// [Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", 4.4.49]
float turns_from_vector(float y, float x) {
    float ax = abs(x);
    float ay = abs(y);
    float longer = max(ax, ay);
    float t = longer > 0.0f ? min(ax, ay) / longer : 0.0f;
    float t2 = t * t;
    float p = -0.0161657367f + t2 * 0.0028662257f;
    p = -0.0752896400f + t2 * (0.0429096138f + t2 * p);
    p = -0.1420889944f + t2 * (0.1065626393f + t2 * p);
    p = -0.3333314528f + t2 * (0.1999355085f + t2 * p);
    float angle = t * (1.0f + t2 * p) * INV_TWO_PI;
    angle = ay > ax ? 0.25f - angle : angle;
    angle = x < 0.0f ? 0.5f - angle : angle;
    return y < 0.0f ? -angle : angle;
}

#endif
