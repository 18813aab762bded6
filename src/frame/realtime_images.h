// The images of a real-time frame, by the table shared/realtime_images.def.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace gp {

enum class RealtimeFormat : uint8_t {
    FLOAT1, HALF2, HALF4, POSITIVE3, RGB9E5, UNORM2, UNORM4, UINT1, UINT2
};
// BLOCK: of no image, but what a kernel is counted in that does BMFR's blocks of 32 x 32 pixels.
enum class RealtimeSize : uint8_t { FULL, THIRD, OUTPUT, BLOCK };
enum class RealtimeMemory : uint8_t { OWN, REUSE, INDIRECT_REUSE, BMFR, SUN, LENT, SCRATCH };

enum class RealtimeImage : uint32_t {
#define X(name, format, size, copies, memory, meaning) name,
#include "shared/realtime_images.def"
#undef X
    count
};
constexpr size_t realtimeImageCount = size_t(RealtimeImage::count);

struct RealtimeImageInfo {
    const char* name;
    RealtimeFormat format;
    RealtimeSize size;
    uint32_t copies;
    RealtimeMemory memory;
    const char* meaning;
};
constexpr RealtimeImageInfo realtimeImageInfos[realtimeImageCount] = {
#define X(name, format, size, copies, memory, meaning)                                        \
    {#name, RealtimeFormat::format, RealtimeSize::size, copies, RealtimeMemory::memory, meaning},
#include "shared/realtime_images.def"
#undef X
};
constexpr const RealtimeImageInfo& realtimeImageInfo(RealtimeImage image) {
    return realtimeImageInfos[size_t(image)];
}
uint32_t bytesPerPixel(RealtimeFormat format);
// The pixel of an image of `otherSize` that lies under the middle of `pixel` in one of `size`.
glm::ivec2 nearestPixel(glm::ivec2 pixel, glm::ivec2 size, glm::ivec2 otherSize);

// Those that can be looked at when a frame is done, which come first.
constexpr size_t realtimeLayerCount = 0
#define X(name, format, size, copies, memory, meaning) \
    + (RealtimeMemory::memory != RealtimeMemory::SCRATCH ? 1 : 0)
#include "shared/realtime_images.def"
#undef X
    ;

// Which images options and scene ask for, beside those that every frame has.
struct ReuseImages {
    bool light = false, indirect = false;
    bool bmfr = false;  // the denoiser that fits
    bool suns = false;  // reflected by surfaces of slopes
    bool operator==(const ReuseImages&) const = default;
};

// Where the kernels find the pixels, row after row; `previous` is null where there is one copy,
// both are where the frame's options need no such image.
struct RealtimeViews {
    glm::ivec2 size[4];  // by RealtimeSize
    std::byte* current[realtimeImageCount];
    std::byte* previous[realtimeImageCount];
};

class RealtimeImages {
public:
    // `lends`: images share memory as the table says. Tests compare with frames that do not.
    explicit RealtimeImages(bool lends = true) : lends_(lends) {}
    RealtimeImages(const RealtimeImages&) = delete;
    RealtimeImages& operator=(const RealtimeImages&) = delete;

    // `full`: of rays; `output`: of the picture, not smaller. All zeros. Throws std::bad_alloc.
    void resize(glm::ivec2 full, glm::ivec2 output, ReuseImages reuse = {});
    // Another size of rays, or other images, for the same picture: what the last frame left for the
    // next stays, each new pixel taking that of the nearest old one. Throws std::bad_alloc, nothing
    // changed then.
    void rescale(glm::ivec2 full, ReuseImages reuse);
    // What this frame writes becomes what the next one remembers.
    void swap();
    const RealtimeViews& views() const { return views_; }
    glm::ivec2 size(RealtimeImage image) const;
    // Whether the image can be looked at, now that the frame is done.
    bool holds(RealtimeImage image) const;
    ReuseImages reuse() const { return reuse_; }
    uint64_t bytes() const;
    // Of all images together where output and full are of one size, without any reuse; rounded
    // up.
    static size_t bytesPerPixel();

    bool filtered = false;  // a denoiser has run over the light
    bool sunsApart = false; // `sun` has a part of it

private:
    enum class Set : uint8_t { none, current, previous, single };
    struct Place {
        Set set = Set::none;
        size_t offset = 0;
    };
    using Places = std::array<Place, realtimeImageCount>;

    void lodge(Places& places) const;
    void point();
    void take(RealtimeImages& made);

    bool lends_;
    // Images of two copies: this frame's and the last one's, in turns; then all others.
    std::vector<std::byte> current_, previous_, single_;
    Places places_;
    RealtimeViews views_{};
    ReuseImages reuse_;
};

}  // namespace gp
