#include <numbers>

#include "api/check.h"
#include "api/pixels.h"
#include "scene/environment_table.h"
#include "scene/sky.h"

namespace gp::api {

namespace {

constexpr uint32_t sideLimit = 32768;
constexpr uint64_t pixelLimit = uint64_t(1) << 28;

// Colour and rotation; the image comes from elsewhere.
Environment tintFrom(const GpEnvironmentDesc& desc, bool hasImage) {
    checkNotNegative(desc.color, 3, "color");
    checkFinite(desc.rotation, "rotation");
    Environment environment;
    environment.color = vec3From(desc.color);
    if (hasImage && allZero(desc.color, 3)) environment.color = glm::vec3(1);
    environment.rotation = desc.rotation;
    return environment;
}

Environment environmentFrom(const GpEnvironmentDesc& desc) {
    if (desc.width == 0 && desc.height == 0) {
        if (desc.pixels)
            fail(GP_ERROR_INVALID_ARGUMENT, "width and height are 0, but pixels is not NULL");
        return tintFrom(desc, false);
    }
    checkImageSize(desc.width, desc.height, sideLimit, pixelLimit);
    checkPointer(desc.pixels, "pixels");
    const size_t count = size_t(desc.width) * desc.height * 4;
    checkNotNegative(desc.pixels, count, "pixels");
    Environment environment = tintFrom(desc, true);
    environment.table = makeEnvironmentTable(desc.pixels, desc.width, desc.height);
    return environment;
}

Environment environmentFrom(const char* path, const GpEnvironmentDesc& desc) {
    Environment environment = tintFrom(desc, true);
    const ImageFile file = readImageFile(path);
    if (file.displayReferred)
        fail(GP_ERROR_FILE_INVALID, "{}: is neither Radiance HDR nor EXR", path);
    std::vector<float> rgba = linearPixels(file);
    for (size_t i = 0; i < rgba.size(); ++i) {
        if (!std::isfinite(rgba[i]))
            fail(GP_ERROR_FILE_INVALID, "{}: pixel {} is {}", path, i / 4, rgba[i]);
        // Resampling filters of other programs leave small negative values beside bright ones.
        rgba[i] = std::max(rgba[i], 0.0f);
    }
    environment.table =
        makeEnvironmentTable(rgba.data(), file.image.width, file.image.height);
    return environment;
}

// A sky's sun goes with its sky.
void replaceEnvironment(Scene& scene, Environment&& environment) {
    removeSkySun(scene);
    scene.environment = std::move(environment);
    ++scene.revision;
}

}  // namespace
}  // namespace gp::api

using namespace gp::api;

extern "C" {

GpError gpSetEnvironment(GpScene scene, const GpEnvironmentDesc* desc) {
    return enter("gpSetEnvironment", "scene", scene, [&](SceneObject& s) {
        replaceEnvironment(s.scene, desc ? environmentFrom(*desc) : gp::Environment{});
    });
}

GpError gpSetEnvironmentFromFile(GpScene scene, const char* path, const GpEnvironmentDesc* desc) {
    return enter("gpSetEnvironmentFromFile", "scene", scene, [&](SceneObject& s) {
        checkPath(path);
        replaceEnvironment(s.scene, environmentFrom(path, desc ? *desc : GpEnvironmentDesc{}));
    });
}

GpError gpSetSky(GpScene scene, float sunAzimuth, float sunElevation, float sunLux) {
    return enter("gpSetSky", "scene", scene, [&](SceneObject& s) {
        checkFinite(sunAzimuth, "sunAzimuth");
        checkRange(sunElevation, 0, float(std::numbers::pi / 2), "sunElevation");
        checkNotNegative(sunLux, "sunLux");
        gp::setSky(s.scene, sunAzimuth, sunElevation, sunLux);
    });
}

}  // extern "C"
