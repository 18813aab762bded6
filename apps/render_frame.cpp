#include "render_frame.h"

#include <fmt/format.h>

#include <cstdio>

#include "exposure.h"
#include "interrupt.h"
#include "progress_bar.h"

namespace gp::tool {
namespace {

int onProgress(void* user, const GpProgress* progress) {
    static_cast<ProgressBar*>(user)->show(*progress);
    // The signal may have come just before the render began.
    return interrupted() ? 1 : 0;
}

}  // namespace

void say(const RenderSettings& settings, const std::string& text) {
    if (!settings.quiet) {
        fmt::print(stderr, "glitterpath: {}\n", text);
    }
}

Frame newFrameFor(GpDevice device, const RenderSettings& settings) {
    GpFrameDesc desc{};
    desc.width = settings.size.width;
    desc.height = settings.size.height;
    desc.mode = settings.local.mode;
    return newFrame(device, desc);
}

bool trace(GpDevice device, GpFrame frame, GpScene scene, const GpCameraDesc& camera,
           const RenderSettings& settings, const GpLocalLighting& local) {
    ProgressBar bar(stderrIsTerminal() && !settings.quiet);
    GpRenderOptions options = settings.options;
    options.local = local;
    options.exposureEv = static_cast<float>(settings.exposureEv.value_or(0.0));
    options.progress = &onProgress;
    options.progressUser = &bar;
    const GpError error = gpRender(frame, scene, &camera, &options);
    if (error == GP_ERROR_CANCELLED) {
        gpGetError(device, nullptr);  // it is no failure, so nobody shall find it later
        return false;
    }
    bar.clear();
    check(device, error);
    return true;
}

void appendColor(GpDevice device, GpFrame frame, const RenderSettings& settings,
                 std::vector<float>& pixels) {
    const std::size_t held = pixels.size();
    const std::size_t count = static_cast<std::size_t>(settings.size.width) * settings.size.height;
    pixels.resize(held + 4 * count);
    check(device, gpReadFrameImage(frame, GP_IMAGE_COLOR, pixels.data() + held,
                                   4 * count * sizeof(float)));
}

double exposeAutomatically(GpDevice device, GpFrame frame, const RenderSettings& settings) {
    std::vector<float> pixels;
    appendColor(device, frame, settings, pixels);
    const double ev = automaticExposureEv(pixels.data(), pixels.size() / 4);
    check(device, gpTonemapFrame(frame, static_cast<float>(ev), settings.options.tonemap));
    return ev;
}

}  // namespace gp::tool
