// The loop of the window: input to the model, its choices to the renderer, pictures to the screen.
#include <fmt/format.h>
#include <imgui.h>

#include <chrono>

#include "interrupt.h"
#include "library.h"
#include "output.h"
#include "tool_error.h"
#include "view/view_renderer.h"
#include "view/view_session.h"
#include "view/window/panels.h"
#include "view/window/window.h"

namespace gp::tool::view {
namespace {

// The pace of the window while something moves. Scripts go by frames of this length whatever the
// machine does, so that they always end at the same place.
constexpr double kFrameSeconds = 1.0 / 60.0;
// With nothing to do it only looks whether Ctrl-C was pressed.
constexpr double kIdleSeconds = 0.25;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

class WindowLoop {
public:
    explicit WindowLoop(ViewSession session)
        : m_isScripted(!session.scriptPath.empty()),
          m_jsonPath(session.jsonPath),
          m_quiet(session.quiet),
          m_window(session.windowSize, "Glitterpath - " + session.facts.path),
          m_model(std::move(session.facts), session.choices, std::move(session.screenshotPath)),
          m_renderer(session.scene, &Window::wake) {
        if (m_isScripted) {
            m_player = ScriptPlayer(std::move(session.script), session.scriptPath);
            m_scriptPath = session.scriptPath;
        }
    }

    int run() {
        while (!m_quit && !m_window.shouldClose() && !m_model.wantsToQuit() && !interrupted()) {
            frame();
        }
        if (!m_jsonPath.empty()) {
            nlohmann::ordered_json json = m_model.stateJson();
            json["window_frames"] = m_frames;
            writeJson(m_jsonPath, json);
        }
        return interrupted() ? kExitInterrupted : kExitSuccess;
    }

private:
    void frame() {
        m_window.poll(secondsToWait());
        const double time = now();
        const double step = m_isScripted ? kFrameSeconds : time - m_lastFrame;
        m_lastFrame = time;
        std::vector<ScriptCommand> shots;
        if (m_isScripted) {
            shots = playScript(time);
        }
        const FrameInput input = m_window.input().take();
        m_isMoving = input.isMoving();
        m_model.advance(input, step, area());
        m_serial = m_renderer.show(m_model.choicesFor(pictureSize()));
        takeResults();
        if (m_model.takeScreenshotRequest()) {
            m_renderer.save(m_model.screenshotPath());
        }
        const bool isSeen = m_window.framebufferSize().width > 0;
        const bool isDue = m_window.takeRedraw() || m_isScripted || m_isMoving;
        if (isSeen && isDue) {
            draw(shots);
        } else if (!shots.empty()) {
            throw RunError(fmt::format("{}: {}: the window is iconified", m_scriptPath,
                                       shots.front().word));
        }
    }

    double secondsToWait() const {
        if (m_isScripted || m_isMoving || m_model.seaMoves()) {
            return std::max(0.0, m_lastFrame + kFrameSeconds - now());
        }
        return kIdleSeconds;
    }

    // In Dear ImGui's coordinates.
    PictureArea area() const {
        const RenderSize size = m_window.framebufferSize();
        const float unit = m_window.pixelsPerUnit();
        PictureArea area;
        area.x = m_model.showsPanels() ? kPanelWidth : 0.0f;
        area.width = std::max(static_cast<float>(size.width) / unit - area.x, 0.0f);
        area.height = static_cast<float>(size.height) / unit;
        return area;
    }

    RenderSize pictureSize() const {
        const PictureArea a = area();
        const float unit = m_window.pixelsPerUnit();
        return {static_cast<std::uint32_t>(a.width * unit),
                static_cast<std::uint32_t>(a.height * unit)};
    }

    void takeResults() {
        if (std::optional<ShownPicture> picture = m_renderer.take()) {
            m_window.setPicture(picture->size, picture->rgba);
            m_model.accept(std::move(*picture));
        }
        for (const ViewNote& note : m_renderer.takeNotes()) {
            if (note.isError && m_isScripted) {
                throw RunError(note.text);
            }
            if (note.isError || !m_quiet) {
                fmt::print(stderr, "glitterpath: {}{}\n", note.isError ? "error: " : "", note.text);
            }
            m_model.accept(note);
        }
    }

    // Returns the commands that want to see the window when it has been drawn.
    std::vector<ScriptCommand> playScript(double time) {
        ScriptWorld world;
        world.seconds = time;
        world.saving = m_renderer.isSaving();
        if (const std::optional<ShownPicture>& picture = m_model.picture()) {
            world.liveFrames = picture->liveFrames;
            if (picture->serial == m_serial) {
                world.samplesAtRest = picture->atRest ? picture->statistics.samplesPerPixel
                                                      : picture->samplesBeside;
            }
        }
        std::vector<ScriptCommand> shots;
        for (const ScriptCommand& command : m_player.step(world)) {
            try {
                obey(command, shots);
            } catch (const UsageError& error) {
                throw RunError(fmt::format("{}:{}: {}", m_scriptPath, command.line, error.what()));
            }
        }
        return shots;
    }

    void obey(const ScriptCommand& command, std::vector<ScriptCommand>& shots) {
        switch (command.verb) {
            case ScriptVerb::set: m_model.set(command.word, command.value); break;
            case ScriptVerb::picture: m_renderer.save(command.word); break;
            case ScriptVerb::state: writeJson(command.word, m_model.stateJson()); break;
            case ScriptVerb::window: shots.push_back(command); break;
            case ScriptVerb::quit: m_quit = true; break;
            default: m_window.inject(command); break;
        }
    }

    void draw(const std::vector<ScriptCommand>& shots) {
        m_window.beginFrame();
        const PictureArea a = area();
        if (m_model.picture() && a.width > 0 && a.height > 0) {
            ImGui::GetBackgroundDrawList()->AddImage(
                m_window.pictureTexture(), ImVec2(a.x, a.y),
                ImVec2(a.x + a.width, a.y + a.height));
            drawOverPicture(m_model, a);
        }
        if (m_model.showsPanels()) {
            drawPanels(m_model, a.height);
        }
        m_window.draw();
        for (const ScriptCommand& shot : shots) {
            saveWindow(shot.word);
        }
        m_window.present();
        ++m_frames;
    }

    // With a device of its own: the renderer's may be busy for a while.
    void saveWindow(const std::string& path) const {
        GpDeviceDesc desc{};
        desc.backend = GP_BACKEND_NULL;
        const Device device = newDevice(desc);
        RenderSize size;
        std::vector<float> rgba = m_window.readPixels(size);
        GpImage image{};
        image.width = size.width;
        image.height = size.height;
        image.pixels = rgba.data();
        check(device.get(), gpSaveImage(device.get(), path.c_str(), &image));
    }

    const bool m_isScripted;
    const std::string m_jsonPath;
    const bool m_quiet;
    std::string m_scriptPath;
    Window m_window;
    ViewModel m_model;
    ScriptPlayer m_player;
    double m_lastFrame = now();
    std::uint64_t m_serial = 0, m_frames = 0;
    bool m_quit = false, m_isMoving = false;
    ViewRenderer m_renderer;  // last: it ends first, and wakes the window until then
};

}  // namespace

int runWindow(ViewSession session) {
    return WindowLoop(std::move(session)).run();
}

}  // namespace gp::tool::view
