#include "ocean/foam.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace gp {

namespace {

template <class F>
void overPoints(size_t count, const F& function) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 8192), function);
}

}  // namespace

Foam::Foam(const OceanSettings& s)
    : count_(size_t(s.size) * s.size), decay_(double(s.foamDecay)) {
    for (int i = 0; i < squeezeCodes; ++i) {
        const double margin = double(squeezeMost) * (2.0 * i / (squeezeCodes - 1) - 1.0);
        // Below, the codes of all that is farther away would add up to something.
        share_[size_t(i)] = margin < -5.0 ? 0.0f : float(0.5 * std::erfc(-margin * M_SQRT1_2));
    }
}

// Whether anything of the ticks up to now had to be computed.
bool Foam::remember(int64_t now, double tick, const Squeeze& squeeze) {
    bool changed = false;
    for (int64_t number = now - ticks + 1; number <= now; ++number) {
        Tick& t = tickOf(number);
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
        const auto faded = float(std::exp(-1.0 / ticksPerDecay));
        for (int64_t number = now - ticks + 1; number <= now; ++number) {
            const Tick& t = tickOf(number);
            for (size_t i = range.begin(); i < range.end(); ++i) {
                const float p = share_[t.codes[i]];
                trace_[i] = p + (1.0f - p) * faded * trace_[i];
            }
        }
    });
    gathered_ = now;
}

void Foam::update(double seconds, const uint16_t* codes, OceanPoint* points,
                  const Squeeze& squeeze) {
    float faded = 0.0f, apart = 0.0f;
    if (decay_ > 0.0) {
        const double tick = decay_ / ticksPerDecay;
        const auto now = int64_t(std::floor(seconds / tick));
        if (remember(now, tick, squeeze) || gathered_ != now) gather(now);
        apart = float(seconds / tick - double(now));
        faded = float(std::exp(-double(apart) / ticksPerDecay));
    }
    overPoints(count_, [&](const tbb::blocked_range<size_t>& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) {
            const float p = share_[codes[i]];
            const float trace = decay_ > 0.0 ? faded * trace_[i] : 0.0f;
            // From the same event as the last tick's, at the tick, to one of its own at the next.
            const float same = std::max(p, trace), other = p + (1.0f - p) * trace;
            points[i].foam = same + apart * (other - same);
        }
    });
}

}  // namespace gp
