/* Boxes, tubes and sprites in immediate mode, and what becomes of them. */
#include "game.h"

#include <math.h>

static void corner(GpImmediate im, float u, float v, Vec3 p) {
    gpTexCoord2f(im, u, v);
    gpVertex3f(im, p.x, p.y, p.z);
}

/* Its upper face is smaller by `taper` metres on each side. The texture runs through the world, a
 * repeat each `metres`, so that it goes on from box to box; metres 0: it fits each face. */
void addBox(GpImmediate im, Vec3 low, Vec3 high, float taper, float metres) {
    /* Bits of a corner: x, y, z at its upper end. Counter-clockwise from outside, beginning at the
     * upper left for walls. */
    static const int faces[6][4] = {{2, 0, 4, 6}, {7, 5, 1, 3}, {0, 1, 5, 4},
                                    {6, 7, 3, 2}, {3, 1, 0, 2}, {6, 4, 5, 7}};
    static const float fitted[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    int f, k;
    gpBegin(im, GP_QUADS);
    for (f = 0; f < 6; ++f)
        for (k = 0; k < 4; ++k) {
            const int c = faces[f][k];
            const float inset = c & 2 ? taper : 0;
            const Vec3 p = vec3(c & 1 ? high.x - inset : low.x + inset, c & 2 ? high.y : low.y,
                                c & 4 ? high.z - inset : low.z + inset);
            const float along = f < 2 ? p.z : p.x, down = f == 2 || f == 3 ? p.z : -p.y;
            if (metres > 0)
                corner(im, (f == 1 || f == 4 ? -along : along) / metres, down / metres, p);
            else
                corner(im, fitted[k][0], fitted[k][1], p);
        }
    gpEnd(im);
}

static Vec3 crossed(Vec3 a, Vec3 b) {
    return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static Vec3 unit(Vec3 v) { return times(v, 1 / sqrtf(v.x * v.x + v.y * v.y + v.z * v.z)); }

/* A round bar, open at its ends. */
void addTube(GpImmediate im, Vec3 from, Vec3 to, float radius, float endRadius) {
    enum { SIDES = 16 };
    const Vec3 along = plus(to, times(from, -1));
    const Vec3 a = unit(crossed(along, fabsf(along.x) < fabsf(along.y) ? vec3(1, 0, 0)
                                                                       : vec3(0, 1, 0)));
    const Vec3 b = unit(crossed(along, a));
    int i;
    gpBegin(im, GP_QUAD_STRIP);
    for (i = 0; i <= SIDES; ++i) {
        const float angle = 2 * PI * (float)i / SIDES;
        const Vec3 out = plus(times(a, cosf(angle)), times(b, sinf(angle)));
        const Vec3 near = plus(from, times(out, radius)), far = plus(to, times(out, endRadius));
        gpNormal3f(im, out.x, out.y, out.z);
        corner(im, (float)i / SIDES, 1, near);
        corner(im, (float)i / SIDES, 0, far);
    }
    gpEnd(im);
}

GpInstance placeMesh(Game* game, GpMeshKind kind, SurfaceName surface, uint64_t id,
                     GpVisibility visibility) {
    GpMeshDesc mesh = {0};
    GpInstanceDesc instance = {0};
    GpInstance placed;
    if (gpGetImmediateMesh(game->im, &mesh)) return NULL;
    mesh.kind = kind;
    mesh.material = game->surfaces[surface];
    instance.mesh = gpNewMesh(game->device, &mesh);
    instance.id = id;
    instance.visibility = visibility;
    placed = gpNewInstance(game->scene, &instance);
    gpReleaseMesh(instance.mesh);
    gpReleaseImmediate(game->im); /* also forgets whether it had normals */
    game->im = gpNewImmediate(game->device);
    return placed;
}

void addSprite(GpImmediate im, Vec3 centre, Vec3 a, Vec3 b, float u0, float u1) {
    const Vec3 low = plus(centre, times(b, -1)), high = plus(centre, b);
    corner(im, u0, 0, plus(high, times(a, -1)));
    corner(im, u0, 1, plus(low, times(a, -1)));
    corner(im, u1, 1, plus(low, a));
    corner(im, u1, 0, plus(high, a));
}

void drawImmediate(Game* game, GpFrame frame, GpDrawDesc* how) {
    if (gpGetImmediateDraw(game->im, how) == GP_SUCCESS) gpDraw(frame, how);
    gpClearImmediate(game->im);
}
