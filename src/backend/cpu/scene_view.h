// A scene as the hot code sees it: plain pointers to flat tables that CpuScene owns. This header is
// compiled for several instruction sets, so it holds no inline code and no standard containers.
#pragma once

#include <cstdint>

#include "backend/cpu/embree_api.h"
#include "frame/frame_images.h"
#include "shared/scene_structs.h"

namespace gp {
class Sea;
struct Camera;
struct RealtimeViews;
enum class RealtimePass : uint32_t;
namespace shared {
struct RealtimeConstants;
struct PreviousInstance;
}  // namespace shared
}  // namespace gp

namespace gp::cpu {

struct TextureView {
    const uint8_t* levels[16];  // pixels of each level; the last is repeated
    uint32_t width, height;     // of level 0
    uint32_t levelCount;
    float halfLog2Texels;       // 0.5 log2(width * height)
    uint8_t isFloat, isSrgb, wrapU, wrapV;  // Wrap
    uint8_t magNearest, minNearest;
};

// An image of slope moments: gp::SlopeMap.
struct SlopeMapView {
    const void* levels[16];     // texels of each level, gp::PackedSlopes
    shared::SlopeMapSize size;
    uint8_t wrapU, wrapV;       // Wrap
};

// The vertex arrays of one mesh.
struct GeometryView {
    const glm::uvec3* triangles;
    const glm::vec3* positions;
    const void* vertices;       // gp::ShadingVertex: normal, tangent, uv
    const glm::vec2* uv1;       // null: none
    const glm::u8vec4* colors;  // null: none
    uint32_t latticeColumns;    // of vertices, where Embree has a lattice for the triangles; or 0
    uint32_t latticeRows;
};

// EnvironmentTable of scene/environment_table.h.
struct EnvironmentView {
    const uint32_t* texels;     // null: uniform
    const shared::EnvironmentCell* cells;
    const uint16_t* densities;
    uint32_t width, height, side;
    float texelScale, densityScale;
    const glm::vec3* rowMeans;  // null: uniform
};

// SkyPyramid of scene/sky_pyramid.h.
struct SkyLevelView {
    const glm::vec3* texels;    // 6 (size + 2)^2
    uint32_t size;
};
struct SkyPyramidView {
    SkyLevelView levels[12];
    SkyLevelView irradiance;
    uint32_t levelCount;
};

struct SceneView {
    RTCScene scene;             // null: empty
    RTCScene sky;               // sky geometry; null: none
    const shared::InstanceRecord* instances;
    const GeometryView* geometries;
    const shared::MaterialRecord* materials;
    const void* bsdfs;          // shading::BsdfParams, a type of each translation unit
    const shared::BsdfLayerRecord* bsdfLayers;
    const shared::TextureLayerRecord* textureLayers;
    const shared::MaterialSlopes* materialSlopes;
    const TextureView* textures;
    const SlopeMapView* slopeMaps;
    const shared::LightRecord* lights;        // directional ones first
    const shared::LightTreeNode* lightTree;
    const uint32_t* lightOfTriangle;          // InstanceRecord::light_map + primitive
    EnvironmentView environment;
    const uint32_t* lightOfPrimitive[4];  // of the geometries after the instances: lights' shapes
    uint32_t instanceCount, lightCount, lightTreeNodes, directionalLights;
    glm::vec3 environmentColor;
    glm::vec3 environmentMean;                // radiance over the sphere
    float environmentCos, environmentSin;     // of its rotation
    float environmentPower;                   // luminance of the irradiance, W/m^2
    const Sea* sea;                           // null: none
    shared::SeaSlopes (*seaSlopes)(const Sea& sea, glm::vec2 rest, glm::vec2 d0, glm::vec2 d1);
    EnvironmentView background;               // the scene's own, as rays without weights see it
    glm::vec3 backgroundColor;
};

// A row of texels of one face of a cube of all directions.
struct SkyRowJob {
    const SceneView* scene;
    const shared::FrameConstants* frame;
    uint32_t face, row, size, samples;
    glm::vec3* texels;
};

// Rays as they were traced, for the benchmark that traces them again with bare Embree.
struct RecordedRay {
    float origin[3], direction[3], tNear, tFar;
};
struct RayRecorder {
    RecordedRay* rays[3];       // camera, bounce, shadow
    uint64_t count[3], capacity;
};

// One rectangle of pixels and one run of samples.
struct TileJob {
    const SceneView* scene;
    const shared::FrameConstants* frame;
    const Camera* camera;
    PixelSums* sums;
    uint32_t x0, y0, x1, y1;
    uint32_t firstSample, sampleCount;
    RayRecorder* recorder;      // null: none
};

struct TileCounts {
    uint64_t camera, bounce, shadow;
    float lightSent[3], lightArrived[3];  // by shadow rays, for each group of lights
};

// The same for GP_MODE_LOCAL.
struct LocalTileJob {
    TileJob tile;
    const shared::LocalLightingConstants* local;
    const void* model;          // shading::BsdfParams in every material's place, or null
    const SkyPyramidView* sky;  // where LocalLightingConstants::sky_nodes is not 0
};

// A rectangle of a real-time pass, in pixels of the images that it writes.
struct RealtimeTileJob {
    TileJob tile;               // without sums and samples
    const shared::RealtimeConstants* realtime;
    const Camera* previousCamera;
    const RealtimeViews* images;
    const shared::PreviousInstance* previousInstances;
    const glm::vec3* const* previousPositions;  // by instance
    const uint32_t* currentOfPrevious;
    const uint32_t* currentLightOfPrevious;
    RealtimePass pass;
    // What each pixel costs is added to, row after row; null: nobody asked.
    float* pixelRays;
    uint64_t* pixelTicks;       // of the time-stamp counter
};

// The hot code, once for each instruction set (isa/).
struct IsaKernels {
    const char* name;
    TileCounts (*traceTile)(const TileJob& job);
    void (*tonemap)(const PixelSums* sums, glm::u8vec4* display, size_t count, float exposureEv,
                    uint32_t tonemap);
    void (*traceSkyRow)(const SkyRowJob& job);
    void (*alphaFilter)(const RTCFilterFunctionNArguments* arguments);
};

// Apart from the path tracer: in one object with it, functions that both call would no longer be
// inlined there.
struct LocalKernels {
    TileCounts (*lightTile)(const LocalTileJob& job);
};

struct RealtimeKernels {
    TileCounts (*runTile)(const RealtimeTileJob& job);
    // Every fourth pixel of every fourth row.
    void (*luminanceHistogram)(const RealtimeViews& images, uint32_t* bins);
    // `count` pixels of the output image, from `first` on.
    void (*tonemap)(const RealtimeViews& images, glm::u8vec4* display, size_t first, size_t count,
                    float exposureEv, uint32_t tonemap);
};

}  // namespace gp::cpu
