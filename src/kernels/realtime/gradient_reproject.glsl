// Of each block of 3 x 3 pixels one repeats a pixel of the last frame, its surface and its draws:
// what comes out otherwise has changed.
// Based on: Schied, Peters and Dachsbacher 2018, "Gradient Estimation for Real-Time Adaptive
// Temporal Filtering", section 4.1; the pixels look for their past, as Q2RTX does, instead of the
// past for its pixels.
// Resources: load_previous_… of hit, barycentrics, depth, normal, material, luma;
// load_current_instance; store_gradient_sample; and those of primary.glsl.
#ifndef GP_KERNELS_REALTIME_GRADIENT_REPROJECT_GLSL
#define GP_KERNELS_REALTIME_GRADIENT_REPROJECT_GLSL
#include "kernels/realtime/primary.glsl"

#define GRADIENT_DEPTH_ERROR 0.1f    // relative
#define GRADIENT_NORMAL_COSINE 0.9f

// A pixel of the last frame that shows what `pixel` shows; `luminance` below 0: there is none.
struct PastPixel {
    ivec2 at;
    float luminance;
};

bool past_surface_agrees(ivec2 pixel, ivec2 past, vec4 motion) {
    uint flags = unpack_material(load_previous_material(past)).flags;
    uint mirrors = unpack_material(load_previous_material(past)).mirrors;
    if ((flags & (REALTIME_SKY | REALTIME_UNLIT)) != 0u || mirrors != 0u) { return false; }
    uint instance = load_previous_hit(past).x;
    if (instance >= HIT_LIGHT || load_current_instance(instance) != load_hit(pixel).x) {
        return false;
    }
    float depth = load_depth(pixel);
    float error = abs(load_previous_depth(past) - (depth + motion.z));
    vec3 n = octahedral_decode(load_normal(pixel).y);
    return error < GRADIENT_DEPTH_ERROR * depth &&
           dot(n, octahedral_decode(load_previous_normal(past).y)) > GRADIENT_NORMAL_COSINE;
}

PastPixel find_past_pixel(ivec2 pixel) {
    LET_REF(RealtimeConstants) r = load_realtime();
    PastPixel past;
    past.at = pixel;
    past.luminance = -1.0f;
    PixelMaterial m = unpack_material(load_material(pixel));
    uint unfit = REALTIME_SKY | REALTIME_UNLIT | REALTIME_NO_HISTORY;
    if ((m.flags & unfit) != 0u || m.mirrors != 0u) { return past; }
    vec4 motion = load_motion(pixel);
    past.at = ivec2(int(floor(float(pixel.x) + 0.5f + motion.x)),
                    int(floor(float(pixel.y) + 0.5f + motion.y)));
    bool inside = past.at.x >= 0 && past.at.y >= 0 && past.at.x < r.size.x && past.at.y < r.size.y;
    if (!inside || !past_surface_agrees(pixel, past.at, motion)) { return past; }
    vec4 luma = load_previous_luma(past.at);
    past.luminance = luma.x + luma.y + max(luma.z, 0.0f);
    return past;
}

// The pixel shows the very point that `past` showed, where it is now.
void repeat_surface(ivec2 pixel, ivec2 past) {
    LET_REF(CameraParams) camera = load_camera();
    LET_REF(RealtimeConstants) r = load_realtime();
    uvec2 shown = load_previous_hit(past);
    vec2 bary = unpack_barycentrics(load_previous_barycentrics(past));
    Hit hit;
    hit.t = 0.0f;
    hit.u = bary.x;
    hit.v = bary.y;
    hit.instance = load_current_instance(shown.x);
    hit.primitive = shown.y;
    bool diffuse = load_frame().diffuse_shading != 0u;
    LET_REF(MaterialRecord) material = load_material(load_instance(hit.instance).material);
    RayCone cone = camera_ray_cone(camera, float(r.size.y));
    vec3 towards = -octahedral_decode(load_view(pixel));
    cone = ray_cone_propagate(cone, load_depth(pixel));
    Surface s = load_surface(hit, towards, cone, surface_needs(material, diffuse));
    vec3 wo = camera.kind == CAMERA_ORTHOGRAPHIC ? -towards
                                                 : normalize(camera.position - s.position);
    if ((dot(s.ng, wo) >= 0.0f ? 1u : 0u) != s.front) { return; }
    Sampler draws = realtime_draws(past, r.frame_index - 1u);
    draws.dimension = CAMERA_DRAWS;
    float u_lod = draw_at(draws, 0u, DRAW_OTHERS).x;
    ShadingPoint p = load_shading_point(material, s, wo, u_lod, diffuse);
    PixelView seen;
    seen.image = mirror_image_identity();
    seen.emission = shown_emission(p);
    seen.mirrors = 0u;
    store_surface(pixel, seen, hit, s, p, wo, vec3(1.0f));
}

// Bits 0-3: 1 + the pixel's number in its block, 0: none; bits 4-17 and 18-31: x and y of the past
// pixel.
void realtime_gradient_reproject(ivec2 block) {
    LET_REF(RealtimeConstants) r = load_realtime();
    float best = -1.0f;
    uint code = 0u;
    ivec2 pixel = block * 3;
    ivec2 past_at = pixel;
    for (uint i = 0u; i < 9u && r.has_previous != 0u; ++i) {
        ivec2 candidate = block * 3 + ivec2(int(i % 3u), int(i / 3u));
        if (candidate.x >= r.size.x || candidate.y >= r.size.y) { continue; }
        PastPixel past = find_past_pixel(candidate);
        if (past.luminance > best) {
            best = past.luminance;
            pixel = candidate;
            past_at = past.at;
            code = (i + 1u) | (uint(past.at.x) << 4u) | (uint(past.at.y) << 18u);
        }
    }
    if (code != 0u) { repeat_surface(pixel, past_at); }
    store_gradient_sample(block, code);
}

#endif
