// How much of the sea foam covers, against the points that break.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ocean/ocean.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using glm::vec2;
using glm::vec3;

// Stretches of a sea at the ticks of its foam, at the grids' own points. Cascades repeat at lengths
// without a common multiple, so that over a large sea all points of one meet all of the others:
// points drawn for each cascade by itself are points of the sea, without interpolation.
class BrokenSea {
public:
    BrokenSea(OceanSettings s, double last, double tick, int ticks) : settings_(s) {
        s.foamDecay = 0.0f;
        Ocean ocean(s);
        for (int k = 0; k < ticks; ++k) {
            ocean.setTime(last - tick * (ticks - 1 - k));
            std::vector<vec3>& now = stretches_.emplace_back();
            for (uint32_t c = 0; c < s.cascades; ++c)
                for (uint32_t i = 0; i < s.size * s.size; ++i)
                    now.push_back(ocean.gridPoint(c, int(i % s.size), int(i / s.size)).stretch);
        }
    }

    // Mean over the sea of 1 where it breaks and of what `fade` a tick leaves of it afterwards.
    double covered(double fade, int samples) const {
        Random random(7);
        const uint32_t count = settings_.size * settings_.size;
        double sum = 0.0;
        for (int i = 0; i < samples; ++i) {
            std::array<size_t, oceanMostCascades> at;
            for (uint32_t c = 0; c < settings_.cascades; ++c) {
                const auto point = uint32_t(random.uniform() * float(count));
                at[c] = size_t(c) * count + std::min(point, count - 1);
            }
            double trace = 0.0;
            for (const std::vector<vec3>& now : stretches_) {
                OceanPoint all;
                for (uint32_t c = 0; c < settings_.cascades; ++c) all.stretch += now[at[c]];
                trace = all.jacobian() < settings_.foamThreshold ? 1.0 : trace * fade;
            }
            sum += trace;
        }
        return sum / samples;
    }

private:
    OceanSettings settings_;
    std::vector<std::vector<vec3>> stretches_;  // by tick, cascade, point
};

// Over places and, if side is above 0, over footprints of that side.
double foamOf(const Ocean& ocean, float side, int samples) {
    Random random(8);
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const vec2 at = vec2(random.uniform(), random.uniform()) * 20.0e3f;
        sum += double(side > 0.0f ? ocean.slopes(at, {side, 0.0f}, {0.0f, side}).foam
                                  : ocean.at(at).foam);
    }
    return sum / samples;
}

// At points 0.90 was measured: where all cascades say that it breaks their product is cut at 1.
// Over footprints 1.19 at 5 m/s to 1.07 at 20 m/s: the law is of second order.
TEST(OceanBreaking, FoamCoversWhatBreaks) {
    for (const float wind : {5.0f, 10.0f, 15.0f, 20.0f}) {
        OceanSettings s;
        s.windSpeed = wind;
        s.foamDecay = 0.0f;
        const double breaks = BrokenSea(s, 3.0, 1.0, 1).covered(0.0, 2'000'000);
        Ocean ocean(s);
        ocean.setTime(3.0);
        for (const float side : {0.0f, 0.3f, 3.0f, 30.0f, 1.0e4f}) {
            const double ratio = foamOf(ocean, side, side > 100.0f ? 1 : 100'000) / breaks;
            EXPECT_GT(ratio, 0.8) << wind << " m/s, " << side << " m";
            EXPECT_LT(ratio, 1.25) << wind << " m/s, " << side << " m";
        }
    }
}

// The same with traces of two seconds, at a tick and between two. Measured: 0.92 to 0.99.
TEST(OceanBreaking, TracesCoverWhatHasBroken) {
    for (const float wind : {5.0f, 10.0f, 15.0f, 20.0f}) {
        OceanSettings s;
        s.windSpeed = wind;
        const double tick = double(s.foamDecay) / 3.0, last = 150 * tick;
        const double broke = BrokenSea(s, last, tick, 16).covered(std::exp(-1.0 / 3.0), 400'000);
        Ocean ocean(s);
        ocean.setTime(last + 1.0e-6);
        for (const float side : {0.0f, 3.0f, 1.0e4f}) {
            const double ratio = foamOf(ocean, side, side > 100.0f ? 1 : 50'000) / broke;
            EXPECT_GT(ratio, 0.8) << wind << " m/s, " << side << " m";
            EXPECT_LT(ratio, 1.25) << wind << " m/s, " << side << " m";
        }
        const double then = foamOf(ocean, 1.0e4f, 1);
        ocean.setTime(last + 0.5 * tick);
        EXPECT_NEAR(foamOf(ocean, 1.0e4f, 1) / then, 1.0, 0.15) << wind;
    }
}

// What is known of u, v and c is correlated along the wind, and turns with it.
TEST(OceanBreaking, TurnsWithTheWind) {
    for (const float wind : {10.0f, 20.0f}) {
        OceanSettings s;
        s.windSpeed = wind;
        s.spreading = OceanSpreading::cosineSquared;
        s.foamDecay = 0.0f;
        const double along = foamOf(Ocean(s), 1.0e4f, 1);
        s.windDirection = 0.7f;
        EXPECT_NEAR(foamOf(Ocean(s), 1.0e4f, 1) / along, 1.0, 0.1) << wind;
    }
}

}  // namespace
}  // namespace gp::test
