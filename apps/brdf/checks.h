// glitterpath brdf check: what a model keeps of the laws of light, in numbers.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "brdf/models.h"

namespace gp::tool {

enum class Verdict { ok, failed, notClaimed, notApplicable };

struct Check {
    std::string name;
    Verdict verdict = Verdict::ok;
    std::string text;              // the numbers for people
    nlohmann::ordered_json json;   // and for programs
};

// What the model says of itself for all values of its parameters (`glitterpath brdf list`).
struct Claims {
    bool reciprocal = false, conserving = false;
};

Check checkReciprocity(GpDevice device, const Model& model, const Claims& claims);
Check checkPositivity(GpDevice device, const Model& model);
Check checkAlbedo(GpDevice device, const Model& model, const Claims& claims);
// With the parameters that make it white, as far as it has such.
Check checkWhiteFurnace(GpDevice device, const Model& model, const Claims& claims);
// Masking and distribution alone, without shadowing. [Heitz 2014, section 5.1]
Check checkWeakWhiteFurnace(GpDevice device, const Model& model);
// Do samples follow their density?
Check checkSampling(GpDevice device, const Model& model, std::size_t samples);

}  // namespace gp::tool
