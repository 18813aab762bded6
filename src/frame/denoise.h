// The passes of the real-time frame that look at images only: the denoisers (which kernels of
// src/kernels/realtime run, in what order), and those that make the picture after them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "frame/realtime_images.h"

namespace gp {

enum class Denoiser : uint8_t { asvgf, svgf, atrous, none };
constexpr size_t denoiserCount = 4;

// The kernels; each takes a pixel (or block) of an image of `size` and one parameter.
#define GP_DENOISE_KERNELS(X)    \
    X(gradient_measure, THIRD)   \
    X(gradient_spread, THIRD)    \
    X(temporal_filter, FULL)     \
    X(atrous_filter, FULL)       \
    X(indirect_temporal, THIRD)  \
    X(indirect_filter, THIRD)    \
    X(indirect_upsample, FULL)   \
    X(realtime_composite, FULL)  \
    X(realtime_resolve, OUTPUT)

enum class DenoiseKernel : uint8_t {
#define X(name, size) name,
    GP_DENOISE_KERNELS(X)
#undef X
    count
};
constexpr size_t denoiseKernelCount = size_t(DenoiseKernel::count);

// One pass over all pixels. All of a pass are finished before the next begins; within one, rows in
// any order, on any threads.
struct DenoisePass {
    const char* name;     // for timing: passes of one name are one entry
    DenoiseKernel kernel;
    int32_t parameter;    // an iteration, or what to do with the last frame
};

// After them the images direct, indirect, indirect_chroma and specular hold what is to be composed.
std::span<const DenoisePass> denoisePasses(Denoiser denoiser);

// The channels together again; and smooth edges, output size.
constexpr DenoisePass compositePass = {"composite", DenoiseKernel::realtime_composite, 0};
constexpr DenoisePass resolvePass = {"resolve", DenoiseKernel::realtime_resolve, 0};

// What the rows of a kernel are counted in.
RealtimeSize denoiseSize(DenoiseKernel kernel);

// Whether it needs the pixels that repeat the last frame's (`gradient_sample`).
bool usesGradients(Denoiser denoiser);

// "asvgf", "svgf", "atrous", "none".
const char* denoiserName(Denoiser denoiser);
std::optional<Denoiser> denoiserFromName(std::string_view name);

}  // namespace gp
