// Glints of glTF files whose roughness, metal and layers vary by a texture: where it is constant,
// the material without it; where it varies, the one that each texel says; no light lost or won.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "render/stage.h"

namespace gp::test {
namespace {

// PNG: one texel of G 128 and B 191; and two, the right one of G 255 and B 0, the left one of the
// same G 128 with B 191.
const char* const constant =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mNgaNgPAAHDAUDNX+S5AAAAAElFTkSuQmCC";
const char* const halves =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR42mNgaNjP8J8BAAeBAj8Pd7QtAAAAAElFTkSu"
    "QmCC";

struct Look {
    double roughness = 0.6, metallic = 1;
    const char* texture = nullptr;
    const char* method = "dictionary";
    double color = 1;
    std::string layers = "";  // extensions of the material, which may read texture 0
};

// A square of 2 m in the plane z = 0, its texture coordinates once across it.
std::string fileOf(const Look& look) {
    const std::string texture = look.texture
        ? fmt::format(R"("images": [{{"uri": "data:image/png;base64,{}"}}],
            "samplers": [{{"magFilter": 9728, "minFilter": 9728, "wrapS": 33071}}],
            "textures": [{{"source": 0, "sampler": 0}}],)", look.texture)
        : "";
    return fmt::format(R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
      "nodes": [{{"mesh": 0}}], {}
      "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "TEXCOORD_0": 1}}, "indices": 2,
        "material": 0}}]}}],
      "materials": [{{
        "extras": {{"glitterpath": {{"glints": {{"density": 1e5, "method": "{}"}}}}}},
        "extensions": {{{}}},
        "pbrMetallicRoughness": {{"roughnessFactor": {}, "metallicFactor": {},
          "baseColorFactor": [{}, {}, {}, 1]{}}}}}],
      "buffers": [{{"byteLength": 92, "uri": "data:application/octet-stream;base64,)"
                       "AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAvwAAgD8AAAAAAACAPwAAgD8AAAAA"
                       "AAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/AACAPwAAgD8AAAEAAgABAAMAAgA="
                       R"("}}],
      "bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48,
        "byteLength": 32}}, {{"buffer": 0, "byteOffset": 80, "byteLength": 12}}],
      "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
        "min": [-1, -1, 0], "max": [1, 1, 0]}}, {{"bufferView": 1, "componentType": 5126,
        "count": 4, "type": "VEC2"}}, {{"bufferView": 2, "componentType": 5123, "count": 6,
        "type": "SCALAR"}}]
      }})", texture, look.method, look.layers, look.roughness, look.metallic, look.color,
        look.color, look.color,
        look.texture && look.layers.empty() ? R"(, "metallicRoughnessTexture": {"index": 0})" : "");
}

// Under a sun and a sky, or in a white surrounding.
Picture pictureOf(const Look& look, bool furnace) {
    Stage stage(bestFullVariant().front());
    const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                       fmt::format("gp_glint_texture_{}.gltf", getpid());
    std::ofstream(path, std::ios::binary) << fileOf(look);
    const GpError loaded = gpLoadSceneFile(stage.scene, path.string().c_str(), nullptr);
    std::filesystem::remove(path);
    stage.check(loaded);
    stage.surround(glm::vec3(furnace ? 1.0f : 0.4f));
    if (!furnace) {
        GpLightDesc sun{};
        sun.intensity = 2, sun.angularRadius = 0.1f;
        put(sun.direction, {0.1f, 0.3f, -1});
        stage.light(sun);
    }
    const glm::vec3 from = glm::normalize(glm::vec3(0, -0.4f, 1));
    return stage.render(16, 16, lookFrom({0, 0, 0}, from, 3, 1.6f), stage.options(64));
}

// Of columns from `first` on, eight of them less the two at the edge between texels.
double meanOf(const Picture& p, uint32_t first) {
    double sum = 0;
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = first; x < first + 6; ++x) sum += double(p.at(x, y).y) / 96;
    return sum;
}

constexpr double shareG = 128 / 255.0, shareB = 191 / 255.0;

TEST(GlintTextures, AConstantTextureIsTheMaterialOfItsFactors) {
    for (const char* method : {"smooth", "dictionary", "counting"}) {
        Look textured, plain;
        textured.roughness = 0.9, textured.metallic = 0.8, textured.texture = constant;
        plain.roughness = 0.9 * shareG, plain.metallic = 0.8 * shareB;
        textured.method = plain.method = method;
        textured.color = plain.color = 0.7;
        const Picture a = pictureOf(textured, false), b = pictureOf(plain, false);
        double most = 0;
        for (size_t i = 0; i < a.color.size(); ++i)
            most = std::max(most, std::abs(double(a.color[i].y) - double(b.color[i].y)) /
                                      std::max(double(b.color[i].y), 0.1));
        EXPECT_LT(most, 0.02) << method;  // of single pixels, whose sparks are steep in roughness
        EXPECT_NEAR(a.mean().y / b.mean().y, 1, 1e-3) << method;
        // The factors without the texture are another material.
        textured.texture = nullptr;
        EXPECT_GT(std::abs(pictureOf(textured, false).mean().y / b.mean().y - 1), 0.05) << method;
    }
}

// Of the channels that the texture has: the coat's roughness, and a film's thickness. The coat is
// rough, so that it is seen beside the facets.
TEST(GlintTextures, LayersReadTheirs) {
    const auto coat = [](double roughness, const char* map) {
        return fmt::format(R"("KHR_materials_clearcoat": {{"clearcoatFactor": 1,
          "clearcoatRoughnessFactor": {}{}}})", roughness, map);
    };
    const auto film = [](double least, double most, const char* map) {
        return fmt::format(R"("KHR_materials_iridescence": {{"iridescenceFactor": 1,
          "iridescenceThicknessMinimum": {}, "iridescenceThicknessMaximum": {}{}}})", least, most,
          map);
    };
    const double thickness = 200 + shareG * 400;
    const std::string cases[][3] = {
        {coat(0.8, R"(, "clearcoatRoughnessTexture": {"index": 0})"), coat(0.8 * shareG, ""),
         coat(0.8, "")},
        {film(200, 600, R"(, "iridescenceThicknessTexture": {"index": 0})"),
         film(100, thickness, ""), film(200, 600, "")}};
    for (const auto& row : cases) {
        Look textured, plain, other;
        textured.texture = constant;
        textured.layers = row[0], plain.layers = row[1], other.layers = row[2];
        // A film on what is white is white.
        if (&row != cases) textured.color = plain.color = other.color = 0.3;
        const Picture a = pictureOf(textured, false), b = pictureOf(plain, false);
        EXPECT_NEAR(a.mean().x / b.mean().x, 1, 2e-3) << row[0];
        EXPECT_NEAR(a.mean().z / b.mean().z, 1, 2e-3) << row[0];
        const Picture c = pictureOf(other, false);
        EXPECT_GT(std::abs(c.mean().x / b.mean().x - 1) + std::abs(c.mean().z / b.mean().z - 1),
                  0.02) << row[0];
    }
}

TEST(GlintTextures, EachTexelIsTheMaterialThatItSays) {
    Look textured, left, right;
    textured.roughness = left.roughness = right.roughness = 0.8;
    textured.texture = halves;
    left.roughness *= shareG, left.metallic *= shareB;
    right.metallic = 0;
    const Picture both = pictureOf(textured, false), a = pictureOf(left, false),
                  b = pictureOf(right, false);
    EXPECT_NEAR(meanOf(both, 0) / meanOf(a, 0), 1, 0.01);
    EXPECT_NEAR(meanOf(both, 10) / meanOf(b, 10), 1, 0.01);
    EXPECT_GT(std::abs(meanOf(a, 0) / meanOf(b, 0) - 1), 0.1);
}

// White paint returns everything at any roughness: the base knows the facets of its texel.
TEST(GlintTextures, WhitePaintVanishesAtEveryRoughness) {
    for (const double roughness : {1.0, 0.5}) {
        Look look;
        look.metallic = 0, look.roughness = roughness, look.texture = halves;
        const Picture p = pictureOf(look, true);
        for (const uint32_t first : {0u, 10u})
            EXPECT_NEAR(meanOf(p, first), 1, 4 * p.sigma().y * 1.7 + 0.004) << roughness;
    }
}

}  // namespace
}  // namespace gp::test
