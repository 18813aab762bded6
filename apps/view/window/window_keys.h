// Our keys in GLFW's numbers.
#pragma once

#include <optional>

#include "view/input_state.h"

namespace gp::tool::view {

std::optional<Key> keyOfGlfw(int glfwKey);
int glfwOfKey(Key key);

}  // namespace gp::tool::view
