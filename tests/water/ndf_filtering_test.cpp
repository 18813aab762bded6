// Highlights filtered over what a pixel sees of a curved surface: against their means over pixels.
#include <gtest/gtest.h>

#include "statistics/random.h"
#include "water/slope_quadrature.h"

GP_SHADING_BEGIN
#include "shading/frame.glsl"
#include "shading/microfacet/ggx.glsl"
#include "shading/slope/ndf_mixture.glsl"
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
// NDF_FILTER_TOKUYOSHI with ndf_mixture_shape, as the renderer has GGX.
constexpr uint ggxMixture = 18;

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
        if (method == NDF_FILTER_TOKUYOSHI || method == ggxMixture
            || method == deferredAnisotropic) {
            const float shape =
                method == ggxMixture ? ndf_mixture_shape(vec2(a2), h, dh[0], dh[1]) : 1.0f;
            const PrincipalWidths w = principal_widths(
                ndf_tokuyoshi(vec3(a2, a2, 0.0f), dh[0], dh[1]));
            const vec3 turned(dot(vec2(h.x, h.y), w.axis), h.y * w.axis.x - h.x * w.axis.y, h.z);
            return double(shape * d(turned, w.alpha_x, w.alpha_y));
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
// for their curvature, and so is GGX as a mixture of them; it has tails that no widening of it can
// have. The older methods take other filters, or one width for both axes.
TEST(NdfFiltering, IsNearTheMeanOverPixels) {
    for (const bool beckmann : {false, true}) {
        for (const double elevation : {0.0, 60.0, 110.0}) {
            const Sphere sphere{directionAt(elevation, 25), 0.01f, beckmann};
            const double none = errorOf(sphere, 0.04, NDF_FILTER_NONE);
            EXPECT_GT(none, 0.45) << elevation;  // one sample misses it
            EXPECT_LT(errorOf(sphere, 0.04, NDF_FILTER_TOKUYOSHI), beckmann ? 0.03 : 0.37)
                << elevation;
            if (!beckmann) { EXPECT_LT(errorOf(sphere, 0.04, ggxMixture), 0.035) << elevation; }
            EXPECT_LT(errorOf(sphere, 0.04, NDF_FILTER_KAPLANYAN), 0.88 * none) << elevation;
            EXPECT_LT(errorOf(sphere, 0.04, NDF_FILTER_DEFERRED), 1.05 * none) << elevation;
            EXPECT_LT(errorOf(sphere, 0.04, forwardIsotropic), 1.05 * none) << elevation;
            EXPECT_LT(errorOf(sphere, 0.04, deferredAnisotropic), beckmann ? 0.03 : 0.37)
                << elevation;
        }
    }
}

// GGX blurred by numbers: over slopes, as the mean under the kernel.
double blurred(vec2 alpha2, vec2 s, vec2 dh0, vec2 dh1) {
    double sum = 0.0, weights = 0.0;
    const double sigma = std::sqrt(double(NDF_PIXEL_VARIANCE));
    for (int i = 0; i < 200 * 200; ++i) {
        const dvec2 t = (dvec2(i % 200, i / 200) + 0.5) * (10.0 / 200) - 5.0;
        const dvec2 at = dvec2(s) + sigma * (t.x * dvec2(dh0) + t.y * dvec2(dh1));
        const double e = 1.0 + at.x * at.x / double(alpha2.x) + at.y * at.y / double(alpha2.y);
        const double weight = std::exp(-0.5 * dot(t, t));
        sum += weight / (e * e), weights += weight;
    }
    return sum / weights / (M_PI * std::sqrt(double(alpha2.x * alpha2.y)));
}

double squaredDistance(vec2 s, vec3 a) {
    const dmat2 inverted = inverse(matrixOf(a));
    return dot(dvec2(s), inverted * dvec2(s));
}

// Along a line and across, from the middle far into the tails; and all of it together.
TEST(NdfMixture, IsGgxBlurredByTheKernel) {
    const vec2 widths[] = {vec2(1e-4f), vec2(4e-4f, 2.5e-5f), vec2(1e-2f)};
    const vec2 changes[][2] = {{vec2(0.04f, 0.0f), vec2(0.0f, 0.04f)},
                               {vec2(0.03f, 0.03f), vec2(0.001f, -0.001f)},
                               {vec2(0.1f, 0.0f), vec2(0.0f, 0.0f)}};
    for (const vec2 a : widths) {
        for (const auto& change : changes) {
            const vec2 dh0 = change[0], dh1 = change[1];
            const vec3 wide = vec3(a, 0.0f) + ndf_kernel(dh0, dh1);
            const double det = double(wide.x * wide.y - wide.z * wide.z);
            const auto filtered = [&](vec2 s) {
                const double e = 1.0 + squaredDistance(s, wide);
                return double(ndf_mixture_shape(a, facet_of(s), vec3(dh0, 0), vec3(dh1, 0)))
                     / (M_PI * std::sqrt(det) * e * e);
            };
            for (const float x : {0.0f, 0.01f, 0.03f, 0.1f, 0.3f, 1.0f}) {
                for (const vec2 s : {vec2(x, 0.0f), vec2(0.6f * x, 0.8f * x), vec2(-x, x)}) {
                    EXPECT_NEAR(filtered(s) / blurred(a, s, dh0, dh1), 1.0, 0.12)
                        << a.x << ' ' << wide.x << ' ' << s.x << ' ' << s.y;
                }
            }
            // In rings whose radii grow by a hundredth, to slopes of 30 widths.
            double all = 0.0;
            for (int i = 0; i < 1400; ++i) {
                const double r = 1e-5 * std::exp(0.01 * i);
                for (int j = 0; j < 64; ++j) {
                    const double phi = 6.283185307 * (j + 0.5) / 64;
                    all += filtered(vec2(dvec2(r * std::cos(phi), r * std::sin(phi))))
                         * r * r * 0.01 * 6.283185307 / 64;
                }
            }
            EXPECT_NEAR(all, 1.0, 0.03) << a.x << ' ' << wide.x;
        }
    }
}

// Nothing moves: nothing changes. Any width and change: a number.
TEST(NdfMixture, IsAlwaysANumber) {
    Random random(6);
    for (int i = 0; i < 100'000; ++i) {
        const vec2 alpha = vec2(std::exp2(-10.0f * random.uniform()),
                                std::exp2(-10.0f * random.uniform()));
        const vec3 h = directionAt(89.0 * double(random.uniform()), 360.0 * random.uniform());
        const float size = std::exp2(8.0f - 30.0f * random.uniform());
        const vec3 dh0 = vec3(random.uniform() - 0.5f, random.uniform() - 0.5f, 0.0f) * size;
        const vec3 dh1 = i % 3 ? vec3(dh0.y, random.uniform(), 0.0f) * size : dh0 * 2.0f;
        ASSERT_NEAR(ndf_mixture_shape(alpha * alpha, h, vec3(0.0f), vec3(0.0f)), 1.0f, 1e-4f);
        const float shape = ndf_mixture_shape(alpha * alpha, h, dh0, dh1);
        ASSERT_TRUE(shape >= 0.0f && shape < 1.0e6f) << shape << ' ' << i;
    }
}

}  // namespace
}  // namespace gp::test
