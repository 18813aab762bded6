/* From patterns to materials: colour, roughness and metal from what a pattern says, normal maps
 * from its heights. */
#include "game.h"

#include <math.h>
#include <stdlib.h>

typedef struct Surface {
    Pattern pattern;  /* NULL: plain, by the numbers that follow */
    float metres;     /* of a wall that one repeat covers; 0: the whole of a face */
    int pixels;       /* of the textures, along each side */
    float glow;       /* W/(m^2 sr) where the pattern's colour is 1; 0: it does not glow */
    int cutOut;       /* not 0: holes where alpha is below one half */
    float color[3], roughness, metallic, emission[3];
} Surface;

/* In the order of SurfaceName. */
static const Surface surfaces[SURFACE_COUNT] = {
    {bricks, 1.6f, 512, 0, 0, {0}, 0, 0, {0}},
    {plates, 2.0f, 512, 0, 0, {0}, 0, 0, {0}},
    {tiles, 2.4f, 512, 0, 0, {0}, 0, 0, {0}},
    {concrete, 2.5f, 256, 0, 0, {0}, 0, 0, {0}},
    {cobbles, 2.6f, 512, 0, 0, {0}, 0, 0, {0}},
    {planks, 0, 256, 0, 0, {0}, 0, 0, {0}},
    {stone, 1.8f, 256, 0, 0, {0}, 0, 0, {0}},
    {doorLeaf, 0, 256, 0, 0, {0}, 0, 0, {0}},
    {screen, 0, 128, 3, 0, {0}, 0, 0, {0}},
    {grate, 0.8f, 128, 0, 1, {0}, 0, 0, {0}},
    {grass, 0, 128, 0, 1, {0}, 0, 0, {0}},
    {window, 0, 64, 14, 0, {0}, 0, 0, {0}},
    {NULL, 0, 0, 0, 0, {0.50f, 0.53f, 0.55f}, 0, 1, {0}},               /* a puddle */
    {NULL, 0, 0, 0, 0, {0.85f, 0.58f, 0.24f}, 0.28f, 1, {0}},           /* brass */
    {NULL, 0, 0, 0, 0, {0.16f, 0.16f, 0.17f}, 0.38f, 1, {0}},           /* iron */
    {NULL, 0, 0, 0, 0, {0.02f, 0.05f, 0.04f}, 0.3f, 0, {0.1f, 1.6f, 1}},   /* the weapon's cell */
    {NULL, 0, 0, 0, 0, {1, 0.72f, 0.25f}, 0.16f, 1, {0.10f, 0.06f, 0}}, /* gold */
    {NULL, 0, 0, 0, 0, {0.25f, 0.12f, 0.02f}, 0.3f, 0, {0}},            /* a beacon, dark ... */
    {NULL, 0, 0, 0, 0, {0.25f, 0.12f, 0.02f}, 0.3f, 0, {14, 5.5f, 0.4f}}, /* ... and lit */
};

float metresOf(SurfaceName surface) { return surfaces[surface].metres; }

static unsigned char byteOf(float x) { return (unsigned char)(fminf(fmaxf(x, 0), 1) * 255 + 0.5f); }

/* [IEC 61966-2-1] */
static unsigned char encoded(float x) {
    x = fminf(fmaxf(x, 0), 1);
    return byteOf(x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1 / 2.4f) - 0.055f);
}

static GpTexture newTexture(GpDevice device, int pixels, const unsigned char* rgba, int isColor,
                            int repeats) {
    GpTextureDesc desc = {0};
    desc.width = desc.height = (uint32_t)pixels;
    desc.pixels = rgba;
    desc.colorSpace = isColor ? GP_COLOR_SRGB : GP_COLOR_LINEAR;
    desc.wrapU = desc.wrapV = repeats ? GP_WRAP_REPEAT : GP_WRAP_CLAMP;
    return gpNewTexture(device, &desc);
}

/* Colours, roughness and metal, and normals of one repeat. */
static void paint(const Surface* s, const Texel* texels, unsigned char* color,
                  unsigned char* metal, unsigned char* normal) {
    const int n = s->pixels;
    const float step = (s->metres > 0 ? s->metres : 1) / (float)n; /* metres from pixel to pixel */
    int x, y, c;
    for (y = 0; y < n; ++y)
        for (x = 0; x < n; ++x) {
            const int i = y * n + x;
            const Texel* t = texels + i;
            /* Slopes to the right and downwards; the map's Y is up. */
            const float right = texels[y * n + (x + 1) % n].height -
                                texels[y * n + (x + n - 1) % n].height;
            const float down = texels[(y + 1) % n * n + x].height -
                               texels[(y + n - 1) % n * n + x].height;
            const float sx = -right / (2 * step), sy = down / (2 * step);
            const float scale = 0.5f / sqrtf(sx * sx + sy * sy + 1);
            for (c = 0; c < 3; ++c) color[4 * i + c] = encoded(t->color[c]);
            color[4 * i + 3] = byteOf(t->alpha);
            metal[4 * i] = 0, metal[4 * i + 3] = 255;
            metal[4 * i + 1] = byteOf(fmaxf(t->roughness, 0.08f));
            metal[4 * i + 2] = byteOf(t->metallic);
            normal[4 * i] = byteOf(0.5f + sx * scale);
            normal[4 * i + 1] = byteOf(0.5f + sy * scale);
            normal[4 * i + 2] = byteOf(0.5f + scale);
            normal[4 * i + 3] = 255;
        }
}

/* NULL where memory is short. */
static GpMaterial patterned(GpDevice device, const Surface* s) {
    const size_t count = (size_t)s->pixels * (size_t)s->pixels;
    Texel* texels = malloc(count * sizeof *texels);
    unsigned char* bytes = malloc(count * 12);
    GpMaterial material = NULL;
    if (texels && bytes) {
        GpMaterialDesc desc = {0};
        size_t i;
        int c;
        for (i = 0; i < count; ++i)
            texels[i] = s->pattern(((float)(i % (size_t)s->pixels) + 0.5f) / (float)s->pixels,
                                   ((float)(i / (size_t)s->pixels) + 0.5f) / (float)s->pixels);
        paint(s, texels, bytes, bytes + 4 * count, bytes + 8 * count);
        desc.baseColorTexture.texture = newTexture(device, s->pixels, bytes, 1, s->metres > 0);
        desc.metallic = desc.roughness = 1;
        desc.metallicRoughnessTexture.texture =
            newTexture(device, s->pixels, bytes + 4 * count, 0, s->metres > 0);
        desc.normalTexture.texture =
            newTexture(device, s->pixels, bytes + 8 * count, 0, s->metres > 0);
        for (c = 0; c < 3; ++c) desc.emission[c] = s->glow;
        if (s->glow > 0) desc.emissionTexture = desc.baseColorTexture;
        desc.alphaMode = s->cutOut ? GP_ALPHA_MASK : GP_ALPHA_OPAQUE;
        material = gpNewMaterial(device, &desc);
        gpReleaseTexture(desc.baseColorTexture.texture);
        gpReleaseTexture(desc.metallicRoughnessTexture.texture);
        gpReleaseTexture(desc.normalTexture.texture);
    }
    free(texels);
    free(bytes);
    return material;
}

static GpMaterial plain(GpDevice device, const Surface* s) {
    GpMaterialDesc desc = {0};
    int c;
    desc.given = GP_GIVEN_ROUGHNESS; /* 0 is a mirror */
    desc.roughness = s->roughness, desc.metallic = s->metallic;
    for (c = 0; c < 3; ++c) {
        desc.baseColor[c] = s->color[c];
        desc.emission[c] = s->emission[c];
    }
    desc.baseColor[3] = 1;
    return gpNewMaterial(device, &desc);
}

void makeSurfaces(Game* game) {
    GpMaterial frames[2];
    int i;
    for (i = 0; i < SURFACE_COUNT; ++i)
        game->surfaces[i] = surfaces[i].pattern ? patterned(game->device, surfaces + i)
                                                : plain(game->device, surfaces + i);
    frames[0] = game->surfaces[BEACON_OFF], frames[1] = game->surfaces[BEACON_ON];
    game->beacon = gpNewAnimatedMaterial(game->device, frames, 2);
}
