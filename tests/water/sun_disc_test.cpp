// A sun's disc on Gaussian slopes, against means over points of the disc.
#include <gtest/gtest.h>

#include "statistics/random.h"
#include "water/slope_quadrature.h"

GP_SHADING_BEGIN
#include "shading/slope/sun_disc.glsl"
GP_SHADING_END

namespace gp::test {
namespace {

using namespace gp::shading;

// Midpoints of rings and sectors of equal area.
template <class F>
double meanOverDisc(int rings, const F& f) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < rings; ++i) {
        const double r = (i + 0.5) / rings;
        for (int j = 0; j < 6 * (2 * i + 1); ++j, ++count) {
            const double phi = 6.283185307 * (j + 0.5) / (6 * (2 * i + 1));
            sum += f(r * std::cos(phi), r * std::sin(phi));
        }
    }
    return sum / count;
}

double exactShare(double x, double y, double narrow, double wide) {
    // Strips across x, as many as the Gaussian needs.
    const double low = std::max(-1.0, x - 9.0 * narrow), high = std::min(1.0, x + 9.0 * narrow);
    double sum = 0.0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps && high > low; ++i) {
        const double at = low + (high - low) * (i + 0.5) / steps;
        const double h = std::sqrt(1.0 - at * at), z = (at - x) / narrow;
        sum += std::exp(-0.5 * z * z) * (std::erf((h - y) / wide * M_SQRT1_2)
                                         + std::erf((h + y) / wide * M_SQRT1_2));
    }
    return sum * (high - low) / steps / narrow * 0.5 / std::sqrt(2.0 * M_PI);
}

// Energy is what all places together get: the area of the disc.
TEST(SunDisc, SharesOfGaussiansKeepTheirLight) {
    const float widths[][2] = {{0.001f, 0.001f}, {0.02f, 0.02f}, {0.1f, 0.1f}, {0.3f, 0.3f},
                               {0.7f, 0.7f}, {1.4f, 1.4f}, {0.1f, 0.5f}, {0.2f, 1.0f},
                               {0.3f, 3.0f}, {1.0f, 3.0f}, {0.02f, 0.2f}};
    for (const auto& [narrow, wide] : widths) {
        const double peak = exactShare(0.0, 0.0, double(narrow), double(wide));
        EXPECT_NEAR(double(gaussian_in_disc(vec2(0.0f), narrow, wide)) / peak, 1.0, 0.01)
            << narrow << ' ' << wide;
        const int steps = 160;
        double sum = 0.0, off = 0.0;
        const double dx = (1.0 + 5.0 * double(narrow)) / steps;
        const double dy = (1.0 + 5.0 * double(wide)) / steps;
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                const double x = (i + 0.5) * dx, y = (j + 0.5) * dy;
                const auto share = double(gaussian_in_disc(vec2(dvec2(x, y)), narrow, wide));
                ASSERT_GE(share, 0.0);
                sum += share;
                if (i % 10 == 3 && j % 10 == 5) {
                    const double e = exactShare(x, y, double(narrow), double(wide));
                    off = std::max(off, std::abs(share - e));
                }
            }
        }
        EXPECT_NEAR(4.0 * sum * dx * dy / M_PI, 1.0, 0.01) << narrow << ' ' << wide;
        EXPECT_LT(off, 0.06 * peak) << narrow << ' ' << wide;
    }
}

// Slopes from 1/20 of the disc's image to twice as wide, round and long, askew, near and off the
// mean, under high and low light: the mean of the density over the disc's points.
TEST(SunDisc, IsTheMeanOverTheDisc) {
    struct Case {
        vec3 wo, wi;
    };
    const Case cases[] = {{directionAt(0, 0), directionAt(20, 30)},
                          {directionAt(50, 10), directionAt(45, 170)},
                          {directionAt(75, 0), directionAt(70, 180)},
                          {directionAt(60, 0), directionAt(60, 90)}};
    const float radius = 0.00465f;
    for (const Case& c : cases) {
        const Frame f = frame_from_normal(c.wi);
        const vec3 disc = sun_slope_covariance(c.wo, c.wi, radius);
        const float own = 2.0f * std::sqrt(std::sqrt(disc.x * disc.y - disc.z * disc.z));
        for (const float size : {0.05f, 0.2f, 0.6f, 1.0f, 2.0f}) {
            for (const float shape : {1.0f, 3.0f}) {
                Slopes d = slopesOf(0, 0, size * own, size * own * shape, shape > 1 ? 0.5f : 0.0f);
                double peak = 0.0;
                for (const vec2 off : {vec2(0.0f), vec2(0.5f, 0.3f), vec2(-0.9f, 0.5f),
                                       vec2(0.2f, 1.1f), vec2(2.0f, 1.0f), vec2(9.0f, 9.0f)}) {
                    const vec3 v = c.wo + c.wi;
                    d.mean = slope_of(v) - (slope_change(v, f.t) * off.x
                                            + slope_change(v, f.b) * off.y) * radius;
                    const double expected = meanOverDisc(150, [&](double x, double y) {
                        const vec3 wi = normalize(c.wi + f.t * (radius * float(x))
                                                  + f.b * (radius * float(y)));
                        return double(slopes_p22(d, slope_of(c.wo + wi)));
                    });
                    const Slopes wide = slopes_widened(d, disc);
                    const double found = double(slopes_p22(wide, slope_of(v))
                                                * sun_disc_shape(d, c.wo, c.wi, radius));
                    peak = std::max(peak, expected);
                    ASSERT_NEAR(found, expected, 0.05 * peak)
                        << size << ' ' << shape << ' ' << off.x << ' ' << off.y;
                    if (off == vec2(0.0f)) { ASSERT_NEAR(found / expected, 1.0, 0.015) << size; }
                }
            }
        }
    }
}

// Wide slopes, discs of no area and light along the surface change nothing; nothing is no number.
TEST(SunDisc, EndsWhereItShould) {
    const vec3 wo = directionAt(50, 10), wi = directionAt(45, 170);
    EXPECT_EQ(sun_disc_shape(slopesOf(0, 0, 0.1f, 0.1f, 0), wo, wi, 0.00465f), 1.0f);
    EXPECT_EQ(sun_disc_shape(slopesOf(0, 0, 0.001f, 0.001f, 0), wo, wi, 1e-12f), 1.0f);
    // Beyond the image of the disc is nothing.
    EXPECT_EQ(sun_disc_shape(slopesOf(0.5f, 0, 0.001f, 0.001f, 0), wo, wi, 0.00465f), 0.0f);
    Random random(5);
    for (int i = 0; i < 100'000; ++i) {
        const float size = std::exp2(-20.0f * random.uniform());
        const Slopes d = slopesOf(random.uniform() - 0.5f, random.uniform() - 0.5f, size,
                                  size * std::exp2(-8.0f * random.uniform()),
                                  1.98f * random.uniform() - 0.99f);
        const vec3 a = directionAt(89.9 * double(random.uniform()), 360.0 * random.uniform());
        const vec3 b = directionAt(89.9 * double(random.uniform()), 360.0 * random.uniform());
        const float shape = sun_disc_shape(d, a, b, 0.1f * random.uniform() + 1e-6f);
        ASSERT_TRUE(shape >= 0.0f && shape < 1.0e6f) << shape;
    }
}

}  // namespace
}  // namespace gp::test
