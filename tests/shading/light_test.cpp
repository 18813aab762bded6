// Lights: samples follow their density, hit their light, and give the irradiance known in closed
// form, for light near and far.
#include "shading/shading.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/chi2.h"

namespace gp::shading {
namespace {

using test::Chi2Options;
using test::Random;

constexpr size_t lightTests = 5;  // chi-square tests of this file

vec2 uniform2(Random& random) {
    const float x = random.uniform();
    return vec2(x, random.uniform());
}

Chi2Options options(const char* name) {
    Chi2Options o;
    o.name = std::string("light ") + name;
    o.testCount = lightTests;
    return o;
}

void expectChi2(const test::Chi2Result& result) {
    EXPECT_TRUE(result.passed) << result.message;
    EXPECT_NEAR(result.pdfIntegral, 1.0, 5e-3) << result.message;
}

// Irradiance on a surface with normal n by sampling; `sample` gives LightSamples.
template <class Sample>
double irradiance(vec3 n, Sample sample, int count = 200000) {
    Random random(3);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const LightSample s = sample(uniform2(random));
        if (s.pdf > 0.0f) {
            sum += double(s.radiance.x) * std::max(0.0, double(dot(s.wi, n))) / double(s.pdf);
        }
    }
    return sum / count;
}

// Irradiance of a uniform polygon of unit radiance, all of it above the horizon.
// [Lambert 1760, Photometria; Arvo 1995, equation 2.8]
double polygonIrradiance(const std::vector<dvec3>& corners, dvec3 n) {
    double sum = 0.0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const dvec3 a = normalize(corners[i]);
        const dvec3 b = normalize(corners[(i + 1) % corners.size()]);
        const dvec3 c = cross(a, b);
        const double sine = length(c);
        sum += std::atan2(sine, dot(a, b)) * dot(c / sine, n);
    }
    return std::abs(sum) / 2.0;
}

DirectionalLight sun(float radius) {
    DirectionalLight l;
    l.direction = normalize(vec3(1.0f, 2.0f, 3.0f));
    l.irradiance = vec3(5.0f);
    const float half = std::sin(0.5f * radius);
    l.one_minus_cos_max = 2.0f * half * half;
    return l;
}

TEST(DirectionalLight, GivesItsIrradiance) {
    for (float radius : {0.0f, 0.00465f, 0.2f, 1.0f}) {
        const DirectionalLight l = sun(radius);
        EXPECT_NEAR(irradiance(l.direction, [&](vec2 u) {
            return directional_light_sample(l, u);
        }), 5.0, 0.01) << radius;
    }
}

TEST(DirectionalLight, PdfKnowsItsDisk) {
    const DirectionalLight l = sun(0.00465f);
    Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const vec2 u = uniform2(random) * 0.998f + vec2(0.001f);
        const LightSample s = directional_light_sample(l, u);
        EXPECT_EQ(directional_light_pdf(l, s.wi), s.pdf);
        EXPECT_EQ(s.is_delta, 0u);
    }
    const Frame f = frame_from_normal(l.direction);
    for (float angle : {0.0048f, 0.1f, 3.0f}) {
        const vec3 w = world_from_local(f, vec3(std::sin(angle), 0.0f, std::cos(angle)));
        EXPECT_EQ(directional_light_pdf(l, w), 0.0f) << angle;
    }
    EXPECT_EQ(directional_light_pdf(sun(0.0f), l.direction), 0.0f);
    EXPECT_EQ(directional_light_sample(sun(0.0f), vec2(0.5f)).is_delta, 1u);
}

SphereLight ball(float radius) {
    SphereLight l;
    l.position = vec3(1.0f, -2.0f, 0.5f);
    l.radius = radius;
    l.emission = vec3(2.0f);
    l.axis = vec3(0.0f, 0.0f, -1.0f);
    l.cos_inner = 1.0f;
    l.cos_outer = -2.0f;
    return l;
}

// From outside in the coordinates of the cone that touches the sphere, which they fill: height over
// its greatest value, and angle.
TEST(SphereLight, FollowsItsDensityFromOutside) {
    const SphereLight l = ball(0.5f);
    for (float distance : {0.505f, 1.0f, 40.0f}) {
        const vec3 p = l.position + distance * normalize(vec3(0.3f, 0.5f, -0.7f));
        const dvec3 toCentre = dvec3(l.position) - dvec3(p);
        const double d = length(toCentre);
        const dvec3 axis = toCentre / d;
        const dvec3 x = normalize(cross(axis, dvec3(0, 0, 1)));
        const dvec3 y = cross(axis, x);
        const double sine = 0.5 / d;
        const double greatest = sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
        expectChi2(test::chi2Rectangle(options("sphere"), dvec2(0), dvec2(1, 2 * M_PI),
            [&](Random& random) {
                const dvec3 w = normalize(dvec3(sphere_light_sample(l, p, uniform2(random)).wi));
                const double height = 0.5 * dot(w - axis, w - axis) / greatest;
                EXPECT_LT(height, 1.001);
                return vec2(dvec2(std::min(height, 1.0),
                                  std::atan2(dot(w, y), dot(w, x)) + M_PI));
            }, [&](vec2) { return double(sphere_light_pdf(l, p, vec3(toCentre))) * greatest; }));
    }
}

TEST(SphereLight, FollowsItsDensityFromInside) {
    const SphereLight l = ball(0.5f);
    const vec3 p = l.position + 0.35f * normalize(vec3(0.3f, 0.5f, -0.7f));
    const dvec3 toCentre = dvec3(l.position) - dvec3(p);
    expectChi2(test::chi2Sphere(options("sphere from inside"), {}, [&](Random& random) {
        return sphere_light_sample(l, p, uniform2(random)).wi;
    }, [&](vec3 w) {
        const double b = dot(dvec3(w), toCentre);
        const double t = b + std::sqrt(b * b - dot(toCentre, toCentre) + 0.25);
        return sphere_light_pdf(l, p, vec3(dvec3(w) * t));
    }));
}

TEST(SphereLight, SamplesLieOnItAndAgreeWithPdf) {
    Random random(2);
    for (float distance : {0.1f, 0.49f, 0.51f, 2.0f, 300.0f}) {
        const SphereLight l = ball(0.5f);
        for (int i = 0; i < 5000; ++i) {
            const vec3 p = l.position + distance * square_to_uniform_sphere(uniform2(random));
            const LightSample s = sphere_light_sample(l, p, uniform2(random));
            ASSERT_GT(s.pdf, 0.0f);
            const vec3 hit = p + s.wi * s.distance;
            EXPECT_NEAR(length(hit - l.position), 0.5f, 2e-4f + distance * 1e-6f);
            EXPECT_NEAR(sphere_light_pdf(l, p, s.wi * s.distance) / s.pdf, 1.0f, 1e-3f);
        }
    }
}

TEST(SphereLight, GivesIrradianceOfItsSolidAngle) {
    for (float distance : {0.6f, 2.0f, 100.0f}) {
        const SphereLight l = ball(0.5f);
        const vec3 n = normalize(vec3(-1.0f, 2.0f, 2.0f));
        const vec3 p = l.position - distance * n;
        const double expected = 2.0 * M_PI * 0.25 / (distance * distance);
        EXPECT_NEAR(irradiance(n, [&](vec2 u) { return sphere_light_sample(l, p, u); }) / expected,
                    1.0, 4e-3);
    }
    const SphereLight point = ball(0.0f);
    const LightSample s = sphere_light_sample(point, point.position + vec3(0, 4, 0), vec2(0.3f));
    EXPECT_FLOAT_EQ(s.radiance.x, 2.0f / 16.0f);
    EXPECT_EQ(s.is_delta, 1u);
    EXPECT_EQ(sphere_light_pdf(point, vec3(0.0f), point.position), 0.0f);
    EXPECT_EQ(sphere_light_sample(point, point.position, vec2(0.3f)).pdf, 0.0f);
}

TEST(SphereLight, SpotFallsOff) {
    EXPECT_EQ(spot_falloff(0.95f, 0.9f, 0.8f), 1.0f);
    EXPECT_NEAR(spot_falloff(0.85f, 0.9f, 0.8f), 0.25f, 1e-5f);
    EXPECT_EQ(spot_falloff(0.79f, 0.9f, 0.8f), 0.0f);
    EXPECT_EQ(spot_falloff(0.91f, 0.9f, 0.9f), 1.0f);  // a sharp edge does not divide by zero
    SphereLight l = ball(0.0f);
    l.cos_inner = 0.9f;
    l.cos_outer = 0.8f;
    EXPECT_EQ(sphere_light_emission(l, l.position + vec3(0, 0, -1)), l.emission);
    EXPECT_EQ(sphere_light_emission(l, l.position + vec3(0, 0, 1)), vec3(0.0f));
}

RectangleLight panel(vec3 corner) {
    RectangleLight l;
    l.corner = corner;
    l.edge_x = vec3(0.0f, 2.0f, 0.0f);
    l.edge_y = vec3(1.5f, 0.0f, 0.0f);  // light leaves along -Z
    l.radiance = vec3(1.0f);
    l.two_sided = 0;
    return l;
}

TEST(RectangleLight, GivesLambertsIrradiance) {
    for (const vec3& corner : {vec3(-0.7f, -0.9f, 0.3f), vec3(2.0f, 3.0f, 4.0f),
                               vec3(-1.0f, 5.0f, 30.0f), vec3(100.0f, -300.0f, 900.0f)}) {
        const RectangleLight l = panel(corner);
        const vec3 n = normalize(vec3(0.1f, 0.2f, 1.0f));
        const double expected = polygonIrradiance(
            {dvec3(corner), dvec3(corner + l.edge_x), dvec3(corner + l.edge_x + l.edge_y),
             dvec3(corner + l.edge_y)}, dvec3(n));
        const auto sample = [&](vec2 u) { return rectangle_light_sample(l, vec3(0.0f), u); };
        // The last is 1e-6 sr: the closed form itself cancels to 1e-4.
        EXPECT_NEAR(irradiance(n, sample) / expected, 1.0, 4e-3) << corner.z;
    }
}

TEST(RectangleLight, PdfAgreesAndOneSideIsDark) {
    Random random(4);
    for (float z : {0.01f, 0.5f, 3.0f, 12.0f, 16.0f, 500.0f}) {
        RectangleLight l = panel(vec3(-0.5f, 0.1f, z));
        for (int i = 0; i < 2000; ++i) {
            const LightSample s = rectangle_light_sample(l, vec3(0.0f), uniform2(random));
            ASSERT_GT(s.pdf, 0.0f);
            const vec3 hit = s.wi * s.distance;
            EXPECT_NEAR(rectangle_light_pdf(l, vec3(0.0f), hit) / s.pdf, 1.0f, 1e-4f);
            EXPECT_NEAR(hit.z / z, 1.0f, 1e-5f);
            EXPECT_TRUE(hit.x >= -0.5002f && hit.x <= 1.0002f) << hit.x;
            EXPECT_TRUE(hit.y >= 0.0998f && hit.y <= 2.1002f) << hit.y;
        }
        const vec3 behind(0.0f, 0.0f, 2.0f * z);
        EXPECT_EQ(rectangle_light_sample(l, behind, vec2(0.4f)).pdf, 0.0f);
        EXPECT_EQ(rectangle_light_pdf(l, behind, vec3(0, 0.5f, -z)), 0.0f);
        l.two_sided = 1;
        EXPECT_GT(rectangle_light_sample(l, behind, vec2(0.4f)).pdf, 0.0f);
    }
}

TriangleLight shard(vec3 p0, float size) {
    TriangleLight l;
    l.p0 = p0;
    l.edge_1 = size * vec3(0.2f, 1.0f, 0.1f);
    l.edge_2 = size * vec3(1.0f, -0.1f, 0.3f);  // faces -Z
    l.radiance = vec3(1.0f);
    l.two_sided = 0;
    return l;
}

TEST(TriangleLight, GivesLambertsIrradiance) {
    const vec3 n(0.0f, 0.0f, 1.0f);
    for (float size : {2.0f, 0.5f, 0.05f}) {
        const TriangleLight l = shard(vec3(0.3f, -0.4f, 1.0f), size);
        const double expected = polygonIrradiance(
            {dvec3(l.p0), dvec3(l.p0 + l.edge_1), dvec3(l.p0 + l.edge_2)}, dvec3(n));
        const auto sample = [&](vec2 u) { return triangle_light_sample(l, vec3(0.0f), u); };
        EXPECT_NEAR(irradiance(n, sample) / expected, 1.0, 4e-3) << size;
    }
    // A tenth of a millimetre a kilometre away: area times both cosines over the squared distance.
    const TriangleLight far = shard(vec3(0.0f, 0.0f, 1000.0f), 1e-4f);
    const dvec3 normal = cross(dvec3(far.edge_1), dvec3(far.edge_2));
    const double expected = 0.5 * std::abs(normal.z) / 1e6;
    const auto sample = [&](vec2 u) { return triangle_light_sample(far, vec3(0.0f), u); };
    EXPECT_NEAR(irradiance(n, sample) / expected, 1.0, 1e-3);
}

TEST(TriangleLight, FollowsItsDensityAndOneSideIsDark) {
    const TriangleLight l = shard(vec3(-0.5f, -0.2f, 0.4f), 1.0f);
    test::SphereDomain domain;
    const dvec3 a(l.p0), b(l.p0 + l.edge_1), c(l.p0 + l.edge_2);
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        domain.edges.push_back(normalize(cross(p, q)));
    }
    const dvec3 normal = cross(b - a, c - a);
    const auto pdf = [&](vec3 w) {
        const bool inside = dot(dvec3(w), cross(a, b)) < 0.0 && dot(dvec3(w), cross(b, c)) < 0.0 &&
                            dot(dvec3(w), cross(c, a)) < 0.0;
        const double t = dot(a, normal) / dot(dvec3(w), normal);
        return inside ? triangle_light_pdf(l, vec3(dvec3(w) * t)) : 0.0f;
    };
    expectChi2(test::chi2Sphere(options("triangle"), domain, [&](Random& random) {
        return triangle_light_sample(l, vec3(0.0f), uniform2(random)).wi;
    }, pdf));
    EXPECT_EQ(triangle_light_sample(l, vec3(0, 0, 5), vec2(0.4f)).pdf, 0.0f);
    EXPECT_EQ(triangle_light_sample(shard(vec3(1), 0.0f), vec3(0), vec2(0.4f)).pdf, 0.0f);
}

TEST(Environment, MapsAsItSays) {
    const auto expectUv = [](vec3 d, float u, float v) {
        const vec2 uv = environment_uv_from_direction(d);
        EXPECT_NEAR(uv.x, u, 1e-6f);
        EXPECT_NEAR(uv.y, v, 1e-6f);
    };
    expectUv(vec3(0, 0, -1), 0.5f, 0.5f);
    expectUv(vec3(1, 0, 0), 0.75f, 0.5f);
    expectUv(vec3(-1, 0, 0), 0.25f, 0.5f);
    expectUv(vec3(0, 1, 0), 0.5f, 0.0f);
    expectUv(vec3(0, -1, 0), 0.5f, 1.0f);
    Random random(6);
    double integral = 0.0;
    constexpr int count = 200000;
    for (int i = 0; i < count; ++i) {
        const vec3 d = square_to_uniform_sphere(uniform2(random));
        const vec3 back = environment_direction_from_uv(environment_uv_from_direction(d));
        ASSERT_LT(distance(d, back), 3e-6f);
        integral += double(environment_pdf_from_uv_pdf(1.0f, d)) * 4.0 * M_PI / count;
    }
    EXPECT_NEAR(integral, 1.0, 5e-3);
    EXPECT_EQ(environment_pdf_from_uv_pdf(1.0f, vec3(0, 1, 0)), 0.0f);
}

}  // namespace
}  // namespace gp::shading
