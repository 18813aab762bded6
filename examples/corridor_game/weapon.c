/* What the player holds. It moves with the camera, and only the camera sees it. */
#include "game.h"

#include <math.h>

/* Right, up and back of the eye, metres. */
static const Vec3 grip = {0.20f, -0.21f, -0.42f};

static void addParts(GpImmediate im, SurfaceName surface) {
    int i;
    switch (surface) {
    case IRON: /* the barrel, and a mouth that widens */
        addTube(im, vec3(0, 0.03f, 0.05f), vec3(0, 0.03f, -0.42f), 0.026f, 0.022f);
        addTube(im, vec3(0, 0.03f, -0.42f), vec3(0, 0.03f, -0.47f), 0.022f, 0.036f);
        addTube(im, vec3(0, 0.03f, -0.47f), vec3(0, 0.03f, -0.40f), 0.032f, 0.012f);
        break;
    case BRASS: /* rings around it */
        for (i = 0; i < 4; ++i) {
            const float z = -0.08f - 0.085f * (float)i, radius = 0.040f - 0.003f * (float)i;
            addTube(im, vec3(0, 0.03f, z + 0.012f), vec3(0, 0.03f, z), 0.024f, radius);
            addTube(im, vec3(0, 0.03f, z), vec3(0, 0.03f, z - 0.012f), radius, 0.024f);
        }
        addTube(im, vec3(-0.034f, 0.004f, 0.04f), vec3(-0.034f, 0.004f, -0.34f), 0.007f, 0.007f);
        addTube(im, vec3(0.034f, 0.004f, 0.04f), vec3(0.034f, 0.004f, -0.34f), 0.007f, 0.007f);
        break;
    case CELL: /* what it shoots with */
        addTube(im, vec3(0, 0.062f, 0.03f), vec3(0, 0.062f, -0.055f), 0.013f, 0.013f);
        break;
    default: /* the stock */
        addBox(im, vec3(-0.028f, -0.035f, -0.06f), vec3(0.028f, 0.016f, 0.12f), 0.008f, 0.12f);
        addBox(im, vec3(-0.022f, -0.16f, 0.03f), vec3(0.022f, -0.03f, 0.085f), -0.004f, 0.12f);
        break;
    }
}

void makeWeapon(Game* game) {
    static const SurfaceName parts[WEAPON_PARTS] = {IRON, BRASS, CELL, PLANKS};
    int i;
    for (i = 0; i < WEAPON_PARTS; ++i) {
        addParts(game->im, parts[i]);
        game->weapon[i] = placeMesh(game, GP_MESH_MOVABLE, parts[i], ID_WEAPON + (uint64_t)i,
                                    GP_VISIBILITY_FIRST_PERSON);
    }
}

void moveWeapon(Game* game, double seconds) {
    const Player* p = &game->player;
    /* It swings once in two steps of 0.75 m. */
    const float swing = sinf(PI * p->walked / 0.75f), lift = fabsf(swing);
    const float breath = 0.003f * sinf(1.7f * (float)seconds);
    const Vec3 off = plus(grip, vec3(0.010f * swing, -0.007f * lift + breath, 0));
    const Vec3 at = plus(p->eye, plus(times(p->right, off.x),
                                      plus(times(p->up, off.y), times(p->back, off.z))));
    const float m[12] = {p->right.x, p->up.x, p->back.x, at.x, p->right.y, p->up.y,
                         p->back.y,  at.y,    p->right.z, p->up.z, p->back.z, at.z};
    int i;
    for (i = 0; i < WEAPON_PARTS; ++i) gpSetInstanceTransform(game->weapon[i], m);
}
