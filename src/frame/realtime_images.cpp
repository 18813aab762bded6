#include "frame/realtime_images.h"

#include <cstring>
#include <span>
#include <utility>

namespace gp {
namespace {

using Layer = RealtimeImage;

// Memory of images that have no use for it from some pass on, and who lives there then, side by
// side. Homes of the same memory are lived in one after the other. What the last frame left (the
// `previous` copies) is history from which on no pass reads it.
struct Home {
    RealtimeImage first, last;  // neighbours in the table
    bool previous;
    std::span<const RealtimeImage> lodgers;
};
constexpr Layer beforeLighting[] = {Layer::view, Layer::throughput};
constexpr Layer whileBlocksAreFiltered[] = {
    Layer::gradient_scale, Layer::gradient_other,       Layer::gradient_scale_other,
    Layer::indirect_low,   Layer::indirect_low_chroma,  Layer::indirect_other,
    Layer::indirect_other_chroma};
constexpr Layer whileDirectIsFiltered[] = {Layer::direct_other};
constexpr Layer whileSpecularIsFiltered[] = {Layer::specular_other};
constexpr Layer afterAtrous[] = {Layer::indirect, Layer::indirect_chroma};
constexpr Layer afterDenoising[] = {Layer::color};
constexpr Home homes[] = {
    // The last pass writes it.
    {Layer::output, Layer::output, false, beforeLighting},
    {Layer::output, Layer::output, false, whileDirectIsFiltered},
    // Lighting is the last to ask what was hit.
    {Layer::hit, Layer::barycentrics, true, whileBlocksAreFiltered},
    {Layer::hit, Layer::barycentrics, true, afterDenoising},
    // The temporal pass is the last to ask what was there; only for depth asks the last pass.
    {Layer::unmapped_normal, Layer::luma, true, whileSpecularIsFiltered},
    {Layer::unmapped_normal, Layer::history_length, true, afterAtrous},
};

constexpr size_t aligned(size_t bytes) { return (bytes + 63) & ~size_t(63); }

constexpr bool layersComeFirst() {
    for (size_t i = 0; i < realtimeImageCount; ++i)
        if ((realtimeImageInfos[i].memory == RealtimeMemory::SCRATCH) !=
            (i >= realtimeLayerCount))
            return false;
    return true;
}
static_assert(layersComeFirst());

size_t bytesOf(const RealtimeViews& views, RealtimeImage image) {
    const RealtimeImageInfo& info = realtimeImageInfo(image);
    const glm::ivec2 size = views.size[size_t(info.size)];
    return aligned(size_t(size.x) * size_t(size.y) * bytesPerPixel(info.format));
}

}  // namespace

uint32_t bytesPerPixel(RealtimeFormat format) {
    switch (format) {
        case RealtimeFormat::HALF4:
        case RealtimeFormat::UINT2: return 8;
        case RealtimeFormat::UNORM2: return 2;
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

bool RealtimeImages::holds(RealtimeImage image) const {
    const bool isFiltered = image == Layer::indirect || image == Layer::indirect_chroma;
    return views_.current[size_t(image)] && (filtered || !isFiltered) &&
           (sunsApart || image != Layer::sun);
}

// In tiny frames, where alignment counts for more than pixels, some find no room.
void RealtimeImages::lodge(Places& places) const {
    for (const Home& home : homes) {
        size_t next = places[size_t(home.first)].offset;
        const size_t end = places[size_t(home.last)].offset + bytesOf(views_, home.last);
        for (const RealtimeImage lodger : home.lodgers) {
            const size_t bytes = bytesOf(views_, lodger);
            if (next + bytes > end) continue;
            places[size_t(lodger)] = {home.previous ? Set::previous : Set::current, next};
            next += bytes;
        }
    }
}

void RealtimeImages::resize(glm::ivec2 full, glm::ivec2 output, ReuseImages reuse) {
    RealtimeImages made(lends_);
    made.views_.size[size_t(RealtimeSize::FULL)] = full;
    made.views_.size[size_t(RealtimeSize::THIRD)] = (full + 2) / 3;
    made.views_.size[size_t(RealtimeSize::OUTPUT)] = output;
    // Blocks begin up to 31 pixels outside of the picture (kernels/realtime/bmfr_fit.glsl).
    made.views_.size[size_t(RealtimeSize::BLOCK)] = (full + 31) / 32 + 1;
    const auto place = [&](Set set, size_t i, size_t& end) {
        made.places_[i] = {set, end};
        end += bytesOf(made.views_, RealtimeImage(i));
    };
    const auto isWanted = [&](RealtimeMemory memory) {
        switch (memory) {
            case RealtimeMemory::REUSE: return reuse.light;
            case RealtimeMemory::INDIRECT_REUSE: return reuse.indirect;
            case RealtimeMemory::BMFR: return reuse.bmfr;
            case RealtimeMemory::SUN: return reuse.suns;
            default: return true;  // lent ones too, where no other's memory has room
        }
    };
    size_t twice = 0, once = 0;
    for (size_t i = 0; i < realtimeImageCount; ++i)
        if (realtimeImageInfos[i].copies == 2 && isWanted(realtimeImageInfos[i].memory))
            place(Set::current, i, twice);
    if (lends_) made.lodge(made.places_);
    for (size_t i = 0; i < realtimeImageCount; ++i)
        if (realtimeImageInfos[i].copies == 1 && made.places_[i].set == Set::none &&
            isWanted(realtimeImageInfos[i].memory))
            place(Set::single, i, once);
    made.current_.resize(twice), made.previous_.resize(twice), made.single_.resize(once);
    made.reuse_ = reuse;
    take(made);
}

void RealtimeImages::take(RealtimeImages& made) {
    current_.swap(made.current_), previous_.swap(made.previous_), single_.swap(made.single_);
    places_ = made.places_, views_ = made.views_;
    reuse_ = made.reuse_;
    point();
}

void RealtimeImages::rescale(glm::ivec2 full, ReuseImages reuse) {
    RealtimeImages made(lends_);
    made.resize(full, views_.size[size_t(RealtimeSize::OUTPUT)], reuse);
    for (size_t i = 0; i < realtimeImageCount; ++i) {
        const RealtimeImageInfo& info = realtimeImageInfos[i];
        const bool stays = info.memory != RealtimeMemory::LENT &&
                           info.memory != RealtimeMemory::SCRATCH;
        if (!stays || !views_.current[i] || !made.views_.current[i]) continue;
        const glm::ivec2 from = views_.size[size_t(info.size)];
        const glm::ivec2 to = made.views_.size[size_t(info.size)];
        const size_t bytes = gp::bytesPerPixel(info.format);
        std::byte* out = made.views_.current[i];
        for (int y = 0; y < to.y; ++y)
            for (int x = 0; x < to.x; ++x, out += bytes) {
                const glm::ivec2 p = nearestPixel({x, y}, to, from);
                const size_t index = size_t(p.y) * size_t(from.x) + size_t(p.x);
                std::memcpy(out, views_.current[i] + index * bytes, bytes);
            }
    }
    take(made);
}

void RealtimeImages::point() {
    for (size_t i = 0; i < realtimeImageCount; ++i) {
        std::byte* const sets[] = {nullptr, current_.data(), previous_.data(), single_.data()};
        const Place& place = places_[i];
        std::byte* const set = sets[size_t(place.set)];
        views_.current[i] = set ? set + place.offset : nullptr;
        const bool twice = set && realtimeImageInfos[i].copies == 2;
        views_.previous[i] = twice ? previous_.data() + place.offset : nullptr;
    }
}

void RealtimeImages::swap() {
    current_.swap(previous_);
    point();
}

uint64_t RealtimeImages::bytes() const {
    return current_.size() + previous_.size() + single_.size();
}

size_t RealtimeImages::bytesPerPixel() {
    size_t full = 0, third = 0;
    for (const RealtimeImageInfo& info : realtimeImageInfos)
        if (info.memory == RealtimeMemory::OWN)
            (info.size == RealtimeSize::THIRD ? third : full) +=
                info.copies * gp::bytesPerPixel(info.format);
    return full + (third + 8) / 9;
}

}  // namespace gp
