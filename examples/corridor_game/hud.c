/* The display of a game: drawn over the finished picture, in a space of its own that is 270 high
 * whatever the picture's size. */
#include "game.h"

#include <stdio.h>
#include <string.h>

#define HIGH 270.0f

static const char glyphs[] = "0123456789ADEGHLORST+";
static const unsigned char dots[sizeof glyphs - 1][7] = {
    {14, 17, 19, 21, 25, 17, 14}, {4, 12, 4, 4, 4, 4, 14},      {14, 17, 1, 2, 4, 8, 31},
    {31, 2, 4, 2, 1, 17, 14},     {2, 6, 10, 18, 31, 2, 2},     {31, 16, 30, 1, 1, 17, 14},
    {6, 8, 16, 30, 17, 17, 14},   {31, 1, 2, 4, 8, 8, 8},       {14, 17, 17, 14, 17, 17, 14},
    {14, 17, 17, 15, 1, 2, 12},   {14, 17, 17, 31, 17, 17, 17}, {30, 17, 17, 17, 17, 17, 30},
    {31, 16, 16, 30, 16, 16, 31}, {14, 17, 16, 23, 17, 17, 15}, {17, 17, 17, 31, 17, 17, 17},
    {16, 16, 16, 16, 16, 16, 31}, {14, 17, 17, 17, 17, 17, 14}, {30, 17, 17, 30, 20, 18, 17},
    {15, 16, 16, 14, 1, 1, 30},   {31, 4, 4, 4, 4, 4, 4},       {0, 4, 4, 31, 4, 4, 0}};

static void rectangle(GpImmediate im, float x, float y, float width, float height) {
    addSprite(im, vec3(x + 0.5f * width, y + 0.5f * height, 0), vec3(0.5f * width, 0, 0),
              vec3(0, -0.5f * height, 0), 0, 1);
}

/* Each dot `dot` units wide; letters that there are no dots for stay blank. */
static void text(GpImmediate im, const char* words, float x, float y, float dot) {
    const float count = (float)(sizeof glyphs - 1);
    for (; *words; ++words, x += 6 * dot) {
        const char* glyph = strchr(glyphs, *words);
        if (glyph) {
            const float column = (float)(glyph - glyphs);
            addSprite(im, vec3(x + 4 * dot, y + 4 * dot, 0), vec3(4 * dot, 0, 0),
                      vec3(0, -4 * dot, 0), column / count, (column + 1) / count);
        }
    }
}

/* A draw into that space, x to the right and y down from the upper left corner, blended. */
static GpDrawDesc flat(const Game* game, GpTexture texture) {
    GpDrawDesc how = {0};
    const float wide = HIGH * (float)game->width / (float)game->height;
    how.target = GP_DRAW_OVERLAY;
    how.view = GP_VIEW_MATRIX;
    how.viewProjection[0] = 2 / wide, how.viewProjection[3] = -1;
    how.viewProjection[5] = -2 / HIGH, how.viewProjection[7] = 1;
    how.viewProjection[10] = how.viewProjection[15] = 1;
    how.texture = texture;
    how.blend = 1;
    return how;
}

static void drawPanels(Game* game, GpFrame frame, float wide) {
    GpImmediate im = game->im;
    GpDrawDesc how = flat(game, NULL);
    int i;
    gpBegin(im, GP_QUADS);
    gpColor4f(im, 0.04f, 0.03f, 0.03f, 0.55f);
    rectangle(im, 8, HIGH - 34, 116, 26);
    rectangle(im, wide - 92, HIGH - 34, 84, 26);
    for (i = 0; i < 10; ++i) { /* health, in ten pieces */
        const int there = i < 9;
        gpColor4f(im, there ? 0.80f : 0.20f, there ? 0.16f : 0.10f, 0.08f, there ? 0.95f : 0.6f);
        rectangle(im, 64 + 5.5f * (float)i, HIGH - 27, 4.5f, 12);
    }
    gpColor4f(im, 0.95f, 0.95f, 0.9f, 0.75f); /* the crosshair */
    rectangle(im, 0.5f * wide - 6, 0.5f * HIGH - 0.5f, 4, 1);
    rectangle(im, 0.5f * wide + 2, 0.5f * HIGH - 0.5f, 4, 1);
    rectangle(im, 0.5f * wide - 0.5f, 0.5f * HIGH - 6, 1, 4);
    rectangle(im, 0.5f * wide - 0.5f, 0.5f * HIGH + 2, 1, 4);
    gpColor4f(im, 1, 1, 1, 1);
    gpEnd(im);
    drawImmediate(game, frame, &how);
}

void drawHud(Game* game, GpFrame frame, double seconds) {
    const float wide = HIGH * (float)game->width / (float)game->height;
    const double since = seconds - game->player.pickedUp;
    const int flash = game->player.pickedUp >= 0 && since < 1.6;
    GpDrawDesc how = flat(game, game->font);
    char count[16];
    drawPanels(game, frame, wide);
    if (flash) { /* something was picked up */
        GpDrawDesc over = flat(game, NULL);
        gpBegin(game->im, GP_QUADS);
        rectangle(game->im, 0, 0, wide, HIGH);
        gpEnd(game->im);
        over.color[0] = 1, over.color[1] = 0.75f, over.color[2] = 0.25f;
        over.color[3] = 0.22f * (1 - smoothStep(0, 0.5f, (float)since));
        drawImmediate(game, frame, &over);
    }
    gpBegin(game->im, GP_QUADS);
    gpColor4f(game->im, 0.95f, 0.85f, 0.65f, 1);
    text(game->im, "+87", 14, HIGH - 30, 2.4f);
    snprintf(count, sizeof count, "%d", game->player.shards);
    text(game->im, "SHARDS", wide - 84, HIGH - 25, 1.3f);
    text(game->im, count, wide - 27, HIGH - 30, 2.4f);
    if (flash) { /* with a shadow, to be read against any background */
        gpColor4f(game->im, 0, 0, 0, 0.8f);
        text(game->im, "GOT A GOLD SHARD", 0.5f * wide - 71, 0.3f * HIGH + 1, 1.5f);
        gpColor4f(game->im, 1, 0.9f, 0.6f, 1);
        text(game->im, "GOT A GOLD SHARD", 0.5f * wide - 72, 0.3f * HIGH, 1.5f);
    }
    gpColor4f(game->im, 1, 1, 1, 1);
    gpEnd(game->im);
    how.color[0] = how.color[1] = how.color[2] = how.color[3] = 1;
    drawImmediate(game, frame, &how);
}

void makeHud(Game* game) { game->font = newFont(game, dots[0], (int)sizeof glyphs - 1); }
