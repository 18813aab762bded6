// How fast waves of a wave number go: gravity, finite depth, and surface tension for ripples.
#ifndef GP_SHADING_OCEAN_DISPERSION_GLSL
#define GP_SHADING_OCEAN_DISPERSION_GLSL
#include "shading/constants.glsl"
#include "shading/special.glsl"

// Depth in m that no wave feels.
#define OCEAN_DEEP 1.0e6f
// Square of the length sqrt(tension / (density gravity)) of water, m^2: 2.7 mm. Ripples shorter
// than 2 pi times it are held by tension more than by weight.
#define OCEAN_CAPILLARY_AREA 7.29e-6f

struct OceanFrequency {
    float omega;  // rad/s
    float by_k;   // its derivative by the wave number: the group velocity, m/s
};

// Of gravity waves. [Lamb 1932, "Hydrodynamics", 6th edition, section 229]
OceanFrequency ocean_gravity_frequency(float k, float depth, float gravity) {
    float kd = min(k * depth, 20.0f);  // beyond, tanh is 1
    float e = 2.0f * kd * expm1_over(2.0f * kd);
    float t = e / (e + 2.0f);          // tanh, which compilers of GLSL lose near 0
    OceanFrequency f;
    f.omega = sqrt(gravity * k * t);
    f.by_k = 0.5f * gravity * (t + kd * (1.0f - t * t)) / f.omega;
    return f;
}

// Angular frequency with surface tension, which moves the phases.
// [Lamb 1932, sections 266 and 267]
float ocean_frequency(float k, float depth, float gravity) {
    return ocean_gravity_frequency(k, depth, gravity).omega *
           sqrt(1.0f + k * k * OCEAN_CAPILLARY_AREA);
}

#endif
