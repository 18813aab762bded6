#include "frame/denoise.h"

namespace gp {
namespace {

using enum DenoiseKernel;

// kernels/realtime/edge_stop.glsl.
constexpr int32_t noHistory = 0, fixedHistory = 1, adaptiveHistory = 2;

constexpr DenoisePass asvgf[] = {
    // How much of the light has changed since the last frame, from pixels that repeat it.
    {"gradient", gradient_measure, 0},
    {"gradient", gradient_spread, 0},
    {"gradient", gradient_spread, 1},
    {"gradient", gradient_spread, 2},
    {"gradient", gradient_spread, 3},
    // The mean over frames, shorter where light has changed.
    {"temporal", temporal_filter, adaptiveHistory},
    {"indirect temporal", indirect_temporal, adaptiveHistory},
    // The mean over neighbours of one surface.
    {"atrous", atrous_filter, 0},
    {"atrous", atrous_filter, 1},
    {"atrous", atrous_filter, 2},
    {"atrous", atrous_filter, 3},
    {"indirect filter", indirect_filter, 0},
    {"indirect filter", indirect_filter, 1},
    {"indirect filter", indirect_filter, 2},
    // From blocks back to pixels.
    {"indirect upsample", indirect_upsample, 0},
};

constexpr DenoisePass svgf[] = {
    {"temporal", temporal_filter, fixedHistory},
    {"indirect temporal", indirect_temporal, fixedHistory},
    {"atrous", atrous_filter, 0},
    {"atrous", atrous_filter, 1},
    {"atrous", atrous_filter, 2},
    {"atrous", atrous_filter, 3},
    {"indirect filter", indirect_filter, 0},
    {"indirect filter", indirect_filter, 1},
    {"indirect filter", indirect_filter, 2},
    {"indirect upsample", indirect_upsample, 0},
};

constexpr DenoisePass atrous[] = {
    {"temporal", temporal_filter, noHistory},
    {"indirect temporal", indirect_temporal, noHistory},
    {"atrous", atrous_filter, 0},
    {"atrous", atrous_filter, 1},
    {"atrous", atrous_filter, 2},
    {"atrous", atrous_filter, 3},
    {"indirect filter", indirect_filter, 0},
    {"indirect filter", indirect_filter, 1},
    {"indirect filter", indirect_filter, 2},
    {"indirect upsample", indirect_upsample, 0},
};

constexpr DenoisePass bmfr[] = {
    // One channel of all diffuse light.
    {"gather", bmfr_gather, 0},
    {"temporal", temporal_filter, fixedHistory},
    // What features of the surfaces explain of it, block by block.
    {"fit", bmfr_fit, 0},
    // The mean over frames hides the borders of blocks.
    {"accumulate", bmfr_accumulate, 0},
};

struct Entry {
    const char* name;
    std::span<const DenoisePass> passes;
};
const Entry entries[denoiserCount] = {
    {"asvgf", asvgf}, {"svgf", svgf}, {"atrous", atrous}, {"none", {}}, {"bmfr", bmfr}};

constexpr RealtimeSize sizes[] = {
#define X(name, size) RealtimeSize::size,
    GP_DENOISE_KERNELS(X)
#undef X
};

}  // namespace

std::span<const DenoisePass> denoisePasses(Denoiser denoiser) {
    return entries[size_t(denoiser)].passes;
}

RealtimeSize denoiseSize(DenoiseKernel kernel) { return sizes[size_t(kernel)]; }

bool usesGradients(Denoiser denoiser) { return denoiser == Denoiser::asvgf; }

bool filtersIndirect(Denoiser denoiser) {
    return denoiser != Denoiser::none && denoiser != Denoiser::bmfr;
}

const char* denoiserName(Denoiser denoiser) { return entries[size_t(denoiser)].name; }

std::optional<Denoiser> denoiserFromName(std::string_view name) {
    for (size_t i = 0; i < denoiserCount; ++i)
        if (name == entries[i].name) return Denoiser(i);
    return std::nullopt;
}

}  // namespace gp
