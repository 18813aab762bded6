// Two directions by their half vector and by the light's direction as seen from it: the angles in
// which isotropic measurements are tabulated.
#ifndef GP_SHADING_MEASURED_HALF_ANGLES_GLSL
#define GP_SHADING_MEASURED_HALF_ANGLES_GLSL
#include "shading/trigonometry.glsl"
#include "shading/bsdf/classic/lobes.glsl"

// In turns. The azimuth of the half vector is left out: isotropic materials do not know it.
struct HalfAngles {
    float theta_h;  // normal to half vector, 0 to 0.25
    float theta_d;  // half vector to light (and to viewer), 0 to 0.25
    float phi_d;    // of the light around the half vector; 0 where it is nearest to the horizon.
                    // Modulo half a turn, which exchanges light and viewer: 0 to 0.5
};

// Both above the horizon. Without turning vectors into the half vector's frame: of its axes only
// ratios are needed, in which the sine of theta_h drops out.
// [Rusinkiewicz 1998, EGWR, "A New Change of Variables for Efficient BRDF Representation", 3]
HalfAngles half_angles(vec3 wo, vec3 wi) {
    HalfVector half_way = half_vector(wo, wi);
    vec3 wm = half_way.wm;
    HalfAngles a;
    a.theta_h = turns_from_vector(sqrt(wm.x * wm.x + wm.y * wm.y), wm.z);
    a.theta_d = turns_from_vector(0.5f * length(wo - wi), half_way.cos_h);
    float across = (wo.x * wi.y - wo.y * wi.x) / half_way.cos_h;
    a.phi_d = turns_from_vector(across, wo.z - wi.z);
    a.phi_d = a.phi_d < 0.0f ? a.phi_d + 0.5f : a.phi_d;
    return a;
}

#endif
