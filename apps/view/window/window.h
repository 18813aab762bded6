// A window with Dear ImGui in it: GLFW, OpenGL 2 and nothing of ours.
#pragma once

#include <string>
#include <vector>

#include "view/input_state.h"
#include "view/resolution_controller.h"
#include "view/script.h"

struct GLFWwindow;

namespace gp::tool::view {

class Window {
public:
    // Throws RunError where there is no display or no OpenGL. One at a time.
    Window(RenderSize size, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Handles what has come; waits for at most so many seconds until something does.
    void poll(double seconds);
    // Ends a poll that waits; any thread.
    static void wake();

    bool shouldClose() const;
    RenderSize framebufferSize() const;  // pixels; 0 x 0 while it is iconified
    float pixelsPerUnit() const;         // of Dear ImGui's coordinates, which are the mouse's
    InputState& input() { return m_input; }
    // Frames of the window that have to be drawn because something came.
    bool takeRedraw();

    // A mouse, key or window command of a script; what GLFW would have called is called.
    void inject(const ScriptCommand& command);

    // Between the first two Dear ImGui may be called; what was drawn is seen after the third.
    void beginFrame();
    void draw();
    void present();
    // Between draw and present: RGBA, linear, top row first.
    std::vector<float> readPixels(RenderSize& size) const;

    // RGBA8, top row first.
    void setPicture(RenderSize size, const std::vector<std::uint8_t>& rgba);
    // What ImGui::Image wants.
    void* pictureTexture() const;

private:
    struct Callbacks;

    GLFWwindow* m_window = nullptr;
    InputState m_input;
    unsigned m_texture = 0;
    RenderSize m_textureSize;
    int m_redraws = 3;
    bool m_isScripted = false, m_isIconified = false;
    float m_scriptMouse[2] = {-1, -1};
    bool m_scriptButtons[2] = {false, false};
};

}  // namespace gp::tool::view
