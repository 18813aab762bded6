// What a person has chosen to see: the window's thread fills it in, the rendering thread obeys.
#pragma once

#include <glitterpath/glitterpath.h>

#include <cstdint>
#include <map>
#include <string>

#include "view/resolution_controller.h"
#include "view/scene_lights.h"

namespace gp::tool::view {

// What is shown while something changes.
enum class LiveMode {
    realtime,  // GP_MODE_REALTIME: goes on at rest, too
    traced,    // path tracing, one sample a pixel
    local      // the picture of a rasteriser (GP_MODE_LOCAL)
};

// GpEyeAdaptation; the exposure of the viewer has no say while it is on.
struct EyeChoices {
    float seconds = 0;                        // 0: off
    float evMin = -10, evMax = 10;
    friend bool operator==(const EyeChoices&, const EyeChoices&) = default;
};

// What only LiveMode::realtime has.
struct RealtimeChoices {
    float renderScale = 1;                    // at most; less where time is short
    GpDenoiser denoiser = GP_DENOISER_ASVGF;
    GpLightReuse lightReuse = GP_REUSE_NONE, indirectReuse = GP_REUSE_NONE;
    std::map<std::string, float> numbers;     // of the denoisers, those that are not by default
    EyeChoices eye;
    GpAntiAliasing antiAliasing = GP_AA_TEMPORAL;
    std::int32_t bounces = 1, mirrors = 4;    // 0 = none
    std::uint64_t cuts = 0;                   // one more for each jump: history is forgotten
    friend bool operator==(const RealtimeChoices&, const RealtimeChoices&) = default;
};

struct Surroundings {
    enum class Kind { asLoaded, sky, color };
    Kind kind = Kind::asLoaded;
    float azimuthDeg = 225, elevationDeg = 40;  // as --sun
    float lux = 0;                              // 0: by its elevation
    float color[3] = {1, 1, 1};                 // W/(m^2 sr)
    friend bool operator==(const Surroundings&, const Surroundings&) = default;
};

// A small white lamp of our own, beside those of the file.
struct HandLamp {
    bool isOn = false, followsCamera = true;
    float intensity = 10;             // W/sr
    float position[3] = {0, 0, 0};    // where it was put down
    friend bool operator==(const HandLamp&, const HandLamp&) = default;
};

// The sea of the scene.
struct SeaChoices {
    bool isThere = false;
    GpOceanDesc desc{};
    double seconds = 0;           // where its waves are
    // How they go on.
    double speed = 1;             // seconds of the sea in a second
    bool isPaused = false;
};

struct ViewChoices {
    // What is traced.
    GpCameraDesc camera{};
    RenderSize size;              // of the picture at rest; 0 x 0: nothing can be seen
    LiveMode live = LiveMode::realtime;
    RealtimeChoices realtime;
    double liveSeconds = 1.0 / 30.0;
    Surroundings surroundings;
    HandLamp lamp;
    SceneLights lights;           // null: as they were loaded
    SeaChoices sea;
    bool beside = false;          // left of the divider the live picture, right of it the reference
    bool reference = false;       // at rest: add samples until there are this many
    std::uint32_t mostSamples = 4096;
    // How it is shown.
    std::string image = "display";
    float divider = 0.5f;         // 0..1 of the picture's width
    bool autoExposure = true;
    float exposureEv = 0;
    GpTonemap tonemap = GP_TONEMAP_AGX;
};

// Whether the exposure is that of the real-time frame itself.
bool eyeDecides(const ViewChoices& choices);
// Whether the waves go on. A reference that somebody asked for is one of a moment.
bool seaMoves(const ViewChoices& choices);
// Whether both are the same sea at the same moment.
bool sameWaves(const SeaChoices& a, const SeaChoices& b);
// Whether the same samples serve both.
bool sameView(const ViewChoices& a, const ViewChoices& b);
// Whether everything is the same.
bool sameChoices(const ViewChoices& a, const ViewChoices& b);

}  // namespace gp::tool::view
