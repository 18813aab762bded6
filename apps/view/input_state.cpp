#include "view/input_state.h"

namespace gp::tool::view {
namespace {

// Hands tremble: a click may move by so many pixels.
constexpr float kDragPixels = 3.0f;

}  // namespace

const std::vector<KeyInfo>& allKeys() {
    static const std::vector<KeyInfo> keys = {
        {Key::forward, "W", "fly forwards"},
        {Key::back, "S", "fly backwards"},
        {Key::left, "A", "fly to the left"},
        {Key::right, "D", "fly to the right"},
        {Key::up, "E", "fly up"},
        {Key::down, "Q", "fly down"},
        {Key::fast, "Shift", "four times as fast"},
        {Key::wholeScene, "F", "show the whole scene"},
        {Key::startView, "R", "back to the first view"},
        {Key::nextCamera, "C", "the file's next camera"},
        {Key::level, "L", "level the horizon"},
        {Key::reference, "P", "progressive reference at rest, on and off"},
        {Key::beside, "B", "reference beside the picture, on and off"},
        {Key::seaPause, "Space", "the sea stands still, or goes on"},
        {Key::seaStep, ".", "the sea stands still, 1/24 s later"},
        {Key::panels, "Tab", "panels, on and off"},
        {Key::screenshot, "F12", "save the picture"},
        {Key::quit, "Escape", "end"}};
    return keys;
}

std::optional<Key> keyNamed(const std::string& name) {
    for (const KeyInfo& info : allKeys()) {
        if (name == info.name) {
            return info.key;
        }
    }
    return std::nullopt;
}

void InputState::key(Key key, bool isDown) {
    if (!isDown) {
        m_held.erase(key);
    } else if (m_held.insert(key).second) {
        m_pressed.push_back(key);
    }
}

void InputState::mouse(const glm::vec2& position) {
    if (m_buttonsDown > 0) {
        m_isDrag = m_isDrag || glm::distance(position, m_pressedAt) > kDragPixels;
        m_dragged += position - m_mouse;
    }
    m_mouse = position;
}

void InputState::button(MouseButton button, bool isDown, bool onPicture) {
    const int bit = button == MouseButton::left ? 1 : 2;
    if (isDown && onPicture) {
        m_buttonsDown |= bit;
        m_pressedAt = m_mouse;
        m_dragged = glm::vec2(0.0f);
        m_isDrag = false;
    } else if (!isDown && (m_buttonsDown & bit) != 0) {
        m_buttonsDown &= ~bit;
        m_clicked = m_clicked || (!m_isDrag && button == MouseButton::left);
    }
}

void InputState::wheel(float steps, bool onPicture) {
    if (onPicture) {
        m_wheel += steps;
    }
}

FrameInput InputState::take() {
    const auto axis = [this](Key positive, Key negative) {
        return static_cast<float>(isHeld(positive)) - static_cast<float>(isHeld(negative));
    };
    FrameInput frame;
    frame.move = {axis(Key::right, Key::left), axis(Key::up, Key::down),
                  axis(Key::forward, Key::back)};
    frame.fast = isHeld(Key::fast);
    if (m_isDrag) {  // with what came before it was known to be one
        frame.drag = m_dragged;
        m_dragged = glm::vec2(0.0f);
        frame.dragFrom = m_pressedAt;
    }
    frame.wheel = m_wheel;
    frame.clicked = m_clicked;
    frame.mouse = m_mouse;
    frame.pressed.swap(m_pressed);
    m_wheel = 0;
    m_clicked = false;
    if (m_buttonsDown == 0) {
        m_isDrag = false;
    }
    return frame;
}

}  // namespace gp::tool::view
