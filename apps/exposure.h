// Automatic exposure: how bright a picture should be shown.
#pragma once

#include <cstddef>

namespace gp::tool {

// In stops, from RGBA radiance and coverage. The rule, for people, is kExposureRule.
//
// The key is the mean log2 luminance of the lit pixels without the darkest and the brightest 5 %;
// pixels that show the surroundings count a fourth of those that show surfaces. d is its distance
// in stops from log2 0.25, the key of a well-exposed picture.
// - Small d is the scene's own intention, large d a matter of units or daylight: the correction is
//   -d * d^4 / (d^4 + 16), so that a key of 0.5 is hardly moved, one of 1 by one stop of its two,
//   and one of 50 by all.
// - A picture is brightened by at most 6 stops, and never so far that more than 2 % of the pixels
//   pass 1: lamps in the dark stay lamps in the dark.
double automaticExposureEv(const float* rgba, std::size_t pixelCount);

extern const char* const kExposureRule;

}  // namespace gp::tool
