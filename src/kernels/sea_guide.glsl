// Which way the sun is, seen from below the sea. Shadow rays end at the water's surface, and what
// the material of a thing below sends up meets the few directions that are refracted to a sun once
// in hundreds. So a share of the directions that leave a surface in the water is drawn by slopes
// of the whole sea, refracted at the flat one. It only chooses directions: the density is that of
// both ways of choosing, and what a direction brings is still found by the path that goes on.
// Based on: the mixture of techniques of Veach 1997, section 9.2.4 (one sample, all densities).
// Resources: load_frame, load_light.
#ifndef GP_KERNELS_SEA_GUIDE_GLSL
#define GP_KERNELS_SEA_GUIDE_GLSL
#include "kernels/sea_frame.glsl"
#include "kernels/shading_point.glsl"
#include "shading/colour.glsl"
#include "shading/slope/refracted_light.glsl"
#include "shared/scene_structs.glsl"

// Of a directional light, what may go down into calm water.
float sea_guide_weight(IN(LightRecord) sun) {
    return luminance(sun.emission) * max(-sun.direction.y, 0.0f);
}

float sea_guide_sum() {
    LET_REF(FrameConstants) f = load_frame();
    float sum = 0.0f;
    for (uint i = 0u; i < f.directional_lights; ++i) { sum += sea_guide_weight(load_light(i)); }
    return sum;
}

// With the sun's disc as slopes: seen through calm water at right angles it is narrower by the
// index, and a facet turns what goes through it by (1 - 1 / ior) of its own angle.
Slopes sea_guide_slopes(IN(LightRecord) sun) {
    LET_REF(FrameConstants) f = load_frame();
    float disc = sun.radius / (f.water_ior - 1.0f);
    Slopes d;
    d.mean = vec2(0.0f);
    d.var_x = f.water_var_x + 0.5f * disc * disc;
    d.var_y = f.water_var_y + 0.5f * disc * disc;
    d.cov = f.water_cov;
    return d;
}

// The zero vector where the facet drawn is turned away.
vec3 sea_guide_direction(float u_light, vec2 u) {
    LET_REF(FrameConstants) f = load_frame();
    float x = u_light * sea_guide_sum();
    for (uint i = 0u; i < f.directional_lights; ++i) {
        LET_REF(LightRecord) sun = load_light(i);
        float weight = sea_guide_weight(sun);
        if (x < weight) {
            vec3 wl = local_from_world(sea_frame(), -sun.direction);
            vec3 w = refracted_light_sample(sea_guide_slopes(sun), wl, f.water_ior, u);
            return world_from_local(sea_frame(), w);
        }
        x -= weight;
    }
    return vec3(0.0f);  // rounding, once in millions
}

// Out of line, as all that only scenes with clear water need.
OUT_OF_LINE float sea_guide_pdf(vec3 direction) {
    LET_REF(FrameConstants) f = load_frame();
    vec3 w = local_from_world(sea_frame(), direction);
    float sum = 0.0f;
    float pdf = 0.0f;
    for (uint i = 0u; i < f.directional_lights; ++i) {
        LET_REF(LightRecord) sun = load_light(i);
        float weight = sea_guide_weight(sun);
        if (!(weight > 0.0f)) { continue; }
        vec3 wl = local_from_world(sea_frame(), -sun.direction);
        pdf += weight * refracted_light_pdf(sea_guide_slopes(sun), wl, f.water_ior, w);
        sum += weight;
    }
    return sum > 0.0f ? pdf / sum : 0.0f;
}

// The density of a direction that the material alone would choose with pdf; guided above 0.
float guided_pdf(float pdf, vec3 direction, float guided) {
    return mix(pdf, sea_guide_pdf(direction), guided);
}

// The lobe number of the material's own sample, where numbers below `guided` are the guide's.
float unguided(float guided, float u_lobe) {
    return u_lobe < guided ? u_lobe
                           : min((u_lobe - guided) / (1.0f - guided), ONE_MINUS_EPSILON);
}

struct GuidedSample {
    BsdfSample b;
    float narrowing;  // its density over the material's own: the weight is smaller by that
};

// In the share `guided` of all cases a direction by the guide in place of `own`, which the material
// drew by unguided(u_lobe).
OUT_OF_LINE GuidedSample guided_sample(IN(ShadingPoint) p, vec3 wo_local, IN(BsdfSample) own,
                                       float guided, float u_lobe, vec2 u) {
    GuidedSample s;
    s.b = own;
    s.narrowing = 1.0f;
    vec3 wi;
    if (u_lobe < guided) {
        wi = sea_guide_direction(u_lobe / guided, u);
        vec3 wi_local = local_from_world(p.frame, wi);
        bool through = !same_side(p.bsdf, wo_local, wi_local);
        s.b = bsdf_no_sample();
        if (wi != vec3(0.0f)) {
            // The lobe only says how wide the ray's cone becomes, and whether it goes inside.
            s.b = bsdf_sample_of(wi_local, bsdf_eval(p.bsdf, wo_local, wi_local),
                                 LOBE_DIFFUSE | (through ? LOBE_TRANSMISSION : 0u));
        }
    } else {
        wi = world_from_local(p.frame, own.wi);
    }
    if (!(s.b.pdf > 0.0f)) { return s; }
    s.narrowing = guided_pdf(s.b.pdf, wi, guided) / s.b.pdf;
    s.b.weight /= s.narrowing;
    s.b.pdf *= s.narrowing;
    return s;
}

#endif
