// The resource functions of src/kernels over plain buffers, enough for the GLSL compiler to check
// every kernel. Rays go through all triangles: there is no acceleration structure in a compute
// shader here.
#include "shared/scene_structs.glsl"
#include "shading/bsdf/params.glsl"
#include "shading/camera.glsl"
#include "shading/slope/lean.glsl"

layout(std430, binding = 0) readonly buffer FrameBuffer { FrameConstants frame_constants; };
layout(std430, binding = 1) readonly buffer InstanceBuffer { InstanceRecord instances[]; };
layout(std430, binding = 2) readonly buffer MaterialBuffer { MaterialRecord materials[]; };
layout(std430, binding = 3) readonly buffer LightBuffer { LightRecord lights[]; };
layout(std430, binding = 4) readonly buffer LightTreeBuffer { LightTreeNode light_tree[]; };
layout(std430, binding = 5) readonly buffer LightMapBuffer { uint light_of_triangle[]; };
layout(std430, binding = 6) readonly buffer TriangleBuffer { TriangleCorners triangles[]; };
layout(std430, binding = 7) readonly buffer EnvironmentBuffer {
    EnvironmentCell environment_cells[];
};
layout(std430, binding = 8) readonly buffer DensityBuffer { float environment_densities[]; };
layout(std430, binding = 9) readonly buffer CornerBuffer { vec4 corner_extras[]; };
layout(std430, binding = 12) readonly buffer BsdfBuffer { BsdfParams bsdfs[]; };
layout(std430, binding = 13) readonly buffer LayerBuffer { BsdfLayerRecord bsdf_layers[]; };
layout(std430, binding = 15) readonly buffer TextureLayerBuffer {
    TextureLayerRecord texture_layers[];
};
layout(std430, binding = 14) readonly buffer LocalLightingBuffer {
    LocalLightingConstants local_lighting_constants;
    BsdfParams lighting_parameters;
};
layout(binding = 10) uniform sampler2D environment_image;
layout(binding = 11) uniform sampler2DArray textures;
layout(binding = 16) uniform sampler2D background_image;
layout(std430, binding = 17) readonly buffer SkyBuffer { uint sky_triangles; };
layout(std430, binding = 18) readonly buffer SlopeMapBuffer { SlopeMapSize slope_maps[]; };
layout(std430, binding = 19) readonly buffer SlopeBuffer { SlopeTexel slope_texels[]; };
layout(std430, binding = 26) readonly buffer MaterialSlopesBuffer {
    MaterialSlopes material_slope_records[];
};
layout(binding = 21) uniform samplerCube sky_levels;
layout(binding = 22) uniform samplerCube sky_irradiance;
layout(std430, binding = 20) readonly buffer SeaBuffer { SeaSlopes sea_texels[]; };

FrameConstants load_frame() { return frame_constants; }
LocalLightingConstants load_local_lighting() { return local_lighting_constants; }
BsdfParams load_lighting_model() { return lighting_parameters; }
vec3 sample_sky(vec3 d, float level) { return vec3(textureLod(sky_levels, d, level)); }
vec3 sample_sky_irradiance(vec3 d) { return vec3(textureLod(sky_irradiance, d, 0.0f)); }
InstanceRecord load_instance(uint i) { return instances[i]; }
MaterialRecord load_material(uint i) { return materials[i]; }
BsdfParams load_bsdf(uint i) { return bsdfs[i]; }
BsdfLayerRecord load_bsdf_layer(uint i) { return bsdf_layers[i]; }
TextureLayerRecord load_texture_layer(uint i) { return texture_layers[i]; }
MaterialSlopes load_material_slopes(uint i) { return material_slope_records[i]; }
LightRecord load_light(uint i) { return lights[i]; }
LightTreeNode load_light_node(uint i) { return light_tree[i]; }
TriangleCorners load_triangle(uint geometry, uint primitive) {
    return triangles[geometry + primitive];
}

uint load_light_of_triangle(uint instance, uint primitive) {
    uint map = instances[instance].light_map;
    return map == NO_INDEX ? NO_INDEX : light_of_triangle[map + primitive];
}

// uv1 and colours lie beside the corners: four vectors a triangle.
vec2 load_uv1(uint geometry, uint primitive, float u, float v) {
    uint i = 4u * (geometry + primitive);
    vec4 mixed =
        corner_extras[i] * (1.0f - u - v) + corner_extras[i + 1u] * u + corner_extras[i + 2u] * v;
    return vec2(mixed.x, mixed.y);
}
vec4 load_vertex_color(uint geometry, uint primitive, float u, float v) {
    return corner_extras[4u * (geometry + primitive) + 3u];
}

vec4 sample_texture(uint index, vec2 uv, float lod, float u_lod) {
    return textureLod(textures, vec3(uv, float(index)), floor(lod + u_lod));
}

// One map, its levels behind each other.
SlopeMapSize load_slope_map(uint i) { return slope_maps[i]; }
Slopes load_slopes(uint map, int level, int x, int y) {
    int w = int(slope_maps[map].width);
    int h = int(slope_maps[map].height);
    int first = 0;
    for (int i = 0; i < level; ++i) {
        first += w * h;
        w = max(w / 2, 1);
        h = max(h / 2, 1);
    }
    return slope_texel_decode(
        slope_texels[first + wrapped_texel(y, h, 0u) * w + wrapped_texel(x, w, 0u)]);
}

// Of a sea that is the same over every metre, and all footprints.
SeaSlopes sample_sea(vec2 rest, vec2 d0, vec2 d1) {
    vec2 size = abs(d0) + abs(d1);
    return sea_texels[int(fract(rest.x) * 16.0f) + 16 * int(fract(rest.y) * 16.0f) +
                      (size.x + size.y > 1.0f ? 256 : 0)];
}

vec3 load_environment(vec2 uv) { return vec3(textureLod(environment_image, uv, 0.0f)); }
vec3 load_background(vec2 uv) { return vec3(textureLod(background_image, uv, 0.0f)); }
EnvironmentCell load_environment_cell(uint i) { return environment_cells[i]; }
void prefetch_environment(vec2 uv) {}
void prefetch_environment_cell(uint i) {}
void prefetch_environment_density(uint i) {}
float load_environment_density(uint i) { return environment_densities[i]; }

// [Moeller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection"]
Hit meet_triangle(Ray ray, uint i, Hit nearest) {
    TriangleCorners c = triangles[i];
    vec3 e1 = c.p1 - c.p0;
    vec3 e2 = c.p2 - c.p0;
    vec3 p = cross(ray.direction, e2);
    float inv = 1.0f / dot(e1, p);
    vec3 s = ray.origin - c.p0;
    vec3 q = cross(s, e1);
    float u = dot(s, p) * inv;
    float v = dot(ray.direction, q) * inv;
    float t = dot(e2, q) * inv;
    if (u >= 0.0f && v >= 0.0f && u + v <= 1.0f && t > ray.t_min && t < nearest.t) {
        nearest.t = t;
        nearest.u = u;
        nearest.v = v;
        nearest.instance = 0u;
        nearest.primitive = i;
    }
    return nearest;
}

Hit trace_closest(Ray ray) {
    Hit nearest;
    nearest.t = ray.t_max;
    nearest.u = 0.0f;
    nearest.v = 0.0f;
    nearest.instance = HIT_NOTHING;
    nearest.primitive = 0u;
    for (uint i = 0u; i < uint(triangles.length()); ++i) {
        nearest = meet_triangle(ray, i, nearest);
    }
    return nearest;
}

Hit trace_sky(Ray ray) {
    Hit nearest;
    nearest.t = ray.t_max;
    nearest.u = 0.0f;
    nearest.v = 0.0f;
    nearest.instance = HIT_NOTHING;
    nearest.primitive = 0u;
    for (uint i = 0u; i < sky_triangles; ++i) { nearest = meet_triangle(ray, i, nearest); }
    return nearest;
}

float trace_visible(Ray ray) { return trace_closest(ray).instance == HIT_NOTHING ? 1.0f : 0.0f; }

void note_shadow_ray(uint group, float value, float visible) {}
