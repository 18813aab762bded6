#include "frame/frame_sky.h"

#include <algorithm>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include "frame/compose.h"
#include "shading/shading.h"

namespace gp {
namespace {

// Where nothing is drawn, rays see the sky itself, and the table only says where to look: it may be
// coarse.
constexpr uint32_t guideSize = 32;

bool hasSkyGeometry(const Scene& scene) {
    return std::any_of(scene.instances.begin(), scene.instances.end(), [](const auto& instance) {
        return (instance->visibility & visibleToSky) != 0;
    });
}

// Those that are drawn in the world; what is drawn in pixels, or through a matrix of its own, says
// nothing about other directions than the picture's.
std::vector<const DrawCommand*> skyDraws(const FramePlan& plan) {
    std::vector<const DrawCommand*> draws;
    if (plan.mode != FrameMode::realtime || !plan.draws) return draws;
    for (const DrawCommand& draw : *plan.draws)
        if (draw.target == DrawTarget::sky && draw.view == DrawView::camera)
            draws.push_back(&draw);
    return draws;
}

// A face is seen by a camera with its middle ahead and t downwards. Cube maps are left-handed: the
// camera's right is where s is small.
Camera cameraOfFace(uint32_t face) {
    Camera camera;
    camera.target = shading::cube_direction(face, {0.5f, 0.5f});
    camera.up = shading::cube_direction(face, {0.5f, 0.0f}) - camera.target;
    camera.verticalFov = 1.5707964f;
    return camera;
}

}  // namespace

SkySource skySourceOf(const Scene& scene, const FramePlan& plan) {
    SkySource source;
    source.geometry = hasSkyGeometry(scene);
    if (source.geometry) source.revision = scene.revision, source.viewer = plan.skyViewer;
    const Environment& environment = scene.environment;
    source.image = environment.table, source.color = environment.color;
    source.rotation = environment.rotation;
    return source;
}

uint32_t skySamples(const SkySource& source) {
    const uint32_t width = source.image ? source.image->width : 0;
    return std::clamp(width / (4 * source.size), source.geometry ? 2u : 1u, 8u);
}

void FrameSky::update(Backend& backend, const BackendScene& backendScene, const Scene& scene,
                      FramePlan& plan) {
    const std::vector<const DrawCommand*> draws = skyDraws(plan);
    SkySource source = skySourceOf(scene, plan);
    plan.sky = nullptr;
    plan.skyDrawn = !draws.empty();
    if (!source.geometry && draws.empty()) return forget();
    source.size = draws.empty() ? guideSize : plan.skyCubeSize;
    try {
        const bool changed = updateBackground(backend, backendScene, plan, source);
        if (!draws.empty()) drawFaces(backend, draws);
        if (changed || !draws.empty() || !table_)
            updateTable(draws.empty() ? background_ : drawn_, source.rotation);
    } catch (...) {
        forget();
        throw;
    }
    plan.sky = table_;
}

// True where it was made anew.
bool FrameSky::updateBackground(Backend& backend, const BackendScene& backendScene,
                                const FramePlan& plan, const SkySource& source) {
    if (source == source_) return false;
    if (source.size != source_.size) table_.reset();
    source_ = {};
    background_.size = source.size;
    background_.texels.assign(size_t(6) * source.size * source.size, glm::vec3(0));
    backend.traceSky(backendScene, plan, skySamples(source), background_);
    source_ = source;
    return true;
}

void FrameSky::drawFaces(Backend& backend, const std::vector<const DrawCommand*>& draws) {
    const uint32_t size = background_.size;
    const size_t count = size_t(size) * size;
    drawn_.size = size;
    drawn_.texels.resize(6 * count);
    std::vector<glm::vec4> color(count);
    std::vector<float> depth;
    // Rows the other way round: what the camera sees on its right has a small s.
    const auto mirrored = [&](size_t i) { return i - i % size + (size - 1 - i % size); };
    for (uint32_t face = 0; face < 6; ++face) {
        const Camera camera = cameraOfFace(face);
        const size_t first = face * count;
        for (size_t i = 0; i < count; ++i)
            color[i] = glm::vec4(background_.texels[first + mirrored(i)], 0);
        std::vector<PlacedDraw> placed;
        for (const DrawCommand* draw : draws)
            placed.push_back({draw, placeInWholeFrame(*draw, camera, size, size)});
        if (usesDepth(placed)) depth.assign(count, std::numeric_limits<float>::infinity());
        backend.rasterize(
            {size, size, color.data(), nullptr, depth.empty() ? nullptr : depth.data()}, placed);
        for (size_t i = 0; i < count; ++i)
            drawn_.texels[first + mirrored(i)] = glm::max(glm::vec3(color[i]), glm::vec3(0));
    }
}

// The image keeps the environment's axes, so that kernels need no other rotation for it.
void FrameSky::updateTable(const CubeMap& cube, float rotation) {
    const glm::mat3 cubeFromImage(
        glm::rotate(glm::mat4(1), rotation, glm::vec3(0, 1, 0)));
    if (!table_) image_ = {};
    if (image_.pixels.empty())
        image_ = latLongFromCube(cube, cubeFromImage);
    else
        latLongFromCube(cube, cubeFromImage, image_);
    // Another choice of directions would turn the same random numbers into other light, which the
    // denoiser must take for changed light: the old choice stays as long as it serves.
    if (!table_ || !refreshSkyTable(*table_, &image_.pixels[0].x))
        table_ = makeSkyTable(&image_.pixels[0].x, image_.width, image_.height);
}

}  // namespace gp
