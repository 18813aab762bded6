// Absorption inside of a body, as KHR_materials_volume has it: white light has `colour` left after
// `attenuation_distance` metres.
#ifndef GP_SHADING_MEDIUM_GLSL
#define GP_SHADING_MEDIUM_GLSL
#include "shading/constants.glsl"

// The coefficient in 1/m. An infinite distance (FLOAT_MAX or more) means no absorption; black is
// kept above zero, so that the coefficient is finite and a path of length zero stays clear.
// [KHR_materials_volume, "Attenuation"]
vec3 medium_absorption(vec3 colour, float attenuation_distance) {
    if (!(attenuation_distance < FLOAT_MAX)) {
        return vec3(0.0f);
    }
    vec3 c = clamp(colour, vec3(1.0e-6f), vec3(1.0f));
    return -log(c) / max(attenuation_distance, 1.0e-6f);
}

// Beer and Lambert's law.
vec3 medium_transmittance(vec3 absorption, float distance) {
    return exp(-absorption * distance);
}

#endif
