// From the command line to a scene with light in it, and to a camera.
#pragma once

#include <string>
#include <vector>

#include "library.h"
#include "render_settings.h"

namespace gp::tool {

// --time, --animation and --scene: which content of a file is meant.
void addSceneChoice(CLI::App& app, GpLoadOptions& load);

struct SceneSetup {
    Scene scene;
    double secondsLoad = 0;
    bool skyAdded = false;           // since nothing lit it
    std::vector<std::string> notes;  // what was added that nobody asked for
};

// Loads the file and adds the light that was asked for, or a sky where there is none.
SceneSetup setUpScene(GpDevice device, const RenderSettings& settings);

// The light that was asked for, into a scene that is there; a sky where there is none.
void addLight(GpDevice device, const RenderSettings& settings, SceneSetup& setup);

// The environment or sky that setUpScene gave the scene, again: for who has set another one.
void setUpSurroundings(GpDevice device, const SceneSetup& setup, const RenderSettings& settings);

// `standard`: the camera, and where it looks, of a scene that has none and nothing to be framed.
GpCameraDesc setUpCamera(GpDevice device, GpScene scene, const RenderSettings& settings,
                         std::vector<std::string>& notes, const GpCameraDesc* standard = nullptr);

}  // namespace gp::tool
