#include "frame/realtime_images.h"

#include <cstring>
#include <utility>

namespace gp {
namespace {

constexpr RealtimeImageInfo infos[] = {
#define X(name, format, size, copies, meaning) \
    {#name, RealtimeFormat::format, RealtimeSize::size, copies, meaning},
#include "shared/realtime_images.def"
#undef X
};

// Images that the denoisers need for a moment, in memory that nothing else needs then: the colour
// is composed when they are done, and what the last frame hit matters only before this one is lit.
// Not any image that the temporal pass reads: it writes both of these.
struct Loan {
    RealtimeImage image, owner;
    bool previous;
};
static_assert(infos[realtimeLayerCount - 1].copies > 0 && infos[realtimeLayerCount].copies == 0,
              "images without memory of their own come last");
constexpr Loan loans[] = {
    {RealtimeImage::direct_other, RealtimeImage::color, false},
    {RealtimeImage::specular_other, RealtimeImage::hit, true},
};

size_t pixels(glm::ivec2 size) { return size_t(size.x) * size_t(size.y); }

}  // namespace

const RealtimeImageInfo& realtimeImageInfo(RealtimeImage image) { return infos[size_t(image)]; }

uint32_t bytesPerPixel(RealtimeFormat format) {
    switch (format) {
        case RealtimeFormat::HALF4:
        case RealtimeFormat::UINT2: return 8;
        default: return 4;
    }
}

glm::ivec2 nearestPixel(glm::ivec2 pixel, glm::ivec2 size, glm::ivec2 otherSize) {
    return {int((int64_t(2 * pixel.x) + 1) * otherSize.x / (2 * size.x)),
            int((int64_t(2 * pixel.y) + 1) * otherSize.y / (2 * size.y))};
}

glm::ivec2 RealtimeImages::size(RealtimeImage image) const {
    return views_.size[size_t(realtimeImageInfo(image).size)];
}

void RealtimeImages::resize(glm::ivec2 full, glm::ivec2 output) {
    RealtimeViews views{};
    views.size[size_t(RealtimeSize::FULL)] = full;
    views.size[size_t(RealtimeSize::THIRD)] = (full + 2) / 3;
    views.size[size_t(RealtimeSize::OUTPUT)] = output;
    std::array<std::vector<std::byte>, realtimeImageCount> current, previous;
    for (size_t i = 0; i < realtimeImageCount; ++i) {
        if (infos[i].copies == 0) continue;
        const size_t bytes = pixels(views.size[size_t(infos[i].size)]) *
                             gp::bytesPerPixel(infos[i].format);
        current[i].resize(bytes);
        views.current[i] = current[i].data();
        if (infos[i].copies < 2) continue;
        previous[i].resize(bytes);
        views.previous[i] = previous[i].data();
    }
    current_.swap(current), previous_.swap(previous);
    views_ = views;
    lend();
}

void RealtimeImages::rescale(glm::ivec2 full) {
    RealtimeImages next;
    next.resize(full, views_.size[size_t(RealtimeSize::OUTPUT)]);
    for (size_t i = 0; i < realtimeImageCount; ++i) {
        if (infos[i].copies < 2) continue;
        const glm::ivec2 from = views_.size[size_t(infos[i].size)];
        const glm::ivec2 to = next.views_.size[size_t(infos[i].size)];
        const size_t bytes = gp::bytesPerPixel(infos[i].format);
        std::byte* out = next.current_[i].data();
        for (int y = 0; y < to.y; ++y)
            for (int x = 0; x < to.x; ++x, out += bytes) {
                const glm::ivec2 p = nearestPixel({x, y}, to, from);
                const size_t index = size_t(p.y) * size_t(from.x) + size_t(p.x);
                std::memcpy(out, current_[i].data() + index * bytes, bytes);
            }
    }
    next.filtered = filtered;
    *this = std::move(next);
}

void RealtimeImages::lend() {
    for (const Loan& loan : loans)
        views_.current[size_t(loan.image)] =
            (loan.previous ? views_.previous : views_.current)[size_t(loan.owner)];
}

void RealtimeImages::swap() {
    for (size_t i = 0; i < realtimeImageCount; ++i) {
        if (infos[i].copies < 2) continue;
        current_[i].swap(previous_[i]);
        std::swap(views_.current[i], views_.previous[i]);
    }
    lend();
}

uint64_t RealtimeImages::bytes() const {
    uint64_t sum = 0;
    for (size_t i = 0; i < realtimeImageCount; ++i) sum += current_[i].size() + previous_[i].size();
    return sum;
}

size_t RealtimeImages::bytesPerPixel() {
    size_t full = 0, third = 0;
    for (const RealtimeImageInfo& info : infos)
        (info.size == RealtimeSize::THIRD ? third : full) +=
            info.copies * gp::bytesPerPixel(info.format);
    return full + (third + 8) / 9;
}

}  // namespace gp
