#include "library.h"

#include "tool_error.h"

namespace gp::tool {
namespace {

// Messages of the library begin with the name of the call, which says nothing to people who do
// not program.
std::string withoutCallName(const std::string& message) {
    const std::size_t colon = message.find(": ");
    if (message.rfind("gp", 0) == 0 && colon != std::string::npos &&
        message.find(' ') == colon + 1) {
        return message.substr(colon + 2);
    }
    return message;
}

[[noreturn]] void fail(GpDevice device, GpError error) {
    const char* message = nullptr;
    const GpError known = gpGetError(device, &message);
    if (known == GP_SUCCESS || message == nullptr || *message == '\0') {
        throw RunError(gpErrorName(error));
    }
    throw RunError(withoutCallName(message));
}

}  // namespace

void check(GpDevice device, GpError error) {
    if (error != GP_SUCCESS) {
        fail(device, error);
    }
}

LoadedImage::LoadedImage(GpDevice device, const std::string& path) {
    check(device, gpLoadImage(device, path.c_str(), &m_image));
}

Device newDevice(const GpDeviceDesc& desc) {
    Device device(gpNewDevice(&desc));
    if (!device) {
        fail(nullptr, GP_ERROR_UNKNOWN);
    }
    return device;
}

Scene newScene(GpDevice device) {
    Scene scene(gpNewScene(device));
    if (!scene) {
        fail(device, GP_ERROR_UNKNOWN);
    }
    return scene;
}

Frame newFrame(GpDevice device, const GpFrameDesc& desc) {
    Frame frame(gpNewFrame(device, &desc));
    if (!frame) {
        fail(device, GP_ERROR_UNKNOWN);
    }
    return frame;
}

}  // namespace gp::tool
