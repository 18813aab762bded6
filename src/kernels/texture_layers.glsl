// Texture layers of a material: one or two textures over the base colour.
// Resources: load_texture_layer, and those of shading_point.glsl.
#ifndef GP_KERNELS_TEXTURE_LAYERS_GLSL
#define GP_KERNELS_TEXTURE_LAYERS_GLSL
#include "shared/scene_structs.glsl"

// What `layer` makes of the colour below it. A sum or a product that no surface can reflect is cut.
vec3 layer_over(vec3 below, vec4 layer, uint blend) {
    vec3 color = vec3(layer);
    if (blend == LAYER_OPAQUE) { return color; }
    if (blend == LAYER_ALPHA) { return mix(below, color, layer.w); }
    if (blend == LAYER_ADD) { return min(below + color, vec3(1.0f)); }
    // Twice the product, so that a layer can brighten as well as darken.
    return min(below * color * 2.0f, vec3(1.0f));
}

#endif
