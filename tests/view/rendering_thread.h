// The Cornell box on the viewer's rendering thread, without a window.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "library.h"
#include "tool/tool_runner.h"
#include "view/view_renderer.h"

namespace gp::test {

constexpr tool::view::RenderSize kSize{96, 64};

class RenderingThread : public ::testing::Test {
protected:
    void SetUp() override {
        GpDeviceDesc desc{};
        desc.threads = 2;
        m_device = tool::newDevice(desc);
        m_scene = tool::newScene(m_device.get());
        tool::check(m_device.get(),
                    gpLoadSceneFile(m_scene.get(), cornellPath().c_str(), nullptr));
        tool::check(m_device.get(),
                    gpGetSceneCamera(m_scene.get(), 0, &m_choices.camera, nullptr));
        m_choices.size = kSize;
        m_choices.autoExposure = false;
        m_renderer.emplace(tool::view::ViewedScene{m_device.get(), m_scene.get(),
                                                   [this] { ++m_restored; }},
                           [] {});
    }

    // The first picture of the present choices for which `isIt` holds; fails after a minute.
    template <class Test>
    tool::view::ShownPicture waitFor(const Test& isIt) {
        for (int i = 0; i < 12000; ++i) {
            const std::uint64_t serial = m_renderer->show(m_choices);
            std::optional<tool::view::ShownPicture> picture = m_renderer->take();
            if (picture && picture->serial == serial && isIt(*picture)) {
                return std::move(*picture);
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ADD_FAILURE() << "no such picture came";
        return {};
    }

    tool::Device m_device;
    tool::Scene m_scene;
    tool::view::ViewChoices m_choices;
    int m_restored = 0;
    std::optional<tool::view::ViewRenderer> m_renderer;
};

}  // namespace gp::test
