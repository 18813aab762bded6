/* The level: boxes. A corridor runs along -Z to a door at z = -13; a room lies to its right, a
 * machine behind a grate to its left, and a yard behind the door. */
#include "game.h"

#include <math.h>

typedef struct Brush {
    SurfaceName surface;
    float low[3], high[3];
    float taper;
} Brush;

static const Brush brushes[] = {
    /* the corridor */
    {TILES, {-2, -0.2f, -13.4f}, {2, 0, 3}, 0},
    {CONCRETE, {-1.6f, 3, -13.2f}, {1.6f, 3.2f, 3}, 0},
    {BRICK, {-2, 0, 3}, {2, 3.4f, 3.3f}, 0},
    {BRICK, {-2, 0, -8}, {-1.6f, 3.4f, 3}, 0},
    {BRICK, {-2, 0, -13.2f}, {-1.6f, 3.4f, -10.6f}, 0},
    {BRICK, {-2, 0, -10.6f}, {-1.6f, 0.9f, -8}, 0},
    {BRICK, {-2, 2.3f, -10.6f}, {-1.6f, 3.4f, -8}, 0},
    {BRICK, {1.6f, 0, -4.2f}, {2, 3.4f, 3}, 0},
    {BRICK, {1.6f, 0, -13.2f}, {2, 3.4f, -5.8f}, 0},
    {BRICK, {1.6f, 2.3f, -5.8f}, {2, 3.4f, -4.2f}, 0},
    {STONE, {-1.62f, 0.82f, -10.6f}, {-1.5f, 0.92f, -8}, 0},  /* below the grate */
    {STONE, {1.52f, 2.28f, -6}, {2.05f, 2.5f, -4}, 0},        /* above the way to the room */
    /* the room */
    {PLATES, {2, -0.2f, -8.1f}, {6.8f, 0, -1.9f}, 0},
    {PLATES, {2, 3.4f, -8.1f}, {6.8f, 3.6f, -1.9f}, 0},
    {PLATES, {6.5f, 0, -8.1f}, {6.8f, 3.4f, -1.9f}, 0},
    {PLATES, {2, 0, -2.2f}, {6.5f, 3.4f, -1.9f}, 0},
    {PLATES, {2, 0, -8.1f}, {6.5f, 3.4f, -7.8f}, 0},
    {PLANKS, {5.2f, 0, -7.7f}, {6.3f, 1.1f, -6.6f}, 0},
    {PLANKS, {5.4f, 1.1f, -7.5f}, {6.2f, 1.9f, -6.7f}, 0},
    {PLANKS, {4.1f, 0, -7.7f}, {4.9f, 0.8f, -6.9f}, 0},
    {PLANKS, {5.5f, 0, -3.4f}, {6.4f, 0.9f, -2.5f}, 0},
    {STONE, {4.15f, 0, -5.6f}, {4.85f, 0.75f, -4.9f}, 0.08f}, /* under the thing to pick up */
    {IRON, {6.35f, 2.35f, -5.45f}, {6.5f, 2.85f, -4.95f}, 0},
    /* behind the grate */
    {PLATES, {-4.7f, 0, -11.3f}, {-4.4f, 3, -7.3f}, 0},
    {PLATES, {-4.4f, 0, -7.6f}, {-2, 3, -7.3f}, 0},
    {PLATES, {-4.4f, 0, -11.3f}, {-2, 3, -11}, 0},
    {PLATES, {-4.4f, -0.2f, -11}, {-2, 0, -7.6f}, 0},
    {CONCRETE, {-4.4f, 3, -11}, {-2, 3.2f, -7.6f}, 0},
    {PLATES, {-4.4f, 0, -10.4f}, {-3.7f, 0.95f, -8.2f}, 0.1f},
    {SCREEN, {-4.4f, 1.15f, -9.2f}, {-4.3f, 2, -8.2f}, 0},
    {SCREEN, {-4.4f, 1.15f, -10.4f}, {-4.3f, 2, -9.4f}, 0},
    /* the door's wall, and the yard's */
    {BRICK, {-9, 0, -13.4f}, {-1.1f, 4.5f, -13}, 0},
    {BRICK, {1.1f, 0, -13.4f}, {9, 4.5f, -13}, 0},
    {BRICK, {-1.1f, 2.5f, -13.4f}, {1.1f, 4.5f, -13}, 0},
    {STONE, {-1.35f, 2.5f, -13.5f}, {1.35f, 2.75f, -12.9f}, 0},
    {COBBLES, {-9, -0.2f, -30}, {9, 0, -13.4f}, 0},
    {BRICK, {-9, 0, -30}, {-8.6f, 4.5f, -13.4f}, 0},
    {BRICK, {8.6f, 0, -30}, {9, 4.5f, -13.4f}, 0},
    {BRICK, {-8.6f, 0, -30}, {8.6f, 3.4f, -29.6f}, 0},
    {STONE, {-9.1f, 4.5f, -30}, {-8.5f, 4.75f, -13}, 0.05f},
    {STONE, {8.5f, 4.5f, -30}, {9.1f, 4.75f, -13}, 0.05f},
    {STONE, {-8.6f, 3.4f, -30.1f}, {8.6f, 3.65f, -29.5f}, 0.05f},
    /* the monument */
    {STONE, {-1.7f, 0, -25.7f}, {1.7f, 0.3f, -22.3f}, 0.05f},
    {STONE, {-1.15f, 0.3f, -25.15f}, {1.15f, 0.6f, -22.85f}, 0.05f},
    {STONE, {-0.7f, 0.6f, -24.7f}, {0.7f, 1.5f, -23.3f}, 0.08f},
    {STONE, {-0.45f, 1.5f, -24.45f}, {0.45f, 5.6f, -23.55f}, 0.17f},
    {BRASS, {-0.28f, 5.6f, -24.28f}, {0.28f, 6.15f, -23.72f}, 0.279f},
    {STONE, {-2.95f, 0, -22.95f}, {-2.25f, 0.95f, -22.25f}, 0.1f},
    {STONE, {2.25f, 0, -22.95f}, {2.95f, 0.95f, -22.25f}, 0.1f},
    /* a tower and crates */
    {BRICK, {-8.6f, 0, -29.6f}, {-4.6f, 8.4f, -25.6f}, 0.15f},
    {STONE, {-8.7f, 8.3f, -29.7f}, {-4.5f, 8.9f, -25.5f}, 0},
    {WINDOW, {-6.4f, 5, -25.72f}, {-5.5f, 6.6f, -25.62f}, 0},
    {WINDOW, {-7.8f, 5, -25.72f}, {-6.9f, 6.6f, -25.62f}, 0},
    {PLANKS, {5.4f, 0, -21.2f}, {6.6f, 1.2f, -20}, 0},
    {PLANKS, {6.7f, 0, -21.6f}, {7.9f, 1.2f, -20.4f}, 0},
    {PLANKS, {6.1f, 1.2f, -21.3f}, {7.1f, 2.2f, -20.3f}, 0},
    {PLANKS, {-5.6f, 0, -17.6f}, {-4.6f, 1, -16.6f}, 0},
};

/* Posts along the corridor, and the beams that they carry. */
static const float posts[] = {0.5f, -3.2f, -7.0f, -11.4f};

static void addPosts(GpImmediate im) {
    const float metres = metresOf(STONE);
    size_t i;
    int side;
    for (i = 0; i < sizeof posts / sizeof *posts; ++i) {
        const float back = posts[i] - 0.25f, front = posts[i] + 0.25f;
        for (side = 0; side < 2; ++side) {
            const float low = side ? 1.3f : -1.62f, high = side ? 1.62f : -1.3f;
            addBox(im, vec3(low, 0, back), vec3(high, 2.75f, front), 0, metres);
            addBox(im, vec3(low - 0.06f, 0, back - 0.06f), vec3(high + 0.06f, 0.3f, front + 0.06f),
                   0.05f, metres);
        }
        addBox(im, vec3(-1.62f, 2.72f, back - 0.04f), vec3(1.62f, 3.02f, front + 0.04f), 0, metres);
    }
}

/* What holds the torches: bars on the posts, and the torches themselves. */
static void addBrackets(GpImmediate im) {
    int i;
    for (i = 0; i < TORCH_COUNT - BOWL_COUNT; ++i) {
        const Vec3 p = torchPosition(i);
        addBox(im, plus(p, vec3(p.x > 0 ? 0 : -0.2f, -0.32f, -0.02f)),
               plus(p, vec3(p.x > 0 ? 0.2f : 0, -0.27f, 0.02f)), 0, 0);
    }
}

static void addTorches(GpImmediate im) {
    int i;
    for (i = 0; i < TORCH_COUNT; ++i) {
        const Vec3 p = torchPosition(i);
        const int bowl = i >= TORCH_COUNT - BOWL_COUNT;
        const float radius = bowl ? 0.3f : 0.075f;
        addTube(im, plus(p, vec3(0, bowl ? -0.4f : -0.42f, 0)), plus(p, vec3(0, -0.12f, 0)),
                0.4f * radius, radius);
    }
}

/* Water that lies in the yard and in the corridor, a little above the stones. */
static void addPuddle(GpImmediate im, Vec3 centre, float radius, float depth, int seed) {
    enum { CORNERS = 40 };
    int i;
    gpBegin(im, GP_TRIANGLE_FAN);
    gpVertex3f(im, centre.x, centre.y, centre.z);
    for (i = 0; i <= CORNERS; ++i) {
        const float angle = 2 * PI * (float)i / CORNERS;
        const float wave = 0.55f + 0.9f * noise(8 * (float)i / CORNERS, 0.5f, 8, seed);
        gpVertex3f(im, centre.x + radius * wave * cosf(angle), centre.y,
                   centre.z - depth * wave * sinf(angle));
    }
    gpEnd(im);
}

static void addPlants(GpImmediate im) {
    int i;
    gpBegin(im, GP_QUADS);
    for (i = 0; i < 70; ++i) {
        const int side = i % 3;
        const float along = hash(i, 0, 300), size = 0.35f + 0.45f * hash(i, 1, 300);
        const float off = 0.15f + 0.5f * hash(i, 2, 300) * hash(i, 3, 300);
        const float turn = PI * hash(i, 4, 300);
        const Vec3 at = side == 0   ? vec3(-8.6f + off, size, -14 - 11 * along)
                        : side == 1 ? vec3(8.6f - off, size, -14 - 15 * along)
                                    : vec3(-4.4f + 13 * along, size, -29.6f + off);
        const Vec3 across = times(vec3(cosf(turn), 0, sinf(turn)), size);
        const Vec3 other = times(vec3(-sinf(turn), 0, cosf(turn)), size);
        addSprite(im, at, across, vec3(0, size, 0), 0, 1);
        addSprite(im, at, other, vec3(0, size, 0), 0, 1);
    }
    gpEnd(im);
}

/* One mesh for each surface. */
void makeLevel(Game* game) {
    int s;
    size_t i;
    for (s = 0; s < SURFACE_COUNT; ++s) {
        int any = 0;
        for (i = 0; i < sizeof brushes / sizeof *brushes; ++i) {
            const Brush* b = brushes + i;
            if (b->surface != (SurfaceName)s) continue;
            addBox(game->im, vec3(b->low[0], b->low[1], b->low[2]),
                   vec3(b->high[0], b->high[1], b->high[2]), b->taper, metresOf(b->surface));
            any = 1;
        }
        if (s == STONE) addPosts(game->im);
        if (s == GRASS) addPlants(game->im), any = 1;
        if (s == IRON) {
            addBrackets(game->im), any = 0;
            placeMesh(game, GP_MESH_STATIC, IRON, 1 + IRON, GP_VISIBILITY_WORLD);
            addTorches(game->im); /* round, hence with normals, hence a mesh of its own */
            placeMesh(game, GP_MESH_STATIC, IRON, 1 + SURFACE_COUNT, GP_VISIBILITY_WORLD);
        }
        if (s == PUDDLE) {
            addPuddle(game->im, vec3(0.5f, 0.012f, -18.6f), 2.5f, 1.7f, 310), any = 1;
            addPuddle(game->im, vec3(-3.9f, 0.012f, -22.5f), 1.2f, 0.9f, 320);
            addPuddle(game->im, vec3(-0.5f, 0.006f, -5.6f), 0.6f, 0.9f, 330);
        }
        if (s == GRATE) {
            const float repeats = 2.6f / metresOf(GRATE), high = 1.4f / metresOf(GRATE);
            gpBegin(game->im, GP_QUADS), any = 1;
            gpTexCoord2f(game->im, 0, 0), gpVertex3f(game->im, -1.8f, 2.3f, -8);
            gpTexCoord2f(game->im, 0, high), gpVertex3f(game->im, -1.8f, 0.9f, -8);
            gpTexCoord2f(game->im, repeats, high), gpVertex3f(game->im, -1.8f, 0.9f, -10.6f);
            gpTexCoord2f(game->im, repeats, 0), gpVertex3f(game->im, -1.8f, 2.3f, -10.6f);
            gpEnd(game->im);
        }
        if (any)
            placeMesh(game, GP_MESH_STATIC, (SurfaceName)s, 1 + (uint64_t)s, GP_VISIBILITY_WORLD);
    }
}
