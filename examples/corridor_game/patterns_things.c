/* What doors, crates, screens and plants look like. */
#include "game.h"

#include <math.h>

static Texel plain(float r, float g, float b, float roughness, float metallic) {
    Texel t = {{0, 0, 0}, 1, 0, 1, 0};
    t.color[0] = r, t.color[1] = g, t.color[2] = b;
    t.roughness = roughness, t.metallic = metallic;
    return t;
}

static float fraction(float x) { return x - floorf(x); }

/* A side of a crate: five boards in a frame. */
Texel planks(float u, float v) {
    const float edge = fminf(fminf(u, 1 - u), fminf(v, 1 - v));
    const int frame = edge < 0.11f;
    const int upright = frame && fminf(u, 1 - u) < 0.11f;
    const float along = upright || !frame ? v : u, across = upright || !frame ? u : v;
    const int board = frame ? 7 + upright : (int)(5 * u);
    const float from = 0.12f * along + 0.37f * (float)board;
    const float grain = cloudNoise(from, across, 48, 4, 200 + board);
    const float gap = frame ? smoothStep(0, 0.012f, 0.11f - edge)
                            : smoothStep(0, 0.06f, fminf(fraction(5 * u), 1 - fraction(5 * u)));
    const float shade = (0.5f + 0.8f * grain) * (0.45f + 0.55f * gap) *
                        (0.8f + 0.4f * hash(board, 1, 30));
    const float nx = fminf(u, 1 - u) - 0.055f, ny = fminf(v, 1 - v) - 0.055f;
    Texel t = plain(0.36f * shade, 0.20f * shade, 0.09f * shade, 0.8f, 0);
    t.height = (frame ? 0.02f : 0) + 0.004f * grain - 0.008f * (1 - gap);
    if (nx * nx + ny * ny < 0.018f * 0.018f) t = plain(0.35f, 0.33f, 0.30f, 0.4f, 1);
    return t;
}

/* Sandstone, hewn. */
Texel stone(float u, float v) {
    const float grain = cloudNoise(u, v, 12, 6, 230), band = cloudNoise(0.3f * u, v, 9, 4, 240);
    const float shade = 0.6f + 0.45f * grain + 0.25f * band;
    Texel t = plain(0.37f * shade, 0.33f * shade, 0.26f * shade, 0.85f, 0);
    t.height = 0.008f * grain;
    return t;
}

/* One leaf of the door, u from the middle of the door outwards. */
Texel doorLeaf(float u, float v) {
    const float wear = cloudNoise(u, v, 8, 5, 260);
    const float rib = fraction(6 * v);
    const float panel = smoothStep(0.06f, 0.12f, rib) * smoothStep(0.94f, 0.88f, rib);
    const float stripe = fraction(5 * (0.5f * u + v));
    Texel t = plain(0.23f, 0.27f, 0.29f, 0.35f + 0.3f * wear, 1);
    t.height = 0.02f * panel;
    if (u < 0.16f) { /* a warning where the leaves meet */
        const float paint = smoothStep(0.34f, 0.44f, wear);
        t = plain(stripe < 0.5f ? 0.75f : 0.02f, stripe < 0.5f ? 0.45f : 0.02f, 0.02f, 0.5f,
                  1 - paint);
        t.height = 0.025f;
    }
    if (wear > 0.62f) {
        const float rust = smoothStep(0.62f, 0.68f, wear);
        t.color[0] = mixed(t.color[0], 0.24f, rust), t.color[1] = mixed(t.color[1], 0.09f, rust);
        t.color[2] = mixed(t.color[2], 0.03f, rust);
        t.metallic *= 1 - rust, t.roughness = mixed(t.roughness, 0.9f, rust);
    }
    return t;
}

/* Lines of writing that nobody can read. */
Texel screen(float u, float v) {
    const int line = (int)(14 * v), letter = (int)(36 * u);
    const int length = 6 + (int)(26 * hash(line, 0, 50));
    const float x = fraction(36 * u), y = fraction(14 * v);
    const int dot = hash(letter * 3 + (int)(3 * x), line * 5 + (int)(5 * y), 51) > 0.45f;
    const int written = letter > 1 && letter < length && line > 0 && line < 13 && y < 0.7f &&
                        x < 0.85f && hash(letter, line, 52) > 0.15f && dot;
    Texel t = plain(0.02f, 0.10f, 0.04f, 0.2f, 0);
    if (written) t.color[0] = 0.25f, t.color[1] = 1, t.color[2] = 0.4f;
    return t;
}

/* Wires, crossing, with holes between them. */
Texel grate(float u, float v) {
    const float a = fraction(8 * (u + v)) - 0.5f, b = fraction(8 * (u - v)) - 0.5f;
    const float wire = fminf(fabsf(a), fabsf(b));
    Texel t = plain(0.30f, 0.27f, 0.24f, 0.5f, 1);
    t.alpha = 1 - smoothStep(0.10f, 0.16f, wire);
    t.height = 0.004f * smoothStep(0.16f, 0, wire);
    return t;
}

/* Blades from the lower edge upwards. */
Texel grass(float u, float v) {
    const float up = 1 - v;
    float best = 0;
    Texel t = plain(0.10f, 0.16f, 0.04f, 0.9f, 0);
    int i;
    for (i = 0; i < 26; ++i) {
        const float root = 0.15f + 0.7f * hash(i, 0, 70), length = 0.35f + 0.6f * hash(i, 1, 70);
        const float lean = 0.55f * (hash(i, 2, 70) - 0.5f);
        const float middle = root + lean * up * up;
        const float width = 0.022f * (1 - up / length);
        const float edge = smoothStep(width, width + 0.012f, fabsf(u - middle));
        const float there = up < length ? 1 - edge : 0;
        if (there > best) {
            const float dry = hash(i, 3, 70);
            best = there;
            t = plain(0.07f + 0.16f * dry, 0.15f + 0.03f * dry, 0.03f, 0.9f, 0);
        }
    }
    t.alpha = best;
    return t;
}

/* Panes in lead, light behind them. */
Texel window(float u, float v) {
    const float x = fraction(2 * u), y = fraction(3 * v);
    const int bar = fminf(fminf(x, 1 - x), fminf(y, 1 - y)) < 0.06f;
    const float glass = 0.6f + 0.8f * cloudNoise(u, v, 6, 3, 290);
    return bar ? plain(0, 0, 0, 0.6f, 0) : plain(glass, 0.62f * glass, 0.25f * glass, 0.2f, 0);
}
