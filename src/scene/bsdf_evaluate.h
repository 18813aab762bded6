// Values and samples of a model, for people and tables: what the renderer computes, f without the
// cosine.
#pragma once

#include <cstdint>
#include <memory>

#include "scene/bsdf_registry.h"

namespace gp {

struct BsdfReading {
    glm::vec3 f{0};  // 1/sr; 0 where wi lies in the surface
    float pdf = 0;   // 1/sr, of sampling wi for this wo
};

// Bits of BsdfDraw::lobe.
enum BsdfLobe : uint32_t {
    bsdfLobeDiffuse = 1,
    bsdfLobeGlossy = 2,
    bsdfLobeSpecular = 4,
    bsdfLobeTransmission = 8
};

struct BsdfDraw {
    glm::vec3 wi{0};      // to the light; 0 where the sample failed
    float pdf = 0;
    glm::vec3 weight{0};  // f |cos_i| / pdf
    uint32_t lobe = 0;
};

// A model with all that it derives from its parameters, which may take longer than thousands of
// values. wi to the light, wo to the viewer; unit length; the normal is +Z, the tangent +X. Any
// number of threads may use one.
class PreparedBsdf {
public:
    explicit PreparedBsdf(const BsdfSettings& settings);
    ~PreparedBsdf();
    PreparedBsdf(const PreparedBsdf&) = delete;
    PreparedBsdf& operator=(const PreparedBsdf&) = delete;

    BsdfReading evaluate(const glm::vec3& wi, const glm::vec3& wo) const;
    // u: for the choice of the lobe and for the direction, each in [0, 1).
    BsdfDraw sample(const glm::vec3& wo, const glm::vec3& u) const;

private:
    struct State;
    std::unique_ptr<const State> state_;
};

// One value.
BsdfReading evaluateBsdf(const BsdfSettings& settings, const glm::vec3& wi, const glm::vec3& wo);

}  // namespace gp
