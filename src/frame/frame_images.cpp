#include "frame/frame_images.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "shading/shading.h"

namespace gp {
namespace {

glm::vec3 varianceOfMean(const PixelSums& s) {
    if (s.samples < 2) return glm::vec3(0);
    const float n = float(s.samples);
    const glm::vec3 mean = glm::vec3(s.color) / n;
    return glm::max(s.colorSquared / n - mean * mean, 0.0f) / (n - 1);
}

glm::vec4 resolve(const PixelSums& s, FrameImage which) {
    const float inv = s.samples ? 1.0f / float(s.samples) : 0.0f;
    const float invHits = s.hits > 0 ? 1.0f / s.hits : 0.0f;
    switch (which) {
        case FrameImage::color: return s.color * inv;
        case FrameImage::albedo: return {s.albedo * inv, 1};
        case FrameImage::normal: return {s.normal * inv, 0};
        case FrameImage::depth:
            return glm::vec4(s.hits > 0 ? s.depth * invHits
                                        : std::numeric_limits<float>::infinity());
        case FrameImage::emission: return {s.emission * inv, 1};
        case FrameImage::direct: return {s.direct * inv, 1};
        case FrameImage::indirect:
            return {glm::max(glm::vec3(s.color) - s.emission - s.direct, 0.0f) * inv, 1};
        case FrameImage::roughness: return {s.roughness * invHits, s.metallic * invHits, 0, 1};
        case FrameImage::variance: return {varianceOfMean(s), 0};
        default: return glm::vec4(0);
    }
}

constexpr FrameImageInfo infos[] = {
#define BYTES_rgba32f 16
#define BYTES_rgba8 4
#define BYTES_r32f 4
#define BYTES_r32ui 4
#define X(id, NAME, format, channels, meaning) \
    {#id, FrameImageFormat::format, channels, BYTES_##format},
#include "shared/frame_images.def"
#undef X
};

}  // namespace

const FrameImageInfo& frameImageInfo(FrameImage image) { return infos[size_t(image)]; }

void readFrameImage(const FrameImages& images, FrameImage which, void* pixels) {
    const size_t n = images.pixelCount();
    if (which == FrameImage::display) {
        std::memcpy(pixels, images.display.data(), n * sizeof(glm::u8vec4));
    } else if (which == FrameImage::instance) {
        auto* out = static_cast<uint32_t*>(pixels);
        for (size_t i = 0; i < n; ++i) out[i] = images.sums[i].instance;
    } else if (which == FrameImage::depth) {
        auto* out = static_cast<float*>(pixels);
        for (size_t i = 0; i < n; ++i) out[i] = resolve(images.sums[i], which).x;
    } else if (which == FrameImage::color && !images.drawn.empty()) {
        std::memcpy(pixels, images.drawn.data(), n * sizeof(glm::vec4));
    } else {
        auto* out = static_cast<glm::vec4*>(pixels);
        for (size_t i = 0; i < n; ++i) out[i] = resolve(images.sums[i], which);
    }
}

double estimateNoise(const FrameImages& images) {
    double difference = 0, mean = 0;
    size_t known = 0;
    for (const PixelSums& s : images.sums) {
        if (s.samples < 2) continue;
        const uint32_t odd = s.samples / 2, even = s.samples - odd;
        const float sum = shading::luminance(glm::vec3(s.color));
        // The picture is about the mean of its halves, and its error of the size of half of what
        // they differ by.
        difference += 0.5 * double(std::abs((sum - s.oddLuminance) / float(even) -
                                            s.oddLuminance / float(odd)));
        mean += double(sum) / double(s.samples);
        ++known;
    }
    if (known == 0) return -1;
    return mean > 0 ? difference / mean : 0;
}

}  // namespace gp
