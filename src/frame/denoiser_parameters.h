// What of the denoisers, light reuse and anti-aliasing a person may turn
// (shared/denoiser_parameters.def).
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace gp {

struct DenoiserParameters {
#define X(name, initial, minimum, maximum, text) float name = initial;
#include "shared/denoiser_parameters.def"
#undef X
};

struct DenoiserParameterInfo {
    const char* name;
    float initial, minimum, maximum;
    const char* text;
    float DenoiserParameters::* member;
};
std::span<const DenoiserParameterInfo> denoiserParameters();
// Who looks at it: names of denoisers, "light reuse", "indirect reuse",
// "anti-aliasing".
std::vector<std::string_view> usersOf(const DenoiserParameterInfo& parameter);

}  // namespace gp
