#include "backend/cpu/slope_table.h"

#include "backend/cpu/texture_view.h"

namespace gp::cpu {

void SlopeTable::beginFill() {
    views_.clear(), records_.clear();
    for (auto& [key, image] : images_) image.index = NO_INDEX;
}

void SlopeTable::endFill() {
    std::erase_if(images_, [](const auto& entry) { return entry.second.index == NO_INDEX; });
}

static SlopeMap mapOf(const SlopeMapUse& use) {
    const Texture& texture = *use.texture.texture;
    if (use.kind == SlopeMapKind::height) return slopeMapFromHeights(texture);
    if (use.kind == SlopeMapKind::displacement)
        return slopeMapFromOffsets(texture, use.scale, use.extent);
    return slopeMapFromNormals(texture);
}

const SlopeTable::Image& SlopeTable::imageOf(const SlopeMapUse& use) {
    const bool displacement = use.kind == SlopeMapKind::displacement;
    const glm::vec3 lengths = displacement ? glm::vec3(use.scale, use.extent) : glm::vec3(0);
    const Texture* texture = use.texture.texture.get();
    const auto [it, fresh] =
        images_.try_emplace({texture, use.kind, lengths.x, lengths.y, lengths.z});
    Image& image = it->second;
    if (fresh || image.revision != texture->revision) {
        image.map = mapOf(use);
        image.texture = use.texture.texture, image.revision = texture->revision;
    }
    if (image.index == NO_INDEX) {
        image.index = uint32_t(views_.size());
        views_.push_back(slopeMapView(image.map));
    }
    return image;
}

// Unit length, or zero where a transform leaves nothing of a coordinate.
static glm::vec2 directionOf(glm::vec2 v) {
    const float l = glm::length(v);
    return l > 0 ? v / l : glm::vec2(0);
}

shared::MaterialSlopes& SlopeTable::add(const SlopeMapUse& use, bool turned) {
    const Image& image = imageOf(use);
    shared::MaterialSlopes r{};
    r.slope_map = image.index;
    if (use.kind == SlopeMapKind::normal) {
        // Where u and v of the image grow over the mesh's coordinates; slopes point along +u and
        // against v.
        const glm::mat3x2& m = use.texture.uvTransform;
        const glm::vec2 u = turned ? directionOf({m[0][0], m[1][0]}) : glm::vec2(1, 0);
        const glm::vec2 v = turned ? directionOf({m[0][1], m[1][1]}) : glm::vec2(0, 1);
        r.to_x = use.scale * glm::vec2(u.x, -v.x), r.to_y = use.scale * glm::vec2(-u.y, v.y);
    } else {
        r.rise = image.map.rise * (use.kind == SlopeMapKind::height ? use.scale : 1.0f);
    }
    return records_.emplace_back(r);
}

}  // namespace gp::cpu
