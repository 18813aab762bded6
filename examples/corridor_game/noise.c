/* Numbers that look random: hashes, smooth noise that repeats, sums of it. */
#include "game.h"

#include <math.h>

/* A linear congruence with its high bits folded in, three times: enough for pictures. */
float hash(int x, int y, int seed) {
    uint32_t h = (uint32_t)x * 73856093u ^ (uint32_t)y * 19349663u ^ (uint32_t)seed * 83492791u;
    h = h * 1664525u + 1013904223u;
    h ^= h >> 16;
    h = h * 1664525u + 1013904223u;
    h ^= h >> 16;
    h = h * 1664525u + 1013904223u;
    return (float)(h >> 8) * (1.0f / 16777216.0f);
}

static int wrapped(int i, int period) {
    const int r = i % period;
    return r < 0 ? r + period : r;
}

float mixed(float a, float b, float share) { return a + (b - a) * share; }

float smoothStep(float low, float high, float x) {
    const float t = fminf(fmaxf((x - low) / (high - low), 0), 1);
    return t * t * (3 - 2 * t);
}

float noise(float x, float y, int period, int seed) {
    const float fx = floorf(x), fy = floorf(y);
    const int x0 = wrapped((int)fx, period), y0 = wrapped((int)fy, period);
    const int x1 = wrapped(x0 + 1, period), y1 = wrapped(y0 + 1, period);
    const float sx = smoothStep(0, 1, x - fx), sy = smoothStep(0, 1, y - fy);
    const float above = mixed(hash(x0, y0, seed), hash(x1, y0, seed), sx);
    const float below = mixed(hash(x0, y1, seed), hash(x1, y1, seed), sx);
    return mixed(above, below, sy);
}

float cloudNoise(float u, float v, int period, int octaves, int seed) {
    float sum = 0, weight = 0.5f, weights = 0;
    int i;
    for (i = 0; i < octaves; ++i) {
        sum += weight * noise(u * (float)period, v * (float)period, period, seed + i);
        weights += weight;
        weight *= 0.5f;
        period *= 2;
    }
    return sum / weights;
}

float flicker(double seconds, int seed) {
    const float t = (float)seconds;
    return 0.6f * noise(7 * t, 0.5f, 4096, seed) + 0.4f * noise(19 * t, 0.5f, 4096, seed + 7);
}
