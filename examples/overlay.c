/* A heads-up display over a traced scene, drawn with immediate mode: overlay [OUTPUT.png]
 * A column under a clear sky is traced; a lens flare is added to the light of the scene, behind the
 * column; bars, a compass and a map of pixels lie over the finished picture. */
#include <glitterpath/glitterpath.h>
#include <math.h>
#include <stdio.h>

static void quad(GpImmediate im, float x0, float y0, float x1, float y1) {
    gpTexCoord2f(im, 0, 0), gpVertex3f(im, x0, y0, 0);
    gpTexCoord2f(im, 0, 1), gpVertex3f(im, x0, y1, 0);
    gpTexCoord2f(im, 1, 1), gpVertex3f(im, x1, y1, 0);
    gpTexCoord2f(im, 1, 0), gpVertex3f(im, x1, y0, 0);
}

static void disk(GpImmediate im, float x, float y, float z, float radius) {
    gpVertex3f(im, x, y, z);
    gpColor4f(im, 0, 0, 0, 0);
    for (int i = 0; i <= 40; ++i) {
        const float angle = 0.157080f * (float)i;
        gpVertex3f(im, x + radius * cosf(angle), y + radius * sinf(angle), z);
    }
}

/* Hands over what `im` holds, and empties it for the next. */
static void draw(GpFrame frame, GpImmediate im, GpDrawDesc* how) {
    how->blend = 1;
    gpGetImmediateDraw(im, how);
    gpDraw(frame, how);
    gpClearImmediate(im);
}

static void drawDisplay(GpFrame frame, GpImmediate im, GpTexture map) {
    GpDrawDesc flare = {0}, panel = {0}, chart = {0};
    flare.blendDestination = GP_BLEND_ONE; /* light is added */
    gpBegin(im, GP_TRIANGLE_FAN);
    gpColor4f(im, 300, 200, 80, 1); /* radiance, as bright as a sunlit scene */
    disk(im, 0.6f, 1.5f, -2, 0.8f);
    gpEnd(im);
    draw(frame, im, &flare);

    panel.target = GP_DRAW_OVERLAY; /* in pixels, from the upper left corner */
    gpBegin(im, GP_QUADS);
    gpColor4f(im, 0, 0, 0, 0.5f), quad(im, 8, 140, 128, 172);
    gpColor4f(im, 0.9f, 0.1f, 0.1f, 1), quad(im, 14, 146, 98, 154);
    gpColor4f(im, 0.1f, 0.5f, 1, 1), quad(im, 14, 158, 122, 166);
    gpEnd(im);
    gpBegin(im, GP_TRIANGLES);
    gpColor4f(im, 1, 1, 1, 0.8f);
    gpVertex3f(im, 160, 8, 0), gpVertex3f(im, 154, 20, 0), gpVertex3f(im, 166, 20, 0);
    gpEnd(im);
    draw(frame, im, &panel);

    chart.target = GP_DRAW_OVERLAY, chart.texture = map;
    chart.color[0] = chart.color[1] = chart.color[2] = 1, chart.color[3] = 0.8f;
    gpBegin(im, GP_QUADS);
    gpColor4f(im, 1, 1, 1, 1), quad(im, 248, 8, 312, 72);
    gpEnd(im);
    draw(frame, im, &chart);
}

int main(int argc, char** argv) {
    static const unsigned char cells[16 * 4] = {
        40, 90, 40, 255, 40, 90, 40, 255, 90, 80, 40, 255, 40, 90, 40, 255,
        40, 90, 40, 255, 40, 60, 160, 255, 90, 80, 40, 255, 40, 90, 40, 255,
        40, 60, 160, 255, 40, 60, 160, 255, 90, 80, 40, 255, 250, 220, 60, 255,
        40, 60, 160, 255, 90, 80, 40, 255, 90, 80, 40, 255, 40, 90, 40, 255};
    GpDevice device = gpNewDevice(NULL);
    GpScene scene = gpNewScene(device);
    GpImmediate im = gpNewImmediate(device);
    GpTextureDesc map = {0};
    GpMeshDesc mesh = {0};
    GpInstanceDesc instance = {0};
    GpFrameDesc size = {320, 180, GP_MODE_REFERENCE};
    GpFrame frame = gpNewFrame(device, &size);
    GpRenderOptions options = {0};
    GpCameraDesc camera = {0};
    const char* message = "";

    gpBegin(im, GP_QUAD_STRIP); /* the column: immediate mode makes traced geometry, too */
    for (int i = 0; i <= 32; ++i) {
        const float angle = -0.196350f * (float)i, c = cosf(angle), s = sinf(angle);
        gpNormal3f(im, c, 0, s);
        gpVertex3f(im, 0.5f * c, 3, 0.5f * s), gpVertex3f(im, 0.5f * c, 0, 0.5f * s);
    }
    gpEnd(im);
    gpGetImmediateMesh(im, &mesh);
    instance.mesh = gpNewMesh(device, &mesh);
    gpNewInstance(scene, &instance), gpClearImmediate(im);
    gpSetSky(scene, 2.5f, 0.7f, 0);
    map.width = map.height = 4, map.pixels = cells, map.magFilter = GP_FILTER_NEAREST;
    drawDisplay(frame, im, gpNewTexture(device, &map));
    camera.position[1] = camera.target[1] = 1.5f, camera.position[2] = 5;
    options.samplesPerPixel = 16, options.exposureEv = -5;
    gpRender(frame, scene, &camera, &options);
    gpSaveFrame(frame, argc > 1 ? argv[1] : "overlay.png", NULL);
    const GpError error = gpGetError(device, &message);
    if (error) fprintf(stderr, "%s: %s\n", gpErrorName(error), message);
    gpReleaseDevice(device);
    return error != GP_SUCCESS;
}
