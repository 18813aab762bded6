// The light that goes down into a sea, and what its water sends back: constants of a frame.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "scene/sea.h"
#include "shared/scene_structs.h"

namespace gp {

// Light from all sides, as far as flat water tells it apart: by height above the horizon.
struct SkyRows {
    const glm::vec3* means = nullptr;  // radiance, from the zenith to the nadir; null: 1 everywhere
    uint32_t count = 0;
    glm::vec3 color{1};                // times that
};

// As shading/ocean/water_light.glsl takes it.
struct WaterLight {
    glm::vec3 radiance{0};  // W/(m^2 sr), upwards, just below the surface of very deep water
    float stretch = 1;      // metres that the light from above has gone for each metre of depth
};

// The share of the light that enters deep water which leaves it again; the rest is absorbed.
glm::vec3 seaReflectance(const SeaSettings& sea);

// Through a flat surface; `suns`: directional lights. Nothing casts a shadow, and other lights are
// not in it.
WaterLight waterLight(const SeaSettings& sea, const shared::LightRecord* suns, uint32_t count,
                      const SkyRows& sky);

}  // namespace gp
