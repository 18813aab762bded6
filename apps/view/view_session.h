// `glitterpath view` between the command line and the window.
#pragma once

#include <string>
#include <vector>

#include "view/scene_edits.h"
#include "view/script.h"
#include "view/view_model.h"

namespace gp::tool::view {

struct ViewSession {
    ViewedScene scene;
    SceneFacts facts;
    ViewChoices choices;
    RenderSize windowSize;
    std::string jsonPath;    // a report at the end; empty: none
    bool quiet = false;
    std::string screenshotPath;
    std::vector<ScriptCommand> script;
    std::string scriptPath;  // empty: a person is there
};

// Opens the window and returns the exit code when it is closed. Throws RunError, also where this
// build has no window (GLFW, Dear ImGui or OpenGL was missing).
int runWindow(ViewSession session);

}  // namespace gp::tool::view
