#include "view/view_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tool_error.h"

namespace gp::tool::view {
namespace {

// A frame that took longer, say because the window was dragged, must not throw the camera far.
constexpr double kLongestStep = 0.1;

}  // namespace

ViewModel::ViewModel(SceneFacts facts, const ViewChoices& choices, std::string screenshotPath)
    : m_facts(std::move(facts)),
      m_camera(m_facts.start, m_facts.reach),
      m_choices(choices),
      m_seaDraft(choices.sea.desc),
      m_screenshotPath(std::move(screenshotPath)) {}

void ViewModel::advance(const FrameInput& input, double seconds, const PictureArea& area) {
    for (const Key key : input.pressed) {
        press(key);
    }
    const auto step = static_cast<float>(std::clamp(seconds, 0.0, kLongestStep));
    m_camera.move(input.move, step, input.fast);
    if (!dragDivider(input, area)) {
        m_camera.turn(input.drag.x, input.drag.y, area.height);
    }
    m_camera.changeSpeed(input.wheel);
    advanceSea(std::max(seconds, 0.0));
    pick(input, area);
}

void ViewModel::press(Key key) {
    switch (key) {
        case Key::wholeScene: goTo(m_facts.wholeScene); break;
        case Key::startView: goTo(m_facts.start); break;
        case Key::nextCamera: nextCamera(); break;
        case Key::level: m_camera.levelOut(); break;
        case Key::reference: m_choices.reference = !m_choices.reference; break;
        case Key::beside: m_choices.beside = !m_choices.beside; break;
        case Key::seaPause:
        case Key::seaStep: pressSea(key); break;
        case Key::panels: m_showsPanels = !m_showsPanels; break;
        case Key::screenshot: requestScreenshot(); break;
        case Key::quit: m_quit = true; break;
        default: break;  // those that are held
    }
}

void ViewModel::goTo(const GpCameraDesc& camera) {
    const float speed = m_camera.speed();  // what the wheel chose stays
    m_camera = FlyCamera(camera, m_facts.reach);
    m_camera.speed() = speed;
    ++m_choices.realtime.cuts;
}

void ViewModel::setLive(LiveMode mode) {
    m_choices.live = mode;
    m_choices.reference = mode != LiveMode::realtime;
}

void ViewModel::nextCamera() {
    if (m_facts.cameras.empty()) {
        accept(ViewNote{false, "the file has no camera"});
        return;
    }
    goToCamera(m_nextCamera % m_facts.cameras.size());
}

void ViewModel::goToCamera(std::size_t index) {
    if (index >= m_facts.cameras.size()) {
        throw UsageError(fmt::format("camera: there is no {} in the file, which has {}", index,
                                     m_facts.cameras.size()));
    }
    goTo(m_facts.cameras[index]);
    m_nextCamera = index + 1;
}

bool ViewModel::dragDivider(const FrameInput& input, const PictureArea& area) {
    if (!input.dragFrom || !m_choices.beside) {
        m_dividerDrag.reset();
        return false;
    }
    const float line = area.x + m_choices.divider * area.width;
    if (m_dividerDrag != input.dragFrom) {
        m_dividerDrag.reset();
        if (std::abs(input.dragFrom->x - line) > kDividerReach) {
            return false;
        }
        m_dividerDrag = input.dragFrom;
    }
    m_choices.divider =
        std::clamp((input.mouse.x - area.x) / std::max(area.width, 1.0f), 0.0f, 1.0f);
    return true;
}

const std::vector<SceneLight>& ViewModel::lights() const {
    static const std::vector<SceneLight> none;
    const SceneLights& present = m_choices.lights ? m_choices.lights : m_facts.lights;
    return present ? *present : none;
}

void ViewModel::changeLight(std::size_t index, const std::function<void(SceneLight&)>& change) {
    const std::vector<SceneLight>& present = lights();
    if (index >= present.size() || present[index].isRemoved) {
        throw UsageError(fmt::format("light: there is no {}", index));
    }
    SceneLight changed = present[index];
    change(changed);
    if (changed == present[index]) {
        return;
    }
    auto all = std::make_shared<std::vector<SceneLight>>(present);
    (*all)[index] = std::move(changed);
    m_choices.lights = std::move(all);
}

void ViewModel::addLight(GpLightKind kind) {
    auto all = std::make_shared<std::vector<SceneLight>>(lights());
    all->push_back(newSceneLight(kind, m_camera.desc(), m_facts.reach));
    m_choices.lights = std::move(all);
}

void ViewModel::pick(const FrameInput& input, const PictureArea& area) {
    const float u = (input.mouse.x - area.x) / std::max(area.width, 1.0f);
    const float v = (input.mouse.y - area.y) / std::max(area.height, 1.0f);
    const bool isInside = u >= 0 && u < 1 && v >= 0 && v < 1;
    std::uint32_t id = 0;
    if (isInside && m_picture) {
        const RenderSize size = m_picture->size;
        const auto x = static_cast<std::size_t>(u * static_cast<float>(size.width));
        const auto y = static_cast<std::size_t>(v * static_cast<float>(size.height));
        id = m_picture->ids[y * size.width + x];
    }
    if (id != m_hoveredId) {
        m_hovered = thingAt(id);
        m_hoveredId = id;
    }
    if (input.clicked) {
        m_pinned = m_hovered;  // a click on nothing lets go
    }
}

void ViewModel::accept(ShownPicture picture) {
    if (!m_picture || picture.liveFrames != m_picture->liveFrames) {
        m_times.add(picture.secondsFrame);
    }
    m_picture = std::move(picture);
}

void ViewModel::accept(const ViewNote& note) {
    m_message = note;
    // What failed would be tried again, and fail again, with every step of the waves.
    m_choices.sea.isPaused |= note.isError;
}

bool ViewModel::takeScreenshotRequest() {
    const bool wanted = m_screenshotWanted;
    m_screenshotWanted = false;
    return wanted;
}

ViewChoices ViewModel::choicesFor(RenderSize size) const {
    ViewChoices choices = m_choices;
    choices.camera = m_camera.desc();
    choices.size = size;
    return choices;
}

}  // namespace gp::tool::view
