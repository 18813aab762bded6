#include "sea/ocean_settings.h"

#include <fmt/format.h>

#include <numbers>

#include "animate/frame_writer.h"
#include "commands.h"
#include "output.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kMetresPerKilometre = 1000;
constexpr std::uint32_t kMaxSamples = 1u << 24;
constexpr std::uint32_t kMaxFrames = 1u << 20;
// Of a still in real time: histories have grown by then.
constexpr std::uint32_t kStillFrames = 16;

// A number of the sea that may be 0 where `given` has a bit for it.
CLI::Option* addSeaNumber(CLI::App& app, const char* name, const char* type, const char* help,
                          double low, double high, float& field, double scale = 1,
                          std::uint32_t* given = nullptr, std::uint32_t bit = 0) {
    return addWord(app, name, type, help, [=, &field](const std::string& word) {
               field = static_cast<float>(parseNumber(name, word, low, high) * scale);
               if (given != nullptr) {
                   *given |= bit;
               }
           })->group("Sea");
}

void addSeaOptions(CLI::App& app, OceanSettings& s) {
    GpOceanDesc& sea = s.sea;
    addSeaNumber(app, "--wind", "M/S", "Wind at 10 m above the water, 0..100 (default 10)", 0, 100,
                 sea.wind, 1, &sea.given, GP_GIVEN_WIND);
    addSeaNumber(app, "--wind-direction", "DEG",
                 "Where the wind blows to, from -Z towards +X (default 0: away from the viewer)",
                 -360, 360, sea.windDirection, kRadiansPerDegree);
    addSeaNumber(app, "--fetch", "KM", "Open water that the wind has crossed, 0.1..10000 "
                 "(default 100)", 0.1, 10000, sea.fetch, kMetresPerKilometre);
    addSeaNumber(app, "--depth", "M", "Depth of the water, 0.1..10000 (default: deep)", 0.1, 10000,
                 sea.depth);
    addWord(app, "--spectrum", "NAME",
            "jonswap, tma (needs --depth), phillips or pierson-moskowitz (default jonswap)",
            [&sea](const std::string& word) {
                const std::pair<const char*, GpOceanSpectrum> choices[] = {
                    {"jonswap", GP_SPECTRUM_JONSWAP}, {"tma", GP_SPECTRUM_TMA},
                    {"phillips", GP_SPECTRUM_PHILLIPS},
                    {"pierson-moskowitz", GP_SPECTRUM_PIERSON_MOSKOWITZ}};
                sea.spectrum = parseChoice("--spectrum", word, choices);
            })->group("Sea");
    addSeaNumber(app, "--swell", "0..1", "How much waves run as long parallel crests (default 0)",
                 0, 1, sea.swell);
    addSeaNumber(app, "--choppiness", "0..2", "How sharp crests are (default 1)", 0, 2,
                 sea.choppiness, 1, &sea.given, GP_GIVEN_CHOPPINESS);
    addSeaNumber(app, "--foam", "0..1", "Share of the foam that breaking waves make (default 1)",
                 0, 1, sea.foam, 1, &sea.given, GP_GIVEN_FOAM);
    addWord(app, "--sea-seed", "N", "Another number is another sea of the same weather (default 0)",
            [&sea](const std::string& word) {
                sea.seed = static_cast<std::uint32_t>(
                    parseInteger("--sea-seed", word, 0, 0xffffffffu));
            })->group("Sea");
    addWord(app, "--cascades", "N", "Bands of waves, 1..4 (default 3)",
            [&sea](const std::string& word) {
                sea.cascades = static_cast<std::uint32_t>(parseInteger("--cascades", word, 1, 4));
            })->group("Sea");
    addWord(app, "--resolution", "N",
            "Cells of the waves' shape around the viewer, 16..2048 (default 384)",
            [&sea](const std::string& word) {
                sea.resolution =
                    static_cast<std::uint32_t>(parseInteger("--resolution", word, 16, 2048));
            })->group("Sea");
    addWord(app, "--time", "S", "Seconds: where the waves are; of a moving picture, in its first "
            "frame (default 0)",
            [&s](const std::string& word) {
                s.timeSeconds = parseNumber("--time", word, -1e5, 1e5);
            })->group("Sea");
}

void addGlintOptions(CLI::App& app, GpOceanDesc& sea) {
    addWord(app, "--glints", "on|off|deliot",
            "Facets that can be counted: by a dictionary, or at a fixed cost (default off)",
            [&sea](const std::string& word) {
                const std::pair<const char*, GpOceanGlints> choices[] = {
                    {"on", GP_GLINTS_ON}, {"off", GP_GLINTS_OFF}, {"deliot", GP_GLINTS_COUNTING}};
                sea.glints = parseChoice("--glints", word, choices);
            })->group("Sea");
    addSeaNumber(app, "--glint-density", "N", "Facets a square metre, 1..1e12 (default 1e6)", 1,
                 1e12, sea.glintDensity);
    addWord(app, "--masking", "vcavity|smith",
            "How waves below a pixel hide one another (default vcavity)",
            [&sea](const std::string& word) {
                const std::pair<const char*, GpOceanMasking> choices[] = {
                    {"vcavity", GP_MASKING_V_CAVITY}, {"smith", GP_MASKING_SMITH}};
                sea.masking = parseChoice("--masking", word, choices);
            })->group("Sea");
}

void addMapOption(CLI::App& app, OceanSettings& s) {
    addWord(app, "--maps", "FOLDER",
            "Write the maps of the waves too, at --time: displacement, normal, foam and moments of "
            "slopes of each cascade, as EXR",
            [&s](const std::string& word) { s.mapFolder = word; })->group("Sea");
}

SunSettings parseSun(const std::string& word) {
    const std::vector<std::string> parts = splitAtCommas(word);
    if (parts.size() != 2 && parts.size() != 3) {
        throw UsageError(fmt::format("--sun: '{}' must be AZ,EL or AZ,EL,LUX", word));
    }
    SunSettings sun;
    sun.azimuthDeg = parseNumber("--sun", parts[0]);
    sun.elevationDeg = parseNumber("--sun", parts[1], 0, 90);
    sun.lux = parts.size() == 3 ? parseNumberFrom("--sun", parts[2], 0, false) : 0;
    return sun;
}

void addSkyOptions(CLI::App& app, RenderSettings& r) {
    const std::string group = "Light";
    addWord(app, "--sun", "AZ,EL[,LUX]",
            "The sun: azimuth from -Z towards +X and elevation 0..90, degrees, and illuminance "
            "on a plane that faces it (by its elevation), with a clear sky around it, or with "
            "--env (default 0,20)",
            [&r](const std::string& word) { r.sun = parseSun(word); })->group(group);
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
    addWord(app, "--camera-height", "M", "Metres above the water at rest, 0.1..100000 (default 3)",
            [&s](const std::string& word) {
                s.cameraHeight = parseNumber("--camera-height", word, 0.1, 1e5);
            })->group(group);
    addWord(app, "--pitch", "DEG", "Where it looks, above the horizontal, -89..89 (default -6)",
            [&s](const std::string& word) {
                s.pitchDeg = parseNumber("--pitch", word, -89, 89);
            })->group(group);
    addWord(app, "--heading", "DEG", "Where it looks, from -Z towards +X (default 0)",
            [&s](const std::string& word) {
                s.headingDeg = parseNumber("--heading", word);
            })->group(group);
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
    addSeaOptions(app, s);
    addGlintOptions(app, s.sea);
    addMapOption(app, s);
    addViewOptions(app, s);
    addSkyOptions(app, r);
    addMovingOptions(app, s);
    addWord(app, "--mode", "realtime|reference|local",
            "realtime: a path or so a pixel, denoised; reference: path-traced; local: a quick "
            "still without noise, shadows or bounces (default reference, with --frames realtime)",
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

// Of --mode local: the sky is reflected by 16 facets where nothing else was asked for.
void checkLocalSea(const CLI::App& app, OceanSettings& s) {
    const bool given = app.count("--environment-light") > 0;
    if (s.picture.mode != GP_MODE_LOCAL) {
        if (given) {
            throw UsageError("--environment-light: only with --mode local");
        }
        return;
    }
    if (s.moves()) {
        throw UsageError("--frames: not with --mode local");
    }
    for (const char* name : {"--bounces", "--clamp", "--no-roulette"}) {
        if (app.count(name) > 0) {
            throw UsageError(fmt::format("{}: not with --mode local", name));
        }
    }
    if (!given) {
        s.picture.render.local.environmentFacets = 16;
    }
}

void checkOceanSettings(const CLI::App& app, OceanSettings& s) {
    RenderSettings& r = s.picture.render;
    if (!s.modeGiven) {
        s.picture.mode = s.moves() ? GP_MODE_REALTIME : GP_MODE_REFERENCE;
    }
    r.local.mode = s.picture.mode;
    checkLocalSea(app, s);
    if (s.sea.spectrum == GP_SPECTRUM_TMA && s.sea.depth == 0) {
        throw UsageError("--spectrum: tma needs --depth");
    }
    if (!r.sun && r.environmentPath.empty()) {
        r.sun = SunSettings{0, 20, 0};
    }
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
    checkPictureSettings(r, video ? PictureFormat::png : pictureFormat(r.outputPath));
    if (s.picture.mode == GP_MODE_REALTIME) {
        if (app.count("--spp") + app.count("--samples") > 0) {
            throw UsageError("--samples: only with --mode reference");
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
