// The whole of src/shading in the order of dependence. Every file includes what it needs itself,
// so each can also be used alone; this is the list for those who want all of it.
#ifndef GP_SHADING_SHADING_GLSL
#define GP_SHADING_SHADING_GLSL

#include "shading/constants.glsl"
#include "shading/trigonometry.glsl"
#include "shading/frame.glsl"
#include "shading/colour.glsl"
#include "shading/sh.glsl"

#include "shading/sampling/hash.glsl"
#include "shading/sampling/sobol.glsl"
#include "shading/sampling/sampler.glsl"
#include "shading/sampling/warps.glsl"
#include "shading/sampling/cosine_power.glsl"
#include "shading/sampling/morton.glsl"
#include "shading/sampling/alias.glsl"
#include "shading/sampling/mis.glsl"
#include "shading/sampling/pixel_filter.glsl"
#include "shading/sampling/spherical_rectangle.glsl"

#include "shading/ray_cone.glsl"
#include "shading/ray_offset.glsl"
#include "shading/camera.glsl"
#include "shading/medium.glsl"

#include "shading/light/light_sample.glsl"
#include "shading/light/directional.glsl"
#include "shading/light/sphere.glsl"
#include "shading/light/rectangle.glsl"
#include "shading/light/lamp_point.glsl"
#include "shading/light/triangle.glsl"
#include "shading/light/environment.glsl"
#include "shading/light/tree.glsl"

#include "shading/special.glsl"
#include "shading/fresnel.glsl"
#include "shading/complex.glsl"
#include "shading/thin_film.glsl"
#include "shading/iridescence.glsl"
#include "shading/iridescence_polarised.glsl"
#include "shading/spectrum.glsl"
#include "shading/grating.glsl"
#include "shading/microfacet/ggx.glsl"
#include "shading/microfacet/ggx_albedo.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/microfacet/multiple_scattering.glsl"
#include "shading/microfacet/nano_roughness.glsl"
#include "shading/microfacet/empirical.glsl"
#include "shading/microfacet/masking.glsl"
#include "shading/microfacet/distribution.glsl"
#include "shading/microfacet/smith_quadrature.glsl"
#include "shading/microfacet/facet_sampling.glsl"
#include "shading/microfacet/mirror_albedo.glsl"
#include "shading/bsdf/bsdf.glsl"
#include "shading/bsdf/blend.glsl"

#endif
