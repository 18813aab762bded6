#include "animate/moving_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exposure.h"
#include "render_frame.h"

namespace gp::tool {
namespace {

// Of the picture that the exposure is found with. Its rule looks at means, which few samples give.
constexpr std::uint32_t kExposureWidth = 320;
constexpr std::uint32_t kExposureSamples = 16;

AnimateSettings playable(AnimateSettings settings) {
    settings.render.load.playable = 1;
    return settings;
}

}  // namespace

MovingScene::MovingScene(GpDevice device, const AnimateSettings& settings)
    : m_device(device), m_settings(settings),
      m_setup(setUpScene(device, playable(settings).render)) {
    m_path = pathOf();
}

GpCameraDesc MovingScene::goTo(std::uint32_t frame) {
    play(frame);
    return m_path(secondsOf(frame));
}

void MovingScene::play(std::uint32_t frame) {
    GpPlayOptions options{};
    options.loop = m_settings.hold ? 0 : 1;
    const double time = m_settings.render.load.time + secondsOf(frame);
    check(m_device, gpSetSceneTime(scene(), time, &options));
}

CameraPath MovingScene::pathOf() {
    if (m_settings.orbits()) {
        return orbit();
    }
    if (m_settings.hasKeys()) {
        const CameraKeys keys =
            readCameraKeys(m_settings.path, m_settings.render.fovDeg.value_or(45.0));
        return [keys](double seconds) { return cameraAt(keys, seconds); };
    }
    RenderSettings view = m_settings.render;
    view.camera = m_settings.path.empty() ? view.camera : m_settings.path;
    // What is framed now stays framed: a scene that moves would shake the camera.
    play(0);
    const GpCameraDesc first = setUpCamera(m_device, scene(), view, m_setup.notes);
    GpSceneInfo info{};
    check(m_device, gpGetSceneInfo(scene(), &info));
    if (view.from || view.lookAt || info.cameras == 0) {
        return [first](double) { return first; };
    }
    return [this, view](double) {
        std::vector<std::string> said;
        return setUpCamera(m_device, scene(), view, said);
    };
}

CameraPath MovingScene::orbit() {
    const RenderSettings& s = m_settings.render;
    play(0);
    GpCameraDesc start{};
    if (s.from || s.lookAt) {
        start = setUpCamera(m_device, scene(), s, m_setup.notes);
    } else {
        const float aspect = static_cast<float>(s.size.width) / static_cast<float>(s.size.height);
        check(m_device, gpFrameScene(scene(), aspect, &start));
        if (s.fovDeg) {
            start.verticalFov = static_cast<float>(*s.fovDeg * std::numbers::pi / 180);
        }
    }
    const glm::dvec3 centre(start.target[0], start.target[1], start.target[2]);
    if (m_settings.orbitHeight) {
        start.position[1] = static_cast<float>(centre.y + *m_settings.orbitHeight);
    }
    const double period = m_settings.orbitPeriod.value_or(secondsOf(m_settings.frames));
    return [=](double seconds) { return orbitAt(start, centre, period, seconds); };
}

std::optional<double> exposureOf(GpDevice device, MovingScene& moving,
                                 const AnimateSettings& settings) {
    if (settings.render.exposureEv) {
        return settings.render.exposureEv;
    }
    if (settings.adapts()) {
        return 0.0;
    }
    const GpCameraDesc camera = moving.goTo(0);
    return exposureOf(device, moving.scene(), camera, settings.render);
}

std::optional<double> exposureOf(GpDevice device, GpScene scene, const GpCameraDesc& camera,
                                 const RenderSettings& settings) {
    RenderSettings small = settings;
    const double shrink = std::min(1.0, double(kExposureWidth) / small.size.width);
    small.size.width = std::max(1u, std::uint32_t(std::lround(small.size.width * shrink)));
    small.size.height = std::max(1u, std::uint32_t(std::lround(small.size.height * shrink)));
    small.local.mode = GP_MODE_REFERENCE;
    small.options.samplesPerPixel = kExposureSamples;
    small.options.timeLimit = small.options.noiseTarget = 0;
    small.options.realtime = {};
    small.quiet = true;  // no bar
    const Frame frame = newFrameFor(device, small);
    if (!trace(device, frame.get(), scene, camera, small, {})) {
        return std::nullopt;
    }
    std::vector<float> pixels;
    appendColor(device, frame.get(), small, pixels);
    return automaticExposureEv(pixels.data(), pixels.size() / 4);
}

}  // namespace gp::tool
