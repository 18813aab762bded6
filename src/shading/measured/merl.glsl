// The table of a MERL file: cells by the angles of half_angles.glsl, the half vector's in a square
// root scale, which gives highlights most of the cells. Red, green and blue of a cell lie beside
// each other (the files have planes); a negative one marks a cell that was not measured.
#ifndef GP_SHADING_MEASURED_MERL_GLSL
#define GP_SHADING_MEASURED_MERL_GLSL
#include "shading/measured/half_angles.glsl"

#define MERL_THETA_H 90
#define MERL_THETA_D 90
#define MERL_PHI_D 180
#define MERL_CELLS 1458000u

// theta_h, theta_d and phi_d, each in cells: cell k reaches from k to k + 1.
// [Matusik et al. 2003, "A Data-Driven Reflectance Model", section 3; the scales are those of the
//  code that is distributed with the data]
vec3 merl_position(IN(HalfAngles) a) {
    return vec3(180.0f * sqrt(a.theta_h), 360.0f * a.theta_d, 360.0f * a.phi_d);
}

uint merl_index(int theta_h, int theta_d, int phi_d) {
    return uint(phi_d + MERL_PHI_D * (theta_d + MERL_THETA_D * theta_h));
}

vec3 merl_cell(uvec2 table, uint index) {
    return vec3(table_float(table, 3u * index), table_float(table, 3u * index + 1u),
                table_float(table, 3u * index + 2u));
}

// The cell that two directions fall into, as other programs choose it: with the half vector near
// the normal the first of all, with the light near the viewer the one of the half vector's azimuth.
// They take the light's azimuth there, which would not be reciprocal, and is the same cell nearly
// always; and phi_d of half a turn, which is 0 here, has their last cell.
// [BRDF Explorer, Disney 2012, measured.func]
uint merl_nearest_index(vec3 wo, vec3 wi) {
    HalfAngles a = half_angles(wo, wi);
    float near_zero = 1.0e-3f * INV_TWO_PI;
    if (a.theta_d < near_zero) {
        vec3 sum = wo + wi;
        float azimuth = turns_from_vector(-sum.y, sum.x);
        a.phi_d = azimuth < 0.0f ? azimuth + 0.5f : azimuth;
    } else if (a.theta_h <= near_zero) {
        a.theta_h = 0.0f;
        a.phi_d = 0.0f;
    }
    vec3 at = merl_position(a);
    int phi_d = int(at.z);
    return merl_index(min(int(at.x), MERL_THETA_H - 1), min(int(at.y), MERL_THETA_D - 1),
                      phi_d < MERL_PHI_D ? phi_d : 0);
}

vec3 merl_nearest(uvec2 table, vec3 wo, vec3 wi) {
    return max(merl_cell(table, merl_nearest_index(wo, wi)), vec3(0.0f));
}

// Between the centres of eight cells, phi_d going round. Cells that were not measured are left out
// and the others get their weight, so that the horizon draws nothing down; black if there are none.
vec3 merl_trilinear(uvec2 table, vec3 wo, vec3 wi) {
    vec3 at = merl_position(half_angles(wo, wi)) - vec3(0.5f);
    vec3 first = floor(at);
    vec3 part = at - first;
    vec3 sum = vec3(0.0f);
    float weights = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        int h = corner >> 2;
        int d = (corner >> 1) & 1;
        int p = corner & 1;
        int phi_d = int(first.z) + p;
        phi_d = phi_d < 0 ? phi_d + MERL_PHI_D : phi_d;
        phi_d = phi_d >= MERL_PHI_D ? phi_d - MERL_PHI_D : phi_d;
        vec3 value = merl_cell(table, merl_index(clamp(int(first.x) + h, 0, MERL_THETA_H - 1),
                                                 clamp(int(first.y) + d, 0, MERL_THETA_D - 1),
                                                 phi_d));
        float weight = (h == 1 ? part.x : 1.0f - part.x) * (d == 1 ? part.y : 1.0f - part.y)
                     * (p == 1 ? part.z : 1.0f - part.z);
        if (min(value.x, min(value.y, value.z)) >= 0.0f) {
            sum += value * weight;
            weights += weight;
        }
    }
    return weights > 0.0f ? sum / weights : vec3(0.0f);
}

#endif
