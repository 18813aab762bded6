#include "view/scene_edits.h"

#include <algorithm>
#include <numbers>

#include "sea/sea_words.h"

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

SceneEdits::~SceneEdits() {
    for (GpLight light : m_lightHandles) {
        if (light != nullptr) {
            gpReleaseLight(light);  // it stays in its scene
        }
    }
}

void SceneEdits::apply(const ViewChoices& choices) {
    applyLights(choices.lights);  // first: another sky would give the file's lights other numbers
    applySurroundings(choices.surroundings);
    applyLamp(choices.lamp, choices.camera);
    applySea(choices.sea);
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

// Before anything of ours is in the scene the file's lights stand in it by their number.
void SceneEdits::takeHandles(const std::vector<SceneLight>& wanted) {
    for (std::size_t i = m_lightHandles.size(); i < wanted.size() && !wanted[i].isOurs; ++i) {
        GpLightDesc desc{};
        GpLight handle = nullptr;
        check(m_scene.device, gpGetSceneLight(m_scene.scene, static_cast<std::uint32_t>(i), &desc,
                                              &handle));
        m_lightHandles.push_back(handle);
    }
}

void SceneEdits::applyLights(const SceneLights& wanted) {
    if (wanted == m_lights || wanted == nullptr) {
        return;
    }
    if (m_lights == nullptr) {
        takeHandles(*wanted);
    }
    for (std::size_t i = 0; i < wanted->size(); ++i) {
        applyLight(i, (*wanted)[i]);
    }
    m_lights = wanted;
}

void SceneEdits::applyLight(std::size_t i, const SceneLight& wanted) {
    const SceneLight* present = m_lights && i < m_lights->size() ? &(*m_lights)[i] : nullptr;
    if (present != nullptr && *present == wanted) {
        return;
    }
    m_lightHandles.resize(std::max(m_lightHandles.size(), i + 1), nullptr);
    GpLight& handle = m_lightHandles[i];
    const GpLightDesc desc = wanted.shown();
    if (wanted.isRemoved) {
        if (handle != nullptr) {
            check(m_scene.device, gpRemoveLight(handle));
            handle = nullptr;
        }
    } else if (handle != nullptr) {
        check(m_scene.device, gpSetLight(handle, &desc));
    } else {
        handle = gpNewLight(m_scene.scene, &desc);
        if (handle == nullptr) {
            check(m_scene.device, GP_ERROR_UNKNOWN);
        }
    }
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

void SceneEdits::applySea(const SeaChoices& wanted) {
    if (sameWaves(wanted, m_sea)) {
        return;
    }
    const bool isOther = wanted.isThere != m_sea.isThere || !sameSea(wanted.desc, m_sea.desc);
    if (isOther) {
        check(m_scene.device,
              gpSetOcean(m_scene.scene, wanted.isThere ? &wanted.desc : nullptr));
        m_sea = wanted;
        m_sea.seconds = 0;  // should the next call fail
    }
    if (wanted.isThere && wanted.seconds != m_sea.seconds) {
        check(m_scene.device, gpSetOceanTime(m_scene.scene, wanted.seconds));
    }
    m_sea = wanted;
}

}  // namespace gp::tool::view
