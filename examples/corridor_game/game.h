/* corridor_game: a walk through a level in the manner of 1999, path traced in real time. Everything
 * that it shows is made by its own code. Read main.c first, then the files in this order. */
#ifndef CORRIDOR_GAME_H
#define CORRIDOR_GAME_H

#include <glitterpath/glitterpath.h>

#define PI 3.14159265f
#define WALK_SECONDS 11.5 /* from the first to the last key of walk.c */

typedef struct Vec3 {
    float x, y, z;
} Vec3;

/* What walls and things are made of: rows of surfaces.c and plain.c, in this order. */
typedef enum SurfaceName {
    BRICK, PLATES, TILES, CONCRETE, COBBLES, PLANKS, STONE, DOOR, SCREEN, GRATE, GRASS, WINDOW,
    PUDDLE, BRASS, IRON, CELL, GOLD, BEACON_OFF, BEACON_ON, SURFACE_COUNT
} SurfaceName;

/* Ids of what moves, so that its motion is known from frame to frame. Those of the level itself are
 * 1 + its SurfaceName. */
enum { ID_DOOR = 100, ID_PICKUP = 110, ID_WEAPON = 120, ID_BEACON = 140 };
/* Ids of lights. */
enum { ID_TORCH = 1, ID_SUN = 50, ID_TUBE = 51, ID_ALARM = 52 };

#define TORCH_COUNT 6
#define BOWL_COUNT 2 /* of them, at the end: bowls of fire in the yard */
#define PICKUP_COUNT 3
#define WEAPON_PARTS 4

typedef struct Player {
    Vec3 eye;
    float yaw, pitch;           /* radians; yaw 0 looks along -Z and grows to the right */
    float walked;               /* metres, for the steps */
    Vec3 right, up, back;       /* the axes of the camera */
    int shards;
    double pickedUp;            /* when it last was, seconds; below 0: never */
} Player;

typedef struct Game {
    GpDevice device;
    GpScene scene;
    GpImmediate im;
    uint32_t width, height;
    GpMaterial surfaces[SURFACE_COUNT], beacon;
    GpTexture flames, glow, clouds, font;
    GpInstance doors[2], pickups[PICKUP_COUNT], weapon[WEAPON_PARTS];
    GpLight torches[TORCH_COUNT], tube, alarm;
    Player player;
} Game;

/* noise.c: numbers that look random and are the same each time, 0..1 unless said otherwise. */
float hash(int x, int y, int seed);
/* Smooth, repeating every `period` units in both directions. */
float noise(float x, float y, int period, int seed);
/* A sum of `octaves` of noise over u and v of 0..1, the first with `period` cells; repeats. */
float cloudNoise(float u, float v, int period, int octaves, int seed);
float smoothStep(float low, float high, float x);
float mixed(float a, float b, float share);
/* How much a flame or a loose contact shines at `seconds`; 0..1. */
float flicker(double seconds, int seed);

/* patterns.c: one repeat of a surface at (u, v), each 0..1, v downwards. */
typedef struct Texel {
    float color[3]; /* linear reflectance; where the surface glows, what it emits */
    float alpha;
    float height;   /* metres */
    float roughness, metallic;
} Texel;
typedef Texel (*Pattern)(float u, float v);
Texel bricks(float u, float v);
Texel plates(float u, float v);
Texel tiles(float u, float v);
Texel concrete(float u, float v);
Texel cobbles(float u, float v);
/* patterns_things.c */
Texel planks(float u, float v);
Texel stone(float u, float v);
Texel doorLeaf(float u, float v);
Texel screen(float u, float v);
Texel grate(float u, float v);
Texel grass(float u, float v);
Texel window(float u, float v);

/* surfaces.c: materials of all surfaces, in game->surfaces. */
void makeSurfaces(Game* game);
/* How many metres of a wall one repeat of a surface covers. */
float metresOf(SurfaceName surface);

/* sprites.c: textures of what is drawn. */
#define FLAME_FRAMES 8 /* columns of the texture of flames */
void makeSprites(Game* game);
float cloudThickness(float u, float v); /* 0..1; repeats */
GpTexture newFont(Game* game, const unsigned char* dots, int count);
/* sky.c */
void makeSky(Game* game);
void drawSky(Game* game, GpFrame frame, double seconds);
/* level.c, shapes.c */
void makeLevel(Game* game);
void addBox(GpImmediate im, Vec3 low, Vec3 high, float taper, float metres);
void addTube(GpImmediate im, Vec3 from, Vec3 to, float radius, float endRadius);
/* Hands over what `im` holds as a mesh, places it in the scene and empties `im`. */
GpInstance placeMesh(Game* game, GpMeshKind kind, SurfaceName surface, uint64_t id,
                     GpVisibility visibility);

/* things.c: doors, items, lamps. lights.c: torches and what else shines. */
void makeThings(Game* game);
void moveThings(Game* game, double seconds);
void makeLights(Game* game);
void moveLights(Game* game, double seconds);
Vec3 torchPosition(int torch);
float doorOpening(double seconds); /* 0 closed .. 1 open */
/* effects.c: flames, glows and sparks, drawn over what was traced. */
void drawEffects(Game* game, GpFrame frame, double seconds);
/* weapon.c */
void makeWeapon(Game* game);
void moveWeapon(Game* game, double seconds);
/* walk.c: where the player is at `seconds`. */
void walk(Player* player, double seconds);
/* hud.c */
void makeHud(Game* game);
void drawHud(Game* game, GpFrame frame, double seconds);

/* Hands what `im` holds to the next render of `frame`, and empties `im`. */
void drawImmediate(Game* game, GpFrame frame, GpDrawDesc* how);
/* A quad around `centre` from the corner -a-b to a+b, with the texture's columns u0..u1. */
void addSprite(GpImmediate im, Vec3 centre, Vec3 a, Vec3 b, float u0, float u1);

static inline Vec3 vec3(float x, float y, float z) {
    Vec3 v;
    v.x = x, v.y = y, v.z = z;
    return v;
}
static inline Vec3 plus(Vec3 a, Vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
static inline Vec3 times(Vec3 a, float s) { return vec3(a.x * s, a.y * s, a.z * s); }

#endif
