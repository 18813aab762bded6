// Words for choices, and the limits of numbers: the same for options, scripts and panels.
#pragma once

#include <cstddef>
#include <utility>

#include "view/view_choices.h"

namespace gp::tool::view {

inline constexpr std::pair<const char*, LiveMode> kLiveWords[] = {
    {"realtime", LiveMode::realtime}, {"traced", LiveMode::traced}, {"local", LiveMode::local}};
inline constexpr std::pair<const char*, GpAntiAliasing> kAntiAliasingWords[] = {
    {"temporal", GP_AA_TEMPORAL}, {"none", GP_AA_NONE}, {"jitter", GP_AA_JITTER}};
inline constexpr std::pair<const char*, GpLightReuse> kLightReuseWords[] = {
    {"none", GP_REUSE_NONE}, {"biased", GP_REUSE_BIASED}, {"unbiased", GP_REUSE_UNBIASED}};
inline constexpr std::pair<const char*, GpTonemap> kTonemapWords[] = {
    {"agx", GP_TONEMAP_AGX},
    {"aces", GP_TONEMAP_ACES},
    {"reinhard", GP_TONEMAP_REINHARD},
    {"none", GP_TONEMAP_NONE}};

inline constexpr double kLowestFps = 1;
inline constexpr double kHighestFps = 240;
inline constexpr double kLongestAdaptation = 3600;  // seconds, the library's
inline constexpr double kFastestSea = 100;          // times real time
inline constexpr std::uint32_t kMostSamples = 1u << 24;
inline constexpr std::int32_t kMostBounces = 16;  // and mirrors, of real time

template <class Value, std::size_t count>
const char* wordOf(Value value, const std::pair<const char*, Value> (&words)[count]) {
    for (const auto& [word, known] : words) {
        if (known == value) {
            return word;
        }
    }
    return "";
}

}  // namespace gp::tool::view
