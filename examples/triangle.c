/* One triangle under a clear sky, rendered to a picture: triangle [OUTPUT.png] */
#include <glitterpath/glitterpath.h>
#include <stdio.h>

int main(int argc, char** argv) {
    const char* path = argc > 1 ? argv[1] : "triangle.png";
    const float positions[] = {-1, 0, 0, 1, 0, 0, 0, 1.5f, 0};
    GpDevice device = gpNewDevice(NULL);
    GpScene scene = gpNewScene(device);

    GpMaterialDesc red = {0};
    red.baseColor[0] = 0.8f;
    red.baseColor[3] = 1;
    GpMeshDesc triangle = {0};
    triangle.material = gpNewMaterial(device, &red);
    triangle.vertexCount = 3;
    triangle.positions = positions;
    GpInstanceDesc instance = {0};
    instance.mesh = gpNewMesh(device, &triangle);
    gpNewInstance(scene, &instance);
    gpSetSky(scene, 2.5f, 0.7f, 0);

    GpFrameDesc size = {0};
    size.width = 320;
    size.height = 240;
    GpFrame frame = gpNewFrame(device, &size);
    GpRenderOptions options = {0};
    options.samplesPerPixel = 16;
    options.exposureEv = -5;
    gpRender(frame, scene, NULL, &options);
    gpSaveFrame(frame, path, NULL);

    const char* message = "";
    GpError error = gpGetError(device, &message); /* the first thing that went wrong, if any did */
    if (error) fprintf(stderr, "%s: %s\n", gpErrorName(error), message);
    gpReleaseDevice(device);
    return error != GP_SUCCESS;
}
