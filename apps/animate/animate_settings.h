// What `glitterpath animate` was asked for, and what other commands about moving pictures share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "render_settings.h"

namespace gp::tool {

struct AnimateSettings {
    RenderSettings render;
    GpFrameMode mode = GP_MODE_REALTIME;
    std::uint32_t frames = 0;  // numbers 0 .. frames - 1
    std::uint32_t start = 0;   // the first that is rendered
    double framesPerSecond = 24;
    bool hold = false;         // animations of the file do not start again at their end

    // the camera
    std::string path;          // --path as written: orbit, FILE.json or a camera; empty: none
    std::optional<double> orbitPeriod;  // seconds
    std::optional<double> orbitHeight;  // metres above the centre

    bool orbits() const { return path == "orbit"; }
    bool hasKeys() const { return path.ends_with(".json"); }
};

// --mode realtime and what belongs to it. The settings must outlive the parsing.
void addRealtimeOptions(CLI::App& app, GpRealtimeOptions& options);

// Options of path tracing that frames of the real-time mode do not take; throws UsageError.
void checkRealtime(const RenderSettings& settings);

// --frames, --fps, --path and their like. The settings must outlive the parsing.
void addMotionOptions(CLI::App& app, AnimateSettings& settings);

// What no option can know by itself; throws UsageError.
void checkMotion(const AnimateSettings& settings);

}  // namespace gp::tool
