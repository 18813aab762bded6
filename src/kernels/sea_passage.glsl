// Light from far away that comes down through the sea as if that were calm: a shadow ray that is
// bent at the surface. Waves would spread it and gather it to caustics; their mean is this, about.
// Resources: load_frame, load_instance, load_material, trace_closest, trace_visible.
#ifndef GP_KERNELS_SEA_PASSAGE_GLSL
#define GP_KERNELS_SEA_PASSAGE_GLSL
#include "kernels/leaving_ray.glsl"
#include "kernels/surface.glsl"
#include "shading/fresnel.glsl"

struct SeaPassage {
    vec3 wi;      // where the light comes from, below
    float share;  // of its radiance over the density of directions above
};

// `wi` leads up to the light, above. A bundle of the solid angle dw has dw cos / (eta^2 cos_t)
// below, where its radiance is eta^2 times what goes through.
SeaPassage calm_sea_passage(vec3 wi) {
    float ior = load_frame().water_ior;
    vec3 up = vec3(0.0f, 1.0f, 0.0f);
    float g = fresnel_g(wi.y, ior);
    float cos_t = g / ior;
    SeaPassage passage;
    passage.wi = -refracted(wi, up, ior, g);
    passage.share = fresnel_transmittance(wi.y, cos_t, ior) * wi.y / cos_t;
    return passage;
}

// `ray` goes up from below; `wi` is where it goes on above the sea.
struct SeaLight {
    float visible;
    float distance;  // metres of water
};

SeaLight trace_through_sea(IN(Ray) ray, vec3 wi) {
    SeaLight found;
    found.visible = 0.0f;
    found.distance = 0.0f;
    Hit hit = trace_closest(ray);
    if (hit.instance >= HIT_LIGHT) { return found; }
    uint flags = load_material(load_instance(hit.instance).material).flags;
    if ((flags & MATERIAL_SEA) == 0u) { return found; }
    Ray above;
    above.origin = offset_ray_origin(surface_position(hit), vec3(0.0f, 1.0f, 0.0f));
    above.direction = wi;
    above.t_min = 0.0f;
    above.t_max = load_frame().ray_length;
    found.visible = trace_visible(above);
    found.distance = hit.t;
    return found;
}

#endif
