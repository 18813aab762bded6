// Of each block of 3 x 3 pixels one repeats a pixel of the last frame, its surface and its draws:
// what comes out otherwise has changed.
// Based on: Schied, Peters and Dachsbacher 2018, "Gradient Estimation for Real-Time Adaptive
// Temporal Filtering", section 4.1; the pixels look for their past, as Q2RTX does, instead of the
// past for its pixels.
// Resources: load_previous_… of hit, barycentrics, depth, normal, material, luma, gradient_sample;
// load_current_instance; store_gradient_sample; and those of pixel_surface.glsl.
#ifndef GP_KERNELS_REALTIME_GRADIENT_REPROJECT_GLSL
#define GP_KERNELS_REALTIME_GRADIENT_REPROJECT_GLSL
#include "kernels/realtime/pixel_surface.glsl"

#define GRADIENT_DEPTH_ERROR 0.1f    // relative
#define GRADIENT_NORMAL_COSINE 0.9f

// A pixel of the last frame that shows what `pixel` shows; `luminance` below 0: there is none.
struct PastPixel {
    ivec2 at;
    float luminance;
};

// The pixel of the last frame that showed what `pixel` shows; it may be outside of the picture.
ivec2 past_place(ivec2 pixel, vec4 motion) {
    return ivec2(int(floor(float(pixel.x) + 0.5f + motion.x)),
                 int(floor(float(pixel.y) + 0.5f + motion.y)));
}

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
    vec3 n = octahedral_decode(load_unmapped_normal(pixel));
    return error < GRADIENT_DEPTH_ERROR * depth &&
           dot(n, octahedral_decode(load_previous_unmapped_normal(past))) > GRADIENT_NORMAL_COSINE;
}

// A pixel that repeated another one had not the draws of its own place: it cannot be repeated by
// them, and a chain of the brightest would not be noise any more.
bool has_repeated(ivec2 past) {
    ivec2 block = past / 3;
    ivec2 inside = past - block * 3;
    return (load_previous_gradient_sample(block) & 15u) == uint(1 + inside.x + 3 * inside.y);
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
    past.at = past_place(pixel, motion);
    bool inside = past.at.x >= 0 && past.at.y >= 0 && past.at.x < r.size.x && past.at.y < r.size.y;
    if (!inside || has_repeated(past.at)) { return past; }
    if (!past_surface_agrees(pixel, past.at, motion)) { return past; }
    vec4 luma = load_previous_luma(past.at);
    past.luminance = luma.x + luma.y + max(luma.z, 0.0f);
    return past;
}

// The pixel shows the very point that `past` showed, where it is now; false if that has turned
// away.
bool repeat_surface(ivec2 pixel, ivec2 past) {
    Sampler draws = realtime_draws(past, load_realtime().frame_index - 1u);
    draws.dimension = CAMERA_DRAWS;
    Hit hit = hit_of_pixel(load_previous_hit(past), load_previous_barycentrics(past));
    hit.instance = load_current_instance(hit.instance);
    LET_REF(CameraParams) camera = load_camera();
    vec3 wo = camera.kind == CAMERA_ORTHOGRAPHIC
                  ? -camera.forward : normalize(camera.position - surface_position(hit));
    PixelSurface at = pixel_surface(hit, wo, load_depth(pixel),
                                    draw_at(draws, 0u, DRAW_OTHERS).x);
    // What has turned away is not what the camera sees there.
    if ((dot(at.s.ng, octahedral_decode(load_view(pixel))) >= 0.0f ? 1u : 0u) != at.s.front) {
        return false;
    }
    PixelView seen;
    seen.image = mirror_image_identity();
    seen.emission = shown_emission(at.p);
    seen.mirrors = 0u;
    store_surface(pixel, seen, hit, at.s, at.p, wo, vec3(1.0f));
    return true;
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
    if (code != 0u && !repeat_surface(pixel, past_at)) { code = 0u; }
    store_gradient_sample(block, code);
}

#endif
