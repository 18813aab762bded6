// The sea of the viewer without a window: its time, its settings, and what the rendering thread
// makes of them.
#include <gtest/gtest.h>

#include "sea/sea_words.h"
#include "tool_error.h"
#include "view/rendering_thread.h"
#include "view/view_model.h"

namespace gp::test {
namespace {

using namespace tool::view;
using tool::UsageError;

// Few cells and one band of waves: quick, and moving all the same.
ViewChoices seaChoices() {
    ViewChoices choices;
    choices.sea.isThere = true;
    choices.sea.desc.resolution = 32;
    choices.sea.desc.cascades = 1;
    return choices;
}

void pass(ViewModel& model, double seconds, std::vector<Key> pressed = {}) {
    FrameInput input;
    input.pressed = std::move(pressed);
    model.advance(input, seconds, {0, 0, 100, 100});
}

double secondsOf(const ViewModel& model) {
    return model.choicesFor({8, 8}).sea.seconds;
}

TEST(ViewSea, GoesOnWithTheClockUntilItIsPaused) {
    ViewModel model({}, seaChoices(), "");
    pass(model, 0.5);
    EXPECT_DOUBLE_EQ(secondsOf(model), 0.5);
    model.set("sea-speed", "4");
    pass(model, 0.5);
    EXPECT_DOUBLE_EQ(secondsOf(model), 2.5);
    pass(model, 0.5, {Key::seaPause});
    EXPECT_DOUBLE_EQ(secondsOf(model), 2.5);
    pass(model, 0.5, {Key::seaStep});
    EXPECT_DOUBLE_EQ(secondsOf(model), 2.5 + 1.0 / 24);
    pass(model, 0.5, {Key::seaPause});
    EXPECT_DOUBLE_EQ(secondsOf(model), 4.5 + 1.0 / 24);
    model.set("sea-time", "1e5");
    pass(model, 1e7);  // it ends where the library's time does
    EXPECT_DOUBLE_EQ(secondsOf(model), 1e6);
}

TEST(ViewSea, StandsStillForAReferenceThatWasAskedFor) {
    ViewModel model({}, seaChoices(), "");
    model.set("reference", "on");
    EXPECT_FALSE(model.seaMoves());
    pass(model, 1);
    EXPECT_EQ(secondsOf(model), 0);
    model.set("reference", "off");
    pass(model, 1);
    EXPECT_EQ(secondsOf(model), 1);
    model.set("live", "local");  // here it is always on, and nobody asked
    EXPECT_TRUE(model.choices().reference);
    EXPECT_TRUE(model.seaMoves());
    model.set("sea-pause", "on");
    EXPECT_FALSE(model.seaMoves());
}

TEST(ViewSea, FailuresPauseIt) {
    ViewModel model({}, seaChoices(), "");
    model.accept(ViewNote{false, "saved"});
    EXPECT_TRUE(model.seaMoves());
    model.accept(ViewNote{true, "no memory"});
    EXPECT_FALSE(model.seaMoves());
}

TEST(ViewSea, ADraftThatNoSeaCanBeIsToldAndForgotten) {
    ViewModel model({}, seaChoices(), "");
    model.seaDraft().wind = 20;
    EXPECT_EQ(model.choices().sea.desc.wind, 0);  // not before it is let go
    model.finishSeaDraft();
    EXPECT_EQ(model.choices().sea.desc.wind, 20);
    const GpOceanDesc before = model.choices().sea.desc;
    model.seaDraft().spectrum = GP_SPECTRUM_TMA;
    model.finishSeaDraft();
    EXPECT_EQ(model.message(), "spectrum: tma needs depth");
    EXPECT_TRUE(model.messageIsError());
    EXPECT_TRUE(tool::sameSea(model.choices().sea.desc, before));
    EXPECT_TRUE(tool::sameSea(model.seaDraft(), before));
    model.set("depth", "5");
    model.set("spectrum", "tma");
    EXPECT_EQ(model.stateJson()["sea"]["spectrum"], "tma");
    EXPECT_THROW(model.set("depth", "deep"), UsageError);
    EXPECT_EQ(model.choices().sea.desc.depth, 5);
}

TEST(ViewSea, WithoutASeaNothingOfItCanBeSet) {
    ViewChoices choices;
    choices.sea.isThere = false;
    ViewModel model(SceneFacts(), choices, "");
    for (const auto& [name, value] : {std::pair{"wind", "5"}, {"sea-time", "5"},
                                      {"sea-pause", "on"}, {"sea-speed", "2"}}) {
        EXPECT_THROW(model.set(name, value), UsageError) << name;
    }
    pass(model, 1, {Key::seaPause});
    EXPECT_EQ(model.message(), "there is no sea (--ocean)");
    EXPECT_EQ(secondsOf(model), 0);
    EXPECT_TRUE(model.stateJson()["sea"].is_null());
    model.set("sea", "on");
    model.set("wind", "5");
    EXPECT_EQ(model.stateJson()["sea"]["wind"], 5);
}

TEST(ViewSea, IsAThingBehindThoseOfTheFile) {
    SceneFacts facts;
    facts.index = SceneIndex(nlohmann::ordered_json::parse(R"({
     "instances": [{"name": "boat", "mesh": 0}], "meshes": [{"name": "m", "material": 0}],
     "materials": [{"name": "wood"}], "textures": []})"));
    ViewModel model(facts, seaChoices(), "");
    ShownPicture picture;
    picture.size = {2, 1};
    picture.ids = {1, 2};
    model.accept(picture);
    FrameInput input;
    input.mouse = {75, 50};
    input.clicked = true;
    model.advance(input, 0, {0, 0, 100, 100});
    ASSERT_TRUE(model.thing());
    EXPECT_EQ(model.thing()->materialName, "sea");
    const auto wind = [&model] { return model.thing()->parameters.front().second; };
    EXPECT_EQ(wind(), "10");
    model.set("wind", "3.5");
    EXPECT_EQ(wind(), "3.5");
    input.mouse = {25, 50};
    model.advance(input, 0, {0, 0, 100, 100});
    EXPECT_EQ(model.thing()->materialName, "wood");
}

// What a word reads is what the same word writes, in the units of --help.
TEST(SeaWords, AreReadAsTheyAreWritten) {
    const std::pair<const char*, const char*> words[] = {
        {"wind", "0"}, {"wind-direction", "-30"}, {"fetch", "250"}, {"depth", "12.5"},
        {"depth", "deep"}, {"spectrum", "phillips"}, {"swell", "0.25"}, {"choppiness", "0"},
        {"foam", "0"}, {"sea-seed", "7"}, {"cascades", "4"}, {"resolution", "64"},
        {"glints", "deliot"}, {"glint-density", "20000"}, {"masking", "smith"},
        {"water-absorption", "0,0.5,12.25"}, {"water-scattering", "0,0,0"},
        {"water-ior", "1.5"}, {"sea-level", "-2.5"}, {"transparent", "on"}};
    for (const auto& [name, value] : words) {
        const tool::SeaWord* word = tool::seaWordNamed(name);
        ASSERT_NE(word, nullptr) << name;
        GpOceanDesc sea{};
        word->set(sea, name, value);
        EXPECT_EQ(word->get(sea), value) << name;
        // What nobody gave is the library's default, and can be written down too.
        GpOceanDesc written{};
        word->set(written, name, word->get(GpOceanDesc{}));
        EXPECT_EQ(word->get(written), word->get(GpOceanDesc{})) << name;
    }
    GpOceanDesc water{};
    for (const char* wrong : {"0.1,0.2", "-0.1,0,0", "0,0,1001", "0,nan,0"}) {
        EXPECT_THROW(tool::seaWordNamed("water-absorption")->set(water, "--x", wrong),
                     tool::UsageError)
            << wrong;
    }
    EXPECT_TRUE(tool::sameSea(water, GpOceanDesc{})) << "a wrong word changes nothing";
    EXPECT_EQ(tool::allSeaWords().size() + 1, std::size(words)) << "one is missing in this test";
}

class ViewSeaThread : public RenderingThread {
protected:
    void SetUp() override {
        RenderingThread::SetUp();
        m_choices.sea = seaChoices().sea;
        // Out of the box, over the water.
        m_choices.camera.position[1] = 2;
        m_choices.camera.position[2] = 6;
        m_choices.camera.target[1] = 0;
        m_choices.surroundings.kind = Surroundings::Kind::sky;
        m_choices.mostSamples = 4;
        m_choices.live = LiveMode::traced;
        m_choices.reference = true;
    }

    std::vector<std::uint8_t> finished() {
        return waitFor([this](const ShownPicture& p) {
            return p.atRest && p.statistics.samplesPerPixel >= m_choices.mostSamples;
        }).rgba;
    }
};

TEST_F(ViewSeaThread, ItsTimeAndItsSettingsAreSeen) {
    const std::vector<std::uint8_t> first = finished();
    m_choices.sea.seconds = 3;
    const std::vector<std::uint8_t> later = finished();
    EXPECT_NE(later, first);
    m_choices.sea.desc.wind = 20;
    const std::vector<std::uint8_t> storm = finished();
    EXPECT_NE(storm, later);
    m_choices.sea.isThere = false;
    const std::vector<std::uint8_t> without = finished();
    EXPECT_NE(without, storm);
    // The same moment of the same sea again, by another way: the same bits.
    m_choices.sea = seaChoices().sea;
    m_choices.sea.seconds = 3;
    EXPECT_EQ(finished(), later);
}

TEST_F(ViewSeaThread, RealTimeAndTheReferenceBesideAreOfTheSameMoment) {
    m_choices.live = LiveMode::realtime;
    m_choices.reference = false;
    m_choices.beside = true;
    m_choices.divider = 0;  // the reference alone is seen
    m_choices.liveSeconds = 100;
    const auto besides = [this] {
        return waitFor([](const ShownPicture& p) {
            return p.size == kSize && p.samplesBeside >= 4;
        }).rgba;
    };
    const std::vector<std::uint8_t> first = besides();
    m_choices.sea.seconds = 5;
    // With the first picture of the new time comes a sample of it, not of the old time.
    const ShownPicture moved = waitFor([](const ShownPicture& p) { return p.samplesBeside > 0; });
    EXPECT_LT(moved.samplesBeside, 4u);
    const std::vector<std::uint8_t> later = besides();
    EXPECT_NE(later, first);
    m_choices.sea.seconds = 0;
    EXPECT_EQ(besides(), first);
}

TEST_F(ViewSeaThread, PicturesAreSavedWhileItMoves) {
    const TestFolder folder;
    m_choices.size = {320, 240};  // more than the two milliseconds between the steps below
    m_choices.liveSeconds = 100;  // at full size
    waitFor([](const ShownPicture&) { return true; });
    m_renderer->save(folder("a.exr"));
    for (int i = 0; i < 5000 && m_renderer->isSaving(); ++i) {
        m_choices.sea.seconds += 0.01;
        m_renderer->show(m_choices);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_FALSE(m_renderer->isSaving());
    EXPECT_TRUE(exists(folder("a.exr")));
}

}  // namespace
}  // namespace gp::test
