#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/microfacet/beckmann.glsl"
GP_SHADING_END

#include "ocean/foam.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace gp {

namespace {

// Breaking is not that sharp even where all waves are known; also keeps edges from stairs.
constexpr float leastWidth = 0.05f;

template <class F>
void overPoints(size_t count, const F& function) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 8192), function);
}

}  // namespace

Foam::Foam(const OceanSettings& s, float others)
    : count_(size_t(s.size) * s.size), decay_(double(s.foamDecay)) {
    const float width = std::hypot(others, leastWidth);
    for (int i = 0; i < squeezeCodes; ++i) {
        const float jacobian = squeezeLeast
            + (squeezeMost - squeezeLeast) * float(i) / float(squeezeCodes - 1);
        const float x = (s.foamThreshold - jacobian) / width;
        share_[size_t(i)] = 0.5f + 0.5f * shading::erf_approximation(x * 0.70710678f);
        // What erf rounds to: nothing, whatever the sign.
        if (x < -5.0f) share_[size_t(i)] = 0.0f;
    }
}

// Whether anything of the ticks up to now had to be computed.
bool Foam::remember(int64_t now, double tick, const Squeeze& squeeze) {
    bool changed = false;
    for (int64_t number = now - ticks + 1; number <= now; ++number) {
        Tick& t = history_[size_t(((number % ticks) + ticks) % ticks)];
        if (t.number == number) continue;
        t.codes.resize(count_);
        squeeze(double(number) * tick, t.codes.data());
        t.number = number;
        changed = true;
    }
    return changed;
}

void Foam::gather(int64_t now) {
    trace_.resize(count_);
    overPoints(count_, [&](const tbb::blocked_range<size_t>& range) {
        std::fill(&trace_[range.begin()], &trace_[range.begin()] + range.size(), 0.0f);
        for (const Tick& t : history_) {
            const float faded = float(std::exp(-double(now - t.number) / ticksPerDecay));
            for (size_t i = range.begin(); i < range.end(); ++i) {
                trace_[i] = std::max(trace_[i], faded * share_[t.codes[i]]);
            }
        }
    });
    gathered_ = now;
}

void Foam::update(double seconds, const uint16_t* codes, OceanPoint* points,
                  const Squeeze& squeeze) {
    float faded = 0.0f;
    if (decay_ > 0.0) {
        const double tick = decay_ / ticksPerDecay;
        const auto now = int64_t(std::floor(seconds / tick));
        if (remember(now, tick, squeeze) || gathered_ != now) gather(now);
        faded = float(std::exp(-(seconds - double(now) * tick) / decay_));
    }
    overPoints(count_, [&](const tbb::blocked_range<size_t>& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) {
            const float trace = decay_ > 0.0 ? faded * trace_[i] : 0.0f;
            points[i].foam = std::max(share_[codes[i]], trace);
        }
    });
}

}  // namespace gp
