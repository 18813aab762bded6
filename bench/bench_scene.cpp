#include "bench_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/gltf.h"
#include "io/image_file.h"
#include "scene/environment_table.h"
#include "scene/sky.h"

namespace gp::bench {
namespace {

constexpr float sunAngularRadius = 0.00459f;  // half of the 0.00918 rad of the Cycles script

float radians(double degrees) { return float(degrees * std::numbers::pi / 180); }

glm::vec3 point(const std::vector<float>& v) { return {v[0], v[1], v[2]}; }

void setEnvironment(Scene& scene, const SceneOptions& options) {
    Image image = io::loadImage(options.environment);
    if (image.format != PixelFormat::rgba32f)
        throw io::FileError(io::FileError::Kind::invalid, options.environment, "holds no radiance");
    float* p = image.floats();
    for (size_t i = 0; i < size_t(image.width) * image.height * 4; ++i) p[i] = std::max(p[i], 0.0f);
    scene.environment.table = makeEnvironmentTable(p, image.width, image.height);
    scene.environment.color = glm::vec3(1);
    scene.environment.rotation = radians(options.environmentRotationDeg);
}

void addSun(Scene& scene, const std::vector<float>& sun) {
    const float azimuth = radians(sun[0]), elevation = radians(sun[1]);
    auto light = std::make_shared<Light>();
    light->kind = LightKind::directional;
    light->emission = glm::vec3(sun[2]);
    light->angularRadius = sunAngularRadius;
    light->direction = {-std::sin(azimuth) * std::cos(elevation), -std::sin(elevation),
                        std::cos(azimuth) * std::cos(elevation)};
    scene.lights.push_back(std::move(light));
}

bool hasLight(const Scene& scene) {
    if (!scene.lights.empty() || scene.environment.color != glm::vec3(0)) return true;
    return std::any_of(scene.instances.begin(), scene.instances.end(), [](const auto& instance) {
        return instance->surface().emission != glm::vec3(0);
    });
}

}  // namespace

Scene loadScene(const SceneOptions& options) {
    Scene scene;
    io::loadGltf(options.path, {}, scene);
    if (!options.environment.empty()) setEnvironment(scene, options);
    if (!options.sun.empty()) addSun(scene, options.sun);
    if (!hasLight(scene)) setSky(scene, radians(225), radians(40), 0);  // as the command does
    ++scene.revision;
    return scene;
}

Camera chooseCamera(const Scene& scene, const SceneOptions& options) {
    Camera camera;
    if (!options.from.empty() && !options.lookAt.empty()) {
        camera.position = point(options.from), camera.target = point(options.lookAt);
    } else if (!scene.cameras.empty()) {
        camera = scene.cameras.front();
    } else {
        camera = frameScene(scene, float(options.width) / float(options.height));
    }
    if (options.fovDeg > 0) camera.verticalFov = radians(options.fovDeg);
    return camera;
}

}  // namespace gp::bench
