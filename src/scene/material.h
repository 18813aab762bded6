// The material of a surface: glTF 2.0 metallic-roughness and its Khronos extensions, defaults
// included. The multipliers below are applied to the textures' values, channel by channel. Or a
// stack of the library's models in its place (`layers`).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "scene/texture.h"

namespace gp {

struct BsdfSettings;

// Parameters of a model of the library: they replace the share weight times mask of those below.
// [Burley 2012, "Physically-Based Shading at Disney", 5.7: parameters are blended, not results]
struct MaterialLayer {
    std::shared_ptr<const BsdfSettings> bsdf;
    float weight = 1;
    TextureUse mask;
    uint32_t channel = 0;              // of the mask
    bool squared = false;              // its square counts; the weight is 1 then
};

// Whether a material is that of the sea, which the renderer gives its waves; deep: nothing is seen
// below it.
enum class SeaWater : uint8_t { none, deep, clear };

enum class AlphaMode : uint8_t { opaque, mask, blend };

// How a texture layer meets the colour below it (kernels/texture_layers.glsl).
enum class LayerBlend : uint8_t { opaque, alpha, add, shade };

// A texture over the base colour.
struct TextureLayer {
    TextureUse texture;                // rgba
    glm::vec4 color{1};                // linear, multiplies it
    LayerBlend blend = LayerBlend::opaque;
};

// What the picture of a slope map is of.
enum class SlopeMapKind : uint8_t { normal, height, displacement };

// A map of slopes below a pixel: what is within a footprint bends and widens the reflection.
struct SlopeMapUse {
    TextureUse texture;                // linear
    SlopeMapKind kind = SlopeMapKind::normal;
    float scale = 1;                   // of slopes; else metres of the mesh a unit of the picture
    glm::vec2 extent{1};               // displacement: metres that the whole picture covers
};

// Null where the renderer can read such a map, else what is in its way.
inline const char* whyNotSlopes(const SlopeMapUse& use) {
    const Texture& t = *use.texture.texture;
    // Slopes of mirror images change their sign, which no reader of a map does.
    const bool mirrored = t.wrapU == Wrap::mirroredRepeat || t.wrapV == Wrap::mirroredRepeat;
    return mirrored && use.kind != SlopeMapKind::normal
               ? "is repeated in mirror images, which heights and displacements cannot be"
               : nullptr;
}

struct Material {
    std::string name;

    glm::vec4 baseColor{1};            // linear RGB and alpha
    TextureUse baseColorTexture;       // rgba
    float metallic = 0;
    float roughness = 1;
    TextureUse metallicRoughnessTexture;  // g: roughness, b: metallic
    TextureUse normalTexture;             // tangent space, y up (OpenGL)
    float normalScale = 1;
    glm::vec3 emission{0};             // radiance, W/(m^2 sr), strength included
    TextureUse emissionTexture;        // rgb

    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;          // single-sided surfaces are seen from both sides in a path
                                       // tracer too; single-sided *emission* leaves one side only
    bool unlit = false;                // KHR_materials_unlit: shows base colour as it is

    float ior = 1.5f;
    float specular = 1;                // KHR_materials_specular
    TextureUse specularTexture;        // a
    glm::vec3 specularColor{1};
    TextureUse specularColorTexture;   // rgb

    float coat = 0;                    // KHR_materials_clearcoat
    TextureUse coatTexture;            // r
    float coatRoughness = 0;
    TextureUse coatRoughnessTexture;   // g
    TextureUse coatNormalTexture;
    float coatNormalScale = 1;

    glm::vec3 sheenColor{0};           // KHR_materials_sheen
    TextureUse sheenColorTexture;      // rgb
    float sheenRoughness = 0;
    TextureUse sheenRoughnessTexture;  // a

    float transmission = 0;            // KHR_materials_transmission
    TextureUse transmissionTexture;    // r
    bool thinWalled = true;            // no KHR_materials_volume thickness: a sheet without inside
    glm::vec3 attenuationColor{1};     // KHR_materials_volume
    float attenuationDistance = std::numeric_limits<float>::infinity();  // metres

    float anisotropy = 0;              // KHR_materials_anisotropy: strength 0..1
    float anisotropyRotation = 0;      // radians, from the tangent towards the bitangent
    TextureUse anisotropyTexture;      // rg: direction, b: strength

    float iridescence = 0;             // KHR_materials_iridescence
    TextureUse iridescenceTexture;     // r
    float iridescenceIor = 1.3f;
    float iridescenceThicknessMinNm = 100;
    float iridescenceThicknessMaxNm = 400;
    TextureUse iridescenceThicknessTexture;  // g

    std::vector<SlopeMapUse> slopeMaps;  // added to the normal map and to each other, at most 4

    // Not empty: what the surface reflects is this stack, bottom first, all of one model; of the
    // fields above only base colour (a factor of the model's own), normal map, slope maps,
    // emission, alpha, attenuation and the anisotropy's rotation (of the tangent) count.
    std::vector<MaterialLayer> layers;

    SeaWater sea = SeaWater::none;

    std::vector<TextureLayer> textureLayers;  // over base colour times its texture, at most 2

    // Not empty: an animated material; all above says nothing, and frames[frame] shows. None of
    // the frames is animated.
    std::vector<std::shared_ptr<const Material>> frames;
    uint32_t frame = 0;

    const Material& shown() const { return frames.empty() ? *this : *frames[frame]; }
    // Whether rays may pass by its alpha, whichever frame shows.
    bool mayPass() const {
        for (const auto& f : frames)
            if (f->mayPass()) return true;
        return frames.empty() && alphaMode != AlphaMode::opaque;
    }
};

}  // namespace gp
