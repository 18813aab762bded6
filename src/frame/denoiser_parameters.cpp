#include "frame/denoiser_parameters.h"

namespace gp {
namespace {

constexpr DenoiserParameterInfo infos[] = {
#define X(name, initial, minimum, maximum, text) \
    {#name, initial, minimum, maximum, text, &DenoiserParameters::name},
#include "shared/denoiser_parameters.def"
#undef X
};

}  // namespace

std::span<const DenoiserParameterInfo> denoiserParameters() { return infos; }

}  // namespace gp
