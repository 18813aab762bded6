#include "animate/animate_settings.h"

#include <fmt/format.h>

#include "commands.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr std::uint32_t kMaxFrames = 1u << 20;

GpLightReuse parseReuse(const char* option, const std::string& word) {
    const std::pair<const char*, GpLightReuse> choices[] = {{"none", GP_REUSE_NONE},
                                                            {"biased", GP_REUSE_BIASED},
                                                            {"unbiased", GP_REUSE_UNBIASED}};
    return parseChoice(option, word, choices);
}

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

void addRealtimeOptions(CLI::App& app, RenderSettings& s) {
    const std::string group = "Real time";
    GpRealtimeOptions& o = s.options.realtime;
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
                o.lightReuse = parseReuse("--light-reuse", word);
            })->group(group);
    addWord(app, "--indirect-reuse", "NAME",
            "The same for light that comes over one more surface: none, biased, unbiased (default "
            "none)",
            [&o](const std::string& word) {
                o.indirectReuse = parseReuse("--indirect-reuse", word);
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
                                                          {"none", GP_DENOISER_NONE}};
    return parseChoice("--denoiser", word, choices);
}

void addEyeOptions(CLI::App& app, GpEyeAdaptation& eye) {
    const std::string group = "Real time";
    addWord(app, "--eye-adaptation", "S",
            "The exposure follows what is seen, as eyes do: seconds until 63 % of the way are "
            "done, up to 3600; --exposure is added (default 0: off)",
            [&eye](const std::string& word) {
                eye.seconds =
                    static_cast<float>(parseNumber("--eye-adaptation", word, 0, 3600));
            })->group(group);
    addWord(app, "--eye-range", "MIN,MAX",
            "The exposures between which it stays, stops within -100..100 (default -10,10)",
            [&eye](const std::string& word) {
                const std::vector<std::string> parts = splitAtCommas(word);
                if (parts.size() != 2) {
                    throw UsageError(fmt::format("--eye-range: '{}' must be MIN,MAX", word));
                }
                eye.evMin = static_cast<float>(parseNumber("--eye-range", parts[0], -100, 100));
                eye.evMax = static_cast<float>(parseNumber("--eye-range", parts[1], -100, 100));
                if (eye.evMin > eye.evMax) {
                    throw UsageError(fmt::format("--eye-range: {} is above {}", parts[0],
                                                 parts[1]));
                }
                if (eye.evMin == 0 && eye.evMax == 0) {
                    throw UsageError("--eye-range: 0,0 leaves nothing to adapt; use --exposure");
                }
            })->group(group);
}

void finishRealtime(RenderSettings& s, double secondsPerFrame) {
    GpRenderOptions& o = s.options;
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
    o.realtime.timeStep = static_cast<float>(secondsPerFrame);
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
