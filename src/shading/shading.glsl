// The whole of src/shading in the order of dependence. Every file includes what it needs itself,
// so each can also be used alone; this is the list for those who want all of it.
#ifndef GP_SHADING_SHADING_GLSL
#define GP_SHADING_SHADING_GLSL

#include "shading/constants.glsl"
#include "shading/frame.glsl"
#include "shading/sampling/hash.glsl"
#include "shading/sampling/sobol.glsl"
#include "shading/sampling/sampler.glsl"
#include "shading/sampling/warps.glsl"

// Reflectance: fresnel.glsl, microfacet/ggx.glsl, microfacet/beckmann.glsl, bsdf/bsdf.glsl.

#endif
