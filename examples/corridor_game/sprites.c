/* Textures of what is drawn and not traced: flames, glows, clouds, letters. */
#include "game.h"

#include <math.h>
#include <stdlib.h>

static GpTexture newTexture(Game* game, int width, int height, const unsigned char* rgba,
                            GpWrap wrap, GpFilter filter) {
    GpTextureDesc desc = {0};
    desc.width = (uint32_t)width, desc.height = (uint32_t)height;
    desc.pixels = rgba;
    desc.wrapU = desc.wrapV = wrap;
    desc.magFilter = desc.minFilter = filter;
    desc.noMipmaps = filter == GP_FILTER_NEAREST;
    return gpNewTexture(game->device, &desc);
}

static void set(unsigned char* pixel, float r, float g, float b, float a) {
    const float rgba[4] = {r, g, b, a};
    int c;
    for (c = 0; c < 4; ++c) pixel[c] = (unsigned char)(255 * fminf(fmaxf(rgba[c], 0), 1) + 0.5f);
}

/* A tongue of fire, drawn out upwards, in eight frames that follow each other in a circle. */
static void flamePixel(unsigned char* pixel, float u, float v, int frame) {
    const float up = 1 - v, around = (float)frame / FLAME_FRAMES;
    const float bend = 0.20f * up * (cloudNoise(0.5f * u, v + around, 4, 3, 700) - 0.5f);
    const float x = 2 * fabsf(u - 0.5f - bend);
    const float lick = cloudNoise(u, v + around, 6, 3, 710);
    const float width = 0.78f * powf(fmaxf(1 - up, 0), 0.8f) * smoothStep(0, 0.16f, up + 0.02f);
    const float heat = smoothStep(0, 0.55f, width - x + 0.42f * (lick - 0.55f)) *
                       smoothStep(0, 0.05f, v);
    set(pixel, 1.25f * heat, heat * heat * 0.95f, heat * heat * heat * heat * 0.6f, heat);
}

static GpTexture flames(Game* game) {
    enum { WIDTH = 32, HEIGHT = 64, ROW = WIDTH * FLAME_FRAMES };
    unsigned char* rgba = malloc(ROW * HEIGHT * 4);
    GpTexture texture = NULL;
    int x, y;
    if (!rgba) return NULL;
    for (y = 0; y < HEIGHT; ++y)
        for (x = 0; x < ROW; ++x)
            flamePixel(rgba + 4 * (y * ROW + x), ((float)(x % WIDTH) + 0.5f) / WIDTH,
                       ((float)y + 0.5f) / HEIGHT, x / WIDTH);
    texture = newTexture(game, ROW, HEIGHT, rgba, GP_WRAP_CLAMP, GP_FILTER_LINEAR);
    free(rgba);
    return texture;
}

static GpTexture glow(Game* game) {
    enum { SIZE = 64 };
    unsigned char rgba[SIZE * SIZE * 4];
    int x, y;
    for (y = 0; y < SIZE; ++y)
        for (x = 0; x < SIZE; ++x) {
            const float dx = 2 * ((float)x + 0.5f) / SIZE - 1;
            const float dy = 2 * ((float)y + 0.5f) / SIZE - 1;
            const float fall = fmaxf(1 - sqrtf(dx * dx + dy * dy), 0);
            const float light = fall * fall * fall;
            set(rgba + 4 * (y * SIZE + x), light, light, light, light);
        }
    return newTexture(game, SIZE, SIZE, rgba, GP_WRAP_CLAMP, GP_FILTER_LINEAR);
}

/* White where the sun gets through, grey where clouds are thick. */
static GpTexture clouds(Game* game) {
    enum { SIZE = 256 };
    unsigned char* rgba = malloc(SIZE * SIZE * 4);
    GpTexture texture;
    int x, y;
    if (!rgba) return NULL;
    for (y = 0; y < SIZE; ++y)
        for (x = 0; x < SIZE; ++x) {
            const float u = ((float)x + 0.5f) / SIZE, v = ((float)y + 0.5f) / SIZE;
            const float thick = cloudThickness(u, v);
            const float light = mixed(1, 0.62f, smoothStep(0.35f, 1, thick));
            set(rgba + 4 * (y * SIZE + x), light, light, mixed(light, 1, 0.12f), thick);
        }
    texture = newTexture(game, SIZE, SIZE, rgba, GP_WRAP_REPEAT, GP_FILTER_LINEAR);
    free(rgba);
    return texture;
}

float cloudThickness(float u, float v) {
    return smoothStep(0.47f, 0.72f, cloudNoise(u, v, 4, 6, 740));
}

/* Letters of 5 by 7 dots, seven bytes each with the left dot in bit 4, in cells of 8 by 8. */
GpTexture newFont(Game* game, const unsigned char* dots, int count) {
    unsigned char* rgba = calloc((size_t)(8 * 8 * count), 4);
    GpTexture texture;
    int i, x, y;
    if (!rgba) return NULL;
    for (i = 0; i < count; ++i)
        for (y = 0; y < 7; ++y)
            for (x = 0; x < 5; ++x)
                if (dots[7 * i + y] >> (4 - x) & 1)
                    set(rgba + 4 * (y * 8 * count + 8 * i + x), 1, 1, 1, 1);
    texture = newTexture(game, 8 * count, 8, rgba, GP_WRAP_CLAMP, GP_FILTER_NEAREST);
    free(rgba);
    return texture;
}

void makeSprites(Game* game) {
    game->flames = flames(game);
    game->glow = glow(game);
    game->clouds = clouds(game);
}
