#include "animate/evaluation.h"

#include <fmt/format.h>

#include <chrono>
#include <numeric>

#include "animate/frame_progress.h"
#include "animate/moving_scene.h"
#include "metrics/color.h"
#include "metrics/noisy_reference.h"
#include "render_frame.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

// Pixels. Without anti-aliasing real time has all of its rays through the centres of pixels.
constexpr float kCentreRadius = 1e-4f;

using metrics::Picture;
using metrics::Plane;
using metrics::ReferencePair;

// What a person sees: display pixels, decoded to linear light.
Picture shownBy(GpDevice device, GpFrame frame, Size size) {
    Picture picture(static_cast<int>(size.width), static_cast<int>(size.height));
    std::vector<unsigned char> rgba(4 * picture.pixels.size());
    check(device, gpReadFrameImage(frame, GP_IMAGE_DISPLAY, rgba.data(), rgba.size()));
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const glm::vec3 encoded(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]);
        picture.pixels[i] = metrics::linearFromSrgb(encoded / 255.0f);
    }
    return picture;
}

Picture encoded(const Picture& linear) {
    Picture picture = linear;
    for (glm::vec3& p : picture.pixels) {
        p = metrics::srgbFromLinear(p);
    }
    return picture;
}

// A layer of the real-time frame: four floats a pixel.
std::vector<glm::vec4> layerOf(GpDevice device, GpFrame frame, const char* name, Size size) {
    std::vector<glm::vec4> pixels(std::size_t{size.width} * size.height);
    check(device, gpReadFrameLayer(frame, name, &pixels[0].x, pixels.size() * sizeof pixels[0]));
    return pixels;
}

// What was where, from the frame that has just been rendered.
struct FrameMotion {
    metrics::Motion motion;
    Plane depth;
};

FrameMotion motionOf(GpDevice device, GpFrame frame, Size size, float renderScale) {
    const int width = static_cast<int>(size.width);
    const int height = static_cast<int>(size.height);
    FrameMotion result;
    result.motion.toPrevious = metrics::Offsets(width, height);
    result.motion.previousDepth = result.motion.slope = result.depth = Plane(width, height);
    const auto motion = layerOf(device, frame, "motion", size);
    const auto depth = layerOf(device, frame, "depth", size);
    for (std::size_t i = 0; i < motion.size(); ++i) {
        // Motion is counted in the pixels of rays.
        result.motion.toPrevious.pixels[i] = glm::vec2(motion[i]) / renderScale;
        result.motion.slope.pixels[i] = motion[i].w / renderScale;
        result.motion.previousDepth.pixels[i] = depth[i].x + motion[i].z;
        result.depth.pixels[i] = depth[i].x;
    }
    return result;
}

class Lamp {
public:
    Lamp(GpDevice device, GpScene scene, const EvaluationLamp& lamp) : m_device(device) {
        m_desc.kind = GP_LIGHT_SPHERE;
        m_desc.unit = GP_UNIT_POWER_LM;
        m_desc.radius = 0.05f;
        m_desc.invisible = 1;
        m_desc.name = "lamp of the evaluation";
        std::copy(lamp.position.begin(), lamp.position.end(), m_desc.position);
        m_lumen = static_cast<float>(lamp.lumen);
        m_light = gpNewLight(scene, &m_desc);
        if (m_light == nullptr) {
            check(device, GP_ERROR_UNKNOWN);
        }
    }
    ~Lamp() { gpReleaseLight(m_light); }
    Lamp(const Lamp&) = delete;
    Lamp& operator=(const Lamp&) = delete;

    // A scene that has not changed need not be made ready again.
    void set(bool on) {
        if (on == m_on) {
            return;
        }
        m_on = on;
        m_desc.intensity = on ? m_lumen : 0.0f;
        check(m_device, gpSetLight(m_light, &m_desc));
    }

private:
    GpDevice m_device;
    GpLightDesc m_desc{};
    float m_lumen = 0;
    bool m_on = false;
    GpLight m_light = nullptr;
};

class Evaluator {
public:
    Evaluator(GpDevice device, const EvaluateSettings& settings)
        : m_device(device), m_settings(settings), m_render(settings.motion.render),
          m_moving(device, settings.motion),
          m_progress(m_render.quiet, 0, settings.motion.frames) {
        RenderSettings reference = m_render;
        reference.local.mode = GP_MODE_REFERENCE;
        m_reference = newFrameFor(device, reference);
        RenderSettings realtime = m_render;
        realtime.local.mode = GP_MODE_REALTIME;
        for (const Variant& variant : settings.variants) {
            m_states.push_back({newFrameFor(device, realtime), {}, {}});
            m_result.variants.push_back({});
            m_result.variants.back().name = variant.name;
        }
        for (const std::string& note : m_moving.notes()) {
            say(m_render, note);
        }
        if (settings.lamp) {
            m_lamp.emplace(device, m_moving.scene(), *settings.lamp);
        }
        m_result.device = gpGetDeviceName(device);
    }

    std::optional<Evaluation> run() {
        setLamp(0);
        const std::optional<double> exposure = exposureOf(m_device, m_moving, m_settings.motion);
        if (!exposure) {
            return std::nullopt;
        }
        m_result.exposureEv = *exposure;
        for (std::uint32_t i = 0; i < m_settings.motion.frames; ++i) {
            if (!evaluateFrame(i)) {
                return std::nullopt;
            }
        }
        return std::move(m_result);
    }

private:
    // Of one variant, from frame to frame.
    struct State {
        Frame frame;
        metrics::ErrorPair error;  // of luma as shown, in the last frame
        Plane depth;
    };

    bool isOut(std::uint32_t frame) const {
        return m_settings.lamp && frame >= m_settings.lamp->offFrame;
    }
    void setLamp(std::uint32_t frame) {
        if (m_lamp) {
            m_lamp->set(!isOut(frame));
        }
    }

    // `half`: 0 or 1. Both halves of a reference have half of its samples and seeds of their own.
    GpRenderOptions referenceOptions(std::uint32_t frame, std::uint32_t half) const {
        GpRenderOptions options = m_render.options;
        options.samplesPerPixel = (options.samplesPerPixel + 1) / 2;
        // As many bounces as real time has by itself, and the filter of its rays: what is measured
        // shall be noise and filters.
        if (options.maxBounces == 0) {
            options.maxBounces = 1;
        }
        options.pixelFilter = GP_PIXEL_BOX;
        if (options.realtime.antiAliasing == GP_AA_NONE) {
            options.pixelFilterRadius = kCentreRadius;
        }
        options.realtime = {};
        options.exposureEv = static_cast<float>(m_result.exposureEv);
        options.seed += 2 * frame + half;
        return options;
    }
    GpRenderOptions realtimeOptions(const Variant& variant) const {
        GpRenderOptions options = m_render.options;
        options.exposureEv = static_cast<float>(m_result.exposureEv);
        options.samplesPerPixel = 0;
        options.realtime = variant.options;
        return options;
    }

    // The reference takes nearly all of the time, twice where the lamp is on once more.
    bool evaluateFrame(std::uint32_t i) {
        const GpCameraDesc camera = m_moving.goTo(i);
        std::optional<ReferencePair> withLamp;
        const double half = isOut(i) ? 0.45 : 0.0;
        if (isOut(i)) {
            m_lamp->set(true);
            withLamp = renderReference(camera, i, 0, half);
            if (!withLamp) {
                return false;
            }
        }
        setLamp(i);
        const std::optional<ReferencePair> reference = renderReference(camera, i, half, 0.9);
        if (!reference) {
            return false;
        }
        m_result.noise.push_back(metrics::noiseOf(*reference));
        m_progress.begin(i, 0.9, 1);
        for (std::size_t v = 0; v < m_states.size(); ++v) {
            if (!evaluateVariant(v, camera, *reference, withLamp ? &*withLamp : nullptr)) {
                return false;
            }
        }
        m_result.lastReference = encoded(reference->mean());
        return true;
    }

    // None when interrupted. `from` .. `to`: its share of the frame's progress.
    std::optional<ReferencePair> renderReference(const GpCameraDesc& camera, std::uint32_t frame,
                                                 double from, double to) {
        ReferencePair pair;
        for (std::uint32_t half = 0; half < 2; ++half) {
            m_progress.begin(frame, from + 0.5 * half * (to - from),
                             from + 0.5 * (half + 1) * (to - from));
            if (!renderWith(m_device, m_reference.get(), m_moving.scene(), camera,
                            referenceOptions(frame, half), m_progress)) {
                return std::nullopt;
            }
            (half == 0 ? pair.a : pair.b) = shownBy(m_device, m_reference.get(), m_render.size);
        }
        return pair;
    }

    bool evaluateVariant(std::size_t index, const GpCameraDesc& camera,
                         const ReferencePair& reference, const ReferencePair* withLamp) {
        State& state = m_states[index];
        VariantResult& result = m_result.variants[index];
        const Variant& variant = m_settings.variants[index];
        const auto start = std::chrono::steady_clock::now();
        if (!renderWith(m_device, state.frame.get(), m_moving.scene(), camera,
                        realtimeOptions(variant), m_progress)) {
            return false;
        }
        const std::chrono::duration<double, std::milli> taken =
            std::chrono::steady_clock::now() - start;
        result.milliseconds.push_back(taken.count());
        const Picture shown = shownBy(m_device, state.frame.get(), m_render.size);
        metrics::NoisyComparison c = metrics::compareWithPair(shown, reference);
        result.mse.push_back(c.mse);
        result.ssim.push_back(c.ssim);
        result.flip.push_back(c.flip.mean);
        result.lastPicture = encoded(shown);
        result.lastFlip = std::move(c.flip.map);
        addFlicker(state, result, shown, reference, variant.options.renderScale);
        if (withLamp != nullptr) {
            metrics::ErrorPair step;
            step.a = metrics::errorsOf(withLamp->a, reference, metrics::luminance).a;
            step.b = metrics::errorsOf(withLamp->b, reference, metrics::luminance).b;
            const auto afterglow = metrics::afterglow(
                metrics::errorsOf(shown, reference, metrics::luminance), step);
            m_result.lampShows &= afterglow.has_value();
            result.afterglow.push_back(afterglow.value_or(0.0));
        }
        return true;
    }

    void addFlicker(State& state, VariantResult& result, const Picture& shown,
                    const ReferencePair& reference, float renderScale) {
        metrics::ErrorPair error = metrics::errorsOf(shown, reference, metrics::shownLuma);
        FrameMotion now = motionOf(m_device, state.frame.get(), m_render.size,
                                   renderScale == 0 ? 1.0f : renderScale);
        if (!state.error.a.pixels.empty()) {
            result.squaredFlicker.push_back(
                metrics::squaredFlicker(error, state.error, &now.motion, &state.depth));
        }
        state.error = std::move(error);
        state.depth = std::move(now.depth);
    }

    GpDevice m_device;
    const EvaluateSettings& m_settings;
    const RenderSettings& m_render;
    MovingScene m_moving;
    FrameProgress m_progress;
    Frame m_reference;
    std::vector<State> m_states;
    std::optional<Lamp> m_lamp;
    Evaluation m_result;
};

}  // namespace

std::optional<Evaluation> evaluateVariants(GpDevice device, const EvaluateSettings& settings) {
    return Evaluator(device, settings).run();
}

double meanFrom(const std::vector<double>& values, std::uint32_t first, std::uint32_t skip) {
    const std::size_t leave = skip > first ? skip - first : 0;
    if (leave >= values.size()) {
        return 0;
    }
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(leave);
    return std::accumulate(from, values.end(), 0.0) / static_cast<double>(values.end() - from);
}

std::vector<double> rootsOf(const std::vector<double>& squares) {
    std::vector<double> roots;
    for (const double square : squares) {
        roots.push_back(metrics::rootOf(square));
    }
    return roots;
}

}  // namespace gp::tool
