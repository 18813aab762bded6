// What hands do at keyboard and mouse, whether they are a person's or a script's.
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace gp::tool::view {

enum class Key {
    forward, back, left, right, up, down, fast,           // held
    wholeScene, startView, nextCamera, level, reference,  // pressed
    beside, seaPause, seaStep, panels, screenshot, quit
};

struct KeyInfo {
    Key key;
    const char* name;  // as scripts and the manual write it
    const char* meaning;
};

const std::vector<KeyInfo>& allKeys();
std::optional<Key> keyNamed(const std::string& name);

enum class MouseButton { left, right };

// Everything since the frame before.
struct FrameInput {
    glm::vec3 move{0.0f};   // right, up, forward: -1..1 each
    bool fast = false;
    glm::vec2 drag{0.0f};   // pixels right and down, of a drag that began on the picture
    std::optional<glm::vec2> dragFrom;  // where it began, as long as it goes on
    float wheel = 0;        // over the picture
    bool clicked = false;   // on the picture, without a drag
    glm::vec2 mouse{-1.0f}; // pixels from the window's corner
    std::vector<Key> pressed;
    // Whether anything has to be done at once, and again as long as it is so.
    bool isMoving() const { return move != glm::vec3(0.0f) || drag != glm::vec2(0.0f); }
};

class InputState {
public:
    void key(Key key, bool isDown);
    void mouse(const glm::vec2& position);
    // onPicture: whether the mouse is over the picture, not over a panel.
    void button(MouseButton button, bool isDown, bool onPicture);
    void wheel(float steps, bool onPicture);
    bool isHeld(Key key) const { return m_held.contains(key); }

    FrameInput take();

private:
    std::set<Key> m_held;
    std::vector<Key> m_pressed;
    glm::vec2 m_mouse{-1.0f}, m_dragged{0.0f}, m_pressedAt{0.0f};
    float m_wheel = 0;
    int m_buttonsDown = 0;
    bool m_isDrag = false, m_clicked = false;
};

}  // namespace gp::tool::view
