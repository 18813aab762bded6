// The shadow ray of a surface to the light chosen for it.
// Resources: trace_visible, note_shadow_ray, and those of the files included.
#ifndef GP_KERNELS_SHADOWED_LIGHT_GLSL
#define GP_KERNELS_SHADOWED_LIGHT_GLSL
#include "kernels/leaving_ray.glsl"
#include "kernels/light_choice.glsl"
#include "kernels/sea_guide.glsl"
#include "kernels/sea_passage.glsl"
#include "shading/colour.glsl"
#include "shading/medium.glsl"
#include "shading/sampling/mis.glsl"

// What is around a surface on the viewer's side.
struct Around {
    vec3 attenuation;  // 1/m
    float guided;      // share of the rays by the material that the guide of the sea draws instead
    uint bends;        // 1: light from far away comes down through the sea, as if that were calm
};

Around around_of(vec3 attenuation) {
    Around a;
    a.attenuation = attenuation;
    a.guided = 0.0f;
    a.bends = 0u;
    return a;
}

// Light that a shadow ray brought to a surface: what the surface does with it is f_cos.
struct ShadowedLight {
    vec3 light;     // radiance over density, weighted; zero: none arrives
    vec3 wi_local;
    vec3 f_cos;
};

ShadowedLight shadowed_light_none() {
    ShadowedLight none;
    none.light = vec3(0.0f);
    none.wi_local = vec3(0.0f);
    none.f_cos = vec3(0.0f);
    return none;
}

// As shadowed_light, of a light that is infinitely far, for a surface in the sea. No other ray is
// to find it: nothing is weighed.
OUT_OF_LINE ShadowedLight light_through_sea(IN(Surface) s, IN(ShadingPoint) p,
                                            IN(ChosenLight) choice, vec3 wo_local, vec3 wo,
                                            vec3 attenuation, float resampled) {
    LightSample light = choice.point;
    ShadowedLight arrived = shadowed_light_none();
    if (!(light.wi.y > 0.0f)) { return arrived; }
    SeaPassage passage = calm_sea_passage(light.wi);
    light.wi = passage.wi;
    vec3 wi_local = local_from_world(p.frame, light.wi);
    if (!sides_agree(s, p, wo, light.wi, wo_local, wi_local)) { return arrived; }
    vec3 f_cos = bsdf_eval(p.bsdf, wo_local, wi_local).f_cos;
    vec3 radiance = chosen_light_radiance(choice) * passage.share;
    float strongest = max_component(f_cos * radiance);
    if (!(strongest > 0.0f)) { return arrived; }
    SeaLight found = trace_through_sea(shadow_ray(s, p, wo, light), choice.point.wi);
    float density = choice.pmf * light.pdf;
    note_shadow_ray(light_group(choice.light), strongest / density, found.visible);
    float weight = resampled > 0.0f ? resampled / light.pdf : 1.0f / density;
    arrived.wi_local = wi_local;
    arrived.f_cos = f_cos;
    arrived.light = radiance * medium_transmittance(attenuation, found.distance) *
                    (weight * found.visible);
    return arrived;
}

// `weigh`: against rays by the material. `resampled` above 0 stands for one over the probability of
// having chosen this point of this light.
ShadowedLight shadowed_light(IN(Surface) s, IN(ShadingPoint) p, IN(ChosenLight) choice,
                             vec3 wo_local, vec3 wo, IN(Around) around, bool weigh,
                             float resampled) {
    LET_REF(LightSample) light = choice.point;
    ShadowedLight arrived = shadowed_light_none();
    if (light.pdf <= 0.0f) { return arrived; }
    if (around.bends != 0u && light.distance == FLOAT_MAX) {
        return light_through_sea(s, p, choice, wo_local, wo, around.attenuation, resampled);
    }
    arrived.wi_local = local_from_world(p.frame, light.wi);
    if (!sides_agree(s, p, wo, light.wi, wo_local, arrived.wi_local)) { return arrived; }
    BsdfValue value = bsdf_eval(p.bsdf, wo_local, arrived.wi_local);
    vec3 radiance = chosen_light_radiance(choice);
    float strongest = max_component(value.f_cos * radiance);
    if (!(strongest > 0.0f)) { return arrived; }
    arrived.f_cos = value.f_cos;
    float density = choice.pmf * light.pdf;
    if (around.guided > 0.0f) { value.pdf = guided_pdf(value.pdf, light.wi, around.guided); }
    float w = light.is_delta != 0u || !weigh ? 1.0f : mis_power(density, value.pdf);
    float visible = trace_visible(shadow_ray(s, p, wo, light));
    note_shadow_ray(light_group(choice.light), strongest / density, visible);
    // What surrounds the surface absorbs; infinitely far light is never inside of a body.
    bool reflected = same_side(p.bsdf, wo_local, arrived.wi_local);
    if (reflected && around.attenuation != vec3(0.0f) && light.distance < FLOAT_MAX) {
        radiance *= medium_transmittance(around.attenuation, light.distance);
    }
    arrived.light = radiance * ((resampled > 0.0f ? w * resampled / light.pdf : w / density) *
                                visible);
    return arrived;
}

#endif
