/* Renders a glTF file through its first camera, with a progress line, and saves a picture for
 * people (PNG) and one for programs (EXR with layers):
 * load_scene SCENE.glb OUTPUT-WITHOUT-ENDING */
#include <glitterpath/glitterpath.h>
#include <stdio.h>
#include <stdlib.h>

/* Called once for each call that fails, so that the code below need not look at every result. */
static void complain(void* user, GpError error, const char* message) {
    (void)user;
    fprintf(stderr, "load_scene: %s (%s)\n", message, gpErrorName(error));
}

static int showProgress(void* user, const GpProgress* progress) {
    (void)user;
    fprintf(stderr, "\r%3.0f %%, %u samples a pixel", 100 * progress->fraction,
            (unsigned)progress->samplesPerPixel);
    return 0; /* anything else would stop the render */
}

/* Exits with an error where a step has failed; the callback has said why. */
static void require(int fine) {
    if (!fine) exit(1);
}

/* Lights a scene that brings no light of its own. */
static void addSkyIfDark(GpScene scene) {
    GpSceneInfo info;
    require(gpGetSceneInfo(scene, &info) == GP_SUCCESS);
    printf("%llu triangles, %llu lights, %llu cameras\n", (unsigned long long)info.triangles,
           (unsigned long long)info.lights, (unsigned long long)info.cameras);
    if (info.lights == 0 && info.emissiveTriangles == 0 && !info.hasEnvironment)
        require(gpSetSky(scene, 2.5f, 0.8f, 0) == GP_SUCCESS);
}

int main(int argc, char** argv) {
    char path[4096];
    GpDeviceDesc deviceDesc = {0};
    GpFrameDesc size = {0};
    GpRenderOptions options = {0};
    GpSaveOptions layers = {0};
    GpDevice device;
    GpScene scene;
    GpFrame frame;
    if (argc != 3) {
        fprintf(stderr, "usage: load_scene SCENE.glb OUTPUT-WITHOUT-ENDING\n");
        return 2;
    }

    deviceDesc.errorCallback = complain;
    device = gpNewDevice(&deviceDesc);
    require(device != NULL);
    scene = gpNewScene(device);
    require(gpLoadSceneFile(scene, argv[1], NULL) == GP_SUCCESS);
    addSkyIfDark(scene);

    size.width = 320;
    size.height = 240;
    frame = gpNewFrame(device, &size);
    options.samplesPerPixel = 16;
    options.exposureEv = -5;
    options.progress = showProgress;
    require(gpRender(frame, scene, NULL, &options) == GP_SUCCESS);
    fprintf(stderr, "\n");

    snprintf(path, sizeof path, "%s.png", argv[2]);
    require(gpSaveFrame(frame, path, NULL) == GP_SUCCESS);
    layers.layers = 1u << GP_IMAGE_ALBEDO | 1u << GP_IMAGE_NORMAL | 1u << GP_IMAGE_DEPTH;
    snprintf(path, sizeof path, "%s.exr", argv[2]);
    require(gpSaveFrame(frame, path, &layers) == GP_SUCCESS);
    gpReleaseDevice(device); /* and everything that was made from it */
    return 0;
}
