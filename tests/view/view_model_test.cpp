// The state behind the panels: keys, settings by name, picking.
#include <gtest/gtest.h>

#include "tool_error.h"
#include "view/view_model.h"

namespace gp::test {
namespace {

using namespace tool::view;

SceneFacts facts() {
    SceneFacts f;
    f.start.target[2] = -1;
    f.wholeScene.position[2] = 10;
    GpCameraDesc camera{};
    for (const float x : {5.0f, 6.0f}) {
        camera.position[0] = x;
        f.cameras.push_back(camera);
    }
    f.index = SceneIndex(nlohmann::ordered_json::parse(R"({
     "instances": [{"name": "a", "mesh": 0}, {"name": "b", "mesh": 0}],
     "meshes": [{"name": "m", "material": 0}],
     "materials": [{"name": "clay", "roughness": 0.5}], "textures": []})"));
    f.reach = 3;  // one metre a second
    f.denoisers.names = {"asvgf", "svgf"};
    f.denoisers.numbers = {{"filter_depth", "slopes", 1, 0.01f, 100, {"asvgf", "svgf"}}};
    SceneLight lamp;
    lamp.desc.kind = GP_LIGHT_SPHERE;
    lamp.desc.intensity = 5;
    lamp.name = "lamp";
    f.lights = std::make_shared<std::vector<SceneLight>>(1, lamp);
    return f;
}

ViewModel newModel() {
    const ViewChoices choices;
    return ViewModel(facts(), choices, "picture.png");
}

constexpr PictureArea kArea{100, 0, 200, 100};

void press(ViewModel& model, Key key) {
    FrameInput input;
    input.pressed = {key};
    model.advance(input, 0.01, kArea);
}

float x(const ViewModel& model) {
    return model.camera().desc().position[0];
}

TEST(ViewModel, FliesAndLooksAround) {
    ViewModel model = newModel();
    FrameInput input;
    input.move = {1, 0, 0};
    model.advance(input, 0.05, kArea);
    EXPECT_NEAR(x(model), 0.05f, 1.0e-6f);
    model.advance(input, 1000, kArea);  // a window that hung
    EXPECT_NEAR(x(model), 0.15f, 1.0e-6f);
    input = {};
    input.wheel = 4;
    model.advance(input, 0.01, kArea);
    EXPECT_FLOAT_EQ(model.camera().speed(), 2.0f);
}

TEST(ViewModel, KeysDoWhatTheirNamesSay) {
    ViewModel model = newModel();
    press(model, Key::wholeScene);
    EXPECT_EQ(model.camera().desc().position[2], 10);
    press(model, Key::nextCamera);
    EXPECT_EQ(x(model), 5);
    press(model, Key::nextCamera);
    EXPECT_EQ(x(model), 6);
    press(model, Key::nextCamera);
    EXPECT_EQ(x(model), 5);
    press(model, Key::startView);
    EXPECT_EQ(x(model), 0);
    press(model, Key::panels);
    EXPECT_FALSE(model.showsPanels());
    press(model, Key::reference);
    EXPECT_TRUE(model.choices().reference);
    EXPECT_FALSE(model.takeScreenshotRequest());
    press(model, Key::screenshot);
    EXPECT_TRUE(model.takeScreenshotRequest());
    EXPECT_FALSE(model.takeScreenshotRequest());
    EXPECT_FALSE(model.wantsToQuit());
    press(model, Key::quit);
    EXPECT_TRUE(model.wantsToQuit());
}

TEST(ViewModel, AFileWithoutCamerasHasNoNextOne) {
    SceneFacts none = facts();
    none.cameras.clear();
    const ViewChoices choices;
    ViewModel model(none, choices, "");
    press(model, Key::nextCamera);
    EXPECT_EQ(model.message(), "the file has no camera");
    EXPECT_THROW(model.set("camera", "0"), tool::UsageError);
}

TEST(ViewModel, EverySettingChangesTheChoices) {
    const std::pair<const char*, const char*> settings[] = {
        {"camera", "1"},          {"position", "1,2,3"}, {"fov", "30"},
        {"exposure", "1.5"},      {"tonemap", "aces"},   {"image", "depth"},
        {"live", "local"},        {"reference", "on"},   {"samples", "7"},
        {"render-scale", "0.5"},  {"anti-aliasing", "none"}, {"bounces", "3"}, {"mirrors", "0"},
        {"fps", "10"},            {"sky", "90,30,0"},    {"surroundings", "1,2,3"},
        {"lamp", "on"},           {"lamp-intensity", "3"}, {"denoiser", "svgf"},
        {"light-reuse", "biased"}, {"indirect-reuse", "unbiased"}, {"eye-adaptation", "0.5"},
        {"tune", "filter_depth=2"},
        {"light", "0.intensity=7"}, {"add-light", "spot"}, {"remove-light", "0"},
        {"beside", "on"},         {"divider", "0.25"},
        {"wind", "5"}, {"wind-direction", "30"}, {"fetch", "5"}, {"depth", "5"},
        {"spectrum", "phillips"}, {"swell", "1"}, {"choppiness", "0"}, {"foam", "0"},
        {"sea-seed", "5"}, {"cascades", "1"}, {"resolution", "16"}, {"glints", "on"},
        {"glint-density", "50"}, {"masking", "smith"}, {"sea-level", "5"}, {"transparent", "on"},
        {"water-absorption", "1,2,3"}, {"water-scattering", "1,2,3"}, {"water-ior", "1.5"},
        {"sea", "off"}, {"sea-time", "5"}, {"sea-speed", "5"}, {"sea-pause", "on"}};
    const std::vector<std::string> names = ViewModel::settingNames();
    EXPECT_EQ(names.size(), std::size(settings)) << "one is missing in this test";
    for (const auto& [name, value] : settings) {
        ViewModel model = newModel();
        model.choices().sea.isThere = true;
        const ViewChoices before = model.choicesFor({8, 8});
        model.set(name, value);
        EXPECT_FALSE(sameChoices(before, model.choicesFor({8, 8}))) << name;
    }
}

TEST(ViewModel, WrongSettingsAreRefusedAndChangeNothing) {
    const std::pair<const char*, const char*> wrong[] = {
        {"camera", "2"},     {"position", "1,2"},   {"fov", "180"},   {"exposure", "x"},
        {"tonemap", "grey"}, {"image", "colour"},   {"live", "best"}, {"reference", "yes"},
        {"render-scale", "0.4"}, {"anti-aliasing", "msaa"}, {"bounces", "17"}, {"mirrors", "-1"},
        {"samples", "0"},    {"fps", "0"},          {"sky", "0,91,0"}, {"sky", "0,10,-1"},
        {"surroundings", "-1,0,0"}, {"lamp", "1"}, {"lamp-intensity", "-1"}, {"zoom", "2"},
        {"denoiser", "oidn"}, {"light-reuse", "on"},
        {"indirect-reuse", "1"}, {"eye-adaptation", "-1"},
        {"tune", "filter_depth"}, {"tune", "filter_depth=1000"}, {"tune", "filter_dept=1"},
        {"light", "1.on=off"}, {"light", "0.cone=5"}, {"light", "0=5"}, {"light", "0.color=-1,0,0"},
        {"light", "0.radius=x"}, {"add-light", "polygon"}, {"add-light", "bulb"},
        {"remove-light", "3"}, {"beside", "1"}, {"divider", "1.5"},
        {"wind", "101"}, {"depth", "0"}, {"spectrum", "tma"}, {"glints", "yes"}, {"cascades", "5"},
        {"transparent", "1"}, {"sea", "yes"}, {"sea-time", "1e6"}, {"sea-speed", "-1"},
        {"sea-pause", "0"}, {"sea-level", "nan"}};
    for (const auto& [name, value] : wrong) {
        ViewModel model = newModel();
        model.choices().sea.isThere = true;
        const ViewChoices before = model.choicesFor({8, 8});
        EXPECT_THROW(model.set(name, value), tool::UsageError) << name << " " << value;
        EXPECT_TRUE(sameChoices(before, model.choicesFor({8, 8}))) << name << " " << value;
    }
}

ShownPicture twoHalves() {
    ShownPicture picture;
    picture.size = {2, 1};
    picture.ids = {1, 2};
    picture.rgba.resize(8);
    return picture;
}

TEST(ViewModel, PicksWhatIsUnderTheMouse) {
    ViewModel model = newModel();
    FrameInput input;
    input.mouse = {250, 50};  // in the right half of the area
    model.advance(input, 0.01, kArea);
    EXPECT_FALSE(model.thing());  // no picture yet
    model.accept(twoHalves());
    model.advance(input, 0.01, kArea);
    ASSERT_TRUE(model.thing());
    EXPECT_EQ(model.thing()->instanceName, "b");
    input.mouse = {150, 50};
    input.clicked = true;
    model.advance(input, 0.01, kArea);
    input.clicked = false;
    input.mouse = {50, 50};  // over the panels: the click holds
    model.advance(input, 0.01, kArea);
    ASSERT_TRUE(model.thing());
    EXPECT_EQ(model.thing()->instanceName, "a");
    EXPECT_EQ(model.stateJson()["thing"]["parameters"]["roughness"], "0.5");
    input.clicked = true;
    model.advance(input, 0.01, kArea);
    EXPECT_FALSE(model.thing());
}

TEST(ViewModel, JumpsForgetHistoryFlightsDoNot) {
    ViewModel model = newModel();
    const std::uint64_t cuts = model.choices().realtime.cuts;
    FrameInput input;
    input.move = {1, 0, 0};
    model.advance(input, 0.05, kArea);
    EXPECT_EQ(model.choices().realtime.cuts, cuts);
    press(model, Key::wholeScene);
    EXPECT_EQ(model.choices().realtime.cuts, cuts + 1);
    model.set("position", "1,2,3");
    EXPECT_EQ(model.choices().realtime.cuts, cuts + 2);
}

TEST(ViewModel, LightsAreChangedAddedAndRemoved) {
    ViewModel model = newModel();
    const SceneLights loaded = model.facts().lights;
    model.set("light", "0.on=off");
    EXPECT_TRUE(loaded->front().isOn);  // what was handed out stays as it is
    EXPECT_EQ(model.lights().front().shown().intensity, 0);
    model.set("light", "0.on=on");
    model.set("light", "0.color=0,0,0");
    EXPECT_EQ(model.lights().front().shown().intensity, 0);  // three zeros would be white
    model.set("position", "1,2,3");
    model.set("add-light", "rectangle");
    ASSERT_EQ(model.lights().size(), 2u);
    EXPECT_EQ(model.lights()[1].desc.position[1], 2);
    model.set("light", "1.width=4");
    EXPECT_NEAR(edgeLength(model.lights()[1].desc.edgeU), 4, 1e-5);
    model.set("remove-light", "0");
    EXPECT_EQ(model.stateJson()["lights"].size(), 1u);
    EXPECT_EQ(model.stateJson()["lights"][0]["number"], 1);  // keeps its number
    EXPECT_THROW(model.set("light", "0.on=on"), tool::UsageError);
    // A change that changes nothing is none.
    const SceneLights before = model.choices().lights;
    model.set("light", "1.on=on");
    EXPECT_EQ(model.choices().lights, before);
}

TEST(ViewModel, NumbersGoBackToDefault) {
    ViewModel model = newModel();
    model.set("tune", "filter_depth=2");
    EXPECT_EQ(model.choices().realtime.numbers.at("filter_depth"), 2);
    model.set("tune", "default");
    EXPECT_TRUE(model.choices().realtime.numbers.empty());
}

TEST(ViewModel, TheDividerIsDragged) {
    ViewModel model = newModel();
    model.set("beside", "on");
    const GpCameraDesc camera = model.camera().desc();
    FrameInput input;
    const auto drag = [&](float from, float to) {
        input.dragFrom = glm::vec2(from, 50);
        input.drag = {to - from, 0};
        input.mouse = {to, 50};
        model.advance(input, 0.01, kArea);
    };
    drag(203, 250);  // the line is at 200
    EXPECT_NEAR(model.choices().divider, 0.75f, 1e-6f);
    drag(203, 1000);  // the same drag, beyond the border
    EXPECT_EQ(model.choices().divider, 1);
    EXPECT_TRUE(sameCamera(camera, model.camera().desc()));
    input = {};
    model.advance(input, 0.01, kArea);
    drag(150, 160);  // beside the line: looks around
    EXPECT_EQ(model.choices().divider, 1);
    EXPECT_FALSE(sameCamera(camera, model.camera().desc()));
    press(model, Key::beside);
    EXPECT_FALSE(model.choices().beside);
}

TEST(ViewModel, OnlyRealTimeGoesOnAtRest) {
    ViewModel model = newModel();
    model.set("live", "traced");
    EXPECT_TRUE(model.choices().reference);
    model.set("live", "realtime");
    EXPECT_FALSE(model.choices().reference);
}

TEST(ViewModel, LiveFramesAreTimedOnce) {
    ViewModel model = newModel();
    ShownPicture picture = twoHalves();
    picture.liveFrames = 1;
    picture.secondsFrame = 0.02;
    model.accept(picture);
    picture.atRest = true;  // more samples at rest: no new live frame
    model.accept(picture);
    EXPECT_EQ(model.times().milliseconds().size(), 1u);
    picture.liveFrames = 2;
    model.accept(picture);
    EXPECT_EQ(model.times().milliseconds().size(), 2u);
}

}  // namespace
}  // namespace gp::test
