/* The way of the player: keys, and a smooth curve through them. */
#include "game.h"

#include <math.h>

typedef struct Key {
    float seconds, x, z, yawDeg, pitchDeg;
} Key;

static const Key keys[] = {
    {0, 0.1f, 2.2f, 0, 0},          {1.5f, 0.2f, -0.4f, -4, -2},   {2.7f, -0.5f, -2.9f, 38, -3},
    {3.7f, -0.5f, -4.5f, 72, -4},   {4.7f, 0, -6.6f, 8, -3},       {5.6f, 0.5f, -8.1f, -50, -2},
    {6.4f, 0.3f, -9.6f, -28, 0},    {7.3f, 0, -11.4f, 0, 1},       {8.3f, 0, -13.9f, 4, 4},
    {9.3f, -0.5f, -15.0f, 14, 13},  {10.4f, -0.6f, -15.6f, 4, -4}, {11.5f, -0.5f, -16.0f, 3, -5},
};
enum { KEY_COUNT = sizeof keys / sizeof *keys };

/* [Catmull and Rom 1974, "A Class of Local Interpolating Splines"], for keys at uneven times: the
 * slope at a key is that between its neighbours. */
static float between(float before, float a, float b, float after, const Key* k, float t) {
    const float length = k[1].seconds - k[0].seconds;
    const float slopeA = (b - before) / (k[1].seconds - (k == keys ? k : k - 1)->seconds) * length;
    const float slopeB = (after - a) /
                         ((k + 2 == keys + KEY_COUNT ? k + 1 : k + 2)->seconds - k[0].seconds) *
                         length;
    const float t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * slopeA + (3 * t2 - 2 * t3) * b +
           (t3 - t2) * slopeB;
}

static Key keyAt(double seconds) {
    const float s = fminf(fmaxf((float)seconds, 0), keys[KEY_COUNT - 1].seconds);
    int i = 0;
    while (i < KEY_COUNT - 2 && keys[i + 1].seconds <= s) ++i;
    {
        const Key* k = keys + i;
        const Key *before = i > 0 ? k - 1 : k, *after = i + 2 < KEY_COUNT ? k + 2 : k + 1;
        const float t = (s - k->seconds) / (k[1].seconds - k->seconds);
        Key at = {s, 0, 0, 0, 0};
        at.x = between(before->x, k->x, k[1].x, after->x, k, t);
        at.z = between(before->z, k->z, k[1].z, after->z, k, t);
        at.yawDeg = between(before->yawDeg, k->yawDeg, k[1].yawDeg, after->yawDeg, k, t);
        at.pitchDeg = between(before->pitchDeg, k->pitchDeg, k[1].pitchDeg, after->pitchDeg, k, t);
        return at;
    }
}

/* Metres walked until then; steps of a hundredth of a second are near enough. */
static float walkedAt(double seconds) {
    float sum = 0;
    double t;
    Key last = keyAt(0);
    for (t = 0.01; t <= seconds; t += 0.01) {
        const Key at = keyAt(t);
        sum += hypotf(at.x - last.x, at.z - last.z);
        last = at;
    }
    return sum;
}

void walk(Player* player, double seconds) {
    const Key at = keyAt(seconds);
    float cy, sy, cp, sp;
    player->walked = walkedAt(seconds);
    player->yaw = at.yawDeg * PI / 180, player->pitch = at.pitchDeg * PI / 180;
    /* The head rises and falls with each step of 0.75 m. */
    player->eye = vec3(at.x, 1.62f + 0.025f * sinf(2 * PI * player->walked / 0.75f), at.z);
    cy = cosf(player->yaw), sy = sinf(player->yaw);
    cp = cosf(player->pitch), sp = sinf(player->pitch);
    player->right = vec3(cy, 0, sy);
    player->back = vec3(-sy * cp, -sp, cy * cp);
    player->up = vec3(-sy * sp, cp, cy * sp);
}
