// Powers of numbers above 0 without a call, so that loops over pixels become vectors. The binary
// logarithm is off by 3e-7 and the last place of a float, a power by as much of itself as its own
// logarithm is: 1e-6 of 1e-4.
#ifndef GP_SHADING_POWERS_GLSL
#define GP_SHADING_POWERS_GLSL
#define LN_TWO 0.693147181f

// x: normal, above 0. By the series of the inverse hyperbolic tangent about the nearest power of
// two. [Abramowitz and Stegun 1964, 4.1.27]
IN_LOOPS float log2_above_0(float x) {
    // From the bits of sqrt(1/2) on, so that what is left is within a factor of sqrt(2).
    uint bits = floatBitsToUint(x) - 0x3f3504f3u;
    int exponent = int(bits) >> 23;
    float m = uintBitsToFloat((bits & 0x007fffffu) + 0x3f3504f3u);
    float t = (m - 1.0f) / (m + 1.0f);
    float t2 = t * t;
    float series = 1.0f + t2 * (1.0f / 3.0f + t2 * (0.2f + t2 * (1.0f / 7.0f)));
    return float(exponent) + 2.885390082f * t * series;
}

// |x| below 126. [Abramowitz and Stegun 1964, 4.2.1: the series of e^(x ln 2) about the nearest
// whole x]
IN_LOOPS float exp2_within_126(float x) {
    // The nearest whole number, plus 127: of what is above 0 a conversion to int is the floor.
    int biased = int(x + 127.5f);
    float f = (x - float(biased - 127)) * LN_TWO;
    float e = 1.0f + f * (1.0f + f * (0.5f + f * (1.0f / 6.0f + f * (1.0f / 24.0f +
              f * (1.0f / 120.0f + f * (1.0f / 720.0f))))));
    return e * uintBitsToFloat(uint(biased) << 23u);
}

// 2^n for a whole number n between -126 and 127.
IN_LOOPS float exp2_whole(float n) {
    return uintBitsToFloat(uint(int(n) + 127) << 23u);
}

// The floor of the logarithm to base 4, at once: half of the exponent. x: normal, above 0.
IN_LOOPS int log4_floor(float x) {
    return int(((floatBitsToUint(x) >> 23u) + 1u) >> 1u) - 64;
}

// Exponents above 0. Of 0 a number below 1e-12 for those of gammas, 1 / 2.4 and above.
IN_LOOPS float pow_above_0(float x, float exponent) {
    return exp2_within_126(max(exponent * log2_above_0(max(x, 1.0e-30f)), -125.0f));
}

#endif
