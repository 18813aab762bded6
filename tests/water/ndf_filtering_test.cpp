// Highlights filtered over what a pixel sees of a curved surface: against their means over pixels.
#include <gtest/gtest.h>

#include "statistics/random.h"
#include "water/slope_quadrature.h"

GP_SHADING_BEGIN
#include "shading/frame.glsl"
#include "shading/microfacet/ggx.glsl"
#include "shading/slope/ndf_filtering.glsl"
GP_SHADING_END

namespace gp::test {
namespace {

using namespace gp::shading;

using Matrix = dmat2;

Matrix matrixOf(vec3 a) {
    return Matrix(double(a.x), double(a.z), double(a.z), double(a.y));
}

// Squared widths of random axes.
vec3 randomWidths(Random& random) {
    const double x = std::exp2(-12.0 * double(random.uniform()));
    const double y = std::exp2(-12.0 * double(random.uniform()));
    const double c = std::cos(6.2831853 * double(random.uniform())), s = std::sqrt(1.0 - c * c);
    return vec3(dvec3(c * c * x + s * s * y, s * s * x + c * c * y, c * s * (x - y)) * 0.98);
}

TEST(NdfFiltering, ProjectedWidthsAreThoseOfTheMatrices) {
    Random random(1);
    const Matrix one(1.0);
    for (int i = 0; i < 5'000; ++i) {
        const vec3 a = randomWidths(random);
        const Matrix p = matrixOf(a) * inverse(one - matrixOf(a));
        const vec3 projected = ndf_projected(a);
        const double scale = p[0][0] + p[1][1];
        ASSERT_NEAR(double(projected.x), p[0][0], 3e-5 * scale);
        ASSERT_NEAR(double(projected.z), p[1][0], 3e-5 * scale);
        const vec3 back = ndf_from_projected(projected);
        ASSERT_NEAR(back.x, a.x, 3e-6f + 1e-4f * a.x);
        ASSERT_NEAR(back.y, a.y, 3e-6f + 1e-4f * a.y);
        ASSERT_NEAR(back.z, a.z, 3e-6f + 1e-4f * std::abs(a.z));
    }
}

TEST(NdfFiltering, PrincipalWidthsMakeTheSameMatrix) {
    Random random(2);
    for (int i = 0; i < 5'000; ++i) {
        const vec3 a = i == 0 ? vec3(0.25f, 0.25f, 0.0f) : randomWidths(random);
        const PrincipalWidths w = principal_widths(a);
        ASSERT_NEAR(length(w.axis), 1.0f, 1e-5f);
        ASSERT_GE(w.alpha_x, w.alpha_y);
        const vec2 x = w.axis * w.alpha_x, y = vec2(-w.axis.y, w.axis.x) * w.alpha_y;
        const float scale = a.x + a.y;
        ASSERT_NEAR(x.x * x.x + y.x * y.x, a.x, 3e-6f * scale);
        ASSERT_NEAR(x.y * x.y + y.y * y.y, a.y, 3e-6f * scale);
        ASSERT_NEAR(x.x * x.y + y.x * y.y, a.z, 3e-6f * scale);
    }
}

TEST(NdfFiltering, HalfVectorsChangeAsDifferencesSay) {
    Random random(3);
    for (int i = 0; i < 1'000; ++i) {
        const vec3 wo = directionAt(80.0 * double(random.uniform()), 360.0 * random.uniform());
        const vec3 wi = directionAt(80.0 * double(random.uniform()), 360.0 * random.uniform());
        const vec3 d = vec3(random.uniform(), random.uniform(), random.uniform()) - 0.5f;
        const vec3 d_wo = d - wo * dot(wo, d), d_wi = (d - wi * dot(wi, d)) * 2.0f;
        const auto at = [&](double e) {
            return normalize(dvec3(wo) + dvec3(d_wo) * e + dvec3(wi) + dvec3(d_wi) * e);
        };
        const dvec3 difference = (at(1e-5) - at(-1e-5)) / 2e-5;
        ASSERT_LT(length(difference - dvec3(half_vector_change(wo, wi, d_wo, d_wi))), 1e-4);
    }
}

// Nothing moves: nothing changes. Much moves: no more is added than allowed.
TEST(NdfFiltering, KernelsAreBounded) {
    const vec3 up(0, 0, 1), none(0.0f), huge(30.0f, 5.0f, 0.0f), most(1e18f, -1e18f, 1e18f);
    const vec3 a(0.01f, 0.04f, 0.005f);
    EXPECT_LT(length(ndf_tokuyoshi(a, none, none) - a), 1e-6f);
    EXPECT_EQ(ndf_kaplanyan(vec2(0.01f, 0.04f), up, none, none), vec2(0.01f, 0.04f));
    EXPECT_EQ(ndf_deferred(0.01f, none, none), 0.01f);
    const vec3 k = ndf_kernel_bounded(ndf_kernel(vec2(30.0f, 5.0f), vec2(0.0f)));
    EXPECT_FLOAT_EQ(k.x, NDF_LARGEST_KERNEL);
    EXPECT_NEAR(k.z * k.z, k.x * k.y, 1e-6f);  // still along one line
    EXPECT_FLOAT_EQ(ndf_deferred(0.01f, huge, none), 0.01f + NDF_LARGEST_KERNEL);
    EXPECT_FLOAT_EQ(ndf_kaplanyan(vec2(0.01f), up, huge, huge).x,
                    0.01f + 2.0f * NDF_LARGEST_HALF_SIDE * NDF_LARGEST_HALF_SIDE);
    for (const vec3 d : {none, huge, most}) {
        for (const float alpha2 : {0.0f, 1e-8f, 0.5f, 1.0f}) {
            const vec3 wide = ndf_tokuyoshi(vec3(alpha2, alpha2, 0.0f), d, d);
            EXPECT_TRUE(wide.x >= 0.0f && wide.x <= 1.0f && wide.y >= 0.0f && wide.y <= 1.0f);
            const PrincipalWidths w = principal_widths(wide);
            EXPECT_TRUE(std::isfinite(w.axis.x) && std::isfinite(w.alpha_y));
        }
    }
    const Slopes wide = slopes_ndf_filtered(slopesOf(0, 0, 0.1f, 0.2f, 0.3f), huge, none);
    EXPECT_FLOAT_EQ(wide.var_x, 0.01f + 0.5f * NDF_LARGEST_KERNEL);
    EXPECT_LT(wide.cov * wide.cov, wide.var_x * wide.var_y);
}

// The same functions with the other's derivatives: one width for each light, and a covariance that
// serves all lights.
constexpr uint forwardIsotropic = 16, deferredAnisotropic = 17;

// A unit sphere seen from above by parallel rays, with pixels of a width; a light far away. Along
// the sphere's normals the frame turns without twisting, as in the frame of frame_from_normal.
struct Sphere {
    vec3 wi;
    float alpha;
    bool beckmann;

    static Frame frameAt(dvec2 p) {
        return frame_from_normal(vec3(dvec3(p, std::sqrt(1.0 - dot(p, p)))));
    }

    float d(vec3 h, float x, float y) const {
        return beckmann ? beckmann_d(h, x, y) : ggx_d(h, x, y);
    }

    vec3 halfAt(dvec2 p) const {
        return local_from_world(frameAt(p), normalize(wi + vec3(0, 0, 1)));
    }

    // The mean under the pixel's Gaussian.
    double exact(dvec2 p, double pixel) const {
        const int steps = 80;
        const double sigma = pixel * std::sqrt(double(NDF_PIXEL_VARIANCE));
        double sum = 0.0, weights = 0.0;
        for (int i = 0; i < steps * steps; ++i) {
            const dvec2 t = (dvec2(i % steps, i / steps) + 0.5) * (8.0 / steps) - 4.0;
            const dvec2 at = p + t * sigma;
            if (dot(at, at) >= 1.0) continue;
            const double weight = std::exp(-0.5 * dot(t, t));
            sum += weight * double(d(halfAt(at), alpha, alpha));
            weights += weight;
        }
        return sum / weights;
    }

    // By one sample in the middle; dn of the sphere is the change of the point itself.
    double filtered(dvec2 p, double pixel, uint method) const {
        const Frame f = frameAt(p);
        const vec3 h = halfAt(p);
        vec3 dn[2], dh[2];
        for (int i = 0; i < 2; ++i) {
            const dvec2 step = i == 0 ? dvec2(pixel, 0) : dvec2(0, pixel);
            dn[i] = vec3(dvec3(step, -dot(p, step) / std::sqrt(1.0 - dot(p, p))));
            const vec3 turn = cross(f.n, dn[i]);  // of the frame, which h does not follow
            dh[i] = local_from_world(f, cross(world_from_local(f, h), turn));
        }
        const float a2 = alpha * alpha;
        if (method == NDF_FILTER_DEFERRED) {
            const float wide = std::sqrt(ndf_deferred(a2, dn[0], dn[1]));
            return double(d(h, wide, wide));
        }
        if (method == forwardIsotropic) {
            const float wide = std::sqrt(ndf_deferred(a2, dh[0], dh[1]));
            return double(d(h, wide, wide));
        }
        if (method == deferredAnisotropic) {
            dh[0] = local_from_world(f, dn[0]), dh[1] = local_from_world(f, dn[1]);
        }
        if (method == NDF_FILTER_KAPLANYAN) {
            const vec2 wide = sqrt(ndf_kaplanyan(vec2(a2), h, dh[0], dh[1]));
            return double(d(h, wide.x, wide.y));
        }
        if (method == NDF_FILTER_TOKUYOSHI || method == deferredAnisotropic) {
            const PrincipalWidths w = principal_widths(
                ndf_tokuyoshi(vec3(a2, a2, 0.0f), dh[0], dh[1]));
            const vec3 turned(dot(vec2(h.x, h.y), w.axis), h.y * w.axis.x - h.x * w.axis.y, h.z);
            return double(d(turned, w.alpha_x, w.alpha_y));
        }
        return double(d(h, alpha, alpha));
    }
};

// At the middle of the highlight under a zenith light the derivative of the half vector is the
// pixel over the radius, in both directions, and Gaussians stay Gaussians.
TEST(NdfFiltering, SpheresHaveTheKnownMean) {
    for (const double pixel : {0.02, 0.05, 0.1}) {
        const Sphere sphere{vec3(0, 0, 1), 0.02f, true};
        const double variance = 2.0 * double(NDF_PIXEL_VARIANCE) * pixel * pixel;
        const double known = 1.0 / (M_PI * (0.0004 + variance));
        // Slopes are not quite proportional to positions: their squares count.
        EXPECT_NEAR(sphere.exact(dvec2(0), pixel), known, 0.02 * known) << pixel;
        EXPECT_NEAR(sphere.filtered(dvec2(0), pixel, NDF_FILTER_TOKUYOSHI), known, 0.01 * known);
        // The isotropic one takes what both axes move for each of them, to be safe.
        EXPECT_NEAR(sphere.filtered(dvec2(0), pixel, NDF_FILTER_DEFERRED),
                    1.0 / (M_PI * (0.0004 + 2.0 * variance)), 0.01 * known);
    }
}

double errorOf(const Sphere& sphere, double pixel, uint method) {
    const dvec2 peak(normalize(sphere.wi + vec3(0, 0, 1)));
    double error = 0.0, total = 0.0;
    for (int y = -4; y <= 4; ++y) {
        for (int x = -4; x <= 4; ++x) {
            // Pixels that the highlight meets anywhere but in their middle.
            const dvec2 p = peak + (dvec2(x, y) + dvec2(0.37, 0.21)) * pixel;
            if (dot(p, p) > 0.98) continue;
            const double exact = sphere.exact(p, pixel);
            error += std::abs(sphere.filtered(p, pixel, method) - exact);
            total += exact;
        }
    }
    return error / total;
}

// Absolute error over all pixels about a highlight, relative to its light. Gaussians are met but
// for their curvature; GGX has tails that no widening of it can have, and the older methods take
// other filters, or one width for both axes.
TEST(NdfFiltering, IsNearTheMeanOverPixels) {
    for (const bool beckmann : {false, true}) {
        for (const double elevation : {0.0, 60.0, 110.0}) {
            const Sphere sphere{directionAt(elevation, 25), 0.01f, beckmann};
            const double none = errorOf(sphere, 0.04, NDF_FILTER_NONE);
            EXPECT_GT(none, 0.45) << elevation;  // one sample misses it
            EXPECT_LT(errorOf(sphere, 0.04, NDF_FILTER_TOKUYOSHI), beckmann ? 0.03 : 0.37)
                << elevation;
            EXPECT_LT(errorOf(sphere, 0.04, NDF_FILTER_KAPLANYAN), 0.88 * none) << elevation;
            EXPECT_LT(errorOf(sphere, 0.04, NDF_FILTER_DEFERRED), 1.05 * none) << elevation;
            EXPECT_LT(errorOf(sphere, 0.04, forwardIsotropic), 1.05 * none) << elevation;
            EXPECT_LT(errorOf(sphere, 0.04, deferredAnisotropic), beckmann ? 0.03 : 0.37)
                << elevation;
        }
    }
}

}  // namespace
}  // namespace gp::test
