// The images of a real-time frame, by the table shared/realtime_images.def.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

enum class RealtimeFormat : uint8_t { FLOAT1, HALF2, HALF4, POSITIVE3, UNORM4, UINT1, UINT2 };
enum class RealtimeSize : uint8_t { FULL, THIRD, OUTPUT };

enum class RealtimeImage : uint32_t {
#define X(name, format, size, copies, meaning) name,
#include "shared/realtime_images.def"
#undef X
    count
};
constexpr size_t realtimeImageCount = size_t(RealtimeImage::count);
// Those with memory of their own, which come first: what can be looked at.
constexpr size_t realtimeLayerCount = 0
#define X(name, format, size, copies, meaning) + (copies > 0 ? 1 : 0)
#include "shared/realtime_images.def"
#undef X
    ;

struct RealtimeImageInfo {
    const char* name;
    RealtimeFormat format;
    RealtimeSize size;
    uint32_t copies;
    const char* meaning;
};
const RealtimeImageInfo& realtimeImageInfo(RealtimeImage image);
uint32_t bytesPerPixel(RealtimeFormat format);
// The pixel of an image of `otherSize` that lies under the middle of `pixel` in one of `size`.
glm::ivec2 nearestPixel(glm::ivec2 pixel, glm::ivec2 size, glm::ivec2 otherSize);

// Where the kernels find the pixels, row after row; `previous` is null where there is one copy.
struct RealtimeViews {
    glm::ivec2 size[3];  // by RealtimeSize
    std::byte* current[realtimeImageCount];
    std::byte* previous[realtimeImageCount];
};

class RealtimeImages {
public:
    // `full`: of rays; `output`: of the picture. All zeros. Throws std::bad_alloc.
    void resize(glm::ivec2 full, glm::ivec2 output);
    // Another size of rays for the same picture: what the last frame wrote stays, each new pixel
    // taking that of the nearest old one. Throws std::bad_alloc, and nothing has changed.
    void rescale(glm::ivec2 full);
    // What this frame writes becomes what the next one remembers.
    void swap();
    const RealtimeViews& views() const { return views_; }
    glm::ivec2 size(RealtimeImage image) const;
    uint64_t bytes() const;
    // Of all images together where output and full are of one size, rounded up.
    static size_t bytesPerPixel();

    bool filtered = false;  // a denoiser has run over the light

private:
    void lend();

    std::array<std::vector<std::byte>, realtimeImageCount> current_, previous_;
    RealtimeViews views_{};
};

}  // namespace gp
