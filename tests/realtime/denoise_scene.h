// Image sequences for the denoisers without a renderer: the G-buffer and the noisy channels are
// written as the passes before would, the denoiser runs, and the results are read.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#if defined(__F16C__)
#include <immintrin.h>
#endif

#include <tbb/parallel_for.h>

#include "backend/cpu/denoise_kernels.h"
#include "scene/camera.h"
#include "shading/shading.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

namespace gp::test {
namespace {

using namespace glm;
using namespace gp::shading;
using namespace gp::shared;

#include "backend/cpu/isa/image_access.h"
#include "kernels/realtime/gbuffer.glsl"

// A surface as a pixel sees it.
struct SurfacePixel {
    float depth = 5;
    vec3 normal{0, 0, 1};
    PixelMaterial material{0.5f, 0, 0, 0};
    vec4 motion{0};  // as the image: pixels, change of depth, slope
};

struct LightPixel {
    vec3 direct{0};
    vec3 indirect{0};
    vec3 indirectFrom{0, 0, 1};
    vec4 specular{0};
};

struct DenoiseScene {
    RealtimeImages memory;
    ImageAccess images{memory.views()};
    RealtimeConstants constants{};
    Camera camera, previousCamera;
    const cpu::DenoiseKernels* kernels = &cpu::denoise::kernelsX86_64;
    int32_t rowsAtOnce = 16;
    bool plain = false;  // without the optimised twins

    explicit DenoiseScene(ivec2 size, bool lends = true) : memory(lends) {
        memory.resize(size, size);
        constants.size = size, constants.output_size = size;
        constants.repeats_draws = 1;
#define X(name, initial, minimum, maximum, text) constants.name = initial;
#include "shared/denoiser_parameters.def"
#undef X
        __builtin_cpu_init();
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
            kernels = &cpu::denoise::kernelsAvx2;
    }

    // Every pixel in turn.
    void forEach(const std::function<void(ivec2)>& f) const {
        for (int y = 0; y < constants.size.y; ++y)
            for (int x = 0; x < constants.size.x; ++x) f(ivec2(x, y));
    }

    void setSurface(ivec2 p, const SurfacePixel& s) const {
        images.store_depth(p, s.depth);
        const uint normal = octahedral_encode(s.normal);
        images.store_normal(p, normal);
        images.store_unmapped_normal(p, normal);
        images.store_material(p, pack_material(s.material));
        images.store_motion(p, s.motion);
    }

    void setLight(ivec2 p, const LightPixel& l) const {
        images.store_direct(p, vec4(l.direct, 0));
        images.store_indirect_raw(p, l.indirect);
        images.store_indirect_from(p, octahedral_encode(l.indirectFrom));
        images.store_specular(p, l.specular);
        const float specular = luminance(vec3(l.specular));
        images.store_luma(p, vec4(luminance(l.direct), ycocg_from_rgb(l.indirect).x, specular, 0));
    }

    // One pixel of every block repeats its own draws of the last frame: in each frame another one,
    // so that none repeats what was repeated.
    ivec2 repeatedPixel(ivec2 block) const {
        const int cell = int(constants.frame_index * 2 % 9);
        return min(ivec2(3 * block.x + cell % 3, 3 * block.y + cell / 3), constants.size - 1);
    }
    void setGradientSamples() const {
        const ivec2 blocks = memory.size(RealtimeImage::gradient_sample);
        for (int y = 0; y < blocks.y; ++y)
            for (int x = 0; x < blocks.x; ++x) {
                const ivec2 p = repeatedPixel(ivec2(x, y)), cell = p - ivec2(3 * x, 3 * y);
                images.store_gradient_sample(ivec2(x, y), uint(1 + cell.x + 3 * cell.y) |
                                                              uint(p.x) << 4 | uint(p.y) << 18);
            }
    }
    bool isRepeated(ivec2 p) const {
        return constants.has_previous != 0 && constants.repeats_draws != 0 &&
               p == repeatedPixel(p / 3);
    }

    void run(const DenoisePass& pass) {
        const int32_t rows = memory.views().size[size_t(denoiseSize(pass.kernel))].y;
        tbb::parallel_for(0, (rows + rowsAtOnce - 1) / rowsAtOnce, [&](int32_t i) {
            const cpu::DenoiseJob job{&memory.views(), &constants, &camera, &previousCamera,
                                      pass.parameter, i * rowsAtOnce,
                                      std::min(rows, (i + 1) * rowsAtOnce)};
            (plain ? kernels->plain : kernels->run)[size_t(pass.kernel)](job);
        });
    }
    void denoise(Denoiser denoiser) {
        for (const DenoisePass& pass : denoisePasses(denoiser)) run(pass);
    }

    // The frame is over: the next one remembers it.
    void next() {
        memory.swap();
        previousCamera = camera;
        constants.has_previous = 1;
        ++constants.frame_index;
    }
};

// Uniform in [0, 1), by pixel, frame and dimension.
inline float noise(ivec2 p, uint frame, uint dimension) {
    return float(hash_u32(hash_u32(hash_u32(uint(p.x) * 0x9E3779B9u + uint(p.y)) + frame) +
                          dimension) >> 8) * EXP2_MINUS_24;
}

// One path's light: 0 or 4 with mean 1 (variance 3).
inline float spark(ivec2 p, uint frame, uint dimension) {
    return noise(p, frame, dimension) < 0.25f ? 4.0f : 0.0f;
}

// Noisy light of mean `mean` in all three channels.
inline LightPixel sparks(ivec2 p, uint frame, float mean) {
    LightPixel l;
    l.direct = vec3(mean * spark(p, frame, 0));
    l.indirect = vec3(mean * spark(p, frame, 1));
    l.specular = vec4(vec3(mean * spark(p, frame, 2)), 1);
    return l;
}

struct Statistics {
    double mean = 0, variance = 0;
};

// Over the pixels for which `value` is a number.
inline Statistics statisticsOf(const DenoiseScene& scene,
                               const std::function<float(ivec2)>& value) {
    double sum = 0, squares = 0, count = 0;
    scene.forEach([&](ivec2 p) {
        const double v = value(p);
        if (v != v) return;
        sum += v, squares += v * v, count += 1;
    });
    const double mean = sum / count;
    return {mean, squares / count - mean * mean};
}

}  // namespace
}  // namespace gp::test

#pragma GCC diagnostic pop
