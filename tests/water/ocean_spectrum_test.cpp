// Spectra of the sea: their integrals, dispersion, directions, and bad settings.
#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/ocean/spreading.glsl"
GP_SHADING_END

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "ocean/ocean.h"
#include "ocean/wave_spectrum.h"
#include "statistics/golden.h"

namespace gp {
namespace {

using namespace shading;

OceanWind windOf(float speed, float fetch, uint spectrum) {
    OceanWind wind;
    wind.speed = speed;
    wind.fetch = fetch;
    wind.depth = OCEAN_DEEP;
    wind.gravity = 9.81f;
    wind.spectrum = spectrum;
    wind.spreading = OCEAN_SPREAD_HASSELMANN;
    wind.swell = 0.0f;
    wind.peak = 0.0f;
    wind.peak = ocean_peak(wind);
    return wind;
}

SpectrumTable::Node between(const SpectrumTable& table, double first, double end) {
    const SpectrumTable::Node a = table.above(first), b = table.above(end);
    return {a.variance - b.variance, a.along - b.along, a.across - b.across};
}

TEST(OceanSpectrum, IntegralsOverBandsAreTheGoldenOnes) {
    const auto rows = test::readGolden("glint/golden_ocean_moments.csv");
    if (rows.empty()) GTEST_SKIP() << "../shared/golden is not here";
    for (const auto& row : rows) {
        OceanSettings s;
        s.windSpeed = std::stof(row.at("U10_ms"));
        s.fetch = std::stof(row.at("fetch_m"));
        const SpectrumTable table = makeSpectrumTable(s);
        const auto node = between(table, std::stod(row.at("k_min")), std::stod(row.at("k_max")));
        // Both are quadratures. Ours has steps of 0.8 % in k, and the spreading jumps at the peak
        // (from exponent 6.97 to 9.77): off by some 1e-4, by 1.4e-3 in one row.
        const auto near = [&](double value, const char* column) {
            const double golden = std::stod(row.at(column));
            EXPECT_NEAR(value, golden, 2e-3 * golden)
                << column << " of U " << row.at("U10_ms") << ", fetch " << row.at("fetch_m")
                << ", k " << row.at("k_min") << ".." << row.at("k_max");
        };
        near(node.variance, "var_h");
        near(4.0 * std::sqrt(node.variance), "Hs");
        near(node.along, "mss_x(upwind)");
        near(node.across, "mss_y(cross)");
        const OceanWind wind = windOf(s.windSpeed, s.fetch, OCEAN_JONSWAP);
        near(double(wind.peak), "omega_p");
        near(double(ocean_jonswap_alpha(wind)), "alpha");
    }
}

TEST(OceanSpectrum, PiersonMoskowitzHasItsKnownHeight) {
    OceanSettings s;
    s.spectrum = OceanSpectrum::piersonMoskowitz;
    s.windSpeed = 12.0f;
    const double peak = 0.855 * 9.81 / 12.0;
    // The integral of alpha g^2 omega^-5 exp(-5/4 (peak / omega)^4).
    const double variance = 8.1e-3 * 9.81 * 9.81 / (5.0 * std::pow(peak, 4.0));
    EXPECT_NEAR(makeSpectrumTable(s).above(0.0).variance, variance, 1e-3 * variance);
}

TEST(OceanSpectrum, PhillipsIsTheSameEquilibriumRangeAsPiersonMoskowitz) {
    // Far above the peak both are alpha / 2 k^-3; Phillips' ends at a thousandth of its length.
    const OceanWind p = windOf(20.0f, 1.0e5f, OCEAN_PHILLIPS);
    const OceanWind m = windOf(20.0f, 1.0e5f, OCEAN_PIERSON_MOSKOWITZ);
    EXPECT_NEAR(ocean_radial_density(p, 2.0f) / ocean_radial_density(m, 2.0f), 1.0f, 0.01f);
    EXPECT_LT(ocean_radial_density(p, 60.0f) / ocean_radial_density(m, 60.0f), 0.01f);
}

TEST(OceanSpectrum, DepthWeakensLongWavesAndDeepWaterDoesNot) {
    OceanWind tma = windOf(10.0f, 1.0e5f, OCEAN_TMA);
    const OceanWind deep = windOf(10.0f, 1.0e5f, OCEAN_JONSWAP);
    for (const float k : {0.1f, 0.3f, 2.0f}) {
        EXPECT_FLOAT_EQ(ocean_radial_density(tma, k), ocean_radial_density(deep, k));
    }
    // [Bouws et al. 1985]: 1/2 at omega sqrt(d / g) = 1, and k-wise by the group velocity besides.
    EXPECT_FLOAT_EQ(ocean_depth_factor(1.0f, 9.81f, 9.81f), 0.5f);
    EXPECT_FLOAT_EQ(ocean_depth_factor(0.5f, 9.81f, 9.81f), 0.125f);
    EXPECT_FLOAT_EQ(ocean_depth_factor(3.0f, 9.81f, 9.81f), 1.0f);
    OceanSettings s;
    s.spectrum = OceanSpectrum::tma;
    double before = makeSpectrumTable(s).above(0.0).variance;
    for (const float depth : {50.0f, 10.0f, 3.0f, 1.0f, 0.1f}) {
        s.depth = depth;
        const double variance = makeSpectrumTable(s).above(0.0).variance;
        EXPECT_LT(variance, before) << depth;
        EXPECT_GT(variance, 0.0) << depth;
        before = variance;
    }
}

TEST(OceanSpectrum, WavesGoAsDeepShallowAndCapillaryOnesDo) {
    const float g = 9.81f;
    // Deep: sqrt(g k), group velocity half of the phase's. Shallow: sqrt(g d) for both.
    const OceanFrequency deep = ocean_gravity_frequency(0.5f, 1000.0f, g);
    EXPECT_NEAR(deep.omega, std::sqrt(g * 0.5f), 1e-5f);
    EXPECT_NEAR(deep.by_k, 0.5f * deep.omega / 0.5f, 1e-5f);
    const OceanFrequency shallow = ocean_gravity_frequency(0.01f, 2.0f, g);
    EXPECT_NEAR(shallow.omega / 0.01f, std::sqrt(g * 2.0f), 1e-3f);
    EXPECT_NEAR(shallow.by_k, std::sqrt(g * 2.0f), 2e-3f);
    for (const float k : {0.02f, 0.2f, 1.0f}) {
        const float d = 1e-3f * k;
        const float slope = (ocean_gravity_frequency(k + d, 4.0f, g).omega -
                             ocean_gravity_frequency(k - d, 4.0f, g).omega) / (2.0f * d);
        EXPECT_NEAR(ocean_gravity_frequency(k, 4.0f, g).by_k, slope, 2e-3f * slope) << k;
    }
    // The slowest waves on water go 0.23 m/s, at a length of 1.7 cm. [Lamb 1932, section 267]
    float slowest = 10.0f, at = 0.0f;
    for (float k = 50.0f; k < 1000.0f; k *= 1.01f) {
        const float speed = ocean_frequency(k, 10.0f, g) / k;
        if (speed < slowest) slowest = speed, at = k;
    }
    EXPECT_NEAR(slowest, 0.231f, 0.002f);
    EXPECT_NEAR(2.0 * M_PI / double(at), 0.0170, 0.0005);
}

TEST(OceanSpectrum, DirectionsIntegrateToOne) {
    for (const uint spreading : {0u, 1u, 2u}) {
        for (const float swell : {0.0f, 0.3f, 1.0f}) {
            for (const float ratio : {0.5f, 0.94f, 1.0f, 1.5f, 3.0f, 20.0f}) {
                OceanWind wind = windOf(10.0f, 1.0e5f, OCEAN_JONSWAP);
                wind.spreading = spreading;
                wind.swell = swell;
                const OceanSpread spread = ocean_spread(wind, ratio * wind.peak);
                double sum = 0.0;
                const int n = 4096;
                for (int i = 0; i < n; ++i) {
                    const double angle = 2.0 * M_PI * ((i + 0.5) / n - 0.5);
                    sum += double(ocean_spread_density(spread, float(angle))) * 2.0 * M_PI / n;
                }
                // The scale of a product is a quadrature of 32 nodes, which feels that some of
                // these densities have a corner upwind.
                const double tolerance = spreading != 0u && swell > 0.0f ? 1e-3 : 1e-4;
                EXPECT_NEAR(sum, 1.0, tolerance) << spreading << " " << swell << " " << ratio;
            }
        }
    }
}

TEST(OceanSpectrum, SwellNarrowsDirections) {
    for (const auto spreading : {OceanSpreading::hasselmann, OceanSpreading::donelanBanner,
                                 OceanSpreading::cosineSquared}) {
        double before = 1.0;
        for (const float swell : {0.0f, 0.5f, 1.0f}) {
            OceanSettings s;
            s.spreading = spreading;
            s.swell = swell;
            const auto node = makeSpectrumTable(s).above(0.0);
            const double share = node.across / (node.along + node.across);
            EXPECT_LT(share, before) << int(spreading) << " " << swell;
            before = share;
        }
    }
}

// [Cox and Munk 1954, JOSA 44(11)]: .00316 U along and .003 + .00192 U across the wind. JONSWAP up
// to 1000 rad/m has no such tail: the order is right, and the order of sizes.
TEST(OceanSpectrum, SlopesAreOfTheOrderThatCoxAndMunkSaw) {
    for (const float wind : {5.0f, 10.0f, 14.0f}) {
        OceanSettings s;
        s.windSpeed = wind;
        const Ocean ocean(s);
        const OceanMoments all = ocean.momentsAbove(0.0f);
        const float along = 0.00316f * wind, across = 0.003f + 0.00192f * wind;
        EXPECT_GT(all.xx, 0.5f * along) << wind;
        EXPECT_LT(all.xx, 1.5f * along) << wind;
        EXPECT_GT(all.yy, 0.5f * across) << wind;
        EXPECT_LT(all.yy, 1.5f * across) << wind;
        EXPECT_GT(all.xx, all.yy) << wind;
        EXPECT_NEAR(all.xy, 0.0f, 1e-6f);
    }
}

TEST(OceanSpectrum, MomentsTurnWithTheWind) {
    OceanSettings s;
    const Ocean along(s);
    s.windDirection = float(M_PI / 2.0);
    const Ocean turned(s);
    s.windDirection = float(M_PI / 4.0);
    const Ocean askew(s);
    EXPECT_NEAR(turned.momentsAbove(0.0f).yy, along.momentsAbove(0.0f).xx, 1e-7f);
    EXPECT_NEAR(askew.momentsAbove(0.0f).xx, askew.momentsAbove(0.0f).yy, 1e-7f);
    EXPECT_GT(askew.momentsAbove(0.0f).xy, 0.0f);
}

struct BadSetting {
    const char* field;
    void (*spoil)(OceanSettings&);
};

TEST(OceanSettings, WrongOnesAreNamed) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float inf = std::numeric_limits<float>::infinity();
    const BadSetting bad[] = {
        {"windSpeed", [](OceanSettings& s) { s.windSpeed = -1.0f; }},
        {"windSpeed", [](OceanSettings& s) { s.windSpeed = nan; }},
        {"windDirection", [](OceanSettings& s) { s.windDirection = inf; }},
        {"fetch", [](OceanSettings& s) { s.fetch = 0.0f; }},
        {"depth", [](OceanSettings& s) { s.depth = 0.0f; }},
        {"depth", [](OceanSettings& s) { s.depth = nan; }},
        {"gravity", [](OceanSettings& s) { s.gravity = 0.0f; }},
        {"swell", [](OceanSettings& s) { s.swell = 1.5f; }},
        {"amplitude", [](OceanSettings& s) { s.amplitude = inf; }},
        {"choppiness", [](OceanSettings& s) { s.choppiness = -0.1f; }},
        {"foamThreshold", [](OceanSettings& s) { s.foamThreshold = 2.0f; }},
        {"foamDecay", [](OceanSettings& s) { s.foamDecay = 1e-4f; }},
        {"spectrum", [](OceanSettings& s) { s.spectrum = OceanSpectrum(9); }},
        {"spreading", [](OceanSettings& s) { s.spreading = OceanSpreading(9); }},
        {"size", [](OceanSettings& s) { s.size = 100; }},
        {"size", [](OceanSettings& s) { s.size = 0; }},
        {"cascades", [](OceanSettings& s) { s.cascades = 5; }},
        {"lengths[0]", [](OceanSettings& s) { s.lengths[0] = nan; }},
        {"lengths[1]", [](OceanSettings& s) { s.lengths[1] = 701.0f; }},
        {"lengths[2]", [](OceanSettings& s) { s.lengths[2] = 1.0f; }},
    };
    for (const BadSetting& row : bad) {
        OceanSettings s;
        ASSERT_EQ(oceanFault(s), "");
        row.spoil(s);
        EXPECT_EQ(oceanFault(s).rfind(row.field, 0), 0u) << row.field << ": " << oceanFault(s);
    }
    OceanSettings still;
    still.foamDecay = 0.0f;
    still.windSpeed = 0.0f;
    EXPECT_EQ(oceanFault(still), "");
}

}  // namespace
}  // namespace gp
