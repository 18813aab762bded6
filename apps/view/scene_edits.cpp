#include "view/scene_edits.h"

#include <algorithm>
#include <numbers>

namespace gp::tool::view {
namespace {

// As large as a bulb: shadows have soft edges, and no sample is wild beside it.
constexpr float kLampRadius = 0.02f;

float radians(float degrees) {
    return degrees * std::numbers::pi_v<float> / 180.0f;
}

GpLightDesc lampDesc(const HandLamp& lamp, const GpCameraDesc& camera) {
    GpLightDesc desc{};
    desc.kind = GP_LIGHT_SPHERE;
    desc.unit = GP_UNIT_RADIOMETRIC;
    desc.intensity = lamp.intensity;
    desc.radius = kLampRadius;
    desc.invisible = 1;  // else the camera would look at its inside
    const float* position = lamp.followsCamera ? camera.position : lamp.position;
    std::copy_n(position, 3, desc.position);
    desc.name = "lamp of the viewer";
    return desc;
}

}  // namespace

void SceneEdits::apply(const ViewChoices& choices) {
    applySurroundings(choices.surroundings);
    applyLamp(choices.lamp, choices.camera);
}

void SceneEdits::applySurroundings(const Surroundings& wanted) {
    if (wanted == m_surroundings) {
        return;
    }
    GpScene scene = m_scene.scene;
    if (wanted.kind == Surroundings::Kind::sky) {
        check(m_scene.device, gpSetSky(scene, radians(wanted.azimuthDeg),
                                       radians(wanted.elevationDeg), wanted.lux));
    } else if (wanted.kind == Surroundings::Kind::color) {
        GpEnvironmentDesc desc{};
        std::copy_n(wanted.color, 3, desc.color);
        check(m_scene.device, gpSetEnvironment(scene, &desc));
    } else if (m_surroundings.kind != Surroundings::Kind::asLoaded) {
        m_scene.restoreSurroundings();
    }
    m_surroundings = wanted;
}

void SceneEdits::applyLamp(const HandLamp& wanted, const GpCameraDesc& camera) {
    if (!wanted.isOn) {
        if (m_lamp != nullptr) {
            check(m_scene.device, gpRemoveLight(m_lamp));
            m_lamp = nullptr;
        }
        return;
    }
    const GpLightDesc desc = lampDesc(wanted, camera);
    if (m_lamp == nullptr) {
        m_lamp = gpNewLight(m_scene.scene, &desc);
        if (m_lamp == nullptr) {
            check(m_scene.device, GP_ERROR_UNKNOWN);
        }
    } else if (desc.intensity != m_lampDesc.intensity ||
               !std::equal(desc.position, desc.position + 3, m_lampDesc.position)) {
        check(m_scene.device, gpSetLight(m_lamp, &desc));
    }
    m_lampDesc = desc;
}

}  // namespace gp::tool::view
