#include "scene/bsdf_evaluate.h"

#include <cmath>

#include "shading/shading.h"

#include "scene/bsdf_settings.h"

namespace gp {

BsdfReading evaluateBsdf(const BsdfSettings& settings, const glm::vec3& wi, const glm::vec3& wo) {
    const shading::BsdfValue value = shading::bsdf_eval(bsdfParamsFrom(settings), wo, wi);
    BsdfReading reading;
    reading.pdf = value.pdf;
    if (wi.z != 0.0f) reading.f = value.f_cos / std::abs(wi.z);
    return reading;
}

}  // namespace gp
