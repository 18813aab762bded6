// One value of a model, for people and tables: what the renderer computes, without the cosine.
#pragma once

#include "scene/bsdf_registry.h"

namespace gp {

struct BsdfReading {
    glm::vec3 f{0};  // 1/sr; 0 where wi lies in the surface
    float pdf = 0;   // 1/sr, of sampling wi for this wo
};

// wi to the light, wo to the viewer; unit length; the normal is +Z, the tangent +X.
BsdfReading evaluateBsdf(const BsdfSettings& settings, const glm::vec3& wi, const glm::vec3& wo);

}  // namespace gp
