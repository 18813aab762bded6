#include "render_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "commands.h"
#include "render_realtime.h"
#include "scene_setup.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr std::uint32_t kMaxSamples = 1u << 24;

// Every image but COLOR, which is always there, and DISPLAY, which is not for EXR.
bool isLayer(int image) {
    return image != GP_IMAGE_COLOR && image != GP_IMAGE_DISPLAY;
}

std::uint32_t parseLayers(const std::string& word) {
    std::uint32_t all = 0;
    std::vector<std::string> names = {"all"};
    std::uint32_t layers = 0;
    std::vector<std::string> wanted = splitAtCommas(word);
    for (int image = 0; image < GP_IMAGE_COUNT; ++image) {
        GpImageInfo info{};
        gpGetImageInfo(static_cast<GpFrameImage>(image), &info);
        if (!isLayer(image)) {
            continue;
        }
        all |= 1u << image;
        names.emplace_back(info.name);
        const auto last = std::remove(wanted.begin(), wanted.end(), info.name);
        if (last != wanted.end()) {
            layers |= 1u << image;
            wanted.erase(last, wanted.end());
        }
    }
    for (const std::string& name : wanted) {
        if (name != "all") {
            failChoice("--aov", name, names);
        }
        layers = all;
    }
    return layers;
}

}  // namespace

SunSettings parseSun(const std::string& word, double lowest) {
    const std::vector<std::string> parts = splitAtCommas(word);
    if (parts.size() != 2 && parts.size() != 3) {
        throw UsageError(fmt::format("--sun: '{}' must be AZ,EL or AZ,EL,LUX", word));
    }
    SunSettings sun;
    sun.azimuthDeg = parseNumber("--sun", parts[0]);
    sun.elevationDeg = parseNumber("--sun", parts[1], lowest, 90);
    sun.lux = parts.size() == 3 ? parseNumberFrom("--sun", parts[2], 0, false) : 0;
    return sun;
}

void addLightOptions(CLI::App& app, RenderSettings& s) {
    const std::string group = "Light";
    addWord(app, "--env", "FILE",
            "Surround the scene with a latitude-longitude picture (HDR or EXR)",
            [&s](const std::string& word) { s.environmentPath = word; })->group(group);
    addWord(app, "--env-rotation", "DEG",
            "Turn it about the vertical, counter-clockwise from above (default 0)",
            [&s](const std::string& word) {
                s.environmentRotationDeg = parseNumber("--env-rotation", word);
            })->group(group);
    addWord(app, "--env-color", "R,G,B",
            "Surround the scene with one radiance, W/(m^2 sr), instead of a picture",
            [&s](const std::string& word) {
                s.environmentColor = parseTriple("--env-color", word);
            })->group(group);
    addWord(app, "--sun", "AZ,EL[,LUX]",
            "A sun at azimuth (degrees from -Z towards +X) and elevation (degrees), with this "
            "illuminance on a plane facing it (0 or none: by its elevation). With --env or "
            "--env-color it is added to them; without, the sky around it comes too",
            [&s](const std::string& word) { s.sun = parseSun(word, -90); })->group(group);
}

void addCameraOptions(CLI::App& app, RenderSettings& s) {
    const std::string group = "Camera";
    addWord(app, "--size", "WxH", "Pixels of the picture (default 1280x720; 320x180 for each "
            "of a sheet)",
            [&s](const std::string& word) {
                s.size = parseSize("--size", word);
                s.sizeGiven = true;
            })->group(group);
    addWord(app, "--camera", "NAME|INDEX",
            "One of the file's cameras, counted from 0 (default: the first; none in the file: one "
            "that shows the whole scene)",
            [&s](const std::string& word) { s.camera = word; })->group(group);
    addWord(app, "--from", "X,Y,Z", "Look from here, metres",
            [&s](const std::string& word) { s.from = parseTriple("--from", word); })->group(group);
    addWord(app, "--look-at", "X,Y,Z", "Look here, metres (default: the middle of the scene)",
            [&s](const std::string& word) {
                s.lookAt = parseTriple("--look-at", word);
            })->group(group);
    addWord(app, "--fov", "DEG", "Vertical angle of view, degrees (default: the camera's; 45)",
            [&s](const std::string& word) {
                s.fovDeg = parseNumber("--fov", word, 0.01, 179.0);
            })->group(group);
}

void addQualityOptions(CLI::App& app, RenderSettings& s) {
    const std::string group = "Quality (the first limit that is reached ends the render)";
    GpRenderOptions& o = s.options;
    addWord(app, "--spp", "N",
            "Samples a pixel (default 64; no limit if one of the next two is set)",
            [&o](const std::string& word) {
                o.samplesPerPixel =
                    static_cast<std::uint32_t>(parseInteger("--spp", word, 1, kMaxSamples));
            })->group(group);
    addWord(app, "--time-limit", "S", "Seconds of rendering",
            [&o](const std::string& word) {
                o.timeLimit = parseNumberFrom("--time-limit", word, 0, true);
            })->group(group);
    addWord(app, "--noise", "REL", "Relative error of the picture, such as 0.02",
            [&o](const std::string& word) {
                o.noiseTarget = parseNumberFrom("--noise", word, 0, true);
            })->group(group);
    addWord(app, "--bounces", "N",
            "How often light may bounce before the last surface (default 16; 0: light that "
            "arrives directly)",
            [&s](const std::string& word) {
                s.bounces = static_cast<std::uint32_t>(parseInteger("--bounces", word, 0, 65535));
                s.options.maxBounces =
                    s.bounces == 0 ? GP_NO_BOUNCES : static_cast<int>(s.bounces);
            })->group(group);
    addWord(app, "--clamp", "L",
            "Largest luminance of one sample's indirect light (default 0: off; biased)",
            [&o](const std::string& word) {
                o.clamp = static_cast<float>(parseNumber("--clamp", word, 0, 3.0e38));
            })->group(group);
    app.add_flag_callback("--no-roulette", [&o] { o.noRussianRoulette = 1; },
                          "End paths at --bounces only")->group(group);
    addWord(app, "--seed", "N", "The same seed gives the same picture, bit by bit (default 0)",
            [&o](const std::string& word) {
                o.seed = parseInteger("--seed", word, 0,
                                      std::numeric_limits<std::uint64_t>::max());
            })->group(group);
    addWord(app, "--shading", "full|diffuse", "diffuse: all surfaces are matte (default full)",
            [&o](const std::string& word) {
                const std::pair<const char*, GpShading> choices[] = {
                    {"full", GP_SHADING_FULL}, {"diffuse", GP_SHADING_DIFFUSE}};
                o.shading = parseChoice("--shading", word, choices);
            })->group(group);
    addWord(app, "--filter", "NAME",
            "How samples share pixels: blackman-harris, box, tent, gaussian (default the first)",
            [&o](const std::string& word) {
                const std::pair<const char*, GpPixelFilter> choices[] = {
                    {"blackman-harris", GP_PIXEL_BLACKMAN_HARRIS}, {"box", GP_PIXEL_BOX},
                    {"tent", GP_PIXEL_TENT}, {"gaussian", GP_PIXEL_GAUSSIAN}};
                o.pixelFilter = parseChoice("--filter", word, choices);
            })->group(group);
}

void addPictureOptions(CLI::App& app, RenderSettings& s) {
    const std::string group = "Picture";
    addWord(app, "--exposure", "EV|auto",
            "PNG: stops of brightness, or auto (default auto, see below)",
            [&s](const std::string& word) {
                s.exposureGiven = true;
                s.exposureEv.reset();
                if (word != "auto") {
                    s.exposureEv = parseNumber("--exposure", word, -100, 100);
                }
            })->group(group);
    addWord(app, "--tonemap", "NAME", "PNG: agx, aces, reinhard or none (default agx)",
            [&s](const std::string& word) {
                const std::pair<const char*, GpTonemap> choices[] = {
                    {"agx", GP_TONEMAP_AGX}, {"aces", GP_TONEMAP_ACES},
                    {"reinhard", GP_TONEMAP_REINHARD}, {"none", GP_TONEMAP_NONE}};
                s.options.tonemap = parseChoice("--tonemap", word, choices);
                s.tonemapGiven = true;
            })->group(group);
    app.add_flag_callback("--alpha", [&s] {
        s.save.alpha = 1;
        s.options.hideBackground = 1;
    }, "Leave out what is seen behind surfaces, which lights them all the same: PNG with alpha and "
       "straight colours, EXR with premultiplied ones")->group(group);
    addWord(app, "--aov", "LIST|all",
            "EXR: further layers, with commas between them: albedo, normal, depth, emission, "
            "direct, indirect, roughness, variance, instance",
            [&s](const std::string& word) {
                s.save.layers = parseLayers(word);
                s.everyLayer = word == "all";
            })->group(group);
    app.add_flag_callback("--full-float", [&s] { s.save.fullFloat = 1; },
                          "EXR: 32-bit floats instead of 16-bit ones")->group(group);
}

void addMachineOptions(CLI::App& app, RenderSettings& s) {
    const std::string group = "Machine and messages";
    addWord(app, "--threads", "N", "Processors to use (default 0: all)",
            [&s](const std::string& word) {
                s.device.threads =
                    static_cast<std::uint32_t>(parseInteger("--threads", word, 0, 1024));
            })->group(group);
    addWord(app, "--backend", "auto|cpu|null", "null checks everything and renders nothing",
            [&s](const std::string& word) {
                const std::pair<const char*, GpBackend> choices[] = {
                    {"auto", GP_BACKEND_AUTO}, {"cpu", GP_BACKEND_CPU}, {"null", GP_BACKEND_NULL}};
                s.device.backend = parseChoice("--backend", word, choices);
            })->group(group);
    addWord(app, "--isa", "NAME", "Instruction set: x86-64, avx2, avx512 (default the best)",
            [&s](const std::string& word) {
                const std::pair<const char*, const char*> choices[] = {
                    {"x86-64", "x86-64"}, {"avx2", "avx2"}, {"avx512", "avx512"}};
                s.instructionSet = parseChoice("--isa", word, choices);
            })->group(group);
    addWord(app, "--json", "FILE", "Write what was measured as JSON; - is stdout",
            [&s](const std::string& word) { s.jsonPath = word; })->group(group);
    app.add_flag("--quiet", s.quiet, "Say nothing but errors")->group(group);
}

void addSceneOptions(CLI::App& app, RenderSettings& s) {
    app.add_option("SCENE", s.scenePath, "The scene: a .gltf or .glb file")->required();
    addSceneChoice(app, s.load);
    app.add_option("--material", s.materials,
                   "Replace materials of the file, NAME or all, by a model, a preset or a measured "
                   "file; may be repeated. Maps of the file stay where MODEL has a use for them. "
                   "MODEL as in `glitterpath brdf plot --help`")
        ->type_name("[NAME=]MODEL[:K=V,...]")
        ->group("Content of the file")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
}

void addRenderOptions(CLI::App& app, RenderSettings& s) {
    addSceneOptions(app, s);
    addWord(app, "-o,--output", "OUT", "The picture: .png, .exr or .hdr",
            [&s](const std::string& word) { s.outputPath = word; })->required();
    addCameraOptions(app, s);
    addLightOptions(app, s);
    addQualityOptions(app, s);
    addLocalOptions(app, s.local);
    addRealtimeRenderOptions(app, s);
    addPictureOptions(app, s);
    addMachineOptions(app, s);
}

PictureFormat pictureFormat(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    std::string ending = dot == std::string::npos ? "" : path.substr(dot + 1);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == "png") {
        return PictureFormat::png;
    }
    if (ending == "exr") {
        return PictureFormat::exr;
    }
    if (ending == "hdr") {
        return PictureFormat::hdr;
    }
    throw UsageError(fmt::format("--output: '{}' does not end in .png, .exr or .hdr", path));
}

void checkLightSettings(const RenderSettings& s) {
    if (!s.environmentPath.empty() && s.environmentColor) {
        throw UsageError("--env-color: not together with --env");
    }
    if (s.environmentRotationDeg != 0 && s.environmentPath.empty()) {
        throw UsageError("--env-rotation: needs --env");
    }
    const bool surrounded = !s.environmentPath.empty() || s.environmentColor;
    if (s.sun && surrounded && s.sun->lux == 0) {
        throw UsageError("--sun: beside an environment it needs its illuminance in lux");
    }
}

void checkPictureSettings(const RenderSettings& s, PictureFormat format) {
    if (s.save.layers != 0 && format != PictureFormat::exr) {
        throw UsageError("--aov: only .exr files have layers");
    }
    if (s.save.fullFloat != 0 && format != PictureFormat::exr) {
        throw UsageError("--full-float: only .exr files hold floats of two sizes");
    }
    if (s.save.alpha != 0 && format == PictureFormat::hdr) {
        throw UsageError("--alpha: .hdr files have none; use .png or .exr");
    }
    if (s.save.alpha != 0 && format == PictureFormat::page) {
        throw UsageError("--alpha: only for files of pictures, .png and .exr");
    }
}

void checkSettings(const CLI::App& app, RenderSettings& s) {
    checkMode(app, s.local);
    finishRealtimeRender(app, s);
    if (!s.local.models.words.empty() && s.options.shading == GP_SHADING_DIFFUSE) {
        throw UsageError("--lighting: not together with --shading diffuse");
    }
    checkPictureSettings(s, pictureFormat(s.outputPath));
    checkLightSettings(s);
}

}  // namespace gp::tool
