/* What is drawn into the traced picture: flames with a glow around them, sparks of the broken tube,
 * dust in the light of the door. All of it adds light, in the order of the calls. */
#include "game.h"

#include <math.h>

static void additive(GpDrawDesc* how, GpTexture texture, float r, float g, float b) {
    how->texture = texture;
    how->blend = 1;
    how->blendSource = GP_BLEND_SRC_ALPHA, how->blendDestination = GP_BLEND_ONE;
    how->given = GP_GIVEN_DRAW_COLOR;
    how->color[0] = r, how->color[1] = g, how->color[2] = b, how->color[3] = 1;
}

static void drawFlames(Game* game, GpFrame frame, double seconds) {
    const Player* p = &game->player;
    GpDrawDesc flame = {0}, halo = {0};
    int i;
    gpBegin(game->im, GP_QUADS);
    for (i = 0; i < TORCH_COUNT; ++i) {
        const int bowl = i >= TORCH_COUNT - BOWL_COUNT;
        const float size = bowl ? 2.3f : 1, power = flicker(seconds, 400 + 20 * i);
        const int column = ((int)(seconds * 16) + 3 * i) % FLAME_FRAMES;
        const float high = size * (0.21f + 0.06f * power);
        /* Half a pixel in from its neighbours. */
        const float u0 = ((float)column + 0.015f) / FLAME_FRAMES, wide = 0.97f / FLAME_FRAMES;
        addSprite(game->im, plus(torchPosition(i), vec3(0, high - 0.14f * size, 0)),
                  times(p->right, 0.115f * size), vec3(0, high, 0), i % 2 ? u0 : u0 + wide,
                  i % 2 ? u0 + wide : u0);
    }
    gpEnd(game->im);
    additive(&flame, game->flames, 7, 5, 4);
    drawImmediate(game, frame, &flame);
    gpBegin(game->im, GP_QUADS);
    for (i = 0; i < TORCH_COUNT; ++i) {
        const float size = (i >= TORCH_COUNT - BOWL_COUNT ? 1.3f : 0.75f) *
                           (0.9f + 0.2f * flicker(seconds, 400 + 20 * i));
        addSprite(game->im, plus(torchPosition(i), plus(vec3(0, 0.08f, 0), times(p->back, 0.15f))),
                  times(p->right, size), times(p->up, size), 0, 1);
    }
    gpEnd(game->im);
    additive(&halo, game->glow, 0.34f, 0.14f, 0.035f);
    drawImmediate(game, frame, &halo);
}

/* They spring from the tube's lower end and fall; each lives for 0.7 s. */
static void drawSparks(Game* game, GpFrame frame, double seconds) {
    const Player* p = &game->player;
    GpDrawDesc how = {0};
    int i, count = 0;
    gpBegin(game->im, GP_QUADS);
    for (i = 0; i < 24; ++i) {
        const double birth = 0.7 * (double)i / 24;
        const float age = (float)fmod(seconds + birth, 0.7);
        const int life = (int)((seconds + birth) / 0.7);
        const float vx = 1.6f * (hash(i, life, 800) - 0.5f);
        const float vz = 1.6f * (hash(i, life, 801) - 0.5f);
        const Vec3 at = vec3(4.75f + vx * age, 2.85f + 0.9f * age * hash(i, life, 802) -
                             4.9f * age * age, -5.27f + vz * age);
        const float size = 0.012f * (1 - age / 0.7f);
        if (hash(0, life, 803) < 0.55f) continue; /* the contact is not loose all the time */
        addSprite(game->im, at, times(p->right, size), times(p->up, size), 0, 1);
        ++count;
    }
    gpEnd(game->im);
    additive(&how, game->glow, 40, 22, 8);
    if (count > 0) drawImmediate(game, frame, &how);
}

/* Motes in the beam that falls through the door, as bright as the door is open. */
static void drawDust(Game* game, GpFrame frame, double seconds) {
    const Player* p = &game->player;
    const float t = (float)seconds, light = 1.3f * doorOpening(seconds);
    GpDrawDesc how = {0};
    int i;
    gpBegin(game->im, GP_QUADS);
    for (i = 0; i < 90; ++i) {
        const float deep = 4 * hash(i, 0, 820);
        const float left = 2 * (hash(i, 1, 820) - 0.5f) + 0.1f * sinf(t + (float)i);
        const float high = 2.3f * hash(i, 2, 820) + 0.05f * sinf(0.7f * t + (float)i);
        /* The beam sinks and turns aside as the sun in lights.c has it. */
        const Vec3 at = vec3(left - 0.43f * deep, high - 0.63f * deep, -13 + deep);
        if (at.y < 0.05f || fabsf(at.x) > 1.5f) continue;
        addSprite(game->im, at, times(p->right, 0.009f), times(p->up, 0.009f), 0, 1);
    }
    gpEnd(game->im);
    additive(&how, game->glow, light, light, 0.9f * light);
    drawImmediate(game, frame, &how);
}

void drawEffects(Game* game, GpFrame frame, double seconds) {
    drawFlames(game, frame, seconds);
    drawSparks(game, frame, seconds);
    drawDust(game, frame, seconds);
}
