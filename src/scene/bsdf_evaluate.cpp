#include "scene/bsdf_evaluate.h"

#include <cmath>

#include "shading/shading.h"

#include "scene/bsdf_settings.h"

namespace gp {

static_assert(bsdfLobeDiffuse == LOBE_DIFFUSE && bsdfLobeGlossy == LOBE_GLOSSY
              && bsdfLobeSpecular == LOBE_SPECULAR && bsdfLobeTransmission == LOBE_TRANSMISSION);

struct PreparedBsdf::State {
    shading::BsdfParams params;
};

PreparedBsdf::PreparedBsdf(const BsdfSettings& settings)
    : state_(new State{bsdfParamsFrom(settings)}) {}

PreparedBsdf::~PreparedBsdf() = default;

BsdfReading PreparedBsdf::evaluate(const glm::vec3& wi, const glm::vec3& wo) const {
    const shading::BsdfValue value = shading::bsdf_eval(state_->params, wo, wi);
    BsdfReading reading;
    reading.pdf = value.pdf;
    if (wi.z != 0.0f) reading.f = value.f_cos / std::abs(wi.z);
    return reading;
}

BsdfDraw PreparedBsdf::sample(const glm::vec3& wo, const glm::vec3& u) const {
    const shading::BsdfSample s =
        shading::bsdf_sample(state_->params, wo, u.x, glm::vec2(u.y, u.z));
    BsdfDraw draw;
    if (!(s.pdf > 0.0f)) return draw;
    draw.wi = s.wi;
    draw.pdf = s.pdf;
    draw.weight = s.weight;
    draw.lobe = s.lobe;
    return draw;
}

BsdfReading evaluateBsdf(const BsdfSettings& settings, const glm::vec3& wi, const glm::vec3& wo) {
    return PreparedBsdf(settings).evaluate(wi, wo);
}

}  // namespace gp
