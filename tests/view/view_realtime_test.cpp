// The rendering thread with what only real time has: the reference beside, heat maps, denoisers;
// and with lights that a person changes.
#include <gtest/gtest.h>

#include <cmath>

#include "view/denoiser_facts.h"
#include "view/rendering_thread.h"

namespace gp::test {
namespace {

using namespace tool::view;

class ViewRealtimeTest : public RenderingThread {
protected:
    void SetUp() override {
        RenderingThread::SetUp();
        m_choices.mostSamples = 64;
        m_choices.liveSeconds = 100;  // full size, whatever else the machine does
    }

    ShownPicture afterFrames(std::uint64_t count) {
        std::uint64_t first = 0;
        return waitFor([&](const ShownPicture& p) {
            first = first == 0 ? p.liveFrames : first;
            return p.liveFrames >= first + count;
        });
    }
};

double mean(const ShownPicture& picture, std::uint32_t firstColumn, std::uint32_t endColumn) {
    double sum = 0;
    for (std::uint32_t y = 0; y < picture.size.height; ++y) {
        for (std::uint32_t x = firstColumn; x < endColumn; ++x) {
            const std::size_t i = 4 * (std::size_t{y} * picture.size.width + x);
            sum += picture.rgba[i] + picture.rgba[i + 1] + picture.rgba[i + 2];
        }
    }
    return sum / (3.0 * picture.size.height * (endColumn - firstColumn));
}

double mean(const ShownPicture& picture) {
    return mean(picture, 0, picture.size.width);
}

bool isFull(const ShownPicture& p) {
    return p.size == kSize && p.renderScale == 1.0;
}

TEST_F(ViewRealtimeTest, TheReferenceStandsBesideAndStartsAnew) {
    waitFor(isFull);
    m_choices.beside = true;
    m_choices.divider = 0.5f;
    const ShownPicture settled =
        waitFor([](const ShownPicture& p) { return p.samplesBeside >= 64; });
    EXPECT_FALSE(settled.atRest);
    EXPECT_GT(settled.rmseBeside, 0);
    EXPECT_LT(settled.rmseBeside, 0.2);
    // The line, white from top to bottom.
    for (const std::uint32_t y : {0u, kSize.height - 1}) {
        const std::size_t i = 4 * (std::size_t{y} * kSize.width + kSize.width / 2);
        EXPECT_EQ(settled.rgba[i] + settled.rgba[i + 1] + settled.rgba[i + 2], 3 * 255);
    }
    // Left of it real time goes on; right of it nothing changes any more.
    const ShownPicture later = waitFor(
        [&settled](const ShownPicture& p) { return p.liveFrames > settled.liveFrames + 3; });
    EXPECT_NE(mean(later, 0, 47), mean(settled, 0, 47));
    EXPECT_EQ(mean(later, 49, 96), mean(settled, 49, 96));
    // What is right is the reference: the same bits as one gpRender.
    GpFrameDesc desc{};
    desc.width = kSize.width;
    desc.height = kSize.height;
    m_choices.divider = 0;
    const ShownPicture whole = waitFor([](const ShownPicture& p) { return p.samplesBeside >= 64; });
    // The least change of the camera begins with one sample.
    m_choices.camera.position[0] += 0.001f;
    const ShownPicture moved = waitFor([](const ShownPicture& p) { return p.samplesBeside > 0; });
    EXPECT_LT(moved.samplesBeside, 64u);
    m_choices.camera.position[0] -= 0.001f;
    m_renderer.reset();
    const tool::Frame frame = tool::newFrame(m_device.get(), desc);
    GpRenderOptions options{};
    options.samplesPerPixel = 64;
    tool::check(m_device.get(),
                gpRender(frame.get(), m_scene.get(), &m_choices.camera, &options));
    std::vector<std::uint8_t> expected(whole.rgba.size());
    tool::check(m_device.get(), gpReadFrameImage(frame.get(), GP_IMAGE_DISPLAY, expected.data(),
                                                 expected.size()));
    for (std::size_t i = 3; i < expected.size(); i += 4) {
        expected[i] = 255;
    }
    EXPECT_EQ(whole.rgba, expected);
}

TEST_F(ViewRealtimeTest, BesideIsSavedAsItIsSeen) {
    const TestFolder folder;
    waitFor(isFull);
    m_choices.beside = true;
    const ShownPicture settled =
        waitFor([](const ShownPicture& p) { return p.samplesBeside >= 64; });
    m_renderer->save(folder("beside.png"));
    m_renderer->save(folder("beside.exr"));
    std::size_t told = 0;
    for (int i = 0; i < 6000 && told < 2; ++i) {
        for (const ViewNote& note : m_renderer->takeNotes()) {
            EXPECT_FALSE(note.isError) << note.text;
            ++told;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    unsigned width = 0;
    unsigned height = 0;
    const std::vector<float> png = readPicture(folder("beside.png"), width, height);
    ASSERT_EQ(width, kSize.width);
    // The reference is at rest: its half is the same in both.
    const std::size_t i = 4 * (std::size_t{kSize.height / 2} * width + 80);
    const double encoded = settled.rgba[i] / 255.0;
    const double linear =
        encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(static_cast<double>(png[i]), linear, 1.0e-4);
    EXPECT_TRUE(exists(folder("beside.exr")));
}

TEST_F(ViewRealtimeTest, HandsThatMoveSeeBothHalvesOfOneView) {
    m_choices.beside = true;
    for (int i = 0; i < 10; ++i) {
        m_choices.camera.position[0] += 0.01f;
        m_renderer->show(m_choices);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        if (const std::optional<ShownPicture> picture = m_renderer->take()) {
            EXPECT_GT(picture->samplesBeside, 0u);
        }
    }
    EXPECT_GT(waitFor([](const ShownPicture&) { return true; }).samplesBeside, 0u);
}

TEST_F(ViewRealtimeTest, HeatMapsHaveAScale) {
    m_choices.image = "heat_rays";
    const ShownPicture rays = waitFor([](const ShownPicture& p) { return p.heat.has_value(); });
    EXPECT_EQ(rays.note, "");
    EXPECT_GE(rays.heat->high, 3);
    EXPECT_EQ(rays.heat->unit, "rays");
    m_choices.image = "heat_time";
    EXPECT_GT(waitFor([](const ShownPicture& p) { return p.heat.has_value(); }).heat->high, 0);
    m_choices.image = "heat_variance";
    EXPECT_GT(waitFor([](const ShownPicture& p) { return p.heat.has_value(); }).heat->high, 0);
    m_choices.realtime.denoiser = GP_DENOISER_NONE;  // finds no variance
    EXPECT_EQ(waitFor([](const ShownPicture&) { return true; }).note,
              "heat_variance: not in this mode; this is the display");
    m_choices.image = "display";
    EXPECT_FALSE(waitFor([](const ShownPicture&) { return true; }).heat);
}

TEST_F(ViewRealtimeTest, NumbersAndDenoisersCount) {
    const DenoiserFacts facts = describeDenoisers(m_device.get());
    ASSERT_GE(facts.names.size(), 4u);
    EXPECT_EQ(facts.names[GP_DENOISER_SVGF], "svgf");
    ASSERT_NE(facts.number("filter_depth"), nullptr);
    EXPECT_TRUE(facts.isUsedBy(*facts.number("svgf_history_frames"), "svgf"));
    EXPECT_FALSE(facts.isUsedBy(*facts.number("svgf_history_frames"), "asvgf"));
    waitFor(isFull);  // another size would forget history
    // A history of one frame stays at one.
    m_choices.image = "history_length";
    const auto shade = [this] { return mean(afterFrames(12)); };
    const double many = shade();
    m_choices.realtime.numbers["direct_history_frames"] = 1;
    m_choices.realtime.numbers["specular_history_frames"] = 1;
    EXPECT_LT(shade(), 0.6 * many);
    m_choices.realtime.numbers.clear();
    m_choices.realtime.denoiser = facts.denoiser("denoiser", "atrous");
    EXPECT_LT(shade(), 1);  // it has no history
}

TEST_F(ViewRealtimeTest, TheEyeDecidesWhereItIsOn) {
    m_choices.realtime.eye.seconds = 0.05f;
    m_choices.autoExposure = true;
    m_choices.exposureEv = 0;
    const float adapted = afterFrames(5).exposureEv;
    m_choices.exposureEv = 2;  // is added
    EXPECT_NEAR(afterFrames(10).exposureEv, adapted + 2, 0.5f);
}

TEST_F(ViewRealtimeTest, LightsOfTheSceneAreChangedAddedAndRemoved) {
    GpLightDesc lamp{};
    lamp.kind = GP_LIGHT_SPHERE;
    std::copy_n(m_choices.camera.position, 3, lamp.position);
    lamp.intensity = 40;
    GpLight handle = gpNewLight(m_scene.get(), &lamp);
    ASSERT_NE(handle, nullptr);
    gpReleaseLight(handle);
    GpSceneInfo info{};
    tool::check(m_device.get(), gpGetSceneInfo(m_scene.get(), &info));
    const auto count = static_cast<std::uint32_t>(info.lights);
    const SceneLights loaded = sceneLights(m_device.get(), m_scene.get(), count);
    const auto shade = [this] { return mean(afterFrames(32)); };
    const double asLoaded = shade();
    const auto with = [&](const auto& change) {
        auto all = std::make_shared<std::vector<SceneLight>>(*loaded);
        change(*all);
        m_choices.lights = std::move(all);
        return shade();
    };
    EXPECT_NEAR(with([](auto&) {}), asLoaded, 4.0);  // noise
    const double off = with([](auto& all) { all.back().isOn = false; });
    EXPECT_LT(off, asLoaded - 10);
    EXPECT_NEAR(with([](auto& all) { all.back().isRemoved = true; }), off, 4.0);
    tool::check(m_device.get(), gpGetSceneInfo(m_scene.get(), &info));
    EXPECT_EQ(info.lights, count - 1);
    EXPECT_GT(with([](auto& all) { all.back().desc.intensity *= 4; }), asLoaded + 10);
    const double two = with([this](auto& all) {
        all.push_back(newSceneLight(GP_LIGHT_SPOT, m_choices.camera, 4));
        setLightField(all.back(), "cone", "60");
        setLightField(all.back(), "intensity", "400");
    });
    EXPECT_GT(two, asLoaded + 15);
    tool::check(m_device.get(), gpGetSceneInfo(m_scene.get(), &info));
    EXPECT_EQ(info.lights, count + 1);
}

}  // namespace
}  // namespace gp::test
