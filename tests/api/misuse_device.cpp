#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

Outcome newDevice(void (*change)(GpDeviceDesc&)) {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;
    change(desc);
    return made(gpNewDevice(&desc));
}

// These calls note no error: gpGetError is the one that tells, the others cannot fail.
void addSilentRows(Rows& rows) {
    const auto add = [&](const char* call, const char* what, GpError expected,
                         std::function<Outcome(World&)> run) {
        rows.push_back({call, what, expected, "", std::move(run), true});
    };
    add("gpGetError", "released device", GP_ERROR_INVALID_HANDLE,
        [](World& w) { return gpGetError(w.released.device, nullptr); });
    add("gpGetError", "handle of a mesh", GP_ERROR_INVALID_HANDLE, [](World& w) {
        return gpGetError(reinterpret_cast<GpDevice>(w.mesh), nullptr);
    });
    add("gpGetError", "nothing to tell", GP_SUCCESS,
        [](World& w) { return gpGetError(w.device, nullptr); });
    add("gpErrorName", "a number that is no code", GP_SUCCESS, [](World&) {
        return std::string(gpErrorName(anyEnum<GpError>(9999))) == "GP_ERROR_UNKNOWN" ? GP_SUCCESS
                                                                            : GP_ERROR_UNKNOWN;
    });
    add("gpCancelRender", "NULL, released and wrong handles", GP_SUCCESS, [](World& w) {
        gpCancelRender(nullptr);
        gpCancelRender(w.released.device);
        gpCancelRender(reinterpret_cast<GpDevice>(w.frame));
        gpCancelRender(reinterpret_cast<GpDevice>(&w));
        return GP_SUCCESS;
    });
    add("gpCancelRender", "nothing is running", GP_SUCCESS, [](World& w) {
        const GpFrameDesc size = {2, 2, GP_MODE_REFERENCE};
        const GpFrame frame = gpNewFrame(w.device, &size);
        gpCancelRender(w.device);
        const GpRenderOptions two = fewSamples(2);  // the next render is not the one meant
        return gpRender(frame, w.scene, nullptr, &two);
    });
}

}  // namespace

Rows deviceRows() {
    Rows rows = {
        {"gpNewDevice", "unknown backend", GP_ERROR_INVALID_ARGUMENT, "backend is 4",
         [](World&) {
             return newDevice([](GpDeviceDesc& d) { d.backend = anyEnum<GpBackend>(4); });
         }},
        {"gpNewDevice", "negative backend", GP_ERROR_INVALID_ARGUMENT, "backend",
         [](World&) {
             return newDevice([](GpDeviceDesc& d) { d.backend = anyEnum<GpBackend>(-1); });
         }},
        {"gpNewDevice", "Vulkan", GP_ERROR_UNSUPPORTED, "Vulkan",
         [](World&) {
             return newDevice([](GpDeviceDesc& d) { d.backend = GP_BACKEND_VULKAN; });
         }},
        {"gpNewDevice", "too many threads", GP_ERROR_OUT_OF_RANGE, "threads is 1025",
         [](World&) { return newDevice([](GpDeviceDesc& d) { d.threads = 1025; }); }},
        {"gpNewDevice", "unknown instruction set", GP_ERROR_INVALID_ARGUMENT, "\"neon\"",
         [](World&) { return newDevice([](GpDeviceDesc& d) { d.instructionSet = "neon"; }); }},
        {"gpNewDevice", "empty instruction set", GP_ERROR_INVALID_ARGUMENT, "instructionSet",
         [](World&) { return newDevice([](GpDeviceDesc& d) { d.instructionSet = ""; }); }},
        {"gpNewDevice", "more than 256 at once", GP_ERROR_TOO_LARGE, "256 devices",
         [](World&) {
             std::vector<GpDevice> many;
             while (GpDevice one = newNullDevice()) many.push_back(one);
             for (GpDevice one : many) gpReleaseDevice(one);
             return std::nullopt;
         }},
    };
    addHandleRows<GpDevice>(rows, "gpReleaseDevice", "device",
                            [](World&, GpDevice d) { return gpReleaseDevice(d); });
    addHandleRows<GpDevice>(rows, "gpGetDeviceName", "device",
                            [](World&, GpDevice d) { return made(gpGetDeviceName(d)); });
    addSilentRows(rows);
    return rows;
}

}  // namespace gp::test
