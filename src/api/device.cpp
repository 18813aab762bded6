// Devices, and the errors that belong to them.
#include "api/cancel.h"
#include "api/check.h"

namespace gp::api {

namespace {

constexpr uint32_t mostThreads = 1024;

BackendOptions backendOptions(const GpDeviceDesc& desc) {
    checkRange(desc.threads, 0, mostThreads, "threads");
    BackendOptions options;
    options.threads = desc.threads;
    if (!desc.instructionSet) return options;
    options.instructionSet = desc.instructionSet;
    for (const char* known : {"x86-64", "avx2", "avx512"})
        if (options.instructionSet == known) return options;
    fail(GP_ERROR_INVALID_ARGUMENT,
         "instructionSet is \"{}\", which is none of x86-64, avx2, avx512", options.instructionSet);
}

std::unique_ptr<Backend> newBackend(const GpDeviceDesc& desc) {
    const uint32_t kind = checkEnum(desc.backend, 4, "backend");
    const BackendOptions options = backendOptions(desc);
    if (kind == GP_BACKEND_NULL) return newNullBackend();
    if (kind == GP_BACKEND_VULKAN)
        fail(GP_ERROR_UNSUPPORTED, "this version has no Vulkan backend");
    try {
        return newCpuBackend(options);
    } catch (const std::runtime_error& e) {
        fail(GP_ERROR_UNSUPPORTED, "{}", e.what());
    }
}

GpDevice newDevice(const GpDeviceDesc& desc) {
    auto device = std::make_shared<DeviceObject>();
    device->backend = newBackend(desc);
    device->name = device->backend->name();
    device->threads = desc.threads;
    device->errorCallback = desc.errorCallback;
    device->errorUser = desc.errorUser;
    device->defaultMaterial = std::make_shared<const Material>();
    device->cancel = takeCancelFlag();
    if (!device->cancel)
        fail(GP_ERROR_TOO_LARGE, "{} devices are in use, which is the most", mostDevices);
    const GpDevice handle = publish<GpDevice>(device);
    device->self = bitsOf(handle);
    nameCancelFlag(device->cancel, device->self);
    return handle;
}

}  // namespace

DeviceObject::~DeviceObject() {
    if (cancel) returnCancelFlag(cancel);
}

ChildObject::ChildObject(DeviceObject& d)
    : device(std::static_pointer_cast<DeviceObject>(d.shared_from_this())) {}

}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpDevice gpNewDevice(const GpDeviceDesc* desc) {
    GpDevice device = nullptr;
    auto body = [&](Object*) { device = newDevice(desc ? *desc : GpDeviceDesc{}); };
    enterFree("gpNewDevice", BodyRef(body));
    return device;
}

GpError gpReleaseDevice(GpDevice device) {
    // Everything ends here, outside of the lock of the table; the device itself after its own.
    std::vector<std::shared_ptr<Object>> ended;
    return enter("gpReleaseDevice", "device", device,
                 [&](DeviceObject& d) { ended = handles().removeAllOf(d); });
}

const char* gpGetDeviceName(GpDevice device) {
    return enter("gpGetDeviceName", "device", device,
                 [](DeviceObject& d) { return d.name.c_str(); });
}

void gpCancelRender(GpDevice device) { requestCancel(bitsOf(device)); }

GpError gpGetError(GpDevice device, const char** message) {
    return takeError(bitsOf(device), message);
}

const char* gpErrorName(GpError error) {
#define GP_NAME(code) \
    case code: return #code;
    uint32_t number;  // through memcpy: any number may come from C
    std::memcpy(&number, &error, sizeof number);
    switch (number) {
        GP_NAME(GP_SUCCESS)
        GP_NAME(GP_ERROR_INVALID_HANDLE)
        GP_NAME(GP_ERROR_INVALID_ARGUMENT)
        GP_NAME(GP_ERROR_OUT_OF_RANGE)
        GP_NAME(GP_ERROR_NOT_FINITE)
        GP_NAME(GP_ERROR_TOO_LARGE)
        GP_NAME(GP_ERROR_INVALID_OPERATION)
        GP_NAME(GP_ERROR_DUPLICATE_ID)
        GP_NAME(GP_ERROR_OUT_OF_MEMORY)
        GP_NAME(GP_ERROR_UNSUPPORTED)
        GP_NAME(GP_ERROR_FILE_NOT_FOUND)
        GP_NAME(GP_ERROR_FILE_INVALID)
        GP_NAME(GP_ERROR_FILE_WRITE)
        GP_NAME(GP_ERROR_CANCELLED)
        default: return "GP_ERROR_UNKNOWN";
    }
#undef GP_NAME
}

}  // extern "C"
