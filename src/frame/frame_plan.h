// Every option of a render, resolved once before the first pass.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "frame/draw.h"
#include "scene/camera.h"

namespace gp {

enum class Tonemap : uint32_t { agx, aces, reinhard, none };
enum class PixelFilter : uint32_t { blackmanHarris, box, tent, gaussian };
enum class ShadingMode : uint32_t { full, diffuse };
enum class FrameMode : uint32_t { reference, realtime, local };

struct BsdfSettings;      // scene/bsdf_registry.h
struct EnvironmentTable;  // scene/environment_table.h
struct SkyPyramid;        // scene/sky_pyramid.h

// FrameMode::local: how lamps light what the camera sees. The numbers are the kernel's.
enum class ShadingFrequency : uint32_t { pixel, vertex, triangle };
enum class Falloff : uint32_t { inverseSquare, inverse, none };
enum class NdfFilter : uint32_t { none, kaplanyan, tokuyoshi, deferred };

struct LocalLighting {
    const BsdfSettings* model = nullptr;  // in every material's place; null: their own
    ShadingFrequency frequency = ShadingFrequency::pixel;
    Falloff falloff = Falloff::inverseSquare;
    NdfFilter ndfFilter = NdfFilter::none;
    glm::vec3 ambient{0};                 // radiance, beside the environment's
    uint32_t environmentNodes = 0;        // facets along each axis that the environment lights,
                                          // 3..5; 0: it is ambient light
};

struct FramePlan {
    uint32_t width = 0, height = 0;
    Camera camera;
    FrameMode mode = FrameMode::reference;
    LocalLighting local;

    uint32_t samplesPerPixel = 64;  // to add; UINT32_MAX: until another limit
    double timeLimit = 0;           // seconds, 0: none
    double noiseTarget = 0;         // relative, 0: none
    uint32_t maxBounces = 16;       // 0: directly arriving light only
    uint64_t seed = 0;
    ShadingMode shading = ShadingMode::full;
    PixelFilter pixelFilter = PixelFilter::blackmanHarris;
    float pixelFilterRadius = 1.5f;
    float clampIndirect = 0;        // 0: off
    bool russianRoulette = true;
    bool lastByLights = false;      // the last surface of a path has a shadow ray only
    float rayLength = std::numeric_limits<float>::max();  // metres; what lies beyond is sky
    float exposureEv = 0;
    Tonemap tonemap = Tonemap::agx;
    bool accumulate = false;
    const DrawList* draws = nullptr;  // rasterised into the picture; null: none

    // In the environment's place, where more surrounds the scene (frame/frame_sky.h); else null.
    std::shared_ptr<const EnvironmentTable> sky;
    bool skyDrawn = false;            // rasterised geometry is in it
    bool hideBackground = false;      // camera rays see nothing behind surfaces
    // FrameMode::local: what surrounds the scene as light (frame/frame_surroundings.h); null: none.
    std::shared_ptr<const SkyPyramid> surroundings;
    glm::vec3 skyViewer{0};           // where sky geometry is seen from
    uint32_t skyCubeSize = 128;       // pixels of a face that sky is drawn into

    // The share of what the environment, directional and local lights send that arrives, on average
    // over the picture: set before the first sample, by Backend::estimateLightVisibility.
    std::array<float, 3> lightVisibility{1, 1, 1};
};

}  // namespace gp
