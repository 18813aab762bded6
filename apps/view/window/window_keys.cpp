#include "view/window/window_keys.h"

#include <GLFW/glfw3.h>

#include <utility>

namespace gp::tool::view {
namespace {

constexpr std::pair<Key, int> kKeys[] = {
    {Key::forward, GLFW_KEY_W},      {Key::back, GLFW_KEY_S},
    {Key::left, GLFW_KEY_A},         {Key::right, GLFW_KEY_D},
    {Key::up, GLFW_KEY_E},           {Key::down, GLFW_KEY_Q},
    {Key::fast, GLFW_KEY_LEFT_SHIFT}, {Key::fast, GLFW_KEY_RIGHT_SHIFT},
    {Key::wholeScene, GLFW_KEY_F},   {Key::startView, GLFW_KEY_R},
    {Key::nextCamera, GLFW_KEY_C},   {Key::level, GLFW_KEY_L},
    {Key::reference, GLFW_KEY_P},    {Key::panels, GLFW_KEY_TAB},
    {Key::beside, GLFW_KEY_B},       {Key::seaPause, GLFW_KEY_SPACE},
    {Key::seaStep, GLFW_KEY_PERIOD},
    {Key::screenshot, GLFW_KEY_F12}, {Key::quit, GLFW_KEY_ESCAPE}};

}  // namespace

std::optional<Key> keyOfGlfw(int glfwKey) {
    for (const auto& [key, number] : kKeys) {
        if (number == glfwKey) {
            return key;
        }
    }
    return std::nullopt;
}

int glfwOfKey(Key key) {
    for (const auto& [known, number] : kKeys) {
        if (known == key) {
            return number;
        }
    }
    return GLFW_KEY_UNKNOWN;
}

}  // namespace gp::tool::view
