// Based on: Koskela, Immonen, Mäkitalo, Foi, Viitanen, Jääskeläinen, Kultala, Takala 2019,
// "Blockwise Multi-Order Feature Regression for Real-Time Path-Tracing Reconstruction", ACM TOG
// 38(5). In each block of 32 x 32 pixels the light, a mean over few frames, is the sum of features
// of the surfaces that fits it best by least squares: a constant, normals, positions and their
// squares. Blocks begin elsewhere in each frame, and bmfr_accumulate averages over them.
// Otherwise than there: the QR decomposition takes in a row of pixels at a time, so that it needs
// no scratch memory; a ridge stands for the noise on features; positions are the camera's, not the
// world's, which only turns the axes of their squares; pixels without surface have no equation. An
// invocation does a whole block.
#ifndef GP_KERNELS_REALTIME_BMFR_FIT_GLSL
#define GP_KERNELS_REALTIME_BMFR_FIT_GLSL
#include "kernels/realtime/edge_stop.glsl"
#include "shading/sampling/hash.glsl"

#define BMFR_BLOCK 32
#define BMFR_FEATURES 10
#define BMFR_OUTPUTS 6                         // diffuse and specular light
#define BMFR_COLUMNS (BMFR_FEATURES + BMFR_OUTPUTS)
#define BMFR_ROWS (BMFR_FEATURES + BMFR_BLOCK)

// Features that are the same all over a block (a wall's normal), or more of them than pixels, would
// leave the system singular. [Koskela et al. 2019, section 3.4] adds noise of +-0.01 to features;
// in 1,024 pixels that is on average an equation for each, "its weight is 0", of this scale.
#define BMFR_RIDGE 0.185f

// Column after column: the triangle of all rows so far, and below it the pixels of the next row;
// after the solution, weights.
struct BmfrSystem {
    float m[BMFR_COLUMNS * BMFR_ROWS];
};

// A block: its first pixel, which may be outside, and the box of its surfaces' positions.
struct BmfrBlock {
    ivec2 first;
    vec3 least;
    vec3 scale;
    uint lit;
};

// Not with a depth that nothing has: it would stretch the box.
bool bmfr_pixel_counts(ivec2 at) {
    return pixel_is_inside(at, load_realtime().size) &&
           pixel_is_lit(load_material(at), load_depth(at)) && load_depth(at) > 0.0f;
}

// Where a pixel's surface is, along axes of the picture and in metres up to a factor for each.
vec3 bmfr_position(ivec2 at) {
    LET_REF(RealtimeConstants) c = load_realtime();
    float depth = load_depth(at);
    float spread = load_camera().kind == CAMERA_ORTHOGRAPHIC ? 1.0f : depth;
    return vec3((float(at.x) / float(c.size.x) - 0.5f) * spread,
                (float(at.y) / float(c.size.y) - 0.5f) * spread, depth);
}

BmfrBlock bmfr_block(ivec2 block) {
    uint at = hash_u32(load_realtime().frame_index);
    BmfrBlock b;
    b.first = block * BMFR_BLOCK - ivec2(int(at & 31u), int((at >> 5u) & 31u));
    b.least = vec3(DEPTH_NONE);
    vec3 most = vec3(-DEPTH_NONE);
    b.lit = 0u;
    for (int i = 0; i < BMFR_BLOCK * BMFR_BLOCK; ++i) {
        ivec2 pixel = b.first + ivec2(i % BMFR_BLOCK, i / BMFR_BLOCK);
        if (!bmfr_pixel_counts(pixel)) { continue; }
        vec3 position = bmfr_position(pixel);
        b.least = min(b.least, position);
        most = max(most, position);
        b.lit += 1u;
    }
    b.scale = vec3(1.0f) / max(most - b.least, vec3(1.0e-6f));
    return b;
}

// What the features of a pixel are made of.
struct BmfrPixel {
    vec3 normal;
    vec3 place;   // in the block's box: 0..1
};

BmfrPixel bmfr_pixel(IN(BmfrBlock) b, ivec2 at) {
    BmfrPixel p;
    p.normal = octahedral_decode(load_normal(at));
    p.place = (bmfr_position(at) - b.least) * b.scale;
    return p;
}

// [Koskela et al. 2019, section 3.3]
float bmfr_feature(IN(BmfrPixel) p, int i) {
    if (i == 0) { return 1.0f; }
    if (i < 4) { return p.normal[i - 1]; }
    float along = p.place[(i - 4) % 3];
    return i < 7 ? along : along * along;
}

// A row of a block's pixels into the lower part of the system. Those without surface become zeros,
// which are no equations.
void bmfr_add_row(INOUT(BmfrSystem) s, IN(BmfrBlock) b, int row) {
    for (int i = 0; i < BMFR_BLOCK; ++i) {
        ivec2 at = b.first + ivec2(i, row);
        int to = BMFR_FEATURES + i;
        if (!bmfr_pixel_counts(at)) {
            for (int column = 0; column < BMFR_COLUMNS; ++column) {
                s.m[column * BMFR_ROWS + to] = 0.0f;
            }
            continue;
        }
        BmfrPixel p = bmfr_pixel(b, at);
        for (int f = 0; f < BMFR_FEATURES; ++f) { s.m[f * BMFR_ROWS + to] = bmfr_feature(p, f); }
        vec4 diffuse = load_direct(at);
        vec4 specular = load_specular(at);
        for (int k = 0; k < 3; ++k) {
            s.m[(BMFR_FEATURES + k) * BMFR_ROWS + to] = diffuse[k];
            s.m[(BMFR_FEATURES + 3 + k) * BMFR_ROWS + to] = specular[k];
        }
    }
}

// Reflects the lower part of each feature's column into the triangle.
// [Householder 1958, "Unitary Triangularization of a Nonsymmetric Matrix"]
void bmfr_triangulate(INOUT(BmfrSystem) s) {
    for (int f = 0; f < BMFR_FEATURES; ++f) {
        int own = f * BMFR_ROWS;
        float below = 0.0f;
        for (int i = BMFR_FEATURES; i < BMFR_ROWS; ++i) { below += s.m[own + i] * s.m[own + i]; }
        if (!(below > 0.0f)) { continue; }
        float pivot = s.m[own + f];
        float reflected = (pivot > 0.0f ? -1.0f : 1.0f) * sqrt(pivot * pivot + below);
        float first = pivot - reflected;
        float scale = 2.0f / (first * first + below);
        for (int column = f + 1; column < BMFR_COLUMNS; ++column) {
            int other = column * BMFR_ROWS;
            float along = first * s.m[other + f];
            for (int i = BMFR_FEATURES; i < BMFR_ROWS; ++i) {
                along += s.m[own + i] * s.m[other + i];
            }
            along *= scale;
            s.m[other + f] -= along * first;
            for (int i = BMFR_FEATURES; i < BMFR_ROWS; ++i) {
                s.m[other + i] -= along * s.m[own + i];
            }
        }
        s.m[own + f] = reflected;
    }
}

// The weights of the features, for each output in its column, below the triangle.
void bmfr_solve(INOUT(BmfrSystem) s) {
    for (int column = BMFR_FEATURES; column < BMFR_COLUMNS; ++column) {
        int out_of = column * BMFR_ROWS;
        for (int f = BMFR_FEATURES - 1; f >= 0; --f) {
            float rest = s.m[out_of + f];
            for (int k = f + 1; k < BMFR_FEATURES; ++k) {
                rest -= s.m[k * BMFR_ROWS + f] * s.m[out_of + BMFR_FEATURES + k];
            }
            float pivot = s.m[f * BMFR_ROWS + f];
            s.m[out_of + BMFR_FEATURES + f] = pivot != 0.0f ? rest / pivot : 0.0f;
        }
    }
}

// What the features say of a pixel; light is never negative. `first`: of three outputs.
vec3 bmfr_light(IN(BmfrSystem) s, IN(BmfrPixel) p, int first) {
    vec3 light = vec3(0.0f);
    for (int f = 0; f < BMFR_FEATURES; ++f) {
        float feature = bmfr_feature(p, f);
        for (int k = 0; k < 3; ++k) {
            int weights = (BMFR_FEATURES + first + k) * BMFR_ROWS + BMFR_FEATURES;
            light[k] += feature * s.m[weights + f];
        }
    }
    return max(light, vec3(0.0f));
}

// The means over frames become what the next frame goes on from, what fits them takes their place.
void bmfr_fit(ivec2 block, int) {
    BmfrBlock b = bmfr_block(block);
    BmfrSystem s;
    for (int i = 0; i < BMFR_COLUMNS * BMFR_ROWS; ++i) { s.m[i] = 0.0f; }
    for (int f = 1; f < BMFR_FEATURES; ++f) { s.m[f * BMFR_ROWS + f] = BMFR_RIDGE; }
    for (int row = 0; row < BMFR_BLOCK && b.lit != 0u; ++row) {
        bmfr_add_row(s, b, row);
        bmfr_triangulate(s);
    }
    bmfr_solve(s);
    for (int i = 0; i < BMFR_BLOCK * BMFR_BLOCK; ++i) {
        ivec2 at = b.first + ivec2(i % BMFR_BLOCK, i / BMFR_BLOCK);
        if (!pixel_is_inside(at, load_realtime().size)) { continue; }
        store_direct_history(at, load_direct(at));
        store_specular_history(at, load_specular(at));
        if (!bmfr_pixel_counts(at)) { continue; }
        BmfrPixel p = bmfr_pixel(b, at);
        store_direct(at, vec4(bmfr_light(s, p, 0), 0.0f));
        store_specular(at, vec4(bmfr_light(s, p, 3), 0.0f));
    }
}

#endif
