/* What walls, floors and ceilings look like close by. All patterns repeat. */
#include "game.h"

#include <math.h>

static Texel texel(float r, float g, float b, float height, float roughness) {
    Texel t = {{0, 0, 0}, 1, 0, 1, 0};
    t.color[0] = r, t.color[1] = g, t.color[2] = b;
    t.height = height, t.roughness = roughness;
    return t;
}

static void shade(Texel* t, float factor) {
    int c;
    for (c = 0; c < 3; ++c) t->color[c] *= factor;
}

static void blend(Texel* t, Texel over, float share) {
    int c;
    for (c = 0; c < 3; ++c) t->color[c] = mixed(t->color[c], over.color[c], share);
    t->height = mixed(t->height, over.height, share);
    t->roughness = mixed(t->roughness, over.roughness, share);
    t->metallic = mixed(t->metallic, over.metallic, share);
}

/* How far (u, v) is from the edge of its cell, as a share of the cell, for cells of `columns` by
 * `rows` whose odd rows are shifted by half a cell; writes which cell it is. */
static float cellEdge(float u, float v, int columns, int rows, float shift, int* column, int* row,
                      float aspect) {
    float x, y;
    *row = (int)(v * (float)rows);
    x = u * (float)columns + (*row % 2 ? shift : 0);
    *column = (int)x % columns;
    x -= floorf(x);
    y = v * (float)rows - (float)*row;
    return fminf(fminf(x, 1 - x) * aspect, fminf(y, 1 - y));
}

/* Four bricks by eight rows. */
Texel bricks(float u, float v) {
    int column, row;
    const float rough = cloudNoise(u, v, 16, 4, 11);
    const float edge = cellEdge(u, v, 4, 8, 0.5f, &column, &row, 2) + 0.05f * (rough - 0.5f);
    const float own = hash(column, row, 3), burnt = smoothStep(0.75f, 1, hash(column, row, 5));
    const float inside = smoothStep(0.055f, 0.12f, edge);
    Texel brick = texel(0.34f + 0.10f * own, 0.165f + 0.05f * own, 0.115f, 0.011f, 0.85f);
    Texel joint = texel(0.30f, 0.28f, 0.25f, 0, 0.95f);
    shade(&brick, mixed(1, 0.45f, burnt) * (0.65f + 0.7f * rough));
    shade(&joint, 0.55f + 0.7f * rough);
    brick.height += 0.003f * rough + 0.003f * own;
    blend(&joint, brick, inside);
    /* Water has run down here and there. */
    blend(&joint, texel(0.05f, 0.05f, 0.045f, joint.height, 0.5f),
          0.5f * smoothStep(0.55f, 0.8f, cloudNoise(u, 0.2f * v, 10, 3, 41)));
    return joint;
}

/* Two by two plates of metal, with rivets and rust. */
Texel plates(float u, float v) {
    int column, row;
    const float edge = cellEdge(u, v, 2, 2, 0, &column, &row, 1);
    const float x = 2 * u - (float)(int)(2 * u), y = 2 * v - (float)(int)(2 * v);
    /* Six rivets along each side. */
    const float along = x < 0.09f || x > 0.91f ? y : x;
    const float at = 6 * along - floorf(6 * along) - 0.5f;
    const float across = edge - 0.06f;
    const float rivet = sqrtf(across * across + at * at / 36);
    const float dirt = cloudNoise(u, v, 6, 6, 60);
    const float wet = cloudNoise(u, 0.3f * v, 14, 4, 80);
    const float rust = smoothStep(0.52f, 0.66f, dirt + 0.25f * (wet - 0.5f) +
                                                   0.12f * smoothStep(0.1f, 0, edge));
    Texel metal = texel(0.42f, 0.43f, 0.45f, 0.004f, 0.30f + 0.25f * dirt);
    Texel rusty = texel(0.26f, 0.10f, 0.035f, 0.005f, 0.92f);
    metal.metallic = 1;
    shade(&metal, 0.8f + 0.3f * hash(column, row, 9));
    shade(&rusty, 0.5f + 0.9f * cloudNoise(u, v, 32, 3, 90));
    metal.height -= 0.006f * smoothStep(0.02f, 0.005f, edge);
    blend(&metal, rusty, rust);
    metal.height += 0.006f * smoothStep(0.022f, 0.012f, rivet);
    return metal;
}

/* Four by four slates, worn smooth in the middle. */
Texel tiles(float u, float v) {
    int column, row;
    const float edge = cellEdge(u, v, 4, 4, 0, &column, &row, 1);
    const float grain = cloudNoise(u, v, 8, 5, 120), own = hash(column, row, 13);
    Texel slate = texel(0.15f, 0.16f, 0.17f, 0.004f, 0.16f + 0.45f * grain);
    Texel joint = texel(0.06f, 0.055f, 0.05f, 0, 0.95f);
    shade(&slate, 0.55f + 0.8f * grain);
    shade(&slate, 0.75f + 0.5f * own);
    if ((column + row) % 2) slate.color[0] *= 1.25f, slate.color[1] *= 1.05f;
    slate.height += 0.0008f * grain + 0.002f * own * (u + v);
    blend(&joint, slate, smoothStep(0.02f, 0.05f, edge));
    return joint;
}

/* Poured between boards. */
Texel concrete(float u, float v) {
    const float grain = cloudNoise(u, v, 8, 6, 140), stain = cloudNoise(u, v, 3, 4, 150);
    const float board = 5 * v - floorf(5 * v);
    Texel t = texel(0.34f, 0.33f, 0.31f, 0.004f * grain, 0.9f);
    shade(&t, 0.55f + 0.6f * grain);
    shade(&t, 0.55f + 0.65f * smoothStep(0.3f, 0.6f, stain));
    t.height += 0.003f * smoothStep(0, 0.06f, board) * smoothStep(1, 0.94f, board);
    return t;
}

/* Stones of a pavement: the cells of scattered points. Moss grows between them.
 * [Worley 1996, "A Cellular Texture Basis Function"] */
Texel cobbles(float u, float v) {
    enum { CELLS = 10 };
    const float px = u * CELLS, py = v * CELLS;
    const int cx = (int)px, cy = (int)py;
    float first = 9, second = 9, own = 0;
    int dx, dy;
    for (dy = -1; dy <= 1; ++dy)
        for (dx = -1; dx <= 1; ++dx) {
            const int x = (cx + dx + CELLS) % CELLS, y = (cy + dy + CELLS) % CELLS;
            const float ox = (float)(cx + dx) + 0.15f + 0.7f * hash(x, y, 21) - px;
            const float oy = (float)(cy + dy) + 0.15f + 0.7f * hash(x, y, 22) - py;
            const float d = sqrtf(ox * ox + oy * oy);
            second = fminf(second, fmaxf(d, first));
            if (d < first) first = d, own = hash(x, y, 23);
        }
    {
        const float edge = second - first, grain = cloudNoise(u, v, 16, 5, 160);
        const float moss = smoothStep(0.42f, 0.62f, cloudNoise(u, v, 4, 4, 170));
        Texel stoneTop = texel(0.30f, 0.29f, 0.28f, 0.02f, 0.75f);
        Texel between = texel(0.08f, 0.075f, 0.06f, 0, 0.95f);
        blend(&between, texel(0.05f, 0.09f, 0.025f, 0.008f, 0.95f), moss);
        shade(&stoneTop, (0.55f + 0.55f * own) * (0.6f + 0.7f * grain));
        stoneTop.height *= 0.75f + 0.25f * own;
        blend(&between, stoneTop, smoothStep(0.04f, 0.28f, edge));
        return between;
    }
}
