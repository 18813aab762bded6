// A surface whose facets can be counted: metal, dielectric over a matte base, or clear body, with
// slopes about any mean. Frame: that of the geometry; which side of the surface a direction is on
// is the side of the mesosurface, the plane of the mean slope (slope_facing).
//
// A share `transmission` of the surface is clear, with the exact Fresnel term; the rest is as in
// glTF's material: Schlick's term, and below it a matte base that gets what this lets through. Each
// keeps its energy. A thin film colours what both reflect, and coat and sheen lie over all of it,
// all three as in glTF's (glint_layers.glsl).
// The point that is seen (uv, footprint, kernel) stands in slots that a renderer fills; as
// parameters they show one cell's facets in plots.
#ifndef GP_SHADING_BSDF_GLINT_GLSL
#define GP_SHADING_BSDF_GLINT_GLSL
#include "shading/frame.glsl"
#include "shading/microfacet/cavity_albedo.glsl"
#include "shading/microfacet/multiple_scattering.glsl"
#include "shading/sampling/hash.glsl"
#include "shading/sampling/sobol.glsl"
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/gltf.glsl"
#include "shading/bsdf/glint_interface.glsl"
#include "shading/bsdf/glint_layers.glsl"
#include "shading/bsdf/params.glsl"

// Of sampling: facets must be met even where they reflect nearly nothing.
#define GLINT_MOST_DIFFUSE 0.98f

// What the facets reflect under a cosine, by their polynomial. Without preparation (bsdf_prepared)
// nothing.
float glint_reflected(IN(BsdfParams) m, float cos_w) {
    Chebyshev reflected;
    reflected.low = m.slot_g;
    reflected.middle = m.slot_h;
    reflected.high = m.slot_i;
    return chebyshev_value(reflected, sqrt(cos_w));
}

// Under a film f0 goes with the angle, and the polynomial is that of f0 = 0: all facets that are
// seen reflect f0 of what it leaves.
OUT_OF_LINE vec3 glint_film_albedo(IN(BsdfParams) m, float cos_w) {
    float rest = clamp(glint_reflected(m, cos_w), 0.0f, 1.0f);
    vec3 f0 = gltf_effective_f0(m, gltf_dielectric_f0(m), m.specular, cos_w);
    return vec3(rest) + f0 * (1.0f - rest);
}

// What they let through to the matte base: what they do not reflect.
float glint_through(IN(BsdfParams) m, float cos_w) {
    if (m.iridescence > 0.0f) { return 1.0f - max_component(glint_film_albedo(m, cos_w)); }
    return clamp(1.0f - glint_reflected(m, cos_w), 0.0f, 1.0f);
}

// The albedo of the dielectric facets, by which the base is coupled to them: twelve values of a
// polynomial in the root of the cosine, which Schlick's term is where facets are smooth. Quick
// enough for every point that is seen.
struct GlintBase {
    Chebyshev reflected;
    float through;  // on average
};

GlintBase glint_base(IN(BsdfParams) m, float alpha) {
    GlintBase base;
    base.reflected = chebyshev_none();
    base.through = 1.0f;
    if (gltf_has_diffuse(m)) {
        bool film = m.iridescence > 0.0f;
        base.reflected = cavity_albedo(alpha, film ? 0.0f : f0_from_ior(m.ior));
        float average = film ? 0.0f : cavity_albedo_average(base.reflected);
        base.through = clamp(1.0f - average, 0.0f, 1.0f);
    }
    return base;
}

// At a point whose facets, with the pixel's kernel, are wider than the material's own.
GlintBase glint_base_at(IN(BsdfParams) m) {
    Slopes d = glint_kernel_added(glint_material_slopes(m), vec2(m.slot_e.x, m.slot_e.y),
                                  vec2(m.slot_e.z, m.slot_e.w));
    // The root of the mean square of both widths, as mean_alpha.
    return glint_base(m, sqrt(d.var_x + d.var_y));
}

// Where the material keeps it. A macro: a function would copy all of the material.
#define GLINT_SET_BASE(m, base)      \
    m.slot_g = base.reflected.low;    \
    m.slot_h = base.reflected.middle; \
    m.slot_i = base.reflected.high;   \
    m.slot_j.x = base.through;

BsdfParams glint_prepared(BsdfParams m) {
    GlintBase base = glint_base(m, mean_alpha(m));
    GLINT_SET_BASE(m, base)
    return m;
}

// What depends on the view alone: turned to the front, with what the matte base needs.
struct GlintView {
    Glint g;
    vec3 o;
    bool turned;
    float eta;      // behind the surface over the view's side
    bool has_base;  // which is not seen from inside of a solid body
    float through;
    float p_base;   // of sampling it, where no layer is chosen
    GlintLayers over;
};

bool glint_is_black(IN(BsdfParams) m, vec3 wo) {
    float facing = slope_facing(glint_mean(m), wo);
    return facing == 0.0f || (facing < 0.0f && gltf_transmissive_share(m) <= 0.0f);
}

// The base is chosen by its part of what returns, about.
float glint_base_probability(IN(BsdfParams) m, float through) {
    float facets = mix(1.0f - through, max_component(m.base_color), m.metallic);
    float clear = gltf_transmissive_share(m) * max_component(m.base_color) * through;
    float base = max_component(gltf_diffuse_color(m)) * through;
    return min(base / max(base + clear + facets, 1.0e-6f), GLINT_MOST_DIFFUSE);
}

GlintView glint_view(IN(BsdfParams) m, vec4 kernel, vec3 wo) {
    GlintView view;
    view.g = glint_of(m, kernel);
    view.turned = slope_facing(view.g.slopes.mean, wo) < 0.0f;
    view.o = view.turned ? glint_turned(m, wo) : wo;
    bool inside = view.turned && m.thin == 0u;
    view.eta = relative_ior(m.ior, inside ? -1.0f : 1.0f);
    view.has_base = !inside && gltf_has_diffuse(m);
    view.through = 0.0f;
    view.p_base = 0.0f;
    if (view.has_base) {
        view.through = glint_through(m, mesosurface_cosine(view.g.slopes.mean, view.o));
        view.p_base = glint_base_probability(m, view.through);
    }
    view.over = glint_no_layers();
    if (has_layers(m)) {
        view.over = glint_layers_seen(m, view.g.slopes.mean, view.o, view.turned);
    }
    return view;
}

GlintView glint_view(IN(BsdfParams) m, vec3 wo) {
    return glint_view(m, m.slot_e, wo);
}

BsdfValue glint_base_eval(IN(BsdfParams) m, IN(GlintView) view, vec3 i) {
    float cos_i = mesosurface_cosine(view.g.slopes.mean, i);
    float through_o = view.through;
    float through_i = glint_through(m, cos_i);
    if (m.iridescence > 0.0f) {
        // Nobody knows the film's average in closed form; the smaller share needs none.
        through_o = min(through_o, through_i);
        through_i = 1.0f;
    }
    BsdfValue v;
    v.f_cos = coupled_diffuse(gltf_diffuse_color(m), vec3(through_o), vec3(through_i),
                              vec3(m.slot_j.x)) * cos_i;
    v.pdf = cos_i * INV_PI;
    return v;
}

// Of one facet, with the base's. front: it reflects, and i is before the mesosurface.
BsdfValue glint_facet_value(IN(BsdfParams) m, IN(GlintView) view, IN(GlintFacet) facet, vec3 i,
                            bool front, bool refracts) {
    // In one place for all kinds of facets: it is by far the longest of all that is done here.
    GlintDensity p22 = glint_density(glint_method(m), view.g, facet.slope);
    float cos_t = refracts ? facet.cos_t : glint_cos_behind(m, facet.cos_h, view.eta);
    GltfFresnel f = glint_fresnel(m, facet.cos_h, cos_t, view.eta);
    float p = gltf_reflection_probability(f);
    BsdfValue v;
    v.f_cos = (front ? f.reflected : f.transmitted) * (facet.f_cos * p22.value);
    v.pdf = (front ? p : 1.0f - p) * (facet.pdf * p22.drawn) * (1.0f - view.p_base);
    if (front && view.has_base) {
        BsdfValue base = glint_base_eval(m, view, i);
        v.f_cos += base.f_cos;
        v.pdf += view.p_base * base.pdf;
    }
    if (has_layers(m)) {
        return glint_under_layers(m, view.over, view.g.slopes.mean, view.turned, i, v);
    }
    return v;
}

BsdfValue glint_eval_view(IN(BsdfParams) m, IN(GlintView) view, vec3 i) {
    bool front = slope_facing(view.g.slopes.mean, i) > 0.0f;
    if (!front && gltf_transmissive_share(m) <= 0.0f) {
        return bsdf_no_value();
    }
    bool refracts = !front && m.thin == 0u;
    GlintFacet facet;
    if (refracts) {
        facet = glint_refraction(m, view.g.slopes, view.o, i, view.eta);
    } else {
        vec3 reflected = front ? i : mesosurface_mirrored(view.g.slopes.mean, i);
        facet = glint_reflection(glint_masking(m), view.g.slopes, view.o, reflected);
    }
    return glint_facet_value(m, view, facet, i, front, refracts);
}

BsdfValue glint_bsdf_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (glint_is_black(m, wo) || slope_facing(glint_mean(m), wi) == 0.0f) {
        return bsdf_no_value();
    }
    GlintView view = glint_view(m, wo);
    return glint_eval_view(m, view, view.turned ? glint_turned(m, wi) : wi);
}

bool glint_bsdf_is_specular(IN(BsdfParams) m) {
    Slopes d = glint_of(m).slopes;
    bool smooth_coat = m.coat <= 0.0f || alpha_is_specular(m.coat_alpha, m.coat_alpha);
    return !gltf_has_diffuse(m) && m.sheen_color == vec3(0.0f) && smooth_coat
        && alpha_is_specular(sqrt(2.0f * d.var_x), sqrt(2.0f * d.var_y));
}

// A direction by a facet that the view sees; the zero vector where it sends light to the wrong
// side, from where it would be reflected again. u_facet: for its cell, and its side of the cavity.
vec3 glint_sample_facet(IN(BsdfParams) m, IN(GlintView) view, float u_lobe, vec2 u,
                        vec2 u_facet) {
    vec2 mean = view.g.slopes.mean;
    vec2 s = glint_slope_sample(glint_method(m), view.g, u, u_facet.x);
    s = sheared_cavity_visible(mean, s, view.o, u_facet.y);
    vec3 wm = facet_of(s);
    float cos_h = dot(view.o, wm);
    vec3 i = reflect(-view.o, wm);
    if (gltf_transmissive_share(m) <= 0.0f) {
        return slope_facing(mean, i) > 0.0f ? i : vec3(0.0f);
    }
    GltfFresnel f = glint_fresnel(m, cos_h, fresnel_g(cos_h, view.eta) / view.eta, view.eta);
    if (u_lobe < gltf_reflection_probability(f)) {
        return slope_facing(mean, i) > 0.0f ? i : vec3(0.0f);
    }
    if (m.thin != 0u) {
        return slope_facing(mean, i) > 0.0f ? mesosurface_mirrored(mean, i) : vec3(0.0f);
    }
    i = refracted(view.o, wm, view.eta, fresnel_g(cos_h, view.eta));
    return slope_facing(mean, i) < 0.0f ? i : vec3(0.0f);
}

BsdfSample glint_bsdf_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (glint_is_black(m, wo)) {
        return bsdf_no_sample();
    }
    GlintView view = glint_view(m, wo);
    vec2 mean = view.g.slopes.mean;
    float p_facets = 1.0f - view.p_base;
    uint lobe = glint_bsdf_is_specular(m) ? LOBE_SPECULAR : LOBE_GLOSSY;
    vec3 i;
    float p_inner = 1.0f - view.over.layers.p_coat - view.over.layers.p_sheen;
    bool on_layers = has_layers(m) && u_lobe >= p_inner;
    u_lobe = on_layers ? u_lobe - p_inner : u_lobe / p_inner;
    if (on_layers) {
        bool sheen = u_lobe < view.over.layers.p_sheen;
        i = glint_layer_sample(m, view.over, mean, sheen, u);
        lobe = sheen ? LOBE_DIFFUSE : coat_lobe(m);
    } else if (u_lobe < p_facets) {
        // Two more numbers, of what both compilers have bit by bit.
        uvec3 bits = hash_u32x3(
            uvec3(floatBitsToUint(u_lobe), floatBitsToUint(u.x), floatBitsToUint(u.y)));
        i = glint_sample_facet(m, view, u_lobe / p_facets, u,
                               vec2(unit_float(bits.x), unit_float(bits.y)));
        lobe |= slope_facing(mean, i) < 0.0f ? LOBE_TRANSMISSION : 0u;
    } else {
        vec3 n = normalize(mesosurface_normal(mean));
        i = world_from_local(frame_from_normal(n), square_to_cosine_hemisphere(u));
        lobe = LOBE_DIFFUSE;
    }
    if (slope_facing(mean, i) == 0.0f) {
        return bsdf_no_sample();
    }
    BsdfValue v = glint_eval_view(m, view, i);
    return bsdf_sample_of(view.turned ? glint_turned(m, i) : i, v, lobe);
}

// As if the surface were smooth, but for its matte base and what one scattering loses of metals:
// from before it, c above 0, without layers. Without a film, no branches, so that loops become
// vectors.
vec3 glint_front_albedo(IN(BsdfParams) m, float c) {
    float kept = 1.0f - 0.34f * mean_alpha(m);
    vec3 metal = kept * gltf_metal_fresnel(m, c);
    bool film = m.iridescence > 0.0f;
    float through = glint_through(m, c);
    vec3 facets = film ? glint_film_albedo(m, c) : vec3(1.0f - through);
    vec3 opaque = facets + m.base_color * through;
    float f = fresnel_dielectric(c, relative_ior(m.ior, 1.0f));
    vec3 mirrored = film ? mix(vec3(f), gltf_film(m, gltf_dielectric_f0(m), c), m.iridescence)
                         : vec3(f);
    vec3 clear = mirrored + m.base_color * (1.0f - max_component(mirrored));
    return mix(mix(opaque, clear, m.transmission), metal, m.metallic);
}

vec3 glint_bsdf_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o == 0.0f || (cos_o < 0.0f && gltf_transmissive_share(m) <= 0.0f)) {
        return vec3(0.0f);
    }
    if (cos_o < 0.0f && m.thin == 0u) {
        float eta = relative_ior(m.ior, cos_o);
        GltfFresnel f = glint_fresnel(m, -cos_o, fresnel_g(-cos_o, eta) / eta, eta);
        return f.reflected + f.transmitted;
    }
    float c = abs(cos_o);
    vec3 albedo = glint_front_albedo(m, c);
    vec3 w = vec3(sqrt(max(1.0f - c * c, 0.0f)), 0.0f, c);
    return has_layers(m) ? albedo_under_layers(m, w, albedo) : albedo;
}

#endif
