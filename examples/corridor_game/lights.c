/* What shines: torches that flicker, a tube with a loose contact, an alarm that turns, the sun.
 * What glows by its material (screens, windows, the beacon) needs nothing here. */
#include "game.h"

#include <math.h>

static const Vec3 torches[TORCH_COUNT] = {{-1.12f, 1.95f, 0.5f},    {-1.12f, 1.95f, -3.2f},
                                          {1.12f, 1.95f, -7.0f},    {-1.12f, 1.95f, -11.4f},
                                          {-2.6f, 1.36f, -22.6f},   {2.6f, 1.36f, -22.6f}};
static const Vec3 alarmPlace = {6.22f, 2.6f, -5.2f};

Vec3 torchPosition(int torch) { return torches[torch]; }

static void setColor(GpLightDesc* desc, float r, float g, float b) {
    desc->color[0] = r, desc->color[1] = g, desc->color[2] = b;
}

static void setVector(float* to, Vec3 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

static GpLightDesc torchAt(int i, double seconds) {
    GpLightDesc desc = {0};
    const float t = (float)seconds, power = flicker(seconds, 400 + 20 * i);
    const Vec3 sway = vec3(0.03f * (noise(6 * t, 0.5f, 4096, 500 + i) - 0.5f),
                           0.09f + 0.05f * (power - 0.5f),
                           0.03f * (noise(6 * t, 0.5f, 4096, 520 + i) - 0.5f));
    desc.id = ID_TORCH + (uint64_t)i;
    desc.kind = GP_LIGHT_SPHERE;
    desc.radius = 0.07f;
    desc.invisible = 1; /* the flame is drawn instead */
    setColor(&desc, 1, 0.46f, 0.14f);
    desc.intensity = (i >= TORCH_COUNT - BOWL_COUNT ? 16.0f : 4.2f) * (0.62f + 0.7f * power);
    setVector(desc.position, plus(torches[i], sway));
    return desc;
}

/* A lamp that has come off its ceiling at one end. Most of the time it is out. */
static GpLightDesc tubeAt(double seconds) {
    static const float corners[] = {3.3f, 3.25f, -5.15f, 3.3f, 3.25f, -5.4f,
                                    4.8f, 2.85f, -5.4f,  4.8f, 2.85f, -5.15f};
    GpLightDesc desc = {0};
    const float slow = noise(1.7f * (float)seconds, 0.5f, 4096, 610);
    const float fast = noise(21 * (float)seconds, 0.5f, 4096, 620);
    desc.id = ID_TUBE;
    desc.kind = GP_LIGHT_POLYGON;
    desc.corners = corners, desc.cornerCount = 4;
    desc.twoSided = 1;
    setColor(&desc, 0.75f, 0.9f, 1);
    desc.intensity = slow > 0.42f ? (fast > 0.38f ? 14 : 2) : 0.5f;
    return desc;
}

static GpLightDesc alarmAt(double seconds) {
    GpLightDesc desc = {0};
    const float turn = 4.5f * (float)seconds;
    desc.id = ID_ALARM;
    desc.kind = GP_LIGHT_SPOT;
    desc.radius = 0.05f;
    setColor(&desc, 1, 0.05f, 0.03f);
    desc.intensity = 40;
    desc.outerAngle = 0.6f, desc.innerAngle = 0.3f;
    setVector(desc.position, alarmPlace);
    setVector(desc.direction, vec3(-fabsf(cosf(turn)) - 0.2f, -0.35f, sinf(turn)));
    return desc;
}

void makeLights(Game* game) {
    GpLightDesc sun = {0}, desc;
    int i;
    for (i = 0; i < TORCH_COUNT; ++i) {
        desc = torchAt(i, 0);
        game->torches[i] = gpNewLight(game->scene, &desc);
    }
    desc = tubeAt(0), game->tube = gpNewLight(game->scene, &desc);
    desc = alarmAt(0), game->alarm = gpNewLight(game->scene, &desc);
    sun.id = ID_SUN;
    sun.angularRadius = 0.012f;
    setColor(&sun, 1, 0.86f, 0.66f);
    sun.intensity = 30;
    setVector(sun.direction, vec3(-0.34f, -0.50f, 0.79f)); /* against the player, low */
    gpReleaseLight(gpNewLight(game->scene, &sun));
}

void moveLights(Game* game, double seconds) {
    GpLightDesc desc;
    int i;
    for (i = 0; i < TORCH_COUNT; ++i) {
        desc = torchAt(i, seconds);
        gpSetLight(game->torches[i], &desc);
    }
    desc = tubeAt(seconds), gpSetLight(game->tube, &desc);
    desc = alarmAt(seconds), gpSetLight(game->alarm, &desc);
}
