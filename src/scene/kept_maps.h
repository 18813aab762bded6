// Another material in the place of one, with what of the old one varies over the surface or belongs
// to the thing itself (GpReplacedMaterials).
#pragma once

#include <cstdint>

#include "scene/material.h"

namespace gp {

// GP_MAP_ bits.
enum MaterialMap : uint32_t {
    mapBaseColor = 1 << 0,
    mapNormal = 1 << 1,
    mapSlopes = 1 << 2,
    mapAlpha = 1 << 3,
    mapEmission = 1 << 4,
    mapRoughness = 1 << 5,
    mapMetallic = 1 << 6,
    mapOthers = 1 << 7,
};

struct MaterialWithMaps {
    Material material;
    uint32_t kept = 0, left = 0;
};

// `replacement` with the maps of `old` that `keep` names, where it has a use for them and none of
// its own. Neither is animated.
MaterialWithMaps withMapsOf(const Material& old, const Material& replacement, uint32_t keep);

}  // namespace gp
