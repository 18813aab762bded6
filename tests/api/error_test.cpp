// How errors are told: per thread, per device, first one kept; callbacks.
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "api/world.h"

namespace gp::test {

namespace {

TEST(Errors, EveryCodeHasItsName) {
    EXPECT_STREQ(gpErrorName(GP_SUCCESS), "GP_SUCCESS");
    EXPECT_STREQ(gpErrorName(GP_ERROR_UNKNOWN), "GP_ERROR_UNKNOWN");
    EXPECT_STREQ(gpErrorName(GP_ERROR_NOT_FINITE), "GP_ERROR_NOT_FINITE");
    EXPECT_STREQ(gpErrorName(GP_ERROR_CANCELLED), "GP_ERROR_CANCELLED");
    for (int code = 2; code <= GP_ERROR_CANCELLED; ++code)
        EXPECT_STRNE(gpErrorName(anyEnum<GpError>(code)), "GP_ERROR_UNKNOWN") << code;
}

TEST(Errors, TheFirstOneIsKeptUntilItIsAskedFor) {
    World w;
    EXPECT_EQ(gpNewMesh(w.device, nullptr), nullptr);
    EXPECT_EQ(gpSetSky(w.scene, 0, -1, 0), GP_ERROR_OUT_OF_RANGE);
    const char* message = nullptr;
    EXPECT_EQ(gpGetError(w.device, &message), GP_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(message, "gpNewMesh: desc is NULL");
    EXPECT_EQ(gpGetError(w.device, &message), GP_SUCCESS);
    EXPECT_STREQ(message, "");
}

TEST(Errors, SuccessDoesNotForgetAnError) {
    World w;
    EXPECT_EQ(gpSetSky(w.scene, 0, -1, 0), GP_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(gpSetSky(w.scene, 0, 1, 0), GP_SUCCESS);
    EXPECT_EQ(gpGetError(w.device, nullptr), GP_ERROR_OUT_OF_RANGE);
}

TEST(Errors, DevicesAndNoDeviceAreKeptApart) {
    World w;
    gpSetSky(w.foreign.scene, 0, -1, 0);
    gpReleaseMesh(nullptr);
    EXPECT_EQ(gpGetError(w.device, nullptr), GP_SUCCESS);
    EXPECT_EQ(gpGetError(nullptr, nullptr), GP_ERROR_INVALID_HANDLE);
    EXPECT_EQ(gpGetError(w.foreign.device, nullptr), GP_ERROR_OUT_OF_RANGE);
}

TEST(Errors, AThreadSeesOnlyItsOwn) {
    World w;
    gpSetSky(w.scene, 0, -1, 0);
    GpError other = GP_ERROR_UNKNOWN, others = GP_ERROR_UNKNOWN;
    std::thread([&] {
        other = gpGetError(w.device, nullptr);
        gpNewMesh(w.device, nullptr);
        others = gpGetError(w.device, nullptr);
    }).join();
    EXPECT_EQ(other, GP_SUCCESS);
    EXPECT_EQ(others, GP_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(gpGetError(w.device, nullptr), GP_ERROR_OUT_OF_RANGE);
}

struct Heard {
    int calls = 0;
    GpError last = GP_SUCCESS;
    std::string message;
    std::thread::id thread;
    GpDevice device = nullptr;
    GpError nested = GP_SUCCESS;
};

void hear(void* user, GpError error, const char* message) {
    Heard& heard = *static_cast<Heard*>(user);
    ++heard.calls;
    heard.last = error;
    heard.message = message;
    heard.thread = std::this_thread::get_id();
}

// Does what the header forbids: it must be refused, not wait for itself for ever.
void hearAndCall(void* user, GpError error, const char* message) {
    hear(user, error, message);
    Heard& heard = *static_cast<Heard*>(user);
    heard.nested = gpReleaseDevice(heard.device);
}

GpDevice deviceWith(GpErrorCallback callback, void* user) {
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;
    desc.errorCallback = callback;
    desc.errorUser = user;
    return gpNewDevice(&desc);
}

TEST(Errors, TheCallbackHearsEachFailureOnce) {
    Heard heard;
    const GpDevice device = deviceWith(hear, &heard);
    const GpScene scene = gpNewScene(device);
    EXPECT_EQ(heard.calls, 0);
    gpSetSky(scene, 0, -1, 0);
    EXPECT_EQ(heard.calls, 1);
    EXPECT_EQ(heard.last, GP_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(heard.thread, std::this_thread::get_id());
    EXPECT_EQ(heard.message, "gpSetSky: sunElevation is -1, outside of 0..1.5708");
    gpNewMesh(device, nullptr);  // the second one too, although gpGetError keeps the first
    EXPECT_EQ(heard.calls, 2);
    EXPECT_EQ(heard.last, GP_ERROR_INVALID_ARGUMENT);
    gpReleaseDevice(device);
    EXPECT_EQ(heard.calls, 2);
}

TEST(Errors, ACallFromACallbackIsRefused) {
    Heard heard;
    heard.device = deviceWith(hearAndCall, &heard);
    gpNewMesh(heard.device, nullptr);
    EXPECT_EQ(heard.calls, 1);
    EXPECT_EQ(heard.nested, GP_ERROR_INVALID_OPERATION);
    EXPECT_EQ(gpReleaseDevice(heard.device), GP_SUCCESS) << "the device must still be there";
}

TEST(Errors, AThrowingCallbackDoesNotUnwindThroughTheLibrary) {
    const GpDevice device =
        deviceWith([](void*, GpError, const char*) { throw 1; }, nullptr);
    EXPECT_EQ(gpNewMesh(device, nullptr), nullptr);
    EXPECT_EQ(gpGetError(device, nullptr), GP_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(gpReleaseDevice(device), GP_SUCCESS);
}

}  // namespace
}  // namespace gp::test
