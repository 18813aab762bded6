// In the place of window/ where GLFW, Dear ImGui or OpenGL was not found.
#include "tool_error.h"
#include "view/view_session.h"

namespace gp::tool::view {

int runWindow(ViewSession) {
    throw RunError("view: this build has no window: GLFW 3, Dear ImGui or OpenGL was missing when "
                   "it was configured");
}

}  // namespace gp::tool::view
