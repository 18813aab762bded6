// What the denoisers promise, on image sequences of known means.
#include "realtime/denoise_scene.h"

#include <gtest/gtest.h>

namespace gp::test {
namespace {

// A plane under light of mean `mean`; the gradient samples repeat the last frame's draws.
void lightPlane(DenoiseScene& s, float mean) {
    s.forEach([&](ivec2 p) {
        s.setSurface(p, {});
        s.setLight(p, sparks(p, s.constants.frame_index - (s.isRepeated(p) ? 1 : 0), mean));
    });
    s.setGradientSamples();
}

void frameOfSparks(DenoiseScene& s, float mean, Denoiser denoiser) {
    lightPlane(s, mean);
    s.denoise(denoiser);
}

TEST(Denoise, AverageOfStaticLightConverges) {
    DenoiseScene s(ivec2(96, 64));
    s.constants.filter_luminance = 0.0f;  // what is left is the mean over frames
    double variance[2] = {};
    for (uint frame = 0; frame < 64; ++frame) {
        frameOfSparks(s, 1, Denoiser::asvgf);
        const auto direct = [&](ivec2 p) { return s.images.load_direct(p).x; };
        if (frame == 15) variance[0] = statisticsOf(s, direct).variance;
        if (frame == 63) {
            const Statistics now = statisticsOf(s, direct);
            variance[1] = now.variance;
            // 6144 pixels of variance 3 / 64: the mean is off by 0.003 in standard.
            EXPECT_NEAR(now.mean, 1, 0.02);
            const Statistics specular =
                statisticsOf(s, [&](ivec2 p) { return s.images.load_specular(p).x; });
            EXPECT_NEAR(specular.mean, 1, 0.02);
            const Statistics indirect =
                statisticsOf(s, [&](ivec2 p) { return s.images.load_indirect(p).x; });
            EXPECT_NEAR(indirect.mean, 1, 0.02);
            EXPECT_NEAR(statisticsOf(s, [&](ivec2 p) { return s.images.load_indirect(p).w; }).mean,
                        1, 0.02);
        }
        s.next();
    }
    // Four times the frames, a quarter of the variance.
    EXPECT_NEAR(variance[0] / variance[1], 4, 0.8);
}

// Means of direct and indirect light after 32 frames in which the brightest pixel of each block
// repeats itself. `counts`: the denoiser is not told.
glm::vec2 meansWithRepeatedPixels(bool counts) {
    DenoiseScene s(ivec2(96, 64));
    s.constants.filter_luminance = 0.0f;  // which has a bias of its own
    s.constants.repeats_draws = counts ? 0 : 1;
    std::vector<LightPixel> last(96 * 64), now(96 * 64);
    const auto index = [](ivec2 p) { return size_t(p.y * 96 + p.x); };
    const auto bright = [&](ivec2 p) {
        return last[index(p)].direct.x + last[index(p)].indirect.x;
    };
    for (uint frame = 0; frame < 32; ++frame) {
        s.forEach([&](ivec2 p) { now[index(p)] = sparks(p, frame, 1); });
        for (int y = 0; y < 22; ++y)
            for (int x = 0; x < 32; ++x) {
                ivec2 best(3 * x, 3 * y);
                const int rows = std::min(3, 64 - 3 * y);
                for (int i = 0; i < 3 * rows; ++i) {
                    const ivec2 p(3 * x + i % 3, 3 * y + i / 3);
                    if (bright(p) > bright(best)) best = p;
                }
                if (frame > 0) now[index(best)] = last[index(best)];
                s.images.store_gradient_sample(
                    ivec2(x, y), uint(1 + best.x % 3 + 3 * (best.y % 3)) | uint(best.x) << 4 |
                                     uint(best.y) << 18);
            }
        s.forEach([&](ivec2 p) {
            s.setSurface(p, {});
            s.setLight(p, now[index(p)]);
        });
        last = now;
        s.denoise(Denoiser::asvgf);
        s.next();
    }
    s.next();
    const auto direct = [&](ivec2 p) { return s.images.load_direct(p).x; };
    const auto indirect = [&](ivec2 p) { return s.images.load_indirect(p).x; };
    return {float(statisticsOf(s, direct).mean), float(statisticsOf(s, indirect).mean)};
}

// Whoever chooses what is repeated may look at it: RTGL1 and Q2RTX take the brightest of a block.
TEST(Denoise, RepeatedPixelsDoNotBrightenTheMean) {
    const glm::vec2 means = meansWithRepeatedPixels(false), counted = meansWithRepeatedPixels(true);
    std::printf("direct %.3f indirect %.3f; counted %.3f %.3f\n", means.x, means.y, counted.x,
                counted.y);
    EXPECT_NEAR(means.x, 1, 0.04);
    EXPECT_NEAR(means.y, 1, 0.04);
    EXPECT_GT(counted.x, 1.1);
    EXPECT_GT(counted.y, 1.1);
}

TEST(Denoise, FilterRemovesNoiseOfOneFrame) {
    for (const Denoiser d : {Denoiser::asvgf, Denoiser::svgf, Denoiser::atrous}) {
        DenoiseScene s(ivec2(96, 64));
        frameOfSparks(s, 1, d);
        const Statistics direct =
            statisticsOf(s, [&](ivec2 p) { return s.images.load_direct(p).x; });
        // The raw variance is 3; the four filters have over a hundred pixels each to average.
        EXPECT_LT(direct.variance, 0.05) << denoiserName(d);
        EXPECT_NEAR(direct.mean, 1, 0.08) << denoiserName(d);
        const Statistics indirect =
            statisticsOf(s, [&](ivec2 p) { return s.images.load_indirect(p).x; });
        EXPECT_LT(indirect.variance, 0.05) << denoiserName(d);
        EXPECT_NEAR(indirect.mean, 1, 0.08) << denoiserName(d);
    }
}

TEST(Denoise, NoneLeavesTheRawLight) {
    DenoiseScene s(ivec2(8, 8));
    lightPlane(s, 1);
    const vec4 before = s.images.load_direct(ivec2(3, 3));
    EXPECT_TRUE(denoisePasses(Denoiser::none).empty());
    s.denoise(Denoiser::none);
    EXPECT_EQ(before, s.images.load_direct(ivec2(3, 3)));
}

// The left half has light of 1, the right half none; what the halves differ by is `change`.
void expectNoLeak(const char* what, const std::function<void(SurfacePixel&)>& change,
                  bool specularOnly = false) {
    for (const Denoiser d : {Denoiser::asvgf, Denoiser::svgf, Denoiser::atrous}) {
        DenoiseScene s(ivec2(60, 30));
        for (uint frame = 0; frame < 24; ++frame) {
            s.forEach([&](ivec2 p) {
                SurfacePixel surface;
                surface.motion.w = 0.02f;
                if (p.x >= 30) change(surface);
                s.setSurface(p, surface);
                s.setLight(p, sparks(p, frame - (s.isRepeated(p) ? 1 : 0), p.x < 30 ? 1.0f : 0.0f));
            });
            s.setGradientSamples();
            s.denoise(d);
            s.next();
        }
        s.next();  // back to the results, which are what is current
        for (int y = 0; y < 30; ++y)
            for (int x = 30; x < 60; ++x) {
                const ivec2 p(x, y);
                EXPECT_LT(s.images.load_specular(p).x, 0.01f) << what << denoiserName(d) << x;
                if (specularOnly) continue;
                ASSERT_LT(s.images.load_direct(p).x, 0.01f) << what << denoiserName(d) << x;
                ASSERT_LT(s.images.load_indirect(p).x, 0.01f) << what << denoiserName(d) << x;
            }
    }
}

TEST(Denoise, DepthKeepsSurfacesApart) {
    expectNoLeak("depth", [](SurfacePixel& s) { s.depth = 7; });
}

TEST(Denoise, NormalsKeepSurfacesApart) {
    expectNoLeak("normal", [](SurfacePixel& s) { s.normal = vec3(1, 0, 0); });
}

TEST(Denoise, RoughnessKeepsReflectionsApart) {
    expectNoLeak("roughness", [](SurfacePixel& s) { s.material.roughness = 0.9f; }, true);
}

TEST(Denoise, MirrorImagesAreOtherSurfaces) {
    DenoiseScene s(ivec2(60, 30));
    s.forEach([&](ivec2 p) {
        SurfacePixel surface;
        surface.material.mirrors = p.x >= 30 ? 1 : 0;
        s.setSurface(p, surface);
        s.setLight(p, sparks(p, 0, p.x < 30 ? 1.0f : 0.0f));
    });
    s.denoise(Denoiser::asvgf);
    for (int x = 30; x < 60; ++x) {
        EXPECT_EQ(s.images.load_direct(ivec2(x, 9)).x, 0) << x;
        EXPECT_EQ(s.images.load_specular(ivec2(x, 9)).x, 0) << x;
    }
}

// The frames until less than a tenth is left of a light that was on for 40.
int lagAfterLightOff(Denoiser d, const std::function<float(const DenoiseScene&, ivec2)>& value) {
    DenoiseScene s(ivec2(60, 48));
    for (uint frame = 0; frame < 40; ++frame) {
        frameOfSparks(s, 1, d);
        s.next();
    }
    for (int lag = 1; lag < 60; ++lag) {
        frameOfSparks(s, 0, d);
        if (statisticsOf(s, [&](ivec2 p) { return value(s, p); }).mean < 0.1) return lag - 1;
        s.next();
    }
    return 60;
}

TEST(Denoise, LightThatGoesOutIsGoneInTwoFrames) {
    const auto direct = [](const DenoiseScene& s, ivec2 p) { return s.images.load_direct(p).x; };
    const auto indirect = [](const DenoiseScene& s, ivec2 p) {
        return s.images.load_indirect(p).x;
    };
    const auto specular = [](const DenoiseScene& s, ivec2 p) {
        return s.images.load_specular(p).x;
    };
    EXPECT_LE(lagAfterLightOff(Denoiser::asvgf, direct), 2);
    EXPECT_LE(lagAfterLightOff(Denoiser::asvgf, indirect), 2);
    EXPECT_LE(lagAfterLightOff(Denoiser::asvgf, specular), 2);
    // SVGF forgets a fifth a frame: 0.8^11 is below a tenth.
    EXPECT_GT(lagAfterLightOff(Denoiser::svgf, direct), 5);
}

TEST(Denoise, LightThatStaysKeepsItsHistory) {
    DenoiseScene s(ivec2(60, 48));
    for (uint frame = 0; frame < 40; ++frame) {
        frameOfSparks(s, 1, Denoiser::asvgf);
        s.next();
    }
    s.next();
    const Statistics frames =
        statisticsOf(s, [&](ivec2 p) { return s.images.load_history_length(p).x * 255; });
    // Of nine frames each pixel repeats one, which adds nothing.
    EXPECT_GE(frames.mean, 35);
    EXPECT_LE(frames.mean, 36);
    EXPECT_LE(frames.variance, 0.25);
}

TEST(Denoise, HistoryFollowsTheMotion) {
    // A plane in parallel motion: what is at x now was at x - 3 + 0.5 in the last frame.
    DenoiseScene s(ivec2(90, 30));
    s.constants.repeats_draws = 0;
    for (uint frame = 0; frame < 20; ++frame) {
        s.forEach([&](ivec2 p) {
            SurfacePixel surface;
            surface.motion = vec4(-2.5f, 0, 0, 0);
            s.setSurface(p, surface);
            const float world = float(p.x) - 2.5f * float(frame);
            LightPixel l;
            l.direct = vec3(1.0f + 0.5f * std::sin(world * 0.1f));
            s.setLight(p, l);
        });
        s.denoise(Denoiser::asvgf);
        s.next();
    }
    s.next();
    for (int x = 60; x < 90; ++x) {
        const ivec2 p(x, 15);
        EXPECT_NEAR(s.images.load_history_length(p).x * 255, 20, 1) << x;
        const float world = float(x) - 2.5f * 19;
        EXPECT_NEAR(s.images.load_direct(p).x, 1.0f + 0.5f * std::sin(world * 0.1f), 0.03f) << x;
    }
    // What came in from the left is as old as its way from there.
    EXPECT_NEAR(s.images.load_history_length(ivec2(0, 15)).x * 255, 1, 0.01);
    EXPECT_NEAR(s.images.load_history_length(ivec2(11, 15)).x * 255, 5.5, 1);
}

TEST(Denoise, DisocclusionForgets) {
    DenoiseScene s(ivec2(60, 30));
    s.constants.repeats_draws = 0;
    const auto frame = [&](int edge) {
        s.forEach([&](ivec2 p) {
            SurfacePixel surface;
            surface.depth = p.x < edge ? 2.0f : 9.0f;
            s.setSurface(p, surface);
            LightPixel l;
            l.direct = vec3(p.x < edge ? 4.0f : 1.0f);
            l.indirect = vec3(p.x < edge ? 4.0f : 1.0f);
            s.setLight(p, l);
        });
        s.denoise(Denoiser::asvgf);
    };
    for (int i = 0; i < 12; ++i) {
        frame(30);
        s.next();
    }
    frame(20);  // the near plane withdraws; the far one behind it has never been seen
    for (int x = 0; x < 60; ++x) {
        const ivec2 p(x, 12);
        const bool uncovered = x >= 20 && x < 30;
        EXPECT_NEAR(s.images.load_history_length(p).x * 255, uncovered ? 1 : 13, 0.01) << x;
        EXPECT_NEAR(s.images.load_direct(p).x, x < 20 ? 4.0f : 1.0f, 0.01f) << x;
        EXPECT_NEAR(s.images.load_indirect(p).x, x < 20 ? 4.0f : 1.0f, 0.01f) << x;
    }
}

TEST(Denoise, NoHistoryFlagAndCutForget) {
    DenoiseScene s(ivec2(12, 12));
    s.constants.repeats_draws = 0;
    for (int i = 0; i < 4; ++i) {
        lightPlane(s, 1);
        s.denoise(Denoiser::svgf);
        s.next();
    }
    lightPlane(s, 1);
    SurfacePixel unknown;
    unknown.material.flags = REALTIME_NO_HISTORY;
    s.setSurface(ivec2(5, 5), unknown);
    s.denoise(Denoiser::svgf);
    EXPECT_NEAR(s.images.load_history_length(ivec2(5, 5)).x * 255, 1, 0.01);
    EXPECT_NEAR(s.images.load_history_length(ivec2(6, 5)).x * 255, 5, 0.01);
    s.next();
    s.constants.has_previous = 0;
    lightPlane(s, 1);
    s.denoise(Denoiser::svgf);
    EXPECT_NEAR(s.images.load_history_length(ivec2(6, 5)).x * 255, 1, 0.01);
}

TEST(Denoise, ReflectionsFollowTheirMirrorImage) {
    // A mirror straight ahead at 2 m; what it shows is 6 m before it, so 8 m away. The camera steps
    // aside by 0.1 m: the image moves as a point at 8 m does, the surface as one at 2 m.
    DenoiseScene s(ivec2(120, 60));
    s.constants.repeats_draws = 0;
    s.constants.firefly_limit = 65504.0f;
    const float halfY = std::tan(0.5f * s.camera.verticalFov);
    const auto pixelsPerMetre = [&](float depth) { return 60.0f / (2.0f * halfY * depth); };
    for (int frame = 0; frame < 16; ++frame) {
        const float eye = 0.1f * float(frame);
        s.camera.position = vec3(eye, 0, 0), s.camera.target = vec3(eye, 0, -1);
        s.forEach([&](ivec2 p) {
            SurfacePixel surface;
            surface.depth = 2;
            surface.material.roughness = 0.02f;
            surface.motion = vec4(0.1f * pixelsPerMetre(2), 0, 0, 0);
            s.setSurface(p, surface);
            const float seen = (float(p.x) + 0.5f - 60.0f) / pixelsPerMetre(8) + eye;
            LightPixel l;
            const float aside = (float(p.x) + 0.5f - 60.0f) / pixelsPerMetre(1);
            const float up = (float(p.y) + 0.5f - 30.0f) / pixelsPerMetre(1);
            l.specular = vec4(vec3(1.0f + 0.9f * std::sin(4.0f * seen)),
                              6.0f * std::sqrt(1.0f + aside * aside + up * up));
            s.setLight(p, l);
        });
        s.denoise(Denoiser::asvgf);
        s.next();
    }
    s.next();
    for (int x = 10; x < 60; ++x) {
        const float seen = (float(x) + 0.5f - 60.0f) / pixelsPerMetre(8) + 1.5f;
        // Followed as a surface it would be smeared to its mean.
        EXPECT_NEAR(s.images.load_specular(ivec2(x, 30)).x, 1 + 0.9f * std::sin(4 * seen), 0.15)
            << x;
        EXPECT_GT(s.images.load_history_length(ivec2(x, 30)).y * 255, 8) << x;
    }
}

}  // namespace
}  // namespace gp::test
