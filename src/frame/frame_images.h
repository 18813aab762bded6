// The images of a frame: what the passes write, and what they are read back as.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

// What the path pass adds up, one an image pixel. Sums over the samples taken so far, in the order
// of the samples, so that the bits depend neither on threads nor on how renders are cut in batches.
struct PixelSums {
    glm::vec4 color{0};        // radiance and coverage
    glm::vec3 colorSquared{0}; // of each sample, for the variance
    uint32_t samples = 0;
    glm::vec3 emission{0};
    float depth = 0;           // over the samples that met something: coverage counts them
    glm::vec3 direct{0};
    float hits = 0;            // samples whose camera ray met a surface
    glm::vec3 albedo{0};
    float roughness = 0;
    glm::vec3 normal{0};
    float metallic = 0;
    uint32_t instance = 0;
    float oddLuminance = 0;    // of the samples with odd numbers: half of the picture
};

enum class FrameImage : uint32_t {
#define X(id, NAME, format, channels, meaning) id,
#include "shared/frame_images.def"
#undef X
    count
};

enum class FrameImageFormat : uint32_t { rgba32f, rgba8, r32f, r32ui };

struct FrameImageInfo {
    const char* name;
    FrameImageFormat format;
    const char* channels;  // letters of the EXR layer
    uint32_t bytesPerPixel;
};
const FrameImageInfo& frameImageInfo(FrameImage image);

struct FrameImages {
    uint32_t width = 0, height = 0;
    std::vector<PixelSums> sums;      // width * height
    std::vector<glm::u8vec4> display; // written by the tone-mapping pass
    std::vector<glm::vec4> drawn;     // color with what was rasterised into it; empty: nothing was
    size_t pixelCount() const { return size_t(width) * height; }
    uint64_t bytes() const {
        return sums.size() * sizeof sums[0] + display.size() * sizeof display[0] +
               drawn.size() * sizeof drawn[0];
    }
};

// Resolves an image into `pixels`, which has room for pixelCount() * bytesPerPixel.
void readFrameImage(const FrameImages& images, FrameImage which, void* pixels);

// The mean absolute error of luminance over its mean, from the difference of the picture's two
// halves, the even and the odd samples: unlike the spread of single samples it knows that they are
// stratified, and a few bright outliers do not drown it. Negative below two samples a pixel.
double estimateNoise(const FrameImages& images);

}  // namespace gp
