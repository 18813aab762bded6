// glitterpath view: a window in which one flies through a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "commands.h"
#include "interrupt.h"
#include "output.h"
#include "render_frame.h"
#include "scene_description.h"
#include "scene_setup.h"
#include "sea/sea_options.h"
#include "tool_error.h"
#include "view/image_view.h"
#include "view/view_session.h"
#include "view/view_words.h"

namespace gp::tool {
namespace {

using namespace view;

constexpr const char* kNotes =
    "W A S D fly, E and Q rise and sink, a drag of the mouse looks around, the wheel changes the\n"
    "speed; Tab shows and hides the panels, which list all keys.\n\n"
    "Examples:\n"
    "  glitterpath view helmet.glb\n"
    "  glitterpath view room.glb --sun 262,30,0 --fps 20 --image normal\n"
    "  glitterpath view --ocean --wind 8 --sun 0,4\n"
    "  glitterpath view boat.glb --ocean --sea-level 0.2 --transparent on\n"
    "  glitterpath view room.glb --script flight.txt --json report.json";

// Its triangles are made anew in every frame: 384 cells, the library's own number, would leave no
// time for rays.
constexpr std::uint32_t kSeaResolution = 128;

struct ViewSettings {
    RenderSettings render;
    ViewChoices choices;
    SeaCamera seaCamera;
    std::string scriptPath, screenshotPath = "picture.png";

    ViewSettings() { choices.sea.desc.resolution = kSeaResolution; }
    bool isSeaAlone() const { return render.scenePath.empty(); }
};

void addViewSeaOptions(CLI::App& app, ViewSettings& s) {
    app.add_flag("--ocean", s.choices.sea.isThere,
                 "The sea around the scene, or alone where no SCENE is given. Words as in "
                 "`glitterpath ocean`; --time is where its waves begin")->group("Sea");
    addSeaOptions(app, seaWords(), s.choices.sea.desc);
    addSeaOptions(app, seaInSceneWords(), s.choices.sea.desc);
    addWord(app, "--sea-speed", "X",
            "How fast the waves go, 0..100 times real time (default 1; 0: they stand)",
            [&s](const std::string& word) {
                s.choices.sea.speed = parseNumber("--sea-speed", word, 0, kFastestSea);
            })->group("Sea");
    addSeaCameraOptions(app, s.seaCamera);
}

// Throws UsageError. The sea begins at --time.
void checkSeaSettings(const CLI::App& app, ViewSettings& s) {
    SeaChoices& sea = s.choices.sea;
    if (!sea.isThere) {
        for (const CLI::Option* option : app.get_options()) {
            if (option->get_group() == "Sea" && option->count() > 0) {
                throw UsageError(fmt::format("{}: only with --ocean", option->get_name()));
            }
        }
        if (s.isSeaAlone()) {
            throw UsageError("SCENE is required, a .gltf or .glb file, or --ocean");
        }
    } else {
        s.choices.realtime.bounces = 2;  // waves show in waves: the library's default with a sea
    }
    for (const char* name : kSeaCameraOptions) {
        if (app.count(name) > 0 && !s.isSeaAlone()) {
            throw UsageError(fmt::format("{}: only with --ocean and without SCENE; --from and "
                                         "--look-at place the camera", name));
        }
    }
    for (const char* name : {"--material", "--animation", "--scene", "--camera"}) {
        if (app.count(name) > 0 && s.isSeaAlone()) {
            throw UsageError(fmt::format("{}: only with SCENE", name));
        }
    }
    if (const std::string fault = seaFault(sea.desc, "--"); !fault.empty()) {
        throw UsageError(fault);
    }
    if (sea.isThere && std::abs(s.render.load.time) > kLongestSeaTime) {
        throw UsageError(fmt::format("--time: {} is not in {}..{}", s.render.load.time,
                                     -kLongestSeaTime, kLongestSeaTime));
    }
    sea.seconds = s.render.load.time;
    if (s.isSeaAlone()) {
        addSeaLight(s.render);
    }
}

SceneSetup setUpViewed(GpDevice device, const RenderSettings& settings) {
    if (!settings.scenePath.empty()) {
        return setUpScene(device, settings);
    }
    SceneSetup setup;
    setup.scene = newScene(device);
    addLight(device, settings, setup);
    return setup;
}

void addSea(GpDevice device, GpScene scene, const SeaChoices& sea) {
    if (sea.isThere) {
        check(device, gpSetOcean(scene, &sea.desc));
        check(device, gpSetOceanTime(scene, sea.seconds));
    }
}

void addViewOptions(CLI::App& app, ViewSettings& s) {
    const std::string group = "View";
    addWord(app, "--fps", "N",
            "Frames a second to keep up while something moves, by rendering fewer pixels "
            "(default 30)",
            [&s](const std::string& word) {
                s.choices.liveSeconds =
                    1.0 / parseNumber("--fps", word, kLowestFps, kHighestFps);
            })->group(group);
    addWord(app, "--live", "NAME",
            "What is seen while something moves: realtime; traced, one path a pixel without a "
            "denoiser; local, local lighting (default realtime)",
            [&s](const std::string& word) {
                s.choices.live = parseChoice("--live", word, kLiveWords);
            })->group(group);
    app.add_flag("--reference", s.choices.reference,
                 "At rest add samples, up to --spp, to the unbiased picture; always on with "
                 "--live traced and local")->group(group);
    addWord(app, "--spp", "N", "Samples a pixel at rest, at most (default 4096)",
            [&s](const std::string& word) {
                s.choices.mostSamples =
                    static_cast<std::uint32_t>(parseInteger("--spp", word, 1, kMostSamples));
            })->group(group);
    addWord(app, "--image", "NAME", "Which image of the frame is seen (default display)",
            [&s](const std::string& word) {
                if (imageNamed(word) == nullptr) {
                    failChoice("--image", word, imageNames());
                }
                s.choices.image = word;
            })->group(group);
    addWord(app, "--exposure", "EV|auto", "Stops of brightness, or auto (default auto)",
            [&s](const std::string& word) {
                s.choices.autoExposure = word == "auto";
                if (word != "auto") {
                    s.choices.exposureEv =
                        static_cast<float>(parseNumber("--exposure", word, -100, 100));
                }
            })->group(group);
    addWord(app, "--tonemap", "NAME", "agx, aces, reinhard or none (default agx)",
            [&s](const std::string& word) {
                s.choices.tonemap = parseChoice("--tonemap", word, kTonemapWords);
            })->group(group);
    addWord(app, "-o,--output", "FILE", "Where F12 saves: .png or .exr (default picture.png)",
            [&s](const std::string& word) { s.screenshotPath = word; })->group(group);
    addWord(app, "--script", "FILE", "Do what the file says in the place of a person, and end",
            [&s](const std::string& word) { s.scriptPath = word; })->group(group);
}

std::vector<ScriptCommand> readScript(const std::string& path) {
    if (path.empty()) {
        return {};
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) {
        throw RunError(fmt::format("{}: cannot be read", path));
    }
    return parseScript(text.str(), path);
}

// The median distance of what the camera sees; 1 where it sees nothing.
float metresToSee(GpDevice device, GpScene scene, const GpCameraDesc& camera) {
    constexpr std::uint32_t kSide = 64;  // as exact as a speed has to be
    GpFrameDesc desc{};
    desc.width = desc.height = kSide;
    desc.mode = GP_MODE_LOCAL;
    const Frame frame = newFrame(device, desc);
    GpRenderOptions options{};
    options.samplesPerPixel = 1;
    check(device, gpRender(frame.get(), scene, &camera, &options));
    std::vector<float> depths(std::size_t{kSide} * kSide);
    check(device, gpReadFrameImage(frame.get(), GP_IMAGE_DEPTH, depths.data(),
                                   depths.size() * sizeof(float)));
    std::erase_if(depths, [](float depth) { return !std::isfinite(depth) || depth <= 0; });
    if (depths.empty()) {
        return 1.0f;
    }
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    return *middle;
}

// Where the viewer begins, and what F shows.
void setUpViews(GpDevice device, SceneSetup& setup, const ViewSettings& s, SceneFacts& facts) {
    GpScene scene = setup.scene.get();
    if (s.isSeaAlone()) {
        facts.wholeScene = s.seaCamera.over(s.choices.sea.desc, s.render.fovDeg);
        facts.start = setUpCamera(device, scene, s.render, setup.notes, &facts.wholeScene);
        return;
    }
    facts.start = setUpCamera(device, scene, s.render, setup.notes);
    const float aspect =
        static_cast<float>(s.render.size.width) / static_cast<float>(s.render.size.height);
    check(device, gpFrameScene(scene, aspect, &facts.wholeScene));
}

// Of the scene as it was loaded: the sea comes into it here, behind all that has a number.
SceneFacts factsOf(GpDevice device, SceneSetup& setup, const ViewSettings& s) {
    const RenderSettings& settings = s.render;
    SceneFacts facts;
    GpScene scene = setup.scene.get();
    facts.path = s.isSeaAlone() ? "the sea" : settings.scenePath;
    facts.deviceName = gpGetDeviceName(device);
    facts.index = SceneIndex(describeScene(device, scene));
    setUpViews(device, setup, s, facts);
    addSea(device, scene, s.choices.sea);
    GpSceneInfo info{};
    check(device, gpGetSceneInfo(scene, &info));
    for (std::uint32_t i = 0; i < info.cameras; ++i) {
        GpCameraDesc camera{};
        check(device, gpGetSceneCamera(scene, i, &camera, nullptr));
        facts.cameras.push_back(camera);
    }
    facts.reach = metresToSee(device, scene, facts.start);
    // The sun of a sky comes last and goes with it: it belongs to the surroundings.
    const bool hasSkySun = settings.environmentPath.empty() && !settings.environmentColor &&
                           (settings.sun || setup.skyAdded);
    facts.lights = sceneLights(device, scene,
                               static_cast<std::uint32_t>(info.lights) - (hasSkySun ? 1u : 0u));
    facts.denoisers = describeDenoisers(device);
    return facts;
}

// The sky that the light panel begins with is the one that is there.
Surroundings firstSky(const RenderSettings& render) {
    Surroundings surroundings;
    if (render.sun) {
        const double turned = std::fmod(render.sun->azimuthDeg, 360.0);
        surroundings.azimuthDeg = static_cast<float>(turned < 0 ? turned + 360 : turned);
        surroundings.elevationDeg = static_cast<float>(std::max(render.sun->elevationDeg, 0.0));
    }
    return surroundings;
}

int runView(const CLI::App& app, ViewSettings& settings) {
    RenderSettings& render = settings.render;
    checkSeaSettings(app, settings);
    checkLightSettings(render);
    if (!render.jsonPath.empty()) {
        checkWritable(render.jsonPath);
    }
    render.device.instructionSet =
        render.instructionSet.empty() ? nullptr : render.instructionSet.c_str();
    ViewSession session;
    session.script = readScript(settings.scriptPath);
    session.scriptPath = settings.scriptPath;
    const Device device = newDevice(render.device);
    SceneSetup setup = setUpViewed(device.get(), render);
    session.scene = {device.get(), setup.scene.get(),
                     [&] { setUpSurroundings(device.get(), setup, render); },
                     settings.choices.sea};
    session.jsonPath = render.jsonPath;
    session.quiet = render.quiet;
    session.facts = factsOf(device.get(), setup, settings);
    session.choices = settings.choices;
    session.choices.surroundings = firstSky(render);
    session.choices.reference |= settings.choices.live != LiveMode::realtime;
    session.windowSize = {render.size.width, render.size.height};
    session.screenshotPath = settings.screenshotPath;
    for (const std::string& note : setup.notes) {
        say(render, note);
    }
    const InterruptGuard guard(device.get());
    return runWindow(std::move(session));
}

}  // namespace

Command addViewCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("view", "Fly through a scene in a window");
    const auto settings = std::make_shared<ViewSettings>();
    addSceneOptions(*app, settings->render);
    app->get_option("SCENE")
        ->required(false)
        ->description("The scene: a .gltf or .glb file; with --ocean it may be left out");
    addViewOptions(*app, *settings);
    addCameraOptions(*app, settings->render);
    app->get_option("--size")->description("Pixels of the window (default 1280x720)");
    addLightOptions(*app, settings->render);
    addViewSeaOptions(*app, *settings);
    addMachineOptions(*app, settings->render);
    app->footer(kNotes);
    return {app, [app, settings] { return runView(*app, *settings); }};
}

}  // namespace gp::tool
