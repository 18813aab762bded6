// Coat and sheen over the glint model. They lie on the mesosurface, the plane of the mean slope,
// and are smooth over the facets; coat_normal is in that plane's frame.
#ifndef GP_SHADING_BSDF_GLINT_LAYERS_GLSL
#define GP_SHADING_BSDF_GLINT_LAYERS_GLSL
#include "shading/frame.glsl"
#include "shading/bsdf/glint_interface.glsl"
#include "shading/bsdf/layers.glsl"

struct GlintLayers {
    Layers layers;
    vec3 o;         // wo in their frame, mirrored to its front
};

// Azimuth has no meaning for either of them, so any frame around the normal will do.
Frame mesosurface_frame(vec2 mean) {
    return frame_from_normal(normalize(mesosurface_normal(mean)));
}

GlintLayers glint_no_layers() {
    GlintLayers over;
    over.layers = layers_none();
    over.o = vec3(0.0f, 0.0f, 1.0f);
    return over;
}

// w, turned to the front as by glint_turned, in the frame of the layers and mirrored to its front.
vec3 glint_layer_direction(IN(BsdfParams) m, vec2 mean, bool turned, vec3 w) {
    vec3 v = local_from_world(mesosurface_frame(mean), w);
    return turned && m.thin == 0u ? vec3(-v.x, -v.y, v.z) : v;
}

// Out of line, as all that follows: facets without layers must not pay for them.
OUT_OF_LINE GlintLayers glint_layers_seen(IN(BsdfParams) m, vec2 mean, vec3 o, bool turned) {
    GlintLayers over = glint_no_layers();
    over.o = glint_layer_direction(m, mean, turned, o);
    if (!turned || m.thin != 0u) { over.layers = layers_seen(m, over.o); }
    return over;
}

// `base`, the value of facets and matte base towards i, under the layers.
OUT_OF_LINE BsdfValue glint_under_layers(IN(BsdfParams) m, GlintLayers over, vec2 mean,
                                         bool turned, vec3 i, BsdfValue base) {
    base.pdf *= 1.0f - over.layers.p_coat - over.layers.p_sheen;
    bool inside = turned && m.thin == 0u;
    vec3 w = glint_layer_direction(m, mean, turned, i);
    if (inside && w.z > 0.0f) {
        return base;
    }
    bool enters = w.z < 0.0f && m.thin == 0u && !turned;
    return under_layers(m, over.layers, over.o, w, enters, base);
}

// How much of what is reflected towards i comes through them.
OUT_OF_LINE float glint_layers_through(IN(BsdfParams) m, GlintLayers over, vec2 mean, bool turned,
                                       vec3 i) {
    return layers_through(m, over.layers, glint_layer_direction(m, mean, turned, i));
}

// A direction by one of them, not from inside of a solid body; the zero vector where there is none.
OUT_OF_LINE vec3 glint_layer_sample(IN(BsdfParams) m, GlintLayers over, vec2 mean, bool sheen,
                                    vec2 u) {
    vec3 w = sheen ? square_to_uniform_hemisphere(u) : coat_sample_direction(m, over.o, u);
    return w.z > 0.0f ? world_from_local(mesosurface_frame(mean), w) : vec3(0.0f);
}

#endif
