// Warps: each inverse undoes its warp, each density integrates to one and is that of the samples.
#include "shading/shading.h"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "statistics/chi2.h"

namespace gp::shading {
namespace {

using test::Chi2Options;
using test::Chi2Result;
using test::Random;

vec2 uniform2(Random& random) {
    const float x = random.uniform();
    return vec2(x, random.uniform());
}

// The whole square including its edges, where a warp has its seams.
void expectRoundTrip(const std::function<vec2(vec2)>& thereAndBack, float tolerance) {
    Random random(1);
    for (int i = 0; i < 100000; ++i) {
        vec2 u = uniform2(random);
        if (i % 50 == 0) u.x = i % 100 == 0 ? 0.0f : ONE_MINUS_EPSILON;
        if (i % 70 == 0) u.y = i % 140 == 0 ? 0.0f : ONE_MINUS_EPSILON;
        const vec2 back = thereAndBack(u);
        ASSERT_TRUE(back.x >= 0.0f && back.x < 1.0f && back.y >= 0.0f && back.y < 1.0f);
        ASSERT_NEAR(back.x, u.x, tolerance) << u.x << " " << u.y;
        ASSERT_NEAR(back.y, u.y, tolerance) << u.x << " " << u.y;
    }
}

TEST(Warps, InversesUndoThem) {
    expectRoundTrip([](vec2 u) {
        return concentric_disk_to_square(square_to_concentric_disk(u));
    }, 1e-6f);
    expectRoundTrip([](vec2 u) {
        return cosine_hemisphere_to_square(square_to_cosine_hemisphere(u));
    }, 1e-6f);
    expectRoundTrip([](vec2 u) {
        return uniform_hemisphere_to_square(square_to_uniform_hemisphere(u));
    }, 1e-6f);
    // Not 2: the whole rim of a cone so wide is the one direction -Z.
    for (float size : {1.9f, 0.5f, 1e-5f, 1e-12f}) {
        expectRoundTrip([size](vec2 u) {
            return uniform_cone_to_square(square_to_uniform_cone(u, size), size);
        }, 2e-6f);
    }
    expectRoundTrip([](vec2 u) {
        return uniform_triangle_to_square(square_to_uniform_triangle(u));
    }, 1e-6f);
    // The angle has no meaning at the poles: u.y comes back only where there is a circle.
    expectRoundTrip([](vec2 u) {
        const vec3 d = square_to_uniform_sphere(u);
        const vec2 back = uniform_sphere_to_square(d);
        const bool seam = d.x * d.x + d.y * d.y < 1e-9f || u.y > 0.999999f;
        return seam ? vec2(back.x, u.y) : back;
    }, 1e-6f);
}

TEST(Warps, DirectionsAreUnit) {
    Random random(2);
    for (int i = 0; i < 100000; ++i) {
        const vec2 u = uniform2(random);
        EXPECT_NEAR(length(square_to_cosine_hemisphere(u)), 1.0f, 1e-6f);
        EXPECT_NEAR(length(square_to_uniform_cone(u, 0.7f)), 1.0f, 1e-6f);
        EXPECT_NEAR(length(square_to_uniform_sphere(u)), 1.0f, 1e-6f);
        const vec3 b = square_to_uniform_triangle(u);
        EXPECT_TRUE(b.x >= 0.0f && b.y >= 0.0f && b.z >= -1e-7f && b.x + b.y + b.z <= 1.000001f);
    }
}

void expectChi2(const Chi2Result& result) {
    EXPECT_TRUE(result.passed) << result.message;
    EXPECT_NEAR(result.pdfIntegral, 1.0, 2e-3) << result.message;
}

constexpr size_t warpTests = 18;  // of this file: Sidak's correction

Chi2Options options(const char* name) {
    Chi2Options o;
    o.name = std::string("warp ") + name;
    o.testCount = warpTests;
    return o;
}

TEST(Warps, UniformHemisphereAndSphere) {
    expectChi2(test::chi2Sphere(options("hemisphere"), {}, [](Random& random) {
        return square_to_uniform_hemisphere(uniform2(random));
    }, uniform_hemisphere_pdf));
    expectChi2(test::chi2Sphere(options("sphere"), {}, [](Random& random) {
        return square_to_uniform_sphere(uniform2(random));
    }, [](vec3) { return uniform_sphere_pdf(); }));
}

// On the plane of the cosine and the angle, where the cone is a rectangle and narrow ones fill it.
TEST(Warps, UniformCone) {
    for (float size : {1.5f, 0.1f, 1.1e-5f}) {
        expectChi2(test::chi2Rectangle(options("cone"), dvec2(0), dvec2(1, 2 * M_PI),
            [size](Random& random) {
                const vec3 d = square_to_uniform_cone(uniform2(random), size);
                const double s2 = double(d.x) * d.x + double(d.y) * d.y;
                const double height = d.z > 0.0f ? s2 / (1.0 + std::sqrt(1.0 - s2)) : 1.0 - d.z;
                return vec2(dvec2(height / size, std::atan2(-d.y, -d.x) + M_PI));
            }, [size](vec2) { return uniform_cone_pdf(size) * size; }));
    }
}

TEST(Warps, UniformTriangle) {
    const auto pdf = [](vec2 p) { return p.x + p.y <= 1.0f ? uniform_triangle_pdf(0.5f) : 0.0f; };
    expectChi2(test::chi2Rectangle(options("triangle"), dvec2(0), dvec2(1), [](Random& random) {
        const vec3 b = square_to_uniform_triangle(uniform2(random));
        return vec2(b.x, b.y);
    }, pdf, [](double x) { return std::vector<double>{1.0 - x}; }));
}

TEST(Warps, PixelFilters) {
    for (uint kind : {FILTER_BOX, FILTER_TENT, FILTER_GAUSSIAN, FILTER_BLACKMAN_HARRIS}) {
        const float radius = 1.5f;
        expectChi2(test::chi2Rectangle(options("filter"), dvec2(-radius), dvec2(radius),
            [=](Random& random) { return filter_sample(kind, radius, uniform2(random)); },
            [=](vec2 p) { return filter_pdf(kind, radius, p); },
            [](double) { return std::vector<double>{0.0}; }));
        EXPECT_EQ(filter_pdf(kind, radius, vec2(0.0f, 1.51f)), 0.0f);
        for (float u : {0.0f, 1e-7f, 1e-4f, 0.5f, ONE_MINUS_EPSILON}) {
            EXPECT_LE(std::abs(filter_sample(kind, radius, vec2(u)).x), radius * 1.00001f);
        }
    }
}

// The inverse of Blackman and Harris' distribution against the distribution in double precision.
TEST(Warps, BlackmanHarrisInvertsItsDistribution) {
    double worst = 0.0;
    for (int i = 0; i <= 100000; ++i) {
        const float u = std::min(float(i) / 100000.0f, ONE_MINUS_EPSILON);
        const double x = double(blackman_harris_sample(u));
        const double mass = (0.35875 * x + (0.48829 * std::sin(M_PI * x) +
            0.14128 / 2.0 * std::sin(2.0 * M_PI * x) +
            0.01168 / 3.0 * std::sin(3.0 * M_PI * x)) / M_PI) / (2.0 * 0.35875);
        worst = std::max(worst, std::abs(0.5 + mass - double(u)));
    }
    EXPECT_LT(worst, 5e-6);
}

TEST(Warps, InverseErf) {
    for (int i = -999; i <= 999; ++i) {
        const double y = i / 1000.0;
        EXPECT_NEAR(std::erf(double(inverse_erf(float(y)))), y, 5e-7);
    }
}

// Rectangles in front, to the side (of which the far part is small), and nearly touching the eye.
// Counted on the rectangle itself, where the density is smooth: 1/sr times cosine over distance^2.
TEST(Warps, SphericalRectangle) {
    struct Case {
        vec3 corner, edgeX, edgeY;
    };
    const Case cases[] = {{vec3(-1, -1, -2), vec3(2, 0, 0), vec3(0, 3, 0)},
                          {vec3(1, 2, -1), vec3(3, 0, 0), vec3(0, 1, 0)},
                          {vec3(-3, -0.5f, -0.05f), vec3(6, 0, 0), vec3(0, 1, 0)},
                          {vec3(1, -2, 3), vec3(0, 0, -6), vec3(0, 4, 0)}};
    for (const Case& c : cases) {
        const SphericalRectangle r = spherical_rectangle(c.corner, c.edgeX, c.edgeY, vec3(0.0f));
        const dvec3 normal = cross(dvec3(c.edgeX), dvec3(c.edgeY));
        const double height = std::abs(dot(dvec3(c.corner), normal));  // times the area
        expectChi2(test::chi2Rectangle(options("spherical rectangle"), dvec2(0), dvec2(1),
            [&](Random& random) {
                const vec3 q = square_to_spherical_rectangle(r, uniform2(random)) - c.corner;
                const vec2 p = vec2(dot(q, c.edgeX) / dot(c.edgeX, c.edgeX),
                                    dot(q, c.edgeY) / dot(c.edgeY, c.edgeY));
                return clamp(p, vec2(0.0f), vec2(1.0f));  // rounding only: the tests below say so
            }, [&](vec2 p) {
                const dvec3 q = dvec3(c.corner) + double(p.x) * dvec3(c.edgeX) +
                                double(p.y) * dvec3(c.edgeY);
                return double(spherical_rectangle_pdf(r)) * height / std::pow(length(q), 3.0);
            }));
        expectRoundTrip([&](vec2 u) {
            const vec3 q = square_to_spherical_rectangle(r, u);
            EXPECT_NEAR(std::abs(dot(dvec3(q), normal)) / height, 1.0, 1e-5);
            EXPECT_TRUE(dot(q - c.corner, c.edgeX) >= -1e-5f) << q.x;
            EXPECT_TRUE(dot(c.corner + c.edgeX + c.edgeY - q, c.edgeY) >= -1e-5f) << q.y;
            return spherical_rectangle_to_square(r, q);
        }, 2e-4f);
    }
}

TEST(Mis, WeightsAddUpToOne) {
    const float densities[] = {0.0f, 1e-38f, 1e-20f, 0.3f, 1.0f, 7.0f, 1e20f, 3e38f,
                               std::numeric_limits<float>::infinity()};
    for (float a : densities) {
        for (float b : densities) {
            const float sum = a > 0.0f || b > 0.0f ? 1.0f : 0.0f;
            EXPECT_NEAR(mis_power(a, b) + mis_power(b, a), sum, 1e-6f) << a << " " << b;
            EXPECT_NEAR(mis_balance(a, b) + mis_balance(b, a), sum, 1e-6f) << a << " " << b;
        }
    }
    EXPECT_FLOAT_EQ(mis_power(3.0f, 4.0f), 9.0f / 25.0f);
    EXPECT_FLOAT_EQ(mis_balance(3.0f, 4.0f), 3.0f / 7.0f);
}

}  // namespace
}  // namespace gp::shading
