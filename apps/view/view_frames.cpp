#include "view/view_frames.h"

#include <algorithm>
#include <chrono>

#include "view/image_view.h"

namespace gp::tool::view {
namespace {

// Between two pictures at rest: short enough to see it clear up, long enough to cost nothing.
constexpr double kSecondsAtRest = 0.25;
// Between two live frames, for eyes that adapt: not a pause of a person.
constexpr double kShortestStep = 1.0e-3;
constexpr double kLongestStep = 1.0;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

GpFrameMode frameModeOf(LiveMode mode) {
    switch (mode) {
        case LiveMode::realtime: return GP_MODE_REALTIME;
        case LiveMode::local: return GP_MODE_LOCAL;
        case LiveMode::traced: break;
    }
    return GP_MODE_REFERENCE;
}

// In ours 0 is none; in the library's it is the default.
std::int32_t libraryCount(std::int32_t count) {
    return count == 0 ? GP_NO_BOUNCES : count;
}

std::vector<GpDenoiserParameter> parametersOf(const RealtimeChoices& choices) {
    std::vector<GpDenoiserParameter> parameters;
    for (const auto& [name, value] : choices.numbers) {
        parameters.push_back({name.c_str(), value});
    }
    return parameters;
}

// `parameters` must live until the frame is there.
void addRealtimeOptions(const RealtimeChoices& choices, bool isCut,
                        const std::vector<GpDenoiserParameter>& parameters,
                        GpRenderOptions& options) {
    options.realtime.denoiser = choices.denoiser;
    options.realtime.lightReuse = choices.lightReuse;
    options.realtime.indirectReuse = choices.indirectReuse;
    options.realtime.parameters = parameters.data();
    options.realtime.parameterCount = static_cast<std::uint32_t>(parameters.size());
    options.realtime.eyeAdaptation.seconds = choices.eye.seconds;
    options.realtime.eyeAdaptation.evMin = choices.eye.evMin;
    options.realtime.eyeAdaptation.evMax = choices.eye.evMax;
    options.maxBounces = libraryCount(choices.bounces);
    options.realtime.resetHistory = isCut ? 1 : 0;
    options.realtime.antiAliasing = choices.antiAliasing;
    options.realtime.mirrorLimit = libraryCount(choices.mirrors);
}

}  // namespace

void ViewFrames::prepare(SizedFrame& frame, RenderSize size, GpFrameMode mode) {
    if (frame.frame && frame.size == size && frame.mode == mode) {
        return;
    }
    GpFrameDesc desc{};
    desc.width = size.width;
    desc.height = size.height;
    desc.mode = mode;
    frame.frame.reset();  // the old one's memory first
    frame.frame = newFrame(m_device, desc);
    frame.size = size;
    frame.mode = mode;
}

void ViewFrames::renderLive(GpScene scene, const ViewChoices& choices) {
    m_liveStart = now();
    const bool isRealtime = choices.live == LiveMode::realtime;
    m_controller.setTarget(choices.liveSeconds);
    m_controller.setMostRenderScale(
        isRealtime ? std::optional<double>(choices.realtime.renderScale) : std::nullopt);
    m_showsRest = false;
    m_samplesAtRest = 0;
    prepare(m_live, m_controller.sizeFor(choices.size), frameModeOf(choices.live));
    GpRenderOptions options{};
    options.samplesPerPixel = 1;
    options.seed = ++m_liveFrames;  // the same noise in every frame would look like dirt
    options.exposureEv = choices.exposureEv;
    options.tonemap = choices.tonemap;
    const std::vector<GpDenoiserParameter> parameters = parametersOf(choices.realtime);
    if (isRealtime) {
        addRealtimeOptions(choices.realtime, choices.realtime.cuts != m_cuts, parameters, options);
        options.realtime.renderScale = static_cast<float>(m_controller.renderScale());
        options.realtime.heatMaps = needsHeatMaps(choices.image) ? 1 : 0;
        options.realtime.timeStep = static_cast<float>(
            std::clamp(m_liveStart - m_lastLiveStart, kShortestStep, kLongestStep));
    }
    m_lastLiveStart = m_liveStart;
    m_cuts = choices.realtime.cuts;
    check(m_device, gpRender(m_live.frame.get(), scene, &choices.camera, &options));
    GpFrameStatistics statistics{};
    check(m_device, gpGetFrameStatistics(m_live.frame.get(), &statistics));
    m_secondsBuild = statistics.secondsBuild;
}

double ViewFrames::noteLiveTime() {
    m_secondsFrame = now() - m_liveStart;
    // Structures are built once; smaller pictures would not make that quicker.
    m_controller.record(std::max(m_secondsFrame - m_secondsBuild, 1.0e-6));
    return m_secondsFrame;
}

// Returns how many there are now. The first sample comes as soon as it is there.
std::uint32_t ViewFrames::addSamples(const SizedFrame& frame, GpScene scene,
                                     const ViewChoices& choices, std::uint32_t samples, bool anew,
                                     double seconds, GpProgressCallback progress, void* user) {
    GpRenderOptions options{};
    options.accumulate = anew ? 0 : 1;
    options.exposureEv = choices.exposureEv;
    options.tonemap = choices.tonemap;
    options.progress = progress;
    options.progressUser = user;
    const bool first = samples == 0;
    options.samplesPerPixel = first ? 1 : choices.mostSamples - samples;
    options.timeLimit = first ? 0.0 : seconds;
    const GpError error = gpRender(frame.frame.get(), scene, &choices.camera, &options);
    if (error == GP_ERROR_CANCELLED) {
        gpGetError(m_device, nullptr);  // it is no failure, so nobody shall find it later
    } else {
        check(m_device, error);
    }
    GpFrameStatistics statistics{};
    check(m_device, gpGetFrameStatistics(frame.frame.get(), &statistics));
    return statistics.samplesPerPixel;
}

bool ViewFrames::renderAtRest(GpScene scene, const ViewChoices& choices,
                              GpProgressCallback progress, void* user, bool anew) {
    prepare(m_rest, choices.size, GP_MODE_REFERENCE);
    m_samplesAtRest = addSamples(m_rest, scene, choices, m_samplesAtRest, anew, kSecondsAtRest,
                                 progress, user);
    m_showsRest = m_samplesAtRest > 0;
    return m_showsRest;
}

void ViewFrames::renderBeside(GpScene scene, const ViewChoices& choices,
                              GpProgressCallback progress, void* user, bool anew) {
    const bool isOther = m_beside.size != m_live.size;
    prepare(m_beside, m_live.size, GP_MODE_REFERENCE);
    // As much time as the live frame had: both go on.
    m_samplesBeside = addSamples(m_beside, scene, choices, isOther ? 0 : m_samplesBeside,
                                 anew || isOther, std::min(m_secondsFrame, kSecondsAtRest),
                                 progress, user);
}

void ViewFrames::tonemap(float ev, GpTonemap curve) const {
    check(m_device, gpTonemapFrame(shown(), ev, curve));
    if (!m_showsRest && samplesBeside() > 0) {
        check(m_device, gpTonemapFrame(m_beside.frame.get(), ev, curve));
    }
}

float ViewFrames::exposureOfLive() const {
    GpFrameStatistics statistics{};
    check(m_device, gpGetFrameStatistics(m_live.frame.get(), &statistics));
    return statistics.exposureEv;
}

}  // namespace gp::tool::view
