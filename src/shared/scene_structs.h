// The C++ side of scene_structs.glsl.
#pragma once

#include <cstddef>

#include "shading/lang.h"

namespace gp::shared {
using namespace glm;
#include "shared/scene_structs.glsl"

static_assert(sizeof(Hit) == 20);
static_assert(sizeof(TextureSlot) == 48);
static_assert(offsetof(MaterialRecord, specular) == 80);
static_assert(offsetof(MaterialRecord, base_color_slot) == 176);
static_assert(sizeof(MaterialRecord) == 176 + 15 * sizeof(TextureSlot));
static_assert(sizeof(BsdfLayerRecord) == 64);
static_assert(sizeof(TextureLayerRecord) == 96);
static_assert(sizeof(MaterialSlopes) == 80 && offsetof(MaterialSlopes, rise) == 64);
static_assert(sizeof(InstanceRecord) == 112);
static_assert(sizeof(TriangleCorners) == 88 || sizeof(TriangleCorners) == 96);
static_assert(sizeof(LightRecord) == 96 && offsetof(LightRecord, cos_outer) == 80);
static_assert(sizeof(LightTreeNode) == 384 && offsetof(LightTreeNode, parent) == 352);
static_assert(sizeof(EnvironmentCell) == 8);
static_assert(sizeof(FrameConstants) == 192 && offsetof(FrameConstants, environment_color) == 48);
static_assert(offsetof(FrameConstants, background_color) == 96 &&
              offsetof(FrameConstants, sky_viewer) == 112 &&
              offsetof(FrameConstants, water_attenuation) == 128 &&
              offsetof(FrameConstants, water_radiance) == 176);
static_assert(sizeof(LocalLightingConstants) == 56 &&
              offsetof(LocalLightingConstants, sky_mean) == 32);
}  // namespace gp::shared
