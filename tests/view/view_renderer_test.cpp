// The rendering thread, with a real scene and without a window.
#include <gtest/gtest.h>

#include <cmath>

#include "view/image_view.h"
#include "view/rendering_thread.h"

namespace gp::test {
namespace {

using namespace tool::view;

class ViewRendererTest : public RenderingThread {
protected:
    void SetUp() override {
        RenderingThread::SetUp();
        m_choices.mostSamples = 8;
        m_choices.live = LiveMode::traced;
        m_choices.reference = true;
    }

    ShownPicture finished() {
        return waitFor([this](const ShownPicture& p) {
            return p.atRest && p.statistics.samplesPerPixel >= m_choices.mostSamples;
        });
    }
    ShownPicture live() {
        return waitFor([](const ShownPicture& p) { return !p.atRest; });
    }
};

double mean(const ShownPicture& picture) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        sum += i % 4 == 3 ? 0 : picture.rgba[i];
    }
    return sum / (0.75 * static_cast<double>(picture.rgba.size()));
}

TEST_F(ViewRendererTest, ASmallPictureFirstAndTheReferenceAtRest) {
    const ShownPicture first = live();
    EXPECT_LT(first.size.width, kSize.width);
    EXPECT_EQ(first.ids.size(), std::size_t{first.size.width} * first.size.height);
    EXPECT_GT(first.secondsFrame, 0);
    const ShownPicture rest = finished();
    EXPECT_EQ(rest.size, kSize);
    EXPECT_EQ(rest.statistics.samplesPerPixel, 8u);
    EXPECT_EQ(rest.rgba.size(), std::size_t{4} * kSize.width * kSize.height);
    // The same bits as one gpRender of eight samples: nothing of the way there is left.
    GpFrameDesc desc{};
    desc.width = kSize.width;
    desc.height = kSize.height;
    m_renderer.reset();
    const tool::Frame frame = tool::newFrame(m_device.get(), desc);
    GpRenderOptions options{};
    options.samplesPerPixel = 8;
    tool::check(m_device.get(),
                gpRender(frame.get(), m_scene.get(), &m_choices.camera, &options));
    std::vector<std::uint8_t> expected(rest.rgba.size());
    tool::check(m_device.get(), gpReadFrameImage(frame.get(), GP_IMAGE_DISPLAY, expected.data(),
                                                 expected.size()));
    for (std::size_t i = 3; i < expected.size(); i += 4) {
        expected[i] = 255;
    }
    EXPECT_EQ(rest.rgba, expected);
}

TEST_F(ViewRendererTest, AnotherViewStartsAnewAnotherToneMapDoesNot) {
    const ShownPicture before = finished();
    m_choices.tonemap = GP_TONEMAP_NONE;
    m_choices.exposureEv = 1;
    const ShownPicture toned = waitFor([](const ShownPicture&) { return true; });
    EXPECT_TRUE(toned.atRest);
    EXPECT_EQ(toned.statistics.samplesPerPixel, 8u);
    EXPECT_EQ(toned.liveFrames, before.liveFrames);
    EXPECT_NE(toned.rgba, before.rgba);
    m_choices.camera.position[0] += 0.1f;
    const ShownPicture moved = live();
    EXPECT_GT(moved.liveFrames, before.liveFrames);
}

TEST_F(ViewRendererTest, EveryImageCanBeSeen) {
    finished();
    std::vector<std::uint8_t> last;
    for (const ImageName& image : allImages()) {
        if (!image.kind) {
            continue;
        }
        m_choices.image = image.info.name;
        const ShownPicture picture = waitFor([](const ShownPicture& p) { return p.atRest; });
        EXPECT_EQ(picture.rgba.size(), std::size_t{4} * kSize.width * kSize.height);
        EXPECT_NE(picture.rgba, last) << m_choices.image;
        EXPECT_GT(mean(picture), 1.0) << m_choices.image << " is black";
        EXPECT_EQ(picture.note, "");
        last = picture.rgba;
    }
    m_choices.image = "motion";  // only in real time
    const ShownPicture other = waitFor([](const ShownPicture& p) { return p.atRest; });
    EXPECT_EQ(other.note, "motion: not in this mode; this is the display");
    m_choices.image = "display";
    EXPECT_EQ(waitFor([](const ShownPicture& p) { return p.atRest; }).rgba, other.rgba);
}

TEST_F(ViewRendererTest, RealTimeGoesOnAtRestAndShowsItsLayers) {
    m_choices.live = LiveMode::realtime;
    m_choices.reference = false;
    m_choices.realtime.lightReuse = GP_REUSE_BIASED;  // both have layers of their own
    m_choices.realtime.indirectReuse = GP_REUSE_BIASED;
    const ShownPicture first = live();
    const ShownPicture later = waitFor([&first](const ShownPicture& p) {
        return p.liveFrames >= first.liveFrames + 20;
    });
    EXPECT_FALSE(later.atRest);
    EXPECT_FALSE(later.passes.empty());
    for (const ImageName& image : allImages()) {
        m_choices.image = image.info.name;
        const ShownPicture picture = live();
        const bool bmfrOnly = m_choices.image.starts_with("fitted_");
        const bool facetsOnly = m_choices.image == "sun";
        EXPECT_EQ(picture.note.empty(),
                  image.kind != GP_IMAGE_VARIANCE && !bmfrOnly && !facetsOnly)
            << m_choices.image;
        EXPECT_EQ(picture.rgba.size(), 4 * picture.ids.size());
    }
    // A jump forgets history; frames go on.
    m_choices.image = "history_length";
    const auto brightness = [](const ShownPicture& p) { return mean(p); };
    const double before = brightness(waitFor([](const ShownPicture& p) {
        return mean(p) > 5;
    }));
    ++m_choices.realtime.cuts;
    EXPECT_LT(brightness(live()), before);
    m_choices.reference = true;
    EXPECT_EQ(finished().statistics.samplesPerPixel, 8u);
}

TEST_F(ViewRendererTest, LightCanBeChangedAndComesBack) {
    m_choices.camera.position[2] += 0.01f;  // so that there is a live frame of every state
    const double loaded = mean(finished());
    m_choices.lamp.isOn = true;
    m_choices.lamp.intensity = 30;
    EXPECT_GT(mean(finished()), loaded + 10);
    m_choices.lamp.isOn = false;
    EXPECT_NEAR(mean(finished()), loaded, 0.01);
    m_choices.surroundings.kind = Surroundings::Kind::color;
    finished();
    EXPECT_EQ(m_restored, 0);
    GpSceneInfo info{};
    m_choices.surroundings.kind = Surroundings::Kind::asLoaded;
    finished();
    m_renderer.reset();
    EXPECT_EQ(m_restored, 1);
    tool::check(m_device.get(), gpGetSceneInfo(m_scene.get(), &info));
    EXPECT_NE(info.hasEnvironment, 0);  // restoring is the caller's, and does nothing here
}

TEST_F(ViewRendererTest, SmallerPicturesWhenTimeIsShort) {
    m_choices.reference = false;
    m_choices.size = {160, 120};
    const auto fly = [this](double seconds) {
        m_choices.liveSeconds = seconds;
        ShownPicture picture;
        for (int i = 0; i < 70; ++i) {
            m_choices.camera.position[0] += 0.001f;
            picture = live();
        }
        return picture.scale;
    };
    const double slow = fly(100.0);  // whatever else the machine does
    const double quick = fly(0.0005);
    EXPECT_LT(quick, slow);
    EXPECT_EQ(slow, 1.0);
}

TEST_F(ViewRendererTest, NothingIsRenderedWhereNothingCanBeSeen) {
    finished();
    m_choices.size = {0, 0};
    m_renderer->show(m_choices);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_FALSE(m_renderer->take());
    m_choices.size = {50, 40};
    EXPECT_EQ(finished().size, (RenderSize{50, 40}));
}

TEST_F(ViewRendererTest, PicturesAreSavedAndFailuresAreTold) {
    const TestFolder folder;
    finished();
    m_renderer->save(folder("a.png"));
    m_renderer->save(folder("a.exr"));
    m_renderer->save(folder("nowhere/a.png"));
    std::vector<ViewNote> notes;
    for (int i = 0; i < 6000 && notes.size() < 3; ++i) {
        for (const ViewNote& note : m_renderer->takeNotes()) {
            notes.push_back(note);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_EQ(notes.size(), 3u);
    EXPECT_EQ(notes[0].text, "saved " + folder("a.png") + " (96x64, 8 samples a pixel)");
    EXPECT_FALSE(notes[1].isError);
    EXPECT_TRUE(notes[2].isError);
    unsigned width = 0;
    unsigned height = 0;
    readPicture(folder("a.png"), width, height);
    EXPECT_EQ(width, 96u);
    EXPECT_TRUE(exists(folder("a.exr")));
    m_choices.exposureEv = 2;  // it goes on after that
    EXPECT_TRUE(waitFor([](const ShownPicture&) { return true; }).atRest);
}

TEST_F(ViewRendererTest, EndsInTheMiddleOfARender) {
    m_choices.size = {1600, 1200};
    m_choices.mostSamples = 4096;
    live();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    m_renderer->show(m_choices);
    const auto start = std::chrono::steady_clock::now();
    m_renderer.reset();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), 20.0);  // a whole picture takes minutes
}

}  // namespace
}  // namespace gp::test
