// Based on: Dammertz, Sewtz, Hanika, Lensch 2010, "Edge-Avoiding A-Trous Wavelet Transform for Fast
// Global Illumination Filtering", HPG, with the variance-guided stops of Schied et al. 2017. Direct
// and specular light are filtered together: what tells surfaces apart is looked up once. Kernels
// are 3 x 3 with gaps of 1, 2, 4, 8. The result of the first is what the next frame remembers
// [Schied et al. 2017, section 4.3].
#ifndef GP_KERNELS_REALTIME_ATROUS_GLSL
#define GP_KERNELS_REALTIME_ATROUS_GLSL
#include "kernels/realtime/edge_stop.glsl"

// Iterations pass their results on: direct (specular), history, direct, other, direct.
#define ATROUS_ITERATIONS 4

vec4 atrous_direct(ivec2 at, int iteration) {
    if (iteration == 1) { return load_direct_history(at); }
    return iteration == 3 ? load_direct_other(at) : load_direct(at);
}

vec4 atrous_specular(ivec2 at, int iteration) {
    if (iteration == 1) { return load_specular_history(at); }
    return iteration == 3 ? load_specular_other(at) : load_specular(at);
}

void atrous_store(ivec2 pixel, int iteration, vec4 direct, vec4 specular) {
    if (iteration == 0) {
        store_direct_history(pixel, direct);
        store_specular_history(pixel, specular);
    } else if (iteration == 2) {
        store_direct_other(pixel, direct);
        store_specular_other(pixel, specular);
    } else {
        store_direct(pixel, direct);
        store_specular(pixel, specular);
    }
}

// What the pixel in the middle says of all its neighbours: reciprocals of allowed differences.
struct AtrousStops {
    EdgeTest surface;
    float depth_straight;
    float depth_diagonal;
    float specular_normal;  // the lobe's; direct light has filter_normal
    float roughness;
    float specular_share;   // of neighbours
    float direct_luma;
    float specular_luma;
    float direct_stop;
    float specular_stop;
};

// Neighbours' lobes overlap if their normals differ by less than the width of the lobe.
float specular_normal_stop(float roughness, float diffuse_stop) {
    float alpha = roughness * roughness;
    return diffuse_stop * clamp(0.25f / (alpha * alpha + 0.015625f), 1.0f, 16.0f);
}

// Smooth surfaces show different things in each pixel: their neighbours count less, and the further
// away the less.
float specular_filter_share(float roughness, int iteration) {
    return clamp(30.0f * roughness - float(iteration), 0.0f, 1.0f);
}

AtrousStops atrous_stops(ivec2 pixel, int iteration, uint material, float depth, vec4 direct,
                         vec4 specular) {
    LET_REF(RealtimeConstants) c = load_realtime();
    AtrousStops s;
    float step = float(1 << iteration);
    s.surface = edge_test(material, depth, finite_or_zero(load_motion(pixel).w),
                          load_normal(pixel));
    s.depth_straight = 1.0f / depth_allowance(depth, s.surface.slope, step, c.filter_depth);
    s.depth_diagonal =
        1.0f / depth_allowance(depth, s.surface.slope, 2.0f * step, c.filter_depth);
    s.roughness = material_roughness(material);
    s.specular_normal = specular_normal_stop(s.roughness, c.filter_normal);
    s.specular_share = specular_filter_share(s.roughness, iteration);
    vec2 frames = load_history_length(pixel) * 255.0f;
    s.direct_luma = luminance(vec3(direct));
    s.specular_luma = luminance(vec3(specular));
    s.direct_stop =
        luminance_stop(s.direct_luma, direct.w, frames.x, iteration, c.filter_luminance);
    s.specular_stop =
        luminance_stop(s.specular_luma, specular.w, frames.y, iteration, c.filter_luminance);
    return s;
}

// The weights of a neighbour: x for direct light, y for specular. `kernel`: of its place.
vec2 atrous_weights(ivec2 at, int iteration, IN(AtrousStops) s, float depth_stop, float kernel) {
    LET_REF(RealtimeConstants) c = load_realtime();
    uint material = load_material(at);
    if (((material ^ s.surface.material) & MATERIAL_SURFACE_BITS) != 0u) { return vec2(0.0f); }
    float bend = 1.0f - normal_cosine(s.surface, load_normal(at));
    float apart = abs(load_depth(at) - s.surface.depth) * depth_stop;
    float direct = abs(luminance(vec3(atrous_direct(at, iteration))) - s.direct_luma);
    float specular = abs(luminance(vec3(atrous_specular(at, iteration))) - s.specular_luma);
    float rough = abs(material_roughness(material) - s.roughness);
    return vec2(kernel * edge_weight(apart + bend * c.filter_normal + direct * s.direct_stop),
                kernel * s.specular_share *
                    edge_weight(apart + bend * s.specular_normal + rough * c.filter_roughness +
                                specular * s.specular_stop));
}

void atrous_filter(ivec2 pixel, int iteration) {
    LET_REF(RealtimeConstants) c = load_realtime();
    vec4 direct = atrous_direct(pixel, iteration);
    vec4 specular = atrous_specular(pixel, iteration);
    uint material = load_material(pixel);
    float depth = load_depth(pixel);
    if (!pixel_is_lit(material, depth)) {
        atrous_store(pixel, iteration, direct, specular);
        return;
    }
    AtrousStops s = atrous_stops(pixel, iteration, material, depth, direct, specular);
    vec2 sum = vec2(1.0f);
    for (int i = 0; i < 9; ++i) {
        ivec2 offset = ivec2(i % 3 - 1, i / 3 - 1);
        ivec2 at = pixel + offset * (1 << iteration);
        if (i == 4 || !pixel_is_inside(at, c.size)) { continue; }
        bool diagonal = offset.x != 0 && offset.y != 0;
        vec2 weight = atrous_weights(at, iteration, s, diagonal ? s.depth_diagonal
                                                                : s.depth_straight,
                                     diagonal ? 0.25f : 0.5f);
        direct += atrous_direct(at, iteration) * weight.x;
        specular += atrous_specular(at, iteration) * weight.y;
        sum += weight;
    }
    atrous_store(pixel, iteration, direct * (1.0f / sum.x), specular * (1.0f / sum.y));
}

#endif
