/* A cloth that waves (its vertices change) beside a tile that turns (its transform changes), over
 * a few frames: dynamic_mesh [FOLDER] writes FOLDER/frame-0.png, frame-1.png, ... */
#include <glitterpath/glitterpath.h>
#include <math.h>
#include <stdio.h>

#define SIDE 24 /* squares on each side of the cloth */
#define FRAMES 4

static float positions[(SIDE + 1) * (SIDE + 1) * 3];
static unsigned int indices[SIDE * SIDE * 6];

static void wave(float time) {
    int x, y;
    float* p = positions;
    for (y = 0; y <= SIDE; ++y)
        for (x = 0; x <= SIDE; ++x) {
            *p++ = 2.0f * (float)x / SIDE - 2.2f;
            *p++ = 2.0f * (float)y / SIDE;
            *p++ = 0.15f * sinf(0.5f * (float)x + 0.2f * (float)y - time);
        }
}

static void connect(void) {
    int x, y;
    unsigned int* i = indices;
    for (y = 0; y < SIDE; ++y)
        for (x = 0; x < SIDE; ++x) {
            const unsigned int corner = (unsigned int)(y * (SIDE + 1) + x);
            *i++ = corner, *i++ = corner + 1, *i++ = corner + SIDE + 2;
            *i++ = corner, *i++ = corner + SIDE + 2, *i++ = corner + SIDE + 1;
        }
}

int main(int argc, char** argv) {
    static const float tile[] = {-0.9f, 0, 0, 0.9f, 0, 0, 0.9f,  2, 0,
                                 -0.9f, 0, 0, 0.9f, 2, 0, -0.9f, 2, 0};
    const char* folder = argc > 1 ? argv[1] : ".";
    GpDevice device = gpNewDevice(NULL);
    GpScene scene = gpNewScene(device);
    GpMaterialDesc blue = {0}, orange = {0};
    GpMeshDesc clothDesc = {0}, tileDesc = {0};
    GpInstanceDesc clothInstance = {0}, tileInstance = {0};
    GpFrameDesc size = {0};
    GpRenderOptions options = {0};
    GpCameraDesc camera = {0};
    GpMesh cloth;
    GpInstance turning;
    GpFrame frame;
    const char* message = "";
    GpError error;
    int n;

    blue.baseColor[0] = 0.1f, blue.baseColor[1] = 0.3f, blue.baseColor[2] = 0.7f;
    orange.baseColor[0] = 0.8f, orange.baseColor[1] = 0.4f, orange.baseColor[2] = 0.1f;
    blue.baseColor[3] = orange.baseColor[3] = 1;
    connect();
    wave(0);
    clothDesc.kind = GP_MESH_DYNAMIC;
    clothDesc.material = gpNewMaterial(device, &blue);
    clothDesc.vertexCount = (SIDE + 1) * (SIDE + 1);
    clothDesc.positions = positions;
    clothDesc.indexCount = SIDE * SIDE * 6;
    clothDesc.indices = indices;
    cloth = clothInstance.mesh = gpNewMesh(device, &clothDesc);
    gpNewInstance(scene, &clothInstance);
    tileDesc.kind = GP_MESH_MOVABLE;
    tileDesc.material = gpNewMaterial(device, &orange);
    tileDesc.vertexCount = 6;
    tileDesc.positions = tile;
    tileInstance.mesh = gpNewMesh(device, &tileDesc);
    turning = gpNewInstance(scene, &tileInstance);
    gpSetSky(scene, 2.6f, 0.6f, 0);

    size.width = 320, size.height = 180;
    frame = gpNewFrame(device, &size);
    camera.position[1] = 1.5f, camera.position[2] = 5;
    camera.target[1] = 1;
    options.samplesPerPixel = 8;
    options.exposureEv = -5;
    for (n = 0; n < FRAMES; ++n) {
        const float angle = 0.4f * (float)n;
        const float turned[12] = {cosf(angle), 0, sinf(angle), 1.1f, 0, 1, 0, 0,
                                  -sinf(angle), 0, cosf(angle), 0};
        char path[4096];
        wave(1.5f * (float)n);
        gpUpdateMesh(cloth, &clothDesc);
        gpSetInstanceTransform(turning, turned);
        gpRender(frame, scene, &camera, &options);
        snprintf(path, sizeof path, "%s/frame-%d.png", folder, n);
        gpSaveFrame(frame, path, NULL);
    }
    error = gpGetError(device, &message);
    if (error) fprintf(stderr, "%s: %s\n", gpErrorName(error), message);
    gpReleaseDevice(device);
    return error != GP_SUCCESS;
}
