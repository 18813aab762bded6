// Writes the files that fuzzing starts from:  fuzz_seeds FOLDER
#include <cstdio>
#include <filesystem>

#include "io/presets_data.h"
#include "io/sample_files.h"

using namespace gp::test;

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: fuzz_seeds FOLDER\n");
        return 2;
    }
    const std::string folder = argv[1];
    std::filesystem::create_directories(folder + "/gltf");
    std::filesystem::create_directories(folder + "/image");
    std::filesystem::create_directories(folder + "/presets");
    const GltfBuilder rich = richGltf();
    GltfBuilder plain;
    plain.addMesh(plain.vec3s({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    writeFile(folder + "/gltf/rich.gltf", rich.gltf());
    writeFile(folder + "/gltf/rich.glb", rich.glb());
    writeFile(folder + "/gltf/plain.gltf", plain.gltf());
    writeFile(folder + "/gltf/plain.glb", plain.glb());
    for (int k = 0; k < 5; ++k)
        writeFile(folder + "/image/" + std::to_string(k) + ".png", samplePng(PngKind(k)));
    for (int k = 0; k < 4; ++k)
        writeFile(folder + "/image/" + std::to_string(k) + ".jpg", sampleJpeg(JpegKind(k)));
    for (int k = 0; k < 10; ++k)
        writeFile(folder + "/image/" + std::to_string(k) + ".exr", sampleExr(ExrKind(k)));
    writeFile(folder + "/image/0.hdr", sampleHdr());
    for (size_t k = 0; const Bytes& greedy : greedyImages())
        writeFile(folder + "/image/greedy" + std::to_string(k++), greedy);
    for (const gp::io::PresetText& file : gp::io::presetTexts()) {
        const auto* bytes = reinterpret_cast<const std::byte*>(file.text.data());
        writeFile(folder + "/presets/" + file.name, {bytes, bytes + file.text.size()});
    }
    return 0;
}
