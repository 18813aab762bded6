/* The edge of a sea of clear water, seen from the beach and from under the surface:
 * shore SHORE.glb OUTPUT-FOLDER [WIDTH HEIGHT SAMPLES]
 * where SHORE.glb is what `glitterpath make-scene shore -o SHORE.glb` writes. */
#include <glitterpath/glitterpath.h>
#include <stdio.h>
#include <stdlib.h>

static void complain(void* user, GpError error, const char* message) {
    (void)user;
    fprintf(stderr, "shore: %s (%s)\n", message, gpErrorName(error));
}

static void require(int fine) {
    if (!fine) exit(1);
}

/* A light breeze towards the beach, and water to see through, with a little sand in it. */
static void addSea(GpScene scene) {
    const float absorption[3] = {0.35f, 0.07f, 0.05f};
    const float scattering[3] = {0.007f, 0.008f, 0.009f};
    GpOceanDesc sea = {0};
    int i;
    sea.wind = 3;
    sea.windDirection = 2.6f;
    sea.fetch = 3000;
    sea.transparent = 1;
    for (i = 0; i < 3; ++i) {
        sea.absorption[i] = absorption[i];
        sea.scattering[i] = scattering[i];
    }
    require(gpSetOcean(scene, &sea) == GP_SUCCESS);
    require(gpSetOceanTime(scene, 4) == GP_SUCCESS);
}

static void render(GpFrame frame, GpScene scene, const GpCameraDesc* camera,
                   const GpRenderOptions* options, const char* folder, const char* name) {
    char path[4096];
    require(gpRender(frame, scene, camera, options) == GP_SUCCESS);
    snprintf(path, sizeof path, "%s/%s", folder, name);
    require(gpSaveFrame(frame, path, NULL) == GP_SUCCESS);
}

int main(int argc, char** argv) {
    GpDeviceDesc deviceDesc = {0};
    GpFrameDesc size = {0};
    GpRenderOptions options = {0};
    GpCameraDesc below = {0};
    GpDevice device;
    GpScene scene;
    GpFrame frame;
    if (argc != 3 && argc != 6) {
        fprintf(stderr, "usage: shore SHORE.glb OUTPUT-FOLDER [WIDTH HEIGHT SAMPLES]\n");
        return 2;
    }
    deviceDesc.errorCallback = complain;
    device = gpNewDevice(&deviceDesc);
    require(device != NULL);
    scene = gpNewScene(device);
    require(gpLoadSceneFile(scene, argv[1], NULL) == GP_SUCCESS);
    require(gpSetSky(scene, 2.0f, 0.8f, 0) == GP_SUCCESS);
    addSea(scene);

    size.width = argc == 6 ? (uint32_t)strtoul(argv[3], NULL, 10) : 320;
    size.height = argc == 6 ? (uint32_t)strtoul(argv[4], NULL, 10) : 180;
    frame = gpNewFrame(device, &size);
    require(frame != 0);
    options.samplesPerPixel = argc == 6 ? (uint32_t)strtoul(argv[5], NULL, 10) : 32;
    options.exposureEv = -4.9f;
    options.clamp = 2000; /* the sun on wet stones, by chance */
    render(frame, scene, NULL, &options, argv[2], "beach.png");

    below.position[1] = -0.9f, below.position[2] = -6;
    below.target[0] = 0.5f, below.target[1] = -0.6f, below.target[2] = -3;
    below.verticalFov = 1.1f;
    options.exposureEv = -4.5f;
    render(frame, scene, &below, &options, argv[2], "below.png");
    gpReleaseDevice(device);
    return 0;
}
