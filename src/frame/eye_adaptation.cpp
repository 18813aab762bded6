#include "frame/eye_adaptation.h"

#include <algorithm>
#include <cmath>

#include "shading/shading.h"

namespace gp {
namespace {

using namespace glm;
using namespace gp::shading;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
struct Rule {
    static vec4 load_output(ivec2) { return vec4(0); }
#include "kernels/realtime/exposure.glsl"
};
#pragma GCC diagnostic pop
static_assert(exposureBins == EXPOSURE_BINS);

constexpr double darkShare = 0.5, brightShare = 0.95;
const float middleGreyStop = std::log2(0.18f);  // [ISO 12232:2019: the reflectance of a grey card]

}  // namespace

float exposureEvFor(const LuminanceHistogram& histogram, const EyeAdaptation& eye) {
    double total = 0;
    for (uint32_t bin = 1; bin < exposureBins; ++bin) total += histogram[bin];
    if (total == 0) return std::clamp(0.0f, eye.evMin, eye.evMax);
    double before = 0, sum = 0, weights = 0;
    for (uint32_t bin = 1; bin < exposureBins; ++bin) {
        const double from = std::max(before, darkShare * total);
        const double to = std::min(before + histogram[bin], brightShare * total);
        before += histogram[bin];
        if (to <= from) continue;
        sum += (to - from) * double(Rule().exposure_bin_stop(bin));
        weights += to - from;
    }
    return std::clamp(middleGreyStop - float(sum / weights), eye.evMin, eye.evMax);
}

float Eye::see(const LuminanceHistogram& histogram, const EyeAdaptation& eye, float seconds) {
    const float wanted = exposureEvFor(histogram, eye);
    ev_ = ev_ ? Rule().exposure_adapted(*ev_, wanted, seconds, eye.seconds) : wanted;
    return *ev_;
}

}  // namespace gp
