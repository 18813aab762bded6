// The C interface with owners that release, and errors that are thrown.
#pragma once

#include <glitterpath/glitterpath.h>

#include <memory>
#include <string>

namespace gp::tool {

template <auto release>
struct Releaser {
    template <class Handle>
    void operator()(Handle* handle) const { release(handle); }
};

template <class Impl, auto release>
using Owner = std::unique_ptr<Impl, Releaser<release>>;

using Device = Owner<GpDeviceImpl, &gpReleaseDevice>;
using Scene = Owner<GpSceneImpl, &gpReleaseScene>;
using Frame = Owner<GpFrameImpl, &gpReleaseFrame>;

// Pixels of the library.
class LoadedImage {
public:
    LoadedImage(GpDevice device, const std::string& path);
    ~LoadedImage() { gpFreeImage(&m_image); }
    LoadedImage(const LoadedImage&) = delete;
    LoadedImage& operator=(const LoadedImage&) = delete;

    const GpImage& get() const { return m_image; }

private:
    GpImage m_image{};
};

// All of these throw RunError with the library's own line.
void check(GpDevice device, GpError error);
Device newDevice(const GpDeviceDesc& desc);
Scene newScene(GpDevice device);
Frame newFrame(GpDevice device, const GpFrameDesc& desc);

}  // namespace gp::tool
