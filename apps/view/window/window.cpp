#include "view/window/window.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl2.h>

#include <algorithm>
#include <stdexcept>

#include "metrics/color.h"
#include "tool_error.h"
#include "view/window/window_keys.h"

namespace gp::tool::view {
namespace {

// Dear ImGui knows what lies under the mouse one frame late; and then something fades in.
constexpr int kFramesPerEvent = 3;

std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "no reason was given" : text;
}

bool isOverPicture() {
    return !ImGui::GetIO().WantCaptureMouse;
}

}  // namespace

// GLFW's side of it. Dear ImGui's own callbacks call these first.
struct Window::Callbacks {
    static Window& of(GLFWwindow* window) {
        Window& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
        self.m_redraws = kFramesPerEvent;
        return self;
    }

    static void key(GLFWwindow* window, int glfwKey, int, int action, int) {
        Window& self = of(window);
        const std::optional<Key> key = keyOfGlfw(glfwKey);
        // Words that are typed into a panel move nothing; but what was let go is let go.
        const bool isTyping = ImGui::GetIO().WantTextInput;
        if (key && action != GLFW_REPEAT && (action == GLFW_RELEASE || !isTyping)) {
            self.m_input.key(*key, action == GLFW_PRESS);
        }
    }
    static void cursor(GLFWwindow* window, double x, double y) {
        of(window).m_input.mouse({static_cast<float>(x), static_cast<float>(y)});
    }
    static void button(GLFWwindow* window, int button, int action, int) {
        Window& self = of(window);
        if (button == GLFW_MOUSE_BUTTON_LEFT || button == GLFW_MOUSE_BUTTON_RIGHT) {
            self.m_input.button(
                button == GLFW_MOUSE_BUTTON_LEFT ? MouseButton::left : MouseButton::right,
                action == GLFW_PRESS, isOverPicture());
        }
    }
    static void scroll(GLFWwindow* window, double, double steps) {
        of(window).m_input.wheel(static_cast<float>(steps), isOverPicture());
    }
    static void refresh(GLFWwindow* window) { of(window); }
    static void resize(GLFWwindow* window, int, int) { of(window); }
    static void focus(GLFWwindow* window, int) { of(window); }
};

Window::Window(RenderSize size, const std::string& title) {
    if (glfwInit() == 0) {
        throw RunError(fmt::format("view: no window can be opened: {}", lastError()));
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    m_window = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height),
                                title.c_str(), nullptr, nullptr);
    if (m_window == nullptr) {
        const std::string reason = lastError();
        glfwTerminate();
        throw RunError(fmt::format("view: no window with OpenGL can be opened: {}", reason));
    }
    glfwMakeContextCurrent(m_window);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(m_window, this);
    glfwSetKeyCallback(m_window, &Callbacks::key);
    glfwSetCursorPosCallback(m_window, &Callbacks::cursor);
    glfwSetMouseButtonCallback(m_window, &Callbacks::button);
    glfwSetScrollCallback(m_window, &Callbacks::scroll);
    glfwSetWindowRefreshCallback(m_window, &Callbacks::refresh);
    glfwSetFramebufferSizeCallback(m_window, &Callbacks::resize);
    glfwSetWindowFocusCallback(m_window, &Callbacks::focus);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // no file of settings in people's folders
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForOpenGL(m_window, true);
    ImGui_ImplOpenGL2_Init();
}

Window::~Window() {
    if (m_texture != 0) {
        glDeleteTextures(1, &m_texture);
    }
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(m_window);
    glfwTerminate();
}

void Window::poll(double seconds) {
    if (seconds > 0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

void Window::wake() {
    glfwPostEmptyEvent();
}

bool Window::shouldClose() const {
    return glfwWindowShouldClose(m_window) != 0;
}

RenderSize Window::framebufferSize() const {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(m_window, &width, &height);
    const bool isIconified =
        m_isIconified || glfwGetWindowAttrib(m_window, GLFW_ICONIFIED) != 0;
    if (isIconified || width <= 0 || height <= 0) {
        return {};
    }
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

float Window::pixelsPerUnit() const {
    int width = 0;
    int framebufferWidth = 0;
    glfwGetWindowSize(m_window, &width, nullptr);
    glfwGetFramebufferSize(m_window, &framebufferWidth, nullptr);
    return width > 0 ? static_cast<float>(framebufferWidth) / static_cast<float>(width) : 1.0f;
}

bool Window::takeRedraw() {
    const bool isDue = m_redraws > 0;
    m_redraws = std::max(m_redraws - 1, 0);
    return isDue;
}

void Window::inject(const ScriptCommand& command) {
    m_isScripted = true;
    const bool isPress = command.verb == ScriptVerb::press || command.verb == ScriptVerb::down;
    const int action = isPress ? GLFW_PRESS : GLFW_RELEASE;
    const auto integer = [&command](int i) { return static_cast<int>(command.numbers[i]); };
    switch (command.verb) {
        case ScriptVerb::press:
        case ScriptVerb::release: {
            const std::optional<Key> key = keyNamed(command.word);
            if (!key) {
                throw UsageError(fmt::format("there is no key '{}'", command.word));
            }
            ImGui_ImplGlfw_KeyCallback(m_window, glfwOfKey(*key), 0, action, 0);
            break;
        }
        case ScriptVerb::mouse:
            m_scriptMouse[0] = static_cast<float>(command.numbers[0]);
            m_scriptMouse[1] = static_cast<float>(command.numbers[1]);
            Callbacks::cursor(m_window, command.numbers[0], command.numbers[1]);
            break;
        case ScriptVerb::down:
        case ScriptVerb::up: {
            const int button =
                command.word == "left" ? GLFW_MOUSE_BUTTON_LEFT : GLFW_MOUSE_BUTTON_RIGHT;
            m_scriptButtons[button] = isPress;
            ImGui_ImplGlfw_MouseButtonCallback(m_window, button, action, 0);
            break;
        }
        case ScriptVerb::wheel:
            ImGui_ImplGlfw_ScrollCallback(m_window, 0.0, command.numbers[0]);
            break;
        case ScriptVerb::size: glfwSetWindowSize(m_window, integer(0), integer(1)); break;
        // Where no window manager listens, nothing would happen: the flag counts as well.
        case ScriptVerb::iconify:
            m_isIconified = true;
            glfwIconifyWindow(m_window);
            break;
        case ScriptVerb::restore:
            m_isIconified = false;
            glfwRestoreWindow(m_window);
            break;
        default: break;
    }
    m_redraws = kFramesPerEvent;
}

void Window::beginFrame() {
    ImGui_ImplOpenGL2_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    if (m_isScripted) {
        // The backend has just asked the real mouse.
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = ImVec2(m_scriptMouse[0], m_scriptMouse[1]);
        io.MouseDown[0] = io.MouseDown[0] || m_scriptButtons[0];
        io.MouseDown[1] = io.MouseDown[1] || m_scriptButtons[1];
    }
    ImGui::NewFrame();
}

void Window::draw() {
    ImGui::Render();
    const RenderSize size = framebufferSize();
    glViewport(0, 0, static_cast<int>(size.width), static_cast<int>(size.height));
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

void Window::present() {
    glfwSwapBuffers(m_window);
}

std::vector<float> Window::readPixels(RenderSize& size) const {
    size = framebufferSize();
    const std::size_t width = size.width;
    std::vector<std::uint8_t> bytes(4 * width * size.height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, static_cast<int>(size.width), static_cast<int>(size.height), GL_RGBA,
                 GL_UNSIGNED_BYTE, bytes.data());
    std::vector<float> rgba;
    rgba.reserve(bytes.size());
    for (std::size_t row = size.height; row-- > 0;) {  // OpenGL counts rows from below
        for (std::size_t i = 4 * width * row; i < 4 * width * (row + 1); ++i) {
            const float encoded = static_cast<float>(bytes[i]) / 255.0f;
            rgba.push_back(i % 4 == 3 ? 1.0f : metrics::linearFromSrgb(encoded));
        }
    }
    return rgba;
}

void Window::setPicture(RenderSize size, const std::vector<std::uint8_t>& rgba) {
    const auto width = static_cast<int>(size.width);
    const auto height = static_cast<int>(size.height);
    if (m_texture == 0) {
        glGenTextures(1, &m_texture);
    }
    glBindTexture(GL_TEXTURE_2D, m_texture);
    if (size == m_textureSize) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                        rgba.data());
    } else {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     rgba.data());
        m_textureSize = size;
    }
    m_redraws = std::max(m_redraws, 1);
}

void* Window::pictureTexture() const {
    return reinterpret_cast<void*>(static_cast<std::uintptr_t>(m_texture));
}

}  // namespace gp::tool::view
