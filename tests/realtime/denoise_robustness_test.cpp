// Bad numbers, odd sizes, threads, instruction sets.
#include "realtime/denoise_scene.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace gp::test {
namespace {

constexpr Denoiser all[] = {Denoiser::asvgf, Denoiser::svgf, Denoiser::atrous};

void fillPlane(DenoiseScene& s) {
    s.forEach([&](ivec2 p) {
        s.setSurface(p, {});
        LightPixel l = sparks(p, s.constants.frame_index, 0.5f);
        l.direct += 0.5f, l.indirect += 0.5f, l.specular += 0.5f;
        s.setLight(p, l);
    });
    s.setGradientSamples();
}

// Bits of halves as a kernel without guards might have left them.
void setHalves(DenoiseScene& s, RealtimeImage image, ivec2 p, uint16_t bits, int count) {
    std::byte* pixel = s.memory.views().current[size_t(image)] +
                       (size_t(p.y) * size_t(s.constants.size.x) + size_t(p.x)) *
                           bytesPerPixel(realtimeImageInfo(image).format);
    for (int i = 0; i < count; ++i) reinterpret_cast<uint16_t*>(pixel)[i] = bits;
}

bool finite(vec4 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

TEST(DenoiseRobustness, BadNumbersStayWhereTheyAre) {
    constexpr uint16_t nanBits = 0x7E00, infinityBits = 0x7C00, mostBits = 0x7BFF;
    for (const Denoiser d : all)
        for (const uint16_t bits : {nanBits, infinityBits, mostBits}) {
            DenoiseScene clean(ivec2(48, 32)), bad(ivec2(48, 32));
            const ivec2 p(13, 16);
            for (int frame = 0; frame < 6; ++frame) {
                for (DenoiseScene* s : {&clean, &bad}) {
                    fillPlane(*s);
                    s->constants.repeats_draws = 0;
                    if (s == &bad && frame == 4) {
                        for (const RealtimeImage image :
                             {RealtimeImage::direct, RealtimeImage::specular})
                            setHalves(*s, image, p, bits, 4);
                        s->images.store_indirect_raw(p, vec3(RGB9E5_LARGEST));
                    }
                    s->denoise(d);
                }
                bad.forEach([&](ivec2 q) {
                    ASSERT_TRUE(finite(bad.images.load_direct(q)));
                    ASSERT_TRUE(finite(bad.images.load_specular(q)));
                    ASSERT_TRUE(finite(bad.images.load_indirect(q)));
                    ASSERT_TRUE(finite(bad.images.load_direct_history(q)));
                    // Fireflies are cut to firefly_limit times the brightest neighbour (2.5) and
                    // shared with neighbours; the means are 1.
                    ASSERT_LT(bad.images.load_direct(q).x, 30) << frame << denoiserName(d);
                    ASSERT_LT(bad.images.load_specular(q).x, 30) << frame << denoiserName(d);
                    ASSERT_LT(bad.images.load_indirect(q).x, 30) << frame << denoiserName(d);
                    // The filter reaches 15 pixels, what it is guided by two more.
                    const int distance = std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
                    if (frame != 4 || distance < 18) return;
                    EXPECT_EQ(bad.images.load_direct(q), clean.images.load_direct(q));
                });
                clean.next(), bad.next();
            }
        }
}

TEST(DenoiseRobustness, BadGeometryIsNotFollowed) {
    DenoiseScene s(ivec2(24, 24));
    const float bad[] = {NAN, INFINITY, -INFINITY, 1e38f, -1e38f, 0.0f};
    for (int frame = 0; frame < 4; ++frame) {
        fillPlane(s);
        for (int i = 0; i < 6; ++i) {
            SurfacePixel odd;
            odd.depth = bad[i];
            s.setSurface(ivec2(3 * i + 2, 5), odd);
            const uint16_t bits = i % 2 == 0 ? 0x7E00 : 0x7C00;
            setHalves(s, RealtimeImage::motion, ivec2(3 * i + 2, 9), bits, 4);
            SurfacePixel far;
            far.motion = vec4(bad[i], bad[5 - i], bad[i], bad[i]);
            s.setSurface(ivec2(3 * i + 2, 13), far);
        }
        s.denoise(Denoiser::asvgf);
        s.forEach([&](ivec2 p) {
            ASSERT_TRUE(finite(s.images.load_direct(p))) << p.x << " " << p.y;
            ASSERT_TRUE(finite(s.images.load_specular(p))) << p.x << " " << p.y;
            ASSERT_TRUE(finite(s.images.load_indirect(p))) << p.x << " " << p.y;
        });
        s.next();
    }
}

TEST(DenoiseRobustness, AnySizeWorks) {
    for (const ivec2 size :
         {ivec2(1, 1), ivec2(2, 3), ivec2(1, 1000), ivec2(1000, 1), ivec2(7, 5)})
        for (const Denoiser d : all) {
            DenoiseScene s(size);
            for (int frame = 0; frame < 3; ++frame) {
                s.forEach([&](ivec2 p) {
                    s.setSurface(p, {});
                    LightPixel l;
                    l.direct = vec3(2), l.specular = vec4(4, 4, 4, 1);
                    l.indirect = vec3(3.5f, 2.75f, 3);
                    s.setLight(p, l);
                });
                s.setGradientSamples();
                s.denoise(d);
                s.forEach([&](ivec2 p) {  // constant light stays what it is, to rounding of halves
                    ASSERT_NEAR(s.images.load_direct(p).y, 2, 0.002);
                    ASSERT_NEAR(s.images.load_indirect(p).x, 3, 0.003);
                    ASSERT_NEAR(s.images.load_indirect(p).w, 3, 0.003);
                    ASSERT_NEAR(s.images.load_indirect_chroma(p).y, -0.5, 0.001);
                    ASSERT_NEAR(s.images.load_specular(p).z, 4, 0.004);
                });
                s.next();
            }
        }
}

TEST(DenoiseRobustness, SkyKeepsOut) {
    DenoiseScene s(ivec2(30, 30));
    s.forEach([&](ivec2 p) {
        SurfacePixel surface;
        LightPixel l;
        if (p.x < 15) {
            surface.depth = DEPTH_NONE, surface.material.flags = REALTIME_SKY;
            l.direct = vec3(7);
        } else {
            l.direct = vec3(1), l.indirect = vec3(1);
        }
        s.setSurface(p, surface);
        s.setLight(p, l);
    });
    s.denoise(Denoiser::asvgf);
    for (int x = 0; x < 30; ++x) {
        EXPECT_EQ(s.images.load_direct(ivec2(x, 9)).x, x < 15 ? 7 : 1) << x;
        EXPECT_NEAR(s.images.load_indirect(ivec2(x, 9)).x, x < 15 ? 0 : 1, 0.001) << x;
    }
}

std::vector<float> resultsOf(int threads, int rowsAtOnce, const cpu::DenoiseKernels& kernels,
                             Denoiser d, bool plain = false, ivec2 size = ivec2(53, 47),
                             bool lends = true) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, size_t(threads));
    DenoiseScene s(size, lends);
    s.plain = plain;
    s.kernels = &kernels;
    s.rowsAtOnce = rowsAtOnce;
    for (int frame = 0; frame < 8; ++frame) {
        s.forEach([&](ivec2 p) {
            SurfacePixel surface;
            surface.depth = p.x * 2 < p.y ? 3.0f : 5.0f + 0.01f * float(p.x);
            surface.normal = normalize(vec3(0.1f * float(p.x % 3), 0.02f * float(p.y), 1));
            surface.material.roughness = float(p.y) / 47.0f;
            surface.motion = vec4(0.7f, -0.3f, 0.01f, 0.01f);
            s.setSurface(p, surface);
            s.setLight(p, sparks(p, uint(frame), float(p.y) * 0.1f));
        });
        s.setGradientSamples();
        s.denoise(d);
        s.next();
    }
    s.next();
    std::vector<float> results;
    s.forEach([&](ivec2 p) {
        for (const vec4 v : {s.images.load_direct(p), s.images.load_specular(p),
                             s.images.load_indirect(p)})
            for (int i = 0; i < 4; ++i) results.push_back(v[i]);
    });
    return results;
}

TEST(DenoiseRobustness, ThreadsAndRowsDoNotMatter) {
    for (const Denoiser d : all) {
        const auto one = resultsOf(1, 47, cpu::denoise::kernelsX86_64, d);
        EXPECT_EQ(one, resultsOf(2, 1, cpu::denoise::kernelsX86_64, d));
        EXPECT_EQ(one, resultsOf(2, 5, cpu::denoise::kernelsX86_64, d));
    }
}

// Who lives in another image's memory finds there what it left, and leaves nothing to be missed.
TEST(DenoiseRobustness, SharedMemoryDoesNotShow) {
    for (const ivec2 size : {ivec2(53, 47), ivec2(2, 2)})
        for (const Denoiser d : all) {
            const auto shared = resultsOf(2, 8, cpu::denoise::kernelsX86_64, d, false, size);
            EXPECT_EQ(shared,
                      resultsOf(2, 8, cpu::denoise::kernelsX86_64, d, false, size, false));
        }
    RealtimeImages shared, apart(false);
    shared.resize(ivec2(64, 48), ivec2(64, 48));
    apart.resize(ivec2(64, 48), ivec2(64, 48));
    EXPECT_LE(double(shared.bytes()), 64 * 48 * 150.0);
    EXPECT_GT(double(apart.bytes()), 64 * 48 * 190.0);
}

TEST(DenoiseRobustness, InstructionSetsAgree) {
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
    const auto plain = resultsOf(2, 8, cpu::denoise::kernelsX86_64, Denoiser::asvgf);
    const auto compare = [&](const cpu::DenoiseKernels& kernels, const char* name) {
        const auto other = resultsOf(2, 8, kernels, Denoiser::asvgf);
        for (size_t i = 0; i < plain.size(); ++i)  // eight frames of rounded halves, multiply-adds
            ASSERT_NEAR(plain[i], other[i], 0.01f * (1.0f + std::abs(plain[i]))) << name << i;
    };
    compare(cpu::denoise::kernelsAvx2, "avx2");
    if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
        compare(cpu::denoise::kernelsAvx512, "avx512");
}

// Wider than the runs that the twins work on, and not a multiple of anything.
TEST(DenoiseRobustness, TwinsDoWhatThePlainKernelsDo) {
    for (const ivec2 size : {ivec2(301, 47), ivec2(128, 9), ivec2(1, 20), ivec2(130, 1)}) {
        const auto compare = [&](const cpu::DenoiseKernels& kernels, const char* name) {
            const auto plain = resultsOf(2, 8, kernels, Denoiser::asvgf, true, size);
            const auto fast = resultsOf(2, 8, kernels, Denoiser::asvgf, false, size);
            for (size_t i = 0; i < plain.size(); ++i)  // eight frames of halves, other roundings
                ASSERT_NEAR(plain[i], fast[i], 0.005f * (1.0f + std::abs(plain[i])))
                    << name << " " << size.x << " " << i;
        };
        compare(cpu::denoise::kernelsX86_64, "x86-64");
        __builtin_cpu_init();
        if (__builtin_cpu_supports("avx2")) compare(cpu::denoise::kernelsAvx2, "avx2");
        if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
            compare(cpu::denoise::kernelsAvx512, "avx512");
    }
}

// A picture of `output` pixels from `size` samples, over frames that move by any amount.
std::vector<float> resolvedPicture(bool plain, ivec2 size, ivec2 output) {
    DenoiseScene s(size);
    s.memory.resize(size, output, {});
    s.constants.output_size = output, s.constants.resolves = 1;
    s.plain = plain;
    std::vector<float> picture;
    for (uint frame = 0; frame < 4; ++frame) {
        s.constants.jitter = vec2(0.3f, -0.4f) * float(frame % 2);
        s.forEach([&](ivec2 p) {
            const auto u = [&](uint i) { return noise(p, frame, i); };
            s.images.store_color(p, vec4(u(0), u(1), 20 * u(2) * u(2), u(3) < 0.5f ? 0 : 1));
            s.images.store_depth(p, u(4) < 0.1f ? DEPTH_NONE : 1 + u(5));
            s.images.store_motion(p, frame == 2 ? vec4(0)  // the past lies on whole pixels
                                                : vec4(9 * u(6) - 4, 9 * u(7) - 4, 0, 0));
        });
        s.run(resolvePass);
        s.next();
    }
    s.next();
    for (int y = 0; y < output.y; ++y)
        for (int x = 0; x < output.x; ++x)
            for (int c = 0; c < 4; ++c) picture.push_back(s.images.load_output(ivec2(x, y))[c]);
    return picture;
}

TEST(DenoiseRobustness, ThePictureIsThatOfThePlainKernel) {
    constexpr ivec2 sizes[][2] = {{{140, 9}, {140, 9}}, {{70, 33}, {131, 64}}, {{1, 1}, {1, 2}},
                                  {{3, 5}, {3, 5}}};
    for (const auto& size : sizes) {
        const auto plain = resolvedPicture(true, size[0], size[1]);
        const auto fast = resolvedPicture(false, size[0], size[1]);
        for (size_t i = 0; i < plain.size(); ++i)  // halves
            ASSERT_NEAR(plain[i], fast[i], 2e-3f * (1 + std::abs(plain[i])))
                << size[1].x << " " << i;
        const auto [least, most] = std::minmax_element(plain.begin(), plain.end());
        EXPECT_LT(*least + 0.2f, *most + (size[0].x == 1 ? 1 : 0));
    }
}

// A thing before a noisy wall goes away: the picture there is that of one frame, without a ghost.
TEST(DenoiseRobustness, ThePictureForgetsWhatCoveredIt) {
    for (const bool plain : {true, false}) {
        DenoiseScene s(ivec2(30, 12)), fresh(ivec2(30, 12));
        for (DenoiseScene* scene : {&s, &fresh}) {
            scene->constants.resolves = 1, scene->plain = plain;
            for (uint frame = 0; frame < 2; ++frame) {
                scene->forEach([&](ivec2 p) {
                    const bool covered = frame == 0 && p.x < 15;
                    const float wall = noise(p, frame, 0);
                    scene->images.store_color(p, vec4(vec3(covered ? 0.5f : wall), 1));
                    scene->images.store_depth(p, covered ? 1.0f : 4.0f);
                    scene->images.store_motion(p, vec4(0));
                });
                scene->run(resolvePass);
                if (frame == 0) scene->next();
                fresh.constants.has_previous = 0;
            }
        }
        int mixed = 0;
        s.forEach([&](ivec2 p) {
            const vec4 now = s.images.load_output(p), alone = fresh.images.load_output(p);
            if (p.x < 14) {
                ASSERT_EQ(now, alone) << p.x << " " << plain;
            }
            mixed += now != alone;
        });
        EXPECT_GT(mixed, 12 * 12);
    }
}

TEST(DenoiseRobustness, NamesGoBothWays) {
    for (size_t i = 0; i < denoiserCount; ++i)
        EXPECT_EQ(denoiserFromName(denoiserName(Denoiser(i))), Denoiser(i));
    EXPECT_FALSE(denoiserFromName("bilateral"));
    EXPECT_FALSE(denoiserFromName(""));
}

}  // namespace
}  // namespace gp::test
