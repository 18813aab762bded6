// Changes of the scene that a person makes while looking: its light and its sea.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "library.h"
#include "view/view_choices.h"

namespace gp::tool::view {

struct ViewedScene {
    GpDevice device = nullptr;
    GpScene scene = nullptr;
    std::function<void()> restoreSurroundings;  // those that it was loaded with
    SeaChoices sea{};                           // that it has
};

// Brings the scene to what was chosen; only what differs from the last time is touched.
class SceneEdits {
public:
    // Device and scene must outlive it. The scene is as it was loaded.
    explicit SceneEdits(ViewedScene scene) : m_scene(std::move(scene)), m_sea(m_scene.sea) {}
    ~SceneEdits();
    SceneEdits(const SceneEdits&) = delete;
    SceneEdits& operator=(const SceneEdits&) = delete;

    void apply(const ViewChoices& choices);

private:
    void applySurroundings(const Surroundings& wanted);
    void applyLights(const SceneLights& wanted);
    void applyLight(std::size_t i, const SceneLight& wanted);
    void takeHandles(const std::vector<SceneLight>& wanted);
    void applyLamp(const HandLamp& wanted, const GpCameraDesc& camera);
    void applySea(const SeaChoices& wanted);

    ViewedScene m_scene;
    Surroundings m_surroundings;
    SceneLights m_lights;                 // as they are in the scene; null: as they were loaded
    std::vector<GpLight> m_lightHandles;  // of these; null where the scene has it not
    GpLight m_lamp = nullptr;  // the scene's, while it is on
    GpLightDesc m_lampDesc{};
    SeaChoices m_sea;          // as it is in the scene
};

}  // namespace gp::tool::view
