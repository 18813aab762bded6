// Small files of every kind, made in memory: what the tests read, and what fuzzing starts from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

namespace gp::test {

using Bytes = std::vector<std::byte>;

Bytes bytesOf(std::string_view text);
std::string base64(const Bytes& bytes);
void writeFile(const std::string& path, const Bytes& bytes);
Bytes readWholeFile(const std::string& path);

// A glTF file under construction: `json` is the file, the accessors' data go to one buffer.
class GltfBuilder {
public:
    GltfBuilder() { json["asset"]["version"] = "2.0"; }

    nlohmann::json json;
    Bytes binary;

    // Each returns the index of a new accessor.
    size_t accessor(const void* data, size_t bytes, size_t count, unsigned componentType,
                    const char* type, bool normalized = false);
    size_t floats(const std::vector<float>& v);
    size_t vec2s(const std::vector<glm::vec2>& v);
    size_t vec3s(const std::vector<glm::vec3>& v);
    size_t vec4s(const std::vector<glm::vec4>& v);
    size_t mat4s(const std::vector<glm::mat4>& v);
    size_t shorts(const std::vector<uint16_t>& v);
    size_t view(const Bytes& data);  // a new buffer view

    // A mesh of one primitive, a node that shows it, and a scene with all nodes so far.
    nlohmann::json& addMesh(size_t positions);
    std::string text() const;  // .gltf, the buffer as a data uri
    Bytes gltf() const { return bytesOf(text()); }
    Bytes glb() const;
};

// Two triangles, a textured material with all extensions, a skin, a morph target, animations.
GltfBuilder richGltf();

enum class PngKind { gray, palette, rgba, wide, interlaced };
Bytes samplePng(PngKind kind);      // 5 x 3
enum class JpegKind { rgb, gray, progressive, cmyk };
Bytes sampleJpeg(JpegKind kind);    // 16 x 8, left half red (dark), right half green (bright)
enum class ExrKind { rgbaHalf, rgbFloat, tiled, lumaChroma, gray, uintRgb, layer, smallWindow,
                     largeWindow, multiPart };
Bytes sampleExr(ExrKind kind);      // display window 4 x 3: R = x, G = y, B = 7
Bytes sampleHdr();                  // 16 x 2, runs
std::vector<Bytes> greedyImages();  // small ones that ask for gigabytes

}  // namespace gp::test
