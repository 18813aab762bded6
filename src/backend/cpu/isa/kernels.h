// The hot code: the kernels of src/kernels with the CPU's resource functions around them. Compiled
// once for each instruction set (isa/*.cpp); everything has internal linkage, so that the linker
// cannot hand one set's code to another.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "backend/cpu/scene_view.h"
#include "frame/camera_params.h"
#include "scene/camera.h"
#include "shading/shading.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

namespace gp::cpu {
namespace {

using namespace glm;
using namespace gp::shading;
using namespace gp::shared;

#include "backend/cpu/texture_sampling.h"

// Ray masks: VisibilityBits of scene/scene.h.
constexpr uint32_t rayCamera = 1, rayBounce = 2, rayShadow = 4, raySky = 8;

// As scene/mesh.h lays it out.
struct PackedVertex {
    uint32_t normal, tangent;
    vec2 uv;
};

struct Kernels {
    const SceneView& view;
    const FrameConstants& constants;
    QueryContext query{};
    TileCounts counts{};
    RayRecorder* recorder = nullptr;
    uint32_t pathSeed = 0;  // of the path being traced: each of its rays gets an alpha seed from it

    Kernels(const SceneView& v, const FrameConstants& f) : view(v), constants(f) {}

    // Frame and tables.
    const FrameConstants& load_frame() { return constants; }
    const InstanceRecord& load_instance(uint i) { return view.instances[i]; }
    const MaterialRecord& load_material(uint i) { return view.materials[i]; }
    const BsdfParams& load_bsdf(uint i) { return static_cast<const BsdfParams*>(view.bsdfs)[i]; }
    const BsdfLayerRecord& load_bsdf_layer(uint i) { return view.bsdfLayers[i]; }
    const TextureLayerRecord& load_texture_layer(uint i) { return view.textureLayers[i]; }
    const MaterialSlopes& load_material_slopes(uint i) { return view.materialSlopes[i]; }
    const LightRecord& load_light(uint i) { return view.lights[i]; }
    const LightTreeNode& load_light_node(uint i) { return view.lightTree[i]; }
    uint load_light_of_triangle(uint instance, uint primitive) {
        const uint map = view.instances[instance].light_map;
        return map == NO_INDEX ? NO_INDEX : view.lightOfTriangle[map + primitive];
    }

    // Geometry.
    TriangleCorners load_triangle(uint geometry, uint primitive) {
        const GeometryView& g = view.geometries[geometry];
        const uvec3 t = g.triangles[primitive];
        const auto* vertices = static_cast<const PackedVertex*>(g.vertices);
        const PackedVertex &a = vertices[t.x], &b = vertices[t.y], &c = vertices[t.z];
        TriangleCorners r;
        r.p0 = g.positions[t.x], r.p1 = g.positions[t.y], r.p2 = g.positions[t.z];
        r.normal0 = a.normal, r.normal1 = b.normal, r.normal2 = c.normal;
        r.tangent0 = a.tangent, r.tangent1 = b.tangent, r.tangent2 = c.tangent;
        r.uv0 = a.uv, r.uv1 = b.uv, r.uv2 = c.uv;
        r.pad0 = 0;
        return r;
    }
    // What load_triangle will read, in two steps of one look-up each.
    void expectTriangle(const Hit& hit) {
        if (hit.instance >= HIT_LIGHT) return;
        const GeometryView& g = view.geometries[view.instances[hit.instance].geometry];
        __builtin_prefetch(g.triangles + hit.primitive);
    }
    void expectCorners(const Hit& hit) {
        if (hit.instance >= HIT_LIGHT) return;
        const GeometryView& g = view.geometries[view.instances[hit.instance].geometry];
        const uvec3 t = g.triangles[hit.primitive];
        const auto* vertices = static_cast<const PackedVertex*>(g.vertices);
        for (int i = 0; i < 3; ++i) {
            __builtin_prefetch(g.positions + t[i]);
            __builtin_prefetch(vertices + t[i]);
        }
    }
    vec2 load_uv1(uint geometry, uint primitive, float u, float v) {
        const GeometryView& g = view.geometries[geometry];
        if (!g.uv1) return vec2(0);
        const uvec3 t = g.triangles[primitive];
        return interpolate(g.uv1[t.x], g.uv1[t.y], g.uv1[t.z], u, v);
    }
    vec4 load_vertex_color(uint geometry, uint primitive, float u, float v) {
        const GeometryView& g = view.geometries[geometry];
        if (!g.colors) return vec4(1);
        const uvec3 t = g.triangles[primitive];
        return (vec4(g.colors[t.x]) * (1.0f - u - v) + vec4(g.colors[t.y]) * u +
                vec4(g.colors[t.z]) * v) *
               (1.0f / 255.0f);
    }
    vec4 sample_texture(uint texture, vec2 uv, float lod, float uLod) {
        return sampleTexture(view.textures[texture], uv, lod, uLod);
    }

    const SlopeMapSize& load_slope_map(uint map) { return view.slopeMaps[map].size; }
    Slopes load_slopes(uint map, int level, int x, int y) {
        const SlopeMapView& m = view.slopeMaps[map];
        const int w = std::max(int(m.size.width >> level), 1);
        const int h = std::max(int(m.size.height >> level), 1);
        const auto* texels = static_cast<const SlopeTexel*>(m.levels[level]);
        return slope_texel_decode(texels[size_t(wrapTexel(y, h, m.wrapV)) * size_t(w) +
                                         size_t(wrapTexel(x, w, m.wrapU))]);
    }

    // Environment.
    vec3 load_environment(vec2 uv) { return readBilinear(view.environment, uv); }
    vec3 load_background(vec2 uv) { return readBilinear(view.background, uv); }
    static vec3 readBilinear(const EnvironmentView& e, vec2 uv) {
        const int w = int(e.width), h = int(e.height);
        const float fx = uv.x * float(w) - 0.5f, fy = uv.y * float(h) - 0.5f;
        const int ix = floorToInt(fx), iy = floorToInt(fy);
        const float ax = fx - float(ix), ay = fy - float(iy);
        const int x0 = wrapTexel(ix, w, 0), x1 = wrapTexel(ix + 1, w, 0);
        const uint32_t* top = e.texels + size_t(wrapTexel(iy, h, 1)) * size_t(w);
        const uint32_t* low = e.texels + size_t(wrapTexel(iy + 1, h, 1)) * size_t(w);
        return e.texelScale * mix(mix(unpackRadiance(top[x0]), unpackRadiance(top[x1]), ax),
                                  mix(unpackRadiance(low[x0]), unpackRadiance(low[x1]), ax), ay);
    }
    void prefetch_environment(vec2 uv) {
        const EnvironmentView& e = view.environment;
        const int x = std::clamp(int(uv.x * float(e.width) - 0.5f), 0, int(e.width) - 1);
        const int y = std::clamp(int(uv.y * float(e.height) - 0.5f), 0, int(e.height) - 1);
        const uint32_t* top = e.texels + size_t(y) * e.width + size_t(x);
        __builtin_prefetch(top);
        __builtin_prefetch(y + 1 < int(e.height) ? top + e.width : top);
    }
    void prefetch_environment_cell(uint i) { __builtin_prefetch(view.environment.cells + i); }
    void prefetch_environment_density(uint i) {
        __builtin_prefetch(view.environment.densities + i);
    }
    const EnvironmentCell& load_environment_cell(uint i) { return view.environment.cells[i]; }
    float load_environment_density(uint i) {
        const EnvironmentView& e = view.environment;
        return std::bit_cast<float>(uint32_t(e.densities[i]) << 16) * e.densityScale;
    }

    // Rays.
    Hit trace_closest(const Ray& ray);
    float trace_visible(const Ray& ray);
    Hit trace_sky(const Ray& ray);
    Hit trace(RTCScene scene, const Ray& ray, uint32_t mask);
    void note_shadow_ray(uint group, float value, float visible) {
        counts.lightSent[group] += value;
        counts.lightArrived[group] += value * visible;
    }
    void trace_camera(const Ray* rays, const uint32_t* alphaSeeds, Hit* hits, uint32_t count);

    uint32_t nextAlphaSeed() { return pathSeed = hash_u32(pathSeed + 0x9E3779B9u); }
    void record(uint32_t kind, const Ray& ray) const;

    // The sea. The one call out of the hot code: its tables are read in one place, by Ocean.
    SeaSlopes sample_sea(vec2 rest, vec2 d0, vec2 d1) {
        return view.seaSlopes(*view.sea, rest, d0, d1);
    }

#include "kernels/environment.glsl"
#include "kernels/surface.glsl"
#include "kernels/material.glsl"
#include "kernels/sky.glsl"
#include "kernels/light_choice.glsl"
#include "kernels/leaving_ray.glsl"
#include "kernels/path.glsl"
#include "kernels/primary.glsl"
};

using PathState = Kernels::PathState;
using PathGuides = Kernels::PathGuides;

#include "backend/cpu/isa/camera_params.h"
#include "backend/cpu/isa/tonemap_row.h"
#include "backend/cpu/lattice_hit.h"
#include "backend/cpu/ray_tracing.h"
#include "backend/cpu/tile.h"

}  // namespace
}  // namespace gp::cpu

#pragma GCC diagnostic pop
