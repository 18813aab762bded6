#include <array>
#include <numbers>

#include <glm/gtc/type_ptr.hpp>

#include "api/check.h"
#include "api/pixels.h"
#include "scene/cube_map.h"
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

constexpr uint32_t faceLimit = 4096;

// The textures themselves, looked at one by one.
std::array<const Texture*, 6> facesFrom(DeviceObject& device, const GpCubemapDesc& desc) {
    std::array<const Texture*, 6> faces{};
    for (size_t i = 0; i < faces.size(); ++i) {
        const std::string field = fmt::format("faces[{}]", i);
        const Texture& t = *resolve(device, desc.faces[i], field.c_str())->texture;
        const MipLevel& level = t.levels[0];
        faces[i] = &t;
        if (level.width != level.height)
            fail(GP_ERROR_INVALID_ARGUMENT, "{} has {} x {} pixels, which is no square", field,
                 level.width, level.height);
        if (level.width > faceLimit)
            fail(GP_ERROR_TOO_LARGE, "{} is {} pixels wide, more than {}", field, level.width,
                 faceLimit);
        if (level.width != faces[0]->levels[0].width)
            fail(GP_ERROR_INVALID_ARGUMENT, "{} is {} pixels wide, but faces[0] {}", field,
                 level.width, faces[0]->levels[0].width);
    }
    return faces;
}

// Float textures are finite, but may be below 0.
void checkRadiance(const CubeMap& cube) {
    const size_t face = size_t(cube.size) * cube.size;
    for (size_t i = 0; i < cube.texels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (!(cube.texels[i][c] >= 0))
                fail(GP_ERROR_OUT_OF_RANGE, "pixel {} of faces[{}] is {}", i % face, i / face,
                     cube.texels[i][c]);
}

glm::mat3 worldFromCubeOf(const GpCubemapDesc& desc) {
    checkFinite(desc.worldFromCube, 9, "worldFromCube");
    if (allZero(desc.worldFromCube, 9)) return glm::mat3(1);
    const glm::mat3 m = glm::transpose(glm::make_mat3(desc.worldFromCube));
    constexpr double exact = 1e-3;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            if (const double product = glm::dot(glm::dvec3(m[i]), glm::dvec3(m[j]));
                std::abs(product - (i == j)) > exact)
                fail(GP_ERROR_OUT_OF_RANGE,
                     "worldFromCube turns and scales: column {} times column {} is {:g}", i, j,
                     product);
    return m;
}

Environment environmentFrom(DeviceObject& device, const GpCubemapDesc& desc) {
    Environment environment;
    checkNotNegative(desc.color, 3, "color");
    environment.color = allZero(desc.color, 3) ? glm::vec3(1) : vec3From(desc.color);
    const glm::mat3 worldFromCube = worldFromCubeOf(desc);
    const CubeMap cube = cubeMapOf(facesFrom(device, desc));
    checkRadiance(cube);
    const LatLongImage image = latLongFromCube(cube, glm::transpose(worldFromCube));
    environment.table = makeEnvironmentTable(&image.pixels[0].x, image.width, image.height);
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

GpError gpSetCubemap(GpScene scene, const GpCubemapDesc* desc) {
    return enter("gpSetCubemap", "scene", scene, [&](SceneObject& s) {
        checkPointer(desc, "desc");
        replaceEnvironment(s.scene, environmentFrom(*s.device, *desc));
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
