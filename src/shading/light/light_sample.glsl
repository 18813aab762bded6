// What every light gives when asked for light at a point, and the helpers they share.
#ifndef GP_SHADING_LIGHT_LIGHT_SAMPLE_GLSL
#define GP_SHADING_LIGHT_LIGHT_SAMPLE_GLSL
#include "shading/constants.glsl"

// Each light file has three functions of a shading point p:
//   X_sample(light, p, u)  a direction towards the light
//   X_pdf(light, p, ...)   the density with which X_sample gives a direction that is known to hit
//   X_radiance(light, ...) what comes along it
// Light of a sample is radiance / pdf, times the BSDF and the cosine; visibility is the caller's.
struct LightSample {
    vec3 wi;        // unit, to the light
    float distance; // along wi, to the light's surface
    vec3 radiance;  // along wi; of a delta light the irradiance across wi
    float pdf;      // 1 / sr; 1 for a delta light; 0: no sample, the other members mean nothing
    uint is_delta;  // 1: no other technique can find this light, so no MIS weight
};

LightSample light_sample_none() {
    LightSample s;
    s.wi = vec3(0.0f, 0.0f, 1.0f);
    s.distance = 0.0f;
    s.radiance = vec3(0.0f);
    s.pdf = 0.0f;
    s.is_delta = 0u;
    return s;
}

// From a density over area to one over solid angle: `to_light` leads to the point of the light,
// `cos_light` is the cosine there. 0 where the light is seen edge-on.
float solid_angle_pdf(float area_pdf, vec3 to_light, float cos_light) {
    float cosine = abs(cos_light);
    return cosine > 1.0e-7f ? area_pdf * dot(to_light, to_light) / cosine : 0.0f;
}

#endif
