// The C++ wrapper: a checkered floor with a lamp above it, and what the frame knows of itself.
//     wrapper [OUTPUT.png]
#include <array>
#include <cstdio>
#include <vector>

#include <glitterpath/glitterpath.hpp>

namespace {

gp::Texture makeCheckers(const gp::Device& device) {
    constexpr uint32_t side = 8;
    std::vector<uint8_t> pixels;
    for (uint32_t i = 0; i < side * side; ++i) {
        const bool light = (i % side + i / side) % 2 == 0;
        for (int channel = 0; channel < 3; ++channel) pixels.push_back(light ? 220 : 40);
        pixels.push_back(255);
    }
    GpTextureDesc desc{};
    desc.width = desc.height = side;
    desc.pixels = pixels.data();
    desc.magFilter = GP_FILTER_NEAREST;
    return gp::Texture(device, desc);
}

gp::Mesh makeFloor(const gp::Device& device, const gp::Material& material) {
    static constexpr std::array<float, 12> positions = {-2, 0, 2, 2, 0, 2, 2, 0, -2, -2, 0, -2};
    static constexpr std::array<float, 8> uv = {0, 1, 1, 1, 1, 0, 0, 0};
    static constexpr std::array<uint32_t, 6> indices = {0, 1, 2, 0, 2, 3};
    GpMeshDesc desc{};
    desc.material = material.get();
    desc.vertexCount = 4;
    desc.positions = positions.data();
    desc.texCoords[0] = uv.data();
    desc.indices = indices.data();
    desc.indexCount = uint32_t(indices.size());
    return gp::Mesh(device, desc);
}

void render(const char* path) {
    gp::Device device;
    gp::Scene scene(device);
    const gp::Texture checkers = makeCheckers(device);
    GpMaterialDesc look{};
    look.baseColorTexture.texture = checkers.get();
    look.roughness = 0.3f;
    const gp::Material material(device, look);
    const gp::Mesh floor = makeFloor(device, material);
    GpInstanceDesc placed{};
    placed.mesh = floor.get();
    gp::Instance(scene, placed);  // the handle goes at once; the instance stays in the scene

    GpLightDesc lamp{};
    lamp.kind = GP_LIGHT_SPHERE;
    lamp.position[1] = 1;
    lamp.radius = 0.2f;
    lamp.intensity = 100;
    lamp.unit = GP_UNIT_POWER_W;
    gp::Light(scene, lamp);

    gp::Frame frame(device, 320, 240);
    GpRenderOptions options{};
    options.samplesPerPixel = 16;
    frame.render(scene, options);
    frame.save(path);
    std::printf("%s: %u samples a pixel in %.2f s\n", device.name().c_str(),
                frame.statistics().samplesPerPixel, frame.statistics().secondsRender);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        render(argc > 1 ? argv[1] : "wrapper.png");
        return 0;
    } catch (const gp::Error& error) {
        std::fprintf(stderr, "%s: %s\n", gpErrorName(error.code()), error.what());
        return 1;
    }
}
