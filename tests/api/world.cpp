#include "api/world.h"

#include <gtest/gtest.h>

namespace gp::test {

const float trianglePositions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const float identity[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

GpDevice newNullDevice() {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;
    return gpNewDevice(&desc);
}

GpMeshDesc triangleDesc(GpMeshKind kind) {
    GpMeshDesc desc{};
    desc.kind = kind;
    desc.vertexCount = 3;
    desc.positions = trianglePositions;
    return desc;
}

GpTextureDesc textureDesc() {
    static const uint8_t pixels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 9};
    GpTextureDesc desc{};
    desc.width = desc.height = 2;
    desc.pixels = pixels;
    return desc;
}

GpRenderOptions fewSamples(uint32_t samples) {
    GpRenderOptions options{};
    options.samplesPerPixel = samples;
    return options;
}

namespace {

GpInstance newInstance(GpScene scene, GpMesh mesh, uint64_t id) {
    GpInstanceDesc desc{};
    desc.id = id;
    desc.mesh = mesh;
    return gpNewInstance(scene, &desc);
}

GpLight newLight(GpScene scene, uint64_t id) {
    GpLightDesc desc{};
    desc.id = id;
    desc.intensity = 3;
    return gpNewLight(scene, &desc);
}

GpFrame newFrame(GpDevice device) {
    GpFrameDesc desc{};
    desc.width = 4;
    desc.height = 3;
    return gpNewFrame(device, &desc);
}

Handles makeHandles(GpDevice device, uint64_t ids) {
    Handles h;
    h.device = device;
    const GpTextureDesc texture = textureDesc();
    h.texture = gpNewTexture(device, &texture);
    h.material = gpNewMaterial(device, nullptr);
    const GpMeshDesc mesh = triangleDesc(GP_MESH_MOVABLE);
    h.mesh = gpNewMesh(device, &mesh);
    h.scene = gpNewScene(device);
    h.instance = newInstance(h.scene, h.mesh, ids);
    h.light = newLight(h.scene, ids);
    h.frame = newFrame(device);
    GpBsdfDesc bsdf{};
    bsdf.model = "lambert";
    h.bsdf = gpNewBsdf(device, &bsdf);
    h.immediate = gpNewImmediate(device);
    gpBegin(h.immediate, GP_TRIANGLES);
    for (int i = 0; i < 3; ++i) gpVertex3f(h.immediate, float(i), float(i * i), 0);
    gpEnd(h.immediate);
    return h;
}

void release(const Handles& h) {
    EXPECT_EQ(gpReleaseTexture(h.texture), GP_SUCCESS);
    EXPECT_EQ(gpReleaseMaterial(h.material), GP_SUCCESS);
    EXPECT_EQ(gpReleaseMesh(h.mesh), GP_SUCCESS);
    EXPECT_EQ(gpReleaseInstance(h.instance), GP_SUCCESS);
    EXPECT_EQ(gpReleaseLight(h.light), GP_SUCCESS);
    EXPECT_EQ(gpReleaseFrame(h.frame), GP_SUCCESS);
    EXPECT_EQ(gpReleaseScene(h.scene), GP_SUCCESS);
    EXPECT_EQ(gpReleaseBsdf(h.bsdf), GP_SUCCESS);
    EXPECT_EQ(gpReleaseImmediate(h.immediate), GP_SUCCESS);
}

std::string describe(GpScene scene) {
    size_t needed = 0;
    EXPECT_EQ(gpDescribeScene(scene, nullptr, 0, &needed), GP_SUCCESS);
    std::string text(needed, ' ');
    EXPECT_EQ(gpDescribeScene(scene, text.data(), text.size(), nullptr), GP_SUCCESS);
    return text;
}

std::string statisticsOf(GpFrame frame) {
    GpFrameStatistics s{};
    EXPECT_EQ(gpGetFrameStatistics(frame, &s), GP_SUCCESS);
    return std::to_string(s.samplesPerPixel) + " " + std::to_string(s.noise) + " " +
           std::to_string(s.secondsRender) + " " + std::to_string(s.frameBytes);
}

std::string vertexOf(GpImmediate immediate) {
    GpMeshDesc d{};
    EXPECT_EQ(gpGetImmediateMesh(immediate, &d), GP_SUCCESS);
    return std::to_string(d.vertexCount) + " " + std::to_string(d.indexCount) + " " +
           std::to_string(d.positions[0]) + (d.colors ? " coloured" : "") +
           (d.normals ? " with normals" : "") + (d.texCoords[0] ? " textured" : "");
}

}  // namespace

World::World() : folder(::testing::TempDir()) {
    static_cast<Handles&>(*this) = makeHandles(newNullDevice(), 7);
    released = makeHandles(device, 8);
    release(released);
    released.device = newNullDevice();
    EXPECT_EQ(gpReleaseDevice(released.device), GP_SUCCESS);
    orphaned = makeHandles(newNullDevice(), 9);
    EXPECT_EQ(gpReleaseDevice(orphaned.device), GP_SUCCESS);
    foreign = makeHandles(newNullDevice(), 10);

    const GpMeshDesc fixed = triangleDesc(GP_MESH_STATIC), dynamic = triangleDesc(GP_MESH_DYNAMIC);
    staticMesh = gpNewMesh(device, &fixed);
    dynamicMesh = gpNewMesh(device, &dynamic);
    staticInstance = newInstance(scene, staticMesh, 0);
    newInstance(scene, dynamicMesh, 0);
    emptyFrame = newFrame(device);
    openImmediate = gpNewImmediate(device);
    gpBegin(openImmediate, GP_TRIANGLES);
    emptyImmediate = gpNewImmediate(device);
    const GpRenderOptions two = fewSamples(2);
    EXPECT_EQ(gpRender(frame, scene, nullptr, &two), GP_SUCCESS);
    gpGetError(device, nullptr);
    gpGetError(nullptr, nullptr);
}

World::~World() {
    gpReleaseDevice(device);
    gpReleaseDevice(foreign.device);
    gpGetError(nullptr, nullptr);
}

std::string World::snapshot() const {
    return describe(scene) + describe(foreign.scene) + statisticsOf(frame) +
           statisticsOf(emptyFrame) + vertexOf(immediate);
}

}  // namespace gp::test
