#include "animate/animate_settings.h"

#include <fmt/format.h>

#include "commands.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr std::uint32_t kMaxFrames = 1u << 20;

}  // namespace

void addMotionOptions(CLI::App& app, AnimateSettings& s) {
    const std::string group = "Motion";
    addWord(app, "--frames", "N", "How many frames there are, numbered from 0",
            [&s](const std::string& word) {
                s.frames =
                    static_cast<std::uint32_t>(parseInteger("--frames", word, 1, kMaxFrames));
            })->required()->group(group);
    addWord(app, "--fps", "F", "Frames a second (default 24)",
            [&s](const std::string& word) {
                s.framesPerSecond = parseNumber("--fps", word, 0.01, 1000);
            })->group(group);
    addWord(app, "--path", "orbit|FILE|CAMERA",
            "How the camera moves: around the scene, by the keys of FILE.json, or as a camera of "
            "the file, by name or number (default: as in `render`; the file's camera moves with "
            "the file)",
            [&s](const std::string& word) { s.path = word; })->group(group);
    addWord(app, "--orbit-period", "S",
            "Seconds of one orbit, counter-clockwise from above; negative: clockwise (default: the "
            "whole clip)",
            [&s](const std::string& word) {
                s.orbitPeriod = parseNumber("--orbit-period", word);
                if (*s.orbitPeriod == 0) {
                    throw UsageError("--orbit-period: 0 seconds are no period");
                }
            })->group(group);
    addWord(app, "--orbit-height", "M",
            "Metres of the orbit above its centre (default: as the camera that shows the scene)",
            [&s](const std::string& word) {
                s.orbitHeight = parseNumber("--orbit-height", word);
            })->group(group);
    app.add_flag("--hold", s.hold,
                 "Animations of the file hold still when they are over, instead of starting again")
        ->group(group);
}

void addRealtimeOptions(CLI::App& app, AnimateSettings& s) {
    const std::string group = "Real time";
    GpRealtimeOptions& o = s.render.options.realtime;
    addWord(app, "--aa", "NAME",
            "Anti-aliasing: temporal; none: rays through the middle of pixels; jitter: rays move, "
            "frames stay as they are (default temporal)",
            [&o](const std::string& word) {
                const std::pair<const char*, GpAntiAliasing> choices[] = {
                    {"temporal", GP_AA_TEMPORAL}, {"none", GP_AA_NONE}, {"jitter", GP_AA_JITTER}};
                o.antiAliasing = parseChoice("--aa", word, choices);
            })->group(group);
    addWord(app, "--render-scale", "S",
            "Rays along each side of the picture for a pixel, 0.5..1; scaled up over time (1)",
            [&o](const std::string& word) {
                o.renderScale = static_cast<float>(parseNumber("--render-scale", word, 0.5, 1));
            })->group(group);
    addWord(app, "--mirrors", "N",
            "Reflections and refractions by smooth surfaces before what a pixel shows, 0..16 (4)",
            [&o](const std::string& word) {
                const auto mirrors = static_cast<int>(parseInteger("--mirrors", word, 0, 16));
                o.mirrorLimit = mirrors == 0 ? GP_NO_BOUNCES : mirrors;
            })->group(group);
    addWord(app, "--light-reuse", "NAME",
            "How shadow rays choose their lamp: none: each pixel by itself; biased, unbiased: with "
            "what pixels nearby found in the last frame (default none)",
            [&o](const std::string& word) {
                const std::pair<const char*, GpLightReuse> choices[] = {
                    {"none", GP_REUSE_NONE},
                    {"biased", GP_REUSE_BIASED},
                    {"unbiased", GP_REUSE_UNBIASED}};
                o.lightReuse = parseChoice("--light-reuse", word, choices);
            })->group(group);
    addWords(app, "--tune", "NAME=VALUE",
             "Another value for a number of denoisers, light reuse or anti-aliasing "
             "(gpDescribeDenoisers lists them); may be repeated",
             s.tuning.words)->group(group);
}

GpDenoiser parseDenoiser(const std::string& word) {
    const std::pair<const char*, GpDenoiser> choices[] = {{"asvgf", GP_DENOISER_ASVGF},
                                                          {"svgf", GP_DENOISER_SVGF},
                                                          {"atrous", GP_DENOISER_ATROUS},
                                                          {"none", GP_DENOISER_NONE},
                                                          {"bmfr", GP_DENOISER_BMFR}};
    return parseChoice("--denoiser", word, choices);
}

void finishRealtime(AnimateSettings& s) {
    GpRenderOptions& o = s.render.options;
    const char* given = o.timeLimit != 0     ? "--time-limit"
                        : o.noiseTarget != 0 ? "--noise"
                        : o.pixelFilter != 0 ? "--filter"
                                             : nullptr;
    if (given != nullptr) {
        throw UsageError(fmt::format("{}: not in real time", given));
    }
    s.tuning.names.clear();
    s.tuning.names.reserve(s.tuning.words.size());  // the parameters point to them
    s.tuning.parameters.clear();
    for (const std::string& word : s.tuning.words) {
        const auto [name, value] = parseAssignment("--tune", word);
        s.tuning.names.push_back(name);
        s.tuning.parameters.push_back({s.tuning.names.back().c_str(),
                                       static_cast<float>(parseNumber("--tune", value))});
    }
    o.realtime.parameters = s.tuning.parameters.data();
    o.realtime.parameterCount = static_cast<std::uint32_t>(s.tuning.parameters.size());
    o.realtime.timeStep = static_cast<float>(1 / s.framesPerSecond);
}

void checkMotion(const AnimateSettings& s) {
    if (!s.orbits() && (s.orbitPeriod || s.orbitHeight)) {
        throw UsageError(fmt::format("{}: needs --path orbit",
                                     s.orbitPeriod ? "--orbit-period" : "--orbit-height"));
    }
    if (s.path.empty()) {
        return;
    }
    if (!s.render.camera.empty()) {
        throw UsageError("--camera: not together with --path");
    }
    if (!s.orbits() && (s.render.from || s.render.lookAt)) {
        throw UsageError(fmt::format("{}: beside --path only for orbits",
                                     s.render.from ? "--from" : "--look-at"));
    }
}

}  // namespace gp::tool
