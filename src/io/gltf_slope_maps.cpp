// Slope maps of a glTF material: its member extras.glitterpath.slopeMaps, a list of normal, height
// and displacement maps over the material's own normal map.
#include <algorithm>

#include <fmt/format.h>

#include "io/gltf_material.h"

namespace gp::io {

namespace {

constexpr const char* members[] = {"kind", "texture", "scale", "extent"};
constexpr const char* kinds[] = {"normal", "height", "displacement"};
constexpr size_t limit = 4;

SlopeMapKind kindOf(const Value& map) {
    const std::string kind = map["kind"].asText();
    const auto found = std::find(std::begin(kinds), std::end(kinds), kind);
    if (found == std::end(kinds))
        map["kind"].fail(fmt::format("must be one of {}", fmt::join(kinds, ", ")));
    return SlopeMapKind(found - std::begin(kinds));
}

SlopeMapUse lengthsOf(const Value& map) {
    for (const std::string& key : map.keys())
        if (std::find(std::begin(members), std::end(members), key) == std::end(members))
            map.fail(fmt::format("'{}' is none of {}", key.substr(0, 40),
                                 fmt::join(members, ", ")));
    SlopeMapUse use;
    use.kind = kindOf(map);
    use.scale = map.real("scale", 1);
    if (use.scale == 0) map["scale"].fail("must not be 0");
    const auto extent = map.find("extent");
    if (!extent) return use;
    if (use.kind != SlopeMapKind::displacement)
        extent->fail("counts for displacement maps only");
    use.extent = map.vec<2>("extent", glm::vec2(1));
    if (!(use.extent.x > 0 && use.extent.y > 0)) extent->fail("must be above 0");
    return use;
}

}  // namespace

void Materials::readSlopeMaps(const Value& value, Material& m) {
    const auto extras = value.find("extras");
    if (!extras || !extras->isObject()) return;  // other programs' extras may be anything
    const auto ours = extras->find("glitterpath");
    if (!ours) return;
    const auto maps = ours->find("slopeMaps");
    if (!maps) return;
    if (maps->size() > limit) maps->fail(fmt::format("has more than {} maps", limit));
    m.slopeMaps.reserve(maps->size());  // textures are put into their places later
    for (size_t i = 0; i < maps->size(); ++i) {
        const Value map = maps->at(i);
        m.slopeMaps.push_back(lengthsOf(map));
        map["texture"];
        if (!use(map, "texture", ColorSpace::linear, m.slopeMaps.back().texture))
            m.slopeMaps.pop_back();
    }
}

void Materials::checkSlopeMaps() const {
    for (const auto& [index, entry] : m_entries)
        for (size_t i = 0; i < entry.material->slopeMaps.size(); ++i)
            if (const char* why = whyNotSlopes(entry.material->slopeMaps[i]))
                m_document.element("materials", uint32_t(index))
                    .fail(fmt::format("extras.glitterpath.slopeMaps: the texture of map {} {}", i,
                                      why));
}

}  // namespace gp::io
