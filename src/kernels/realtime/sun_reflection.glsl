// What facets of slopes (the model `glint`, the sea) reflect of suns, in an image of its own that
// no denoiser touches: it is computed whole, disc and all, so that filters could only blur it. What
// is left to chance is the point of the disc that the shadow ray goes to: where an edge is sharp
// the picture is final, in penumbrae it is noisy, a ray a frame.
// Resources: load_frame, load_light, trace_visible, note_shadow_ray, and pixel_surface.glsl's.
#ifndef GP_KERNELS_REALTIME_SUN_REFLECTION_GLSL
#define GP_KERNELS_REALTIME_SUN_REFLECTION_GLSL
#include "kernels/realtime/pixel_surface.glsl"
#include "shading/bsdf/glint_sun.glsl"

// Radiance towards the viewer, over what mirrors on the way have left.
struct SunLight {
    vec3 facets;
    vec3 matte;     // of the base under them, which is as soft as its shadows and may be denoised
    uint apart;     // 0: nothing is known here, the sun comes as all other light does
};

SunLight sun_light_none() {
    SunLight none;
    none.facets = vec3(0.0f);
    none.matte = vec3(0.0f);
    none.apart = 0u;
    return none;
}

// Whether the suns that this surface reflects can be left out of what is denoised.
bool suns_are_apart(IN(PixelSurface) at) {
    if (load_realtime().suns_apart == 0u || at.p.bsdf.model != MODEL_GLINT) { return false; }
    // In water the sun comes through waves, which shadowed_light knows.
    if (at.water != 0u || bsdf_is_specular(at.p.bsdf)) { return false; }
    for (uint i = 0u; i < load_frame().directional_lights; ++i) {
        if (!slopes_hide_disc(at.p.bsdf, directional_light(load_light(i)))) { return false; }
    }
    return true;
}

// All suns on the viewer's side of the surface. u: the point of their discs that may be in shadow.
SunLight light_of_suns(IN(PixelSurface) at, vec2 u) {
    SunLight sum = sun_light_none();
    sum.apart = 1u;
    for (uint i = 0u; i < load_frame().directional_lights; ++i) {
        DirectionalLight sun = directional_light(load_light(i));
        vec3 wi = sun.direction;
        vec3 wi_local = local_from_world(at.p.frame, wi);
        if (!same_side(at.p.bsdf, at.wo_local, wi_local)) { continue; }
        if (!sides_agree(at.s, at.p, at.wo, wi, at.wo_local, wi_local)) { continue; }
        vec3 f = sun_f_cos(at.p.bsdf, at.wo_local, wi_local, sun);
        float strongest = max_component(f * sun.irradiance);
        if (!(strongest > 0.0f)) { continue; }
        LightSample point = directional_light_sample(sun, u);
        float visible = trace_visible(shadow_ray(at.s, at.p, at.wo, point));
        note_shadow_ray(light_group(i), strongest, visible);
        vec3 matte = min(slopes_matte_part(at.p.bsdf, at.wo_local, wi_local), f);
        vec3 light = sun.irradiance * visible;
        sum.facets += (f - matte) * light;
        sum.matte += matte * light;
    }
    return sum;
}

#endif
