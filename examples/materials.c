/* Three spheres: a preset, a model with its parameters, and a stack of two with a striped mask:
 * materials [OUTPUT.png] */
#include <glitterpath/glitterpath.h>
#include <math.h>
#include <stdio.h>

enum { RINGS = 64, SIDES = 128 };

/* Latitude and longitude: uv runs once around and once from pole to pole. */
static GpMesh newSphere(GpDevice device, GpMaterial material) {
    static float positions[(RINGS + 1) * (SIDES + 1) * 3], uv[(RINGS + 1) * (SIDES + 1) * 2];
    static uint32_t indices[RINGS * SIDES * 6];
    uint32_t count = 0;
    for (int r = 0; r <= RINGS; ++r)
        for (int s = 0; s <= SIDES; ++s) {
            const int v = r * (SIDES + 1) + s;
            const float theta = 3.14159265f * r / RINGS, phi = 6.2831853f * s / SIDES;
            positions[3 * v] = sinf(theta) * cosf(phi);
            positions[3 * v + 1] = cosf(theta);
            positions[3 * v + 2] = -sinf(theta) * sinf(phi);
            uv[2 * v] = (float)s / SIDES;
            uv[2 * v + 1] = (float)r / RINGS;
            if (r == RINGS || s == SIDES) continue;
            const uint32_t a = (uint32_t)v, b = a + SIDES + 1;
            const uint32_t quad[6] = {a, b, b + 1, a, b + 1, a + 1};
            for (int k = 0; k < 6; ++k) indices[count++] = quad[k];
        }
    GpMeshDesc desc = {0};
    desc.material = material;
    desc.vertexCount = (RINGS + 1) * (SIDES + 1);
    desc.positions = desc.normals = positions; /* a unit sphere is its own normals */
    desc.texCoords[0] = uv;
    desc.indices = indices;
    desc.indexCount = count;
    return gpNewMesh(device, &desc);
}

static GpBsdf newBsdf(GpDevice device, const char* model, const GpBsdfParameter* parameters,
                      uint32_t count) {
    GpBsdfDesc desc = {0};
    desc.model = model;
    desc.parameters = parameters;
    desc.parameterCount = count;
    return gpNewBsdf(device, &desc);
}

int main(int argc, char** argv) {
    GpDevice device = gpNewDevice(NULL);
    GpScene scene = gpNewScene(device);

    GpMaterialDesc preset = {0}, ward = {0}, stack = {0};
    preset.preset = "satin_gold";

    const GpBsdfParameter brushed[] = {{"alpha_x", "0.08"}, {"alpha_y", "0.4"},
                                       {"base_color", "0.1,0.15,0.3"}, {"form", "duer"}};
    ward.bsdf = newBsdf(device, "ward", brushed, 4);

    const uint8_t stripes[] = {0, 0, 0, 255, 255, 0, 0, 255};
    GpTextureDesc texture = {0};
    texture.width = 2;
    texture.height = 1;
    texture.pixels = stripes;
    texture.colorSpace = GP_COLOR_LINEAR;
    texture.magFilter = texture.minFilter = GP_FILTER_NEAREST;
    GpMaterialLayer rust = {0};
    rust.bsdf = newBsdf(device, "rust", NULL, 0); /* presets are models by another name */
    rust.mask.texture = gpNewTexture(device, &texture);
    rust.mask.transform[0] = 8;
    rust.mask.transform[4] = 1;
    stack.bsdf = newBsdf(device, "clean_iron", NULL, 0);
    stack.layers = &rust;
    stack.layerCount = 1;

    const GpMaterialDesc* materials[] = {&preset, &ward, &stack};
    for (int i = 0; i < 3; ++i) {
        GpInstanceDesc instance = {0};
        instance.mesh = newSphere(device, gpNewMaterial(device, materials[i]));
        const float moved[12] = {1, 0, 0, 2.2f * (float)(i - 1), 0, 1, 0, 0, 0, 0, 1, 0};
        for (int k = 0; k < 12; ++k) instance.worldFromObject[k] = moved[k];
        gpNewInstance(scene, &instance);
    }
    gpSetSky(scene, 2.5f, 0.7f, 0);

    GpFrameDesc size = {0};
    size.width = 480;
    size.height = 200;
    GpFrame frame = gpNewFrame(device, &size);
    GpRenderOptions options = {0};
    options.samplesPerPixel = 32;
    options.exposureEv = -5;
    gpRender(frame, scene, NULL, &options);
    gpSaveFrame(frame, argc > 1 ? argv[1] : "materials.png", NULL);

    const char* message = "";
    GpError error = gpGetError(device, &message);
    if (error) fprintf(stderr, "%s: %s\n", gpErrorName(error), message);
    gpReleaseDevice(device);
    return error != GP_SUCCESS;
}
