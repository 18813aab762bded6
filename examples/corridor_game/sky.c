/* The sky twice: as geometry with clouds that move, drawn where nothing else is, which in real time
 * also lights the level and lies in its puddles; and below that as an environment that stands
 * still, for what the geometry leaves open and for modes in which no ray sees what is drawn. */
#include "game.h"

#include <math.h>

#define CLOUD_SCALE 0.16f /* repeats of the clouds for each unit of their plane */
static const Vec3 sunward = {0.34f, 0.50f, -0.79f}; /* against the sun's light in lights.c */

/* Radiance without clouds, W/(m^2 sr); towards: unit length. */
static Vec3 clearSky(Vec3 towards) {
    const float up = fmaxf(towards.y, 0);
    const float high = 1 - expf(-2.6f * up);
    const float facing = towards.x * sunward.x + towards.y * sunward.y + towards.z * sunward.z;
    const float haze = powf(fmaxf(facing, 0), 12), disk = powf(fmaxf(facing, 0), 400);
    if (towards.y < 0) return vec3(0.25f, 0.24f, 0.23f);
    return plus(vec3(mixed(2.6f, 0.32f, high), mixed(2.9f, 0.85f, high), mixed(3.3f, 2.4f, high)),
                vec3(2.2f * haze + 12 * disk, 1.8f * haze + 10 * disk, 1.2f * haze + 7 * disk));
}

/* Where on the clouds' plane the view meets it; `drift` in repeats. */
static void cloudPlace(Vec3 towards, float drift, float* u, float* v) {
    const float far = CLOUD_SCALE / (towards.y + 0.1f);
    *u = towards.x * far + drift;
    *v = towards.z * far + 0.3f * drift;
}

static float horizonFade(Vec3 towards) { return smoothStep(0.01f, 0.16f, towards.y); }

static Vec3 cloudColor(Vec3 towards) {
    const float facing = towards.x * sunward.x + towards.y * sunward.y + towards.z * sunward.z;
    return times(vec3(1, 0.96f, 0.92f), 2.9f + 4.5f * powf(fmaxf(facing, 0), 5));
}

static Vec3 direction(float azimuth, float elevation) {
    return vec3(sinf(azimuth) * cosf(elevation), sinf(elevation), -cosf(azimuth) * cosf(elevation));
}

void makeSky(Game* game) {
    enum { WIDTH = 128, HEIGHT = 64 };
    static float pixels[WIDTH * HEIGHT * 4];
    GpEnvironmentDesc desc = {0};
    int x, y;
    for (y = 0; y < HEIGHT; ++y)
        for (x = 0; x < WIDTH; ++x) {
            const Vec3 towards = direction(2 * PI * (((float)x + 0.5f) / WIDTH - 0.5f),
                                           PI * (0.5f - ((float)y + 0.5f) / HEIGHT));
            float* p = pixels + 4 * (y * WIDTH + x);
            Vec3 light = clearSky(towards);
            if (towards.y > 0) {
                float u, v, cover;
                cloudPlace(towards, 0, &u, &v);
                cover = horizonFade(towards) * cloudThickness(u - floorf(u), v - floorf(v));
                light = plus(times(light, 1 - cover), times(cloudColor(towards), cover));
            }
            p[0] = light.x, p[1] = light.y, p[2] = light.z, p[3] = 1;
        }
    desc.width = WIDTH, desc.height = HEIGHT, desc.pixels = pixels;
    gpSetEnvironment(game->scene, &desc);
}

enum { ROUND = 48, HIGH = 16 };

/* Rings around the viewer, from a little below the horizon to above his head. */
static void addDome(GpImmediate im, int withClouds, float drift) {
    int ring, i, k;
    for (ring = 0; ring < HIGH; ++ring) {
        gpBegin(im, GP_QUAD_STRIP);
        for (i = 0; i <= ROUND; ++i)
            for (k = 1; k >= 0; --k) {
                const float part = (float)(ring + k) / HIGH;
                const Vec3 d = direction(2 * PI * (float)i / ROUND,
                                         0.5f * PI * (part * part * 1.03f - 0.03f));
                if (withClouds) {
                    const Vec3 c = cloudColor(d);
                    float u, v;
                    cloudPlace(d, drift, &u, &v);
                    gpColor4f(im, c.x, c.y, c.z, horizonFade(d));
                    gpTexCoord2f(im, u, v);
                } else {
                    const Vec3 c = clearSky(d);
                    gpColor4f(im, c.x, c.y, c.z, 1);
                }
                gpVertex3f(im, d.x, d.y, d.z);
            }
        gpEnd(im);
    }
}

void drawSky(Game* game, GpFrame frame, double seconds) {
    GpDrawDesc clear = {0}, clouds = {0};
    clear.target = clouds.target = GP_DRAW_SKY;
    addDome(game->im, 0, 0);
    drawImmediate(game, frame, &clear);
    clouds.texture = game->clouds;
    clouds.blend = 1;
    addDome(game->im, 1, 0.006f * (float)seconds);
    drawImmediate(game, frame, &clouds);
}
