// BMFR: light that features of surfaces explain passes through it, noise does not.
#include "realtime/denoise_scene.h"

#include <gtest/gtest.h>

namespace gp::test {
namespace {

constexpr ivec2 size(80, 56);  // blocks of 32 that reach over every border

// A bumpy slope: depths and normals differ from pixel to pixel.
SurfacePixel bumpy(ivec2 p) {
    SurfacePixel s;
    const vec2 at(p);
    s.depth = 5.0f + 0.02f * at.x + 0.01f * at.y;
    s.motion.w = 0.03f;
    s.normal = normalize(vec3(0.3f * std::sin(0.5f * at.x), 0.3f * std::cos(0.4f * at.y), 1.0f));
    return s;
}

// What lambertian surfaces show of a far lamp, and a gradient; all of it in the span of the
// features: a constant, the normal, where in the picture.
float explained(ivec2 p) {
    const SurfacePixel s = bumpy(p);
    return 1.0f + dot(s.normal, vec3(0.5f, -0.4f, 0.3f)) + 0.1f * s.depth;
}

void fill(DenoiseScene& s, const std::function<LightPixel(ivec2)>& light) {
    s.constants.repeats_draws = 0;
    s.forEach([&](ivec2 p) {
        s.setSurface(p, bumpy(p));
        s.setLight(p, light(p));
    });
}

LightPixel sharedOut(float light) {
    LightPixel l;
    l.direct = vec3(light, 0.5f * light, 0);
    l.indirect = vec3(light, 0, light);
    l.specular = vec4(vec3(0.25f * light), 1);
    return l;
}

double rmse(const DenoiseScene& s, const std::function<float(ivec2)>& error) {
    const Statistics e = statisticsOf(s, error);
    return std::sqrt(e.variance + e.mean * e.mean);
}

TEST(Bmfr, WhatFeaturesExplainPassesThrough) {
    DenoiseScene s(size);
    for (int frame = 0; frame < 4; ++frame) {
        fill(s, [](ivec2 p) { return sharedOut(explained(p)); });
        s.denoise(Denoiser::bmfr);
        // The ridge is what keeps it from being exact, most in small blocks at the border; without
        // normals the error would be 0.1.
        const auto direct = [&](ivec2 p) { return s.images.load_direct(p).x - 2 * explained(p); };
        EXPECT_LT(rmse(s, direct), 0.01) << frame;
        EXPECT_NEAR(statisticsOf(s, direct).mean, 0, 0.003);
        EXPECT_LT(rmse(s, [&](ivec2 p) {
            return s.images.load_direct(p).y - 0.5f * explained(p);
        }), 0.005);
        EXPECT_LT(rmse(s, [&](ivec2 p) { return s.images.load_direct(p).z - explained(p); }), 0.01);
        EXPECT_LT(rmse(s, [&](ivec2 p) {
            return s.images.load_specular(p).y - 0.25f * explained(p);
        }), 0.005);
        // All diffuse light is in one channel, and not counted twice.
        s.forEach([&](ivec2 p) { ASSERT_EQ(s.images.load_indirect_raw(p), vec3(0)); });
        s.next();
    }
}

TEST(Bmfr, NoiseDoesNot) {
    DenoiseScene s(size);
    double first = 0;
    for (uint frame = 0; frame < 24; ++frame) {
        fill(s, [&](ivec2 p) { return sparks(p, frame, 1); });
        s.denoise(Denoiser::bmfr);
        const Statistics direct =
            statisticsOf(s, [&](ivec2 p) { return s.images.load_direct(p).x; });
        EXPECT_NEAR(direct.mean, 2, 0.15) << frame;  // with the indirect light
        // A path has a variance of 6; least squares of 10 weights over 1,024 pixels, less in blocks
        // at the border, leave about 10 / 1,024 of it.
        EXPECT_LT(direct.variance, 0.3) << frame;
        if (frame == 0) first = direct.variance;
        if (frame == 23) {
            EXPECT_LT(direct.variance, 0.25 * first);
        }
        s.next();
    }
}

// Another surface in the same block has light of its own.
TEST(Bmfr, FeaturesTellSurfacesApart) {
    DenoiseScene s(size);
    s.constants.repeats_draws = 0;
    s.forEach([&](ivec2 p) {
        SurfacePixel surface;
        if (p.x >= 40) surface.normal = vec3(1, 0, 0);
        s.setSurface(p, surface);
        LightPixel l;
        l.direct = vec3(p.x < 40 ? 1.0f : 0.0f);
        s.setLight(p, l);
    });
    s.denoise(Denoiser::bmfr);
    for (int x = 0; x < size.x; ++x)
        EXPECT_NEAR(s.images.load_direct(ivec2(x, 30)).x, x < 40 ? 1.0f : 0.0f, 0.03f) << x;
}

// What has no surface is no equation: a bright sky beside an unlit plane.
TEST(Bmfr, PixelsWithoutSurfaceHaveNoSay) {
    DenoiseScene s(size);
    s.constants.repeats_draws = 0;
    s.forEach([&](ivec2 p) {
        SurfacePixel surface = bumpy(p);
        const bool sky = p.y < 20 || p == ivec2(50, 40);
        if (sky) surface.depth = DEPTH_NONE, surface.material.flags = REALTIME_SKY;
        s.setSurface(p, surface);
        LightPixel l;
        l.direct = vec3(sky ? 100.0f : 1.0f);
        s.setLight(p, l);
    });
    s.denoise(Denoiser::bmfr);
    s.forEach([&](ivec2 p) {
        const bool sky = p.y < 20 || p == ivec2(50, 40);
        EXPECT_NEAR(s.images.load_direct(p).x, sky ? 100.0f : 1.0f, 0.02f) << p.x << " " << p.y;
    });
}

// Blocks begin elsewhere in each frame: what no feature explains, a step in the middle of a wall,
// has other borders in each, and their mean is smoother than any of them.
TEST(Bmfr, BordersOfBlocksAverageOut) {
    DenoiseScene s(size);
    s.constants.repeats_draws = 0;
    const auto roughness = [&] {
        double sum = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 1; x + 1 < size.x; ++x) {
                const float bend = s.images.load_direct(ivec2(x - 1, y)).x -
                                   2 * s.images.load_direct(ivec2(x, y)).x +
                                   s.images.load_direct(ivec2(x + 1, y)).x;
                sum += double(bend) * double(bend);
            }
        return sum;
    };
    double first = 0, last = 0;
    for (int frame = 0; frame < 20; ++frame) {
        s.forEach([&](ivec2 p) {
            s.setSurface(p, {});
            LightPixel l;
            l.direct = vec3(p.x < 40 ? 1.0f : 3.0f);
            s.setLight(p, l);
        });
        s.denoise(Denoiser::bmfr);
        (frame == 0 ? first : last) = roughness();
        s.next();
    }
    EXPECT_GT(first, 0.5);
    EXPECT_LT(last, 0.5 * first);
}

// Numbers that are none, in light or in geometry, spoil no block.
TEST(Bmfr, BadNumbersAreNone) {
    DenoiseScene s(size);
    const float bad[] = {NAN, INFINITY, -INFINITY, 1e38f, -1e38f, 0.0f};
    for (int frame = 0; frame < 6; ++frame) {
        fill(s, [](ivec2) { return sharedOut(1); });
        for (int i = 0; i < 6; ++i) {
            const ivec2 p(11 * i + 3, 20);
            SurfacePixel surface = bumpy(p);
            surface.depth = bad[(i + frame) % 6];
            surface.motion = vec4(bad[(i + 1) % 6]);
            s.setSurface(p, surface);
            s.images.store_motion(p + ivec2(0, 9), vec4(bad[i]));
            LightPixel l = sharedOut(1);
            l.direct = vec3(i < 3 ? 0.0f : 1.0f);
            s.setLight(p + ivec2(0, 4), l);
        }
        s.denoise(Denoiser::bmfr);
        s.forEach([&](ivec2 p) {
            const vec4 direct = s.images.load_direct(p);
            const bool isBad = p.y == 20 && p.x % 11 == 3;
            ASSERT_TRUE(std::isfinite(direct.x + direct.y + direct.z));
            ASSERT_TRUE(std::isfinite(s.images.load_fitted_diffuse(p).x));
            if (!isBad) { ASSERT_NEAR(direct.x, 2, 0.3) << frame << " " << p.x << " " << p.y; }
        });
        s.next();
    }
}

TEST(Bmfr, ItsImagesAreThereForItAlone) {
    RealtimeImages images;
    images.resize({64, 48}, {64, 48});
    const uint64_t without = images.bytes();
    EXPECT_FALSE(images.holds(RealtimeImage::fitted_diffuse));
    images.resize({64, 48}, {64, 48}, {false, false, true});
    EXPECT_TRUE(images.holds(RealtimeImage::fitted_diffuse));
    EXPECT_EQ(images.bytes() - without, 64u * 48u * 32u);
}

}  // namespace
}  // namespace gp::test
