// A clear coat over sheen over any base:
//
//   coat + T_coat (sheen + T_sheen base)
//
// T of coat and sheen is the smaller of 1 - E at wo and at wi, as KHR_materials_sheen has it, so
// that no more light leaves than arrives, and the same for wo and wi exchanged. All directions are
// in the frame of the surface, mirrored to that side of a sheet that wo sees.
#ifndef GP_SHADING_BSDF_LAYERS_GLSL
#define GP_SHADING_BSDF_LAYERS_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"
#include "shading/bsdf/coat.glsl"
#include "shading/bsdf/sheen.glsl"

// What of them depends on the view alone, and how probable each lobe is.
struct Layers {
    float coat_through;
    float sheen_through;
    float p_coat;
    float p_sheen;
    float disc;  // coat_eval_disc; 0: the light is in one direction
};

bool has_layers(IN(BsdfParams) m) {
    return m.coat > 0.0f || m.sheen_color != vec3(0.0f);
}

// What coat and sheen let through towards w, on the outside.
float coat_through(IN(BsdfParams) m, vec3 w) {
    return m.coat > 0.0f ? 1.0f - coat_albedo(m, w) : 1.0f;
}

float sheen_through(IN(BsdfParams) m, vec3 w) {
    float color = max_component(m.sheen_color);
    return color > 0.0f ? 1.0f - color * sheen_albedo_white(w.z, m.sheen_alpha) : 1.0f;
}

// From inside of a solid body they are not seen.
Layers layers_none() {
    Layers layers;
    layers.coat_through = 1.0f;
    layers.sheen_through = 1.0f;
    layers.p_coat = 0.0f;
    layers.p_sheen = 0.0f;
    layers.disc = 0.0f;
    return layers;
}

// Lobes are chosen in proportion to their estimated albedos; o.z > 0.
Layers layers_seen(IN(BsdfParams) m, vec3 o) {
    Layers layers;
    layers.coat_through = coat_through(m, o);
    layers.sheen_through = sheen_through(m, o);
    layers.p_coat = 1.0f - layers.coat_through;
    layers.p_sheen = layers.coat_through * (1.0f - layers.sheen_through);
    layers.disc = 0.0f;
    return layers;
}

// How much of light that is reflected towards i comes through both.
float layers_through(IN(BsdfParams) m, IN(Layers) layers, vec3 i) {
    float through = 1.0f;
    if (m.sheen_color != vec3(0.0f)) {
        through *= min(layers.sheen_through, sheen_through(m, i));
    }
    if (m.coat > 0.0f) {
        through *= min(layers.coat_through, coat_through(m, i));
    }
    return through;
}

// The base's value `base` seen through sheen and coat, and what these two add. enters: into a solid
// body; then they are crossed once, on wo's side, and light that leaves it crosses them on wi's.
BsdfValue under_layers(IN(BsdfParams) m, IN(Layers) layers, vec3 o, vec3 i, bool enters,
                       IN(BsdfValue) base) {
    BsdfValue v = base;
    // The direction on the other side of the layers, were they to be crossed twice.
    vec3 far_side = vec3(i.x, i.y, abs(i.z));
    if (m.sheen_color != vec3(0.0f)) {
        float through = enters ? 1.0f : sheen_through(m, far_side);
        v.f_cos *= min(layers.sheen_through, through);
        if (i.z > 0.0f) {
            v.f_cos += m.sheen_color * sheen_f_cos(o, i, m.sheen_alpha);
            v.pdf += layers.p_sheen * uniform_hemisphere_pdf(i);
        }
    }
    if (m.coat > 0.0f) {
        float through = enters ? 1.0f : coat_through(m, far_side);
        v.f_cos *= min(layers.coat_through, through);
        BsdfValue coat = layers.disc > 0.0f ? coat_eval_disc(m, o, i, layers.disc)
                                            : coat_eval(m, o, i);
        v.f_cos += coat.f_cos;
        v.pdf += layers.p_coat * coat.pdf;
    }
    return v;
}

// The albedo of all, seen from w, above a base of that albedo.
vec3 albedo_under_layers(IN(BsdfParams) m, vec3 w, vec3 base) {
    vec3 albedo = base * sheen_through(m, w);
    albedo += m.sheen_color * sheen_albedo_white(w.z, m.sheen_alpha);
    float through = coat_through(m, w);
    return albedo * through + vec3(1.0f - through);
}

#endif
