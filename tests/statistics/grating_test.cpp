// Gratings: Bessel functions, efficiencies of orders and what they sum up to, colours of the
// spectrum.
#include <gtest/gtest.h>

#include "shading/shading.h"
#include "chi2/quadrature.h"
#include "statistics/random.h"

namespace gp::test {
namespace {

using namespace gp::shading;

Grating gratingOf(uint profile, float periodNm, float depthNm, float duty) {
    Grating g;
    g.profile = profile;
    g.period_nm = periodNm;
    g.depth_nm = depthNm;
    g.duty = duty;
    return g;
}

TEST(Grating, BesselFunctionsAreAccurate) {
    double worst = 0.0;
    for (int n = 0; n <= 40; ++n) {
        for (const float x : {0.0f, 1e-5f, 1e-3f, 0.1f, 0.7f, 1.5f, 2.4048f, 5.0f, 11.3f, 19.0f,
                              28.0f, 40.0f}) {
            const double exact = std::cyl_bessel_j(double(n), double(x));
            const double ours = double(bessel_j(n, x));
            EXPECT_NEAR(ours, exact, 2e-7) << n << " " << x;
            worst = std::max(worst, std::abs(ours - exact));
        }
    }
    fmt::print("Bessel functions: largest error {:.1e}\n", worst);
}

// The coefficients of the wave behind the profile, by their definition.
double fourierEfficiency(const Grating& g, int order, double phase) {
    const auto part = [&](double shift) {
        return integratePieces([&](double t) {
            const double height = g.profile == GRATING_SINUSOIDAL
                ? 0.5 * std::sin(2.0 * M_PI * t)
                : t < double(g.duty) ? 1.0 : 0.0;
            return std::cos(phase * height - 2.0 * M_PI * order * t - shift);
        }, 0.0, 1.0, {double(g.duty), 0.25, 0.5, 0.75}, {1e-8, 1e-9}, 10);
    };
    const double real = part(0.0), imaginary = part(0.5 * M_PI);
    return real * real + imaginary * imaginary;
}

TEST(Grating, EfficienciesAreFourierCoefficients) {
    for (const uint profile : {GRATING_SINUSOIDAL, GRATING_BINARY}) {
        for (const float phase : {0.3f, 2.0f, 6.0f, 15.0f}) {
            const Grating g = gratingOf(profile, 1600.0f, 100.0f, 0.35f);
            double sum = 0.0;
            for (int m = -400; m <= 400; ++m) sum += double(grating_efficiency(g, m, phase));
            // The edges of a binary profile go into orders like 1 / m^2.
            EXPECT_NEAR(sum, 1.0, profile == GRATING_BINARY ? 1e-3 : 1e-5) << profile << phase;
            for (int m = -6; m <= 6; ++m) {
                EXPECT_NEAR(double(grating_efficiency(g, m, phase)),
                            fourierEfficiency(g, m, double(phase)), 1e-5)
                    << profile << " " << phase << " " << m;
            }
        }
    }
    // A smooth or empty profile is a mirror; half a wave up and down at half the period has no
    // zeroth order.
    EXPECT_EQ(grating_efficiency(gratingOf(GRATING_BINARY, 1.0f, 0.0f, 0.5f), 0, 0.0f), 1.0f);
    EXPECT_NEAR(grating_efficiency(gratingOf(GRATING_BINARY, 1.0f, 0.0f, 0.5f), 0, PI), 0.0f,
                1e-6f);
    EXPECT_NEAR(grating_efficiency(gratingOf(GRATING_BINARY, 1.0f, 0.0f, 0.5f), 1, PI),
                4.0f * INV_PI * INV_PI, 1e-6f);
}

TEST(Grating, OrdersLeaveWhereTheEquationSays) {
    // 1,600 nm and 800 nm at normal incidence: sines of 0, 1/2 and (grazing, rounded) 1.
    const Grating g = gratingOf(GRATING_BINARY, 1600.0f, 100.0f, 0.5f);
    const vec3 up(0.0f, 0.0f, 1.0f);
    EXPECT_NEAR(grating_order_cosine(g, up, 1, 800.0f), std::sqrt(0.75f), 1e-6f);
    EXPECT_EQ(grating_order_cosine(g, up, 3, 800.0f), 0.0f);
    EXPECT_EQ(grating_highest_order(g, up, 500.0f), 3);
    EXPECT_EQ(grating_lowest_order(g, up, 500.0f), -3);
    // Every order between the ends leaves, none outside does.
    Random random(61);
    for (int i = 0; i < 10'000; ++i) {
        const float x = random.uniform();
        const vec3 w = square_to_uniform_hemisphere(vec2(x, random.uniform()));
        const float nm = 380.0f + 340.0f * random.uniform();
        const int first = grating_lowest_order(g, w, nm), last = grating_highest_order(g, w, nm);
        ASSERT_LE(first, 0);
        ASSERT_GE(last, 0);
        for (int m = first - 2; m <= last + 2; ++m) {
            const double sine = double(m) * double(nm) / 1600.0 - double(w.x);
            const double rest = 1.0 - sine * sine - double(w.y) * double(w.y);
            if (std::abs(rest) < 1e-5) continue;
            ASSERT_EQ(rest > 0.0, m >= first && m <= last) << m << " " << rest;
        }
    }
}

// Each order has its own phase, so that nothing makes their sum 1; the shares are brought down.
TEST(Grating, OrdersReturnNoMoreThanComes) {
    Random random(62);
    float before = 0.0f, after = 0.0f;
    for (int i = 0; i < 20'000; ++i) {
        const uint profile = i % 2 == 0 ? GRATING_SINUSOIDAL : GRATING_BINARY;
        const Grating g = gratingOf(profile, 300.0f + 2700.0f * random.uniform(),
                                    1000.0f * random.uniform(), random.uniform());
        const float x = random.uniform();
        const vec3 wo = square_to_uniform_hemisphere(vec2(x, random.uniform()));
        const float nm = 380.0f + 340.0f * random.uniform();
        const float total = grating_total(g, wo, nm);
        float sum = 0.0f;
        for (int m = grating_lowest_order(g, wo, nm); m <= grating_highest_order(g, wo, nm); ++m) {
            const float x1 = float(m) * nm / g.period_nm - wo.x;
            const vec3 wi(x1, -wo.y, grating_order_cosine(g, wo, m, nm));
            const float totalI = grating_total(g, wi, nm);
            const float share = grating_order_share(g, wo, wi, m, nm, total, totalI);
            ASSERT_TRUE(share >= 0.0f && std::isfinite(share));
            ASSERT_EQ(share, grating_order_share(g, wi, wo, m, nm, totalI, total));
            sum += share;
        }
        ASSERT_LE(sum, 1.0f + 1e-5f);
        before = std::max(before, total);
        after = std::max(after, sum);
    }
    fmt::print("sum of all orders: up to {:.3f}, brought down to {:.6f}\n", before, after);
    EXPECT_GT(before, 1.2f);  // else grating_order_share would be for nothing
}

TEST(Grating, ColoursOfTheSpectrumSumUpToWhite) {
    for (int channel = 0; channel < 3; ++channel) {
        const double sum = integrate([&](double nm) {
            return double(rgb_of_wavelength(float(nm))[channel]);
        }, 380.0, 720.0, {1e-6, 1e-9}, 12);
        EXPECT_NEAR(sum, 1.0, 1e-5) << channel;
    }
    // Red, green and blue where they are expected; nothing outside.
    const vec3 red = rgb_of_wavelength(630.0f), green = rgb_of_wavelength(530.0f);
    const vec3 blue = rgb_of_wavelength(455.0f);
    EXPECT_GT(red.x, 3.0f * max(red.y, red.z));
    EXPECT_GT(green.y, 3.0f * max(green.x, green.z));
    EXPECT_GT(blue.z, 3.0f * max(blue.x, blue.y));
    EXPECT_EQ(rgb_of_wavelength(379.0f), vec3(0.0f));
    EXPECT_EQ(rgb_of_wavelength(721.0f), vec3(0.0f));
    // CIE 1931 at 555 nm: 0.5121, 1.0000, 0.0057; the fit is off by some 0.01.
    const vec3 xyz = cie_xyz_of_wavelength(555.0f);
    EXPECT_NEAR(xyz.x, 0.5121f, 0.02f);
    EXPECT_NEAR(xyz.y, 1.0f, 0.02f);
    EXPECT_NEAR(xyz.z, 0.0057f, 0.02f);
}

}  // namespace
}  // namespace gp::test
