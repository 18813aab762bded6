/* What moves: the two leaves of the door, shards that turn until they are picked up, and a beacon
 * that flashes while the door does. */
#include "game.h"

#include <math.h>

#define DOOR_STARTS 5.9 /* seconds; the player is near then */
#define DOOR_TAKES 1.5

static const Vec3 pickupPlaces[PICKUP_COUNT] = {
    {4.5f, 1.25f, -5.25f}, {0.1f, 1.0f, -10.9f}, {-2.6f, 1.0f, -19.4f}};

float doorOpening(double seconds) {
    return smoothStep(0, 1, (float)((seconds - DOOR_STARTS) / DOOR_TAKES));
}

/* Three rows of four, from the axes of a thing and its place. */
static void transformFrom(float* m, Vec3 x, Vec3 y, Vec3 z, Vec3 at) {
    const float rows[12] = {x.x, y.x, z.x, at.x, x.y, y.y, z.y, at.y, x.z, y.z, z.z, at.z};
    int i;
    for (i = 0; i < 12; ++i) m[i] = rows[i];
}

/* A crystal: two pyramids of six sides. */
static void addShard(GpImmediate im) {
    enum { SIDES = 6 };
    int i, end;
    for (end = -1; end <= 1; end += 2) {
        gpBegin(im, GP_TRIANGLE_FAN);
        gpVertex3f(im, 0, 0.24f * (float)end, 0);
        for (i = 0; i <= SIDES; ++i) {
            const float angle = 2 * PI * (float)(i * end) / SIDES;
            gpVertex3f(im, 0.12f * cosf(angle), 0, -0.12f * sinf(angle));
        }
        gpEnd(im);
    }
}

static void addLeaf(GpImmediate im, int side) {
    /* u runs from the middle outwards, on both leaves and both faces. */
    const float outer = side ? 1.15f : -1.15f, front = -13.14f, back = -13.26f;
    const float at[4][2] = {{0, 2.55f}, {0, 0}, {1, 0}, {1, 2.55f}};
    int k, face;
    gpBegin(im, GP_QUADS);
    for (face = 0; face < 2; ++face)
        for (k = 0; k < 4; ++k) {
            gpTexCoord2f(im, at[k][0], at[k][1] > 0 ? 0 : 1);
            gpVertex3f(im, at[k][0] * outer, at[k][1], face ? back : front);
        }
    for (k = 0; k < 4; ++k) { /* the edge where they meet */
        gpTexCoord2f(im, 0.1f, at[k][1] > 0 ? 0 : 1);
        gpVertex3f(im, 0, at[k][1], at[k][0] > 0 ? back : front);
    }
    gpEnd(im);
}

void makeThings(Game* game) {
    int i;
    for (i = 0; i < 2; ++i) {
        addLeaf(game->im, i);
        game->doors[i] = placeMesh(game, GP_MESH_MOVABLE, DOOR, ID_DOOR + (uint64_t)i,
                                   GP_VISIBILITY_WORLD);
    }
    for (i = 0; i < PICKUP_COUNT; ++i) {
        addShard(game->im);
        game->pickups[i] = placeMesh(game, GP_MESH_MOVABLE, GOLD, ID_PICKUP + (uint64_t)i,
                                     GP_VISIBILITY_WORLD);
    }
    addBox(game->im, vec3(-0.22f, 2.56f, -12.92f), vec3(0.22f, 2.7f, -12.82f), 0.03f, 0);
    {
        GpInstance beacon =
            placeMesh(game, GP_MESH_STATIC, BEACON_OFF, ID_BEACON, GP_VISIBILITY_WORLD);
        gpSetInstanceMaterial(beacon, game->beacon);
        gpReleaseInstance(beacon);
    }
    game->player.pickedUp = -1;
}

static void movePickup(Game* game, int i, double seconds) {
    const Vec3 place = pickupPlaces[i];
    const float turn = 2.2f * (float)seconds, c = cosf(turn), s = sinf(turn);
    const Vec3 at = plus(place, vec3(0, 0.07f * sinf(2.6f * (float)seconds), 0));
    float m[12];
    transformFrom(m, vec3(c, 0, -s), vec3(0.2f * s, 0.98f, 0.2f * c), vec3(s, 0, c), at);
    gpSetInstanceTransform(game->pickups[i], m);
    if (hypotf(game->player.eye.x - place.x, game->player.eye.z - place.z) > 0.9f) return;
    gpRemoveInstance(game->pickups[i]);
    game->pickups[i] = NULL;
    ++game->player.shards;
    game->player.pickedUp = seconds;
}

void moveThings(Game* game, double seconds) {
    const float open = 1.08f * doorOpening(seconds);
    const int moves = open > 0 && open < 1.08f;
    float m[12];
    int i;
    for (i = 0; i < 2; ++i) {
        transformFrom(m, vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(i ? open : -open, 0, 0));
        gpSetInstanceTransform(game->doors[i], m);
    }
    for (i = 0; i < PICKUP_COUNT; ++i)
        if (game->pickups[i]) movePickup(game, i, seconds);
    gpSetMaterialFrame(game->beacon, moves && fmod(seconds, 0.4) < 0.2);
}
