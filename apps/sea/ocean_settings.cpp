#include "sea/ocean_settings.h"

#include <fmt/format.h>

#include "animate/frame_writer.h"
#include "commands.h"
#include "output.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr std::uint32_t kMaxSamples = 1u << 24;
constexpr std::uint32_t kMaxFrames = 1u << 20;
// Of a still in real time: histories have grown by then.
constexpr std::uint32_t kStillFrames = 16;
// In real time, as the library has it where there is a sea.
constexpr std::uint32_t kRealtimeBounces = 2;

void addTimeOption(CLI::App& app, OceanSettings& s) {
    addWord(app, "--time", "S", "Seconds: where the waves are; of a moving picture, in its first "
            "frame (default 0)",
            [&s](const std::string& word) {
                s.timeSeconds = parseNumber("--time", word, -kLongestSeaTime, kLongestSeaTime);
            })->group("Sea");
}

void addMapOption(CLI::App& app, OceanSettings& s) {
    addWord(app, "--maps", "FOLDER",
            "Write the maps of the waves too, at --time: displacement, normal, foam and moments of "
            "slopes of each cascade, as EXR",
            [&s](const std::string& word) { s.mapFolder = word; })->group("Sea");
}

void addSkyOptions(CLI::App& app, RenderSettings& r) {
    const std::string group = "Light";
    addWord(app, "--sun", "AZ,EL[,LUX]",
            "The sun: azimuth from -Z towards +X and elevation 0..90, degrees, and illuminance "
            "on a plane that faces it (by its elevation), with a clear sky around it, or with "
            "--env (default 0,20)",
            [&r](const std::string& word) { r.sun = parseSun(word, 0); })->group(group);
    addWord(app, "--env", "FILE",
            "A latitude-longitude picture (HDR or EXR) in place of the sky",
            [&r](const std::string& word) { r.environmentPath = word; })->group(group);
    addWord(app, "--env-rotation", "DEG",
            "Turn it about the vertical, counter-clockwise from above (default 0)",
            [&r](const std::string& word) {
                r.environmentRotationDeg = parseNumber("--env-rotation", word);
            })->group(group);
}

void addViewOptions(CLI::App& app, OceanSettings& s) {
    const std::string group = "Camera";
    addWord(app, "--size", "WxH", "Pixels of the picture (default 1280x720)",
            [&s](const std::string& word) {
                s.picture.render.size = parseSize("--size", word);
            })->group(group);
    addSeaCameraOptions(app, s.camera);
    addWord(app, "--fov", "DEG", "Vertical angle of view, degrees (default 45)",
            [&s](const std::string& word) {
                s.picture.render.fovDeg = parseNumber("--fov", word, 0.01, 179);
            })->group(group);
}

void addMovingOptions(CLI::App& app, OceanSettings& s) {
    const std::string group = "Motion";
    addWord(app, "--frames", "N", "A moving picture of so many frames, numbered from 0",
            [&s](const std::string& word) {
                s.picture.frames =
                    static_cast<std::uint32_t>(parseInteger("--frames", word, 1, kMaxFrames));
            })->group(group);
    addWord(app, "--fps", "F", "Frames a second (default 24)",
            [&s](const std::string& word) {
                s.picture.framesPerSecond = parseNumber("--fps", word, 0.01, 1000);
            })->group(group);
    addWord(app, "--start", "N", "The first frame to render, to go on with numbered files (0)",
            [&s](const std::string& word) {
                s.picture.start =
                    static_cast<std::uint32_t>(parseInteger("--start", word, 0, kMaxFrames));
            })->group(group);
}

}  // namespace

void addOceanOptions(CLI::App& app, OceanSettings& s) {
    RenderSettings& r = s.picture.render;
    r.frames = kStillFrames;
    addWord(app, "-o,--output", "OUT",
            "The picture: .png, .exr or .hdr; with --frames DIR/%04d.png (or .exr, .hdr) or a "
            "video: .mp4, .mkv, .webm",
            [&r](const std::string& word) { r.outputPath = word; })->required();
    addSeaOptions(app, seaWords(), s.sea);
    addTimeOption(app, s);
    addMapOption(app, s);
    addViewOptions(app, s);
    addSkyOptions(app, r);
    addMovingOptions(app, s);
    addWord(app, "--mode", "realtime|reference|local",
            "realtime: a path or so a pixel, denoised; reference: path-traced; local: quick, "
            "without noise, shadows or bounces (default reference, with --frames realtime)",
            [&s](const std::string& word) {
                const std::pair<const char*, GpFrameMode> choices[] = {
                    {"realtime", GP_MODE_REALTIME},
                    {"reference", GP_MODE_REFERENCE},
                    {"local", GP_MODE_LOCAL}};
                s.picture.mode = parseChoice("--mode", word, choices);
                s.modeGiven = true;
            });
    addEnvironmentLight(app, r.local, "Local lighting (--mode local)");
    addWord(app, "--denoiser", "NAME", "asvgf, svgf, atrous, bmfr or none (default asvgf)",
            [&r](const std::string& word) {
                r.options.realtime.denoiser = parseDenoiser(word);
            })->group("Real time");
    addRealtimeOptions(app, r);
    addQualityOptions(app, r);
    addWord(app, "--samples", "N", "The same as --spp",
            [&r](const std::string& word) {
                r.options.samplesPerPixel =
                    static_cast<std::uint32_t>(parseInteger("--samples", word, 1, kMaxSamples));
            });
    addPictureOptions(app, r);
    addMachineOptions(app, r);
}

// --mode local: the sky is reflected by 16 facets where nothing else was asked for.
void checkLocalSea(const CLI::App& app, OceanSettings& s) {
    const bool given = app.count("--environment-light") > 0;
    if (s.picture.mode != GP_MODE_LOCAL) {
        if (given) {
            throw UsageError("--environment-light: only with --mode local");
        }
        return;
    }
    for (const char* name : {"--bounces", "--clamp", "--no-roulette"}) {
        if (app.count(name) > 0) {
            throw UsageError(fmt::format("{}: not with --mode local", name));
        }
    }
    if (!given) {
        s.picture.render.local.environmentFacets = 16;
    }
    s.picture.render.options.local.environmentFacets =
        s.picture.render.local.environmentFacets;
}

void checkOceanSettings(const CLI::App& app, OceanSettings& s) {
    RenderSettings& r = s.picture.render;
    if (!s.modeGiven) {
        s.picture.mode = s.moves() ? GP_MODE_REALTIME : GP_MODE_REFERENCE;
    }
    r.local.mode = s.picture.mode;
    checkLocalSea(app, s);
    if (const std::string fault = seaFault(s.sea, "--"); !fault.empty()) {
        throw UsageError(fault);
    }
    addSeaLight(r);
    checkLightSettings(r);
    bool video = false;
    if (s.moves()) {
        checkFrameOutput(r.outputPath, r.size);
        video = isVideo(r.outputPath);
        if (s.picture.start >= s.picture.frames) {
            throw UsageError(fmt::format("--start: {} is not below --frames {}", s.picture.start,
                                         s.picture.frames));
        }
        if (video && s.picture.start > 0) {
            throw UsageError("--start: a video is written in one go; use numbered files");
        }
    } else {
        for (const char* name : {"--fps", "--start"}) {
            if (app.count(name) > 0) {
                throw UsageError(fmt::format("{}: only with --frames", name));
            }
        }
        checkWritable(r.outputPath);
    }
    checkPictureSettings(r, video ? PictureFormat::page : pictureFormat(r.outputPath));
    if (s.picture.mode == GP_MODE_REALTIME) {
        if (app.count("--spp") + app.count("--samples") > 0) {
            throw UsageError("--samples: only with --mode reference");
        }
        if (app.count("--bounces") == 0) {
            r.bounces = kRealtimeBounces;
        }
        finishRealtime(r, 1 / s.picture.framesPerSecond);
    } else {
        for (const char* name : {"--aa", "--render-scale", "--mirrors", "--denoiser",
                                 "--light-reuse", "--indirect-reuse", "--tune"}) {
            if (app.count(name) > 0) {
                throw UsageError(fmt::format("{}: only with --mode realtime", name));
            }
        }
    }
    if (!r.jsonPath.empty()) {
        checkWritable(r.jsonPath);
    }
    r.device.instructionSet = r.instructionSet.empty() ? nullptr : r.instructionSet.c_str();
}

}  // namespace gp::tool
