// `glitterpath make-scene`: scenes made wholly by our own code, written as binary glTF 2.0.
// They are the project's demonstration and test scenes, so that no foreign asset ships with it.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace gp::make_scene {

struct MakeSceneOptions {
    std::string name;                         // one of listScenes()
    std::string outputPath;                   // FILE.glb; appears only when it is complete
    std::map<std::string, double> parameters;  // those left out take their defaults
};

struct SceneParameter {
    std::string name;
    std::string description;
    double defaultValue = 0.0;
    double minimum = 0.0;
    double maximum = 0.0;
    bool integer = false;
};

struct SceneInfo {
    std::string name;
    std::string description;
    std::string renderOptions;  // what `glitterpath render` is best given beside the file
    std::vector<SceneParameter> parameters;
};

// Every scene that can be made, in the order in which help lists them.
std::vector<SceneInfo> listScenes();

// Writes the scene. Throws std::runtime_error with one line that names what is wrong:
// an unknown scene or parameter, a value out of range, a file that cannot be written.
void makeScene(const MakeSceneOptions& options);

}  // namespace gp::make_scene
