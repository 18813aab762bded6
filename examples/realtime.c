/* A game's frame, path traced in real time: a door slides, a lamp flickers, the camera walks, a bar
 * is drawn over it. realtime [FOLDER] writes FOLDER/realtime.png, the last of 24 frames. */
#include <glitterpath/glitterpath.h>
#include <math.h>
#include <stdio.h>

#define FRAMES 24

/* A box between two corners, in the helper's way of OpenGL 1. */
static GpMesh box(GpDevice device, GpImmediate im, const float* lo, const float* hi,
                  GpMeshKind kind, GpMaterial material) {
    static const int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    GpMeshDesc desc = {0};
    int f, v;
    gpClearImmediate(im);
    gpBegin(im, GP_QUADS);
    for (f = 0; f < 6; ++f)
        for (v = 0; v < 4; ++v) {
            const int c = faces[f][v]; /* bits: x, y, z at the upper corner */
            gpVertex3f(im, c & 1 ? hi[0] : lo[0], c & 2 ? hi[1] : lo[1], c & 4 ? hi[2] : lo[2]);
        }
    gpEnd(im);
    gpGetImmediateMesh(im, &desc);
    desc.kind = kind;
    desc.material = material;
    return gpNewMesh(device, &desc);
}

static GpInstance place(GpScene scene, GpMesh mesh, uint64_t id) {
    GpInstanceDesc desc = {0};
    desc.mesh = mesh;
    desc.id = id; /* so that motion is known even if the program hands everything over anew */
    return gpNewInstance(scene, &desc);
}

int main(int argc, char** argv) {
    static const float stone[][2][3] = {
        {{-4, -0.2f, -5}, {4, 0, 6}}, {{-4, 3, -5}, {4, 3.2f, 6}}, /* floor and ceiling */
        {{-4, 0, -1.2f}, {-0.6f, 3, -1}}, {{0.6f, 0, -1.2f}, {4, 3, -1}},
        {{-0.6f, 2.4f, -1.2f}, {0.6f, 3, -1}}, {{-4, 0, -5}, {4, 3, -4.8f}}};
    static const float doorBox[2][3] = {{-0.6f, 0, -1.15f}, {0.6f, 2.4f, -1.05f}};
    static const float bar[] = {20, 150, 0, 220, 150, 0, 220, 162, 0,
                                20, 150, 0, 220, 162, 0, 20,  162, 0};
    GpDevice device = gpNewDevice(NULL);
    GpScene scene = gpNewScene(device);
    GpImmediate im = gpNewImmediate(device);
    GpFrameDesc size = {320, 180, GP_MODE_REALTIME};
    GpFrame frame = gpNewFrame(device, &size);
    GpRenderOptions options = {0};
    GpMaterialDesc brass = {0};
    GpLightDesc lamp = {0}, moon = {0};
    GpDrawDesc health = {0};
    GpLight light;
    GpInstance door;
    const char* message = "";
    char path[4096];
    GpError error;
    int n;

    brass.baseColor[0] = 0.9f, brass.baseColor[1] = 0.7f, brass.baseColor[2] = 0.3f;
    brass.baseColor[3] = 1;
    brass.metallic = 1, brass.roughness = 0.4f;
    for (n = 0; n < 6; ++n)
        place(scene, box(device, im, stone[n][0], stone[n][1], GP_MESH_STATIC, NULL), 10 + n);
    door = place(scene, box(device, im, doorBox[0], doorBox[1], GP_MESH_MOVABLE,
                            gpNewMaterial(device, &brass)), 4);
    lamp.id = 1, lamp.kind = GP_LIGHT_SPHERE, lamp.radius = 0.1f, lamp.unit = GP_UNIT_POWER_LM;
    lamp.color[0] = 1, lamp.color[1] = 0.6f, lamp.color[2] = 0.3f;
    lamp.position[0] = 1.3f, lamp.position[1] = 1.9f, lamp.position[2] = -0.6f;
    light = gpNewLight(scene, &lamp);
    moon.id = 2, moon.kind = GP_LIGHT_SPHERE, moon.radius = 0.2f, moon.unit = GP_UNIT_POWER_LM;
    moon.color[0] = 0.3f, moon.color[1] = 0.5f, moon.color[2] = 1, moon.intensity = 1500;
    moon.position[0] = -0.8f, moon.position[1] = 2.2f, moon.position[2] = -3.5f;
    gpNewLight(scene, &moon);

    health.target = GP_DRAW_OVERLAY;
    health.positions = bar, health.vertexCount = 6;
    health.color[0] = 0.8f, health.color[3] = 1;
    options.realtime.eyeAdaptation.seconds = 0.5f;
    for (n = 0; n < FRAMES; ++n) {
        const float t = (float)n / FRAMES;
        const float slide[12] = {1, 0, 0, 1.1f * t, 0, 1, 0, 0, 0, 0, 1, 0};
        GpCameraDesc camera = {0};
        camera.position[0] = 0.5f - t, camera.position[1] = 1.5f, camera.position[2] = 4.5f - t;
        camera.target[1] = 1.2f;
        lamp.intensity = 900 + 300 * sinf(9 * t);
        gpSetLight(light, &lamp);
        gpSetInstanceTransform(door, slide);
        gpDraw(frame, &health);
        gpRender(frame, scene, &camera, &options);
    }
    snprintf(path, sizeof path, "%s/realtime.png", argc > 1 ? argv[1] : ".");
    gpSaveFrame(frame, path, NULL);
    error = gpGetError(device, &message);
    if (error) fprintf(stderr, "%s: %s\n", gpErrorName(error), message);
    gpReleaseDevice(device);
    return error != GP_SUCCESS;
}
