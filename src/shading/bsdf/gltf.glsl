// The glTF 2.0 metallic-roughness material with ior, specular, clearcoat, sheen, transmission (thin
// or solid), anisotropy and iridescence:
//
//   coat + T_coat (sheen + T_sheen (interface + diffuse))
//
// It follows appendix B of the specification and the extensions, with these differences, all of
// them so that no more light leaves than arrives, and the same for wo and wi exchanged:
// - The diffuse base gets what the interface lets in and out again, (1 - E(o)) (1 - E(i)) over
//   (1 - E_avg), not 1 - F(h), which at grazing angles returns up to 1.9 times the light.
// - T of coat and sheen is the smaller of 1 - E at wo and at wi, as KHR_materials_sheen has it;
//   the specification's coat looks at the view's angle only.
#ifndef GP_SHADING_BSDF_GLTF_GLSL
#define GP_SHADING_BSDF_GLTF_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/microfacet/ggx_albedo.glsl"
#include "shading/bsdf/params.glsl"
#include "shading/bsdf/coat.glsl"
#include "shading/bsdf/sheen.glsl"
#include "shading/bsdf/gltf_interface.glsl"

// What depends on the view alone, and how probable each lobe is; the interface has the rest.
struct GltfView {
    vec3 o;            // wo, mirrored to z > 0
    bool flip;
    float eta;
    float alpha;       // one width for the fits of albedos
    float f0;          // of the dielectric, the largest channel
    float coat_through;
    float sheen_through;
    float base_through;  // 1 - E(o) of the dielectric
    float p_coat;
    float p_sheen;
    float p_diffuse;
};

// Schlick's f0 that gives the film's reflectance at this angle, so that the fits of albedos work.
vec3 gltf_effective_f0(IN(BsdfParams) m, vec3 f0, float f90, float cos_w) {
    float weight = min(schlick_weight(cos_w), 0.99f);
    vec3 f = mix(fresnel_schlick(f0, vec3(f90), cos_w), gltf_film(m, f0, cos_w), m.iridescence);
    return clamp((f - vec3(f90 * weight)) / (1.0f - weight), vec3(0.0f), vec3(1.0f));
}

// 1 - E of the dielectric interface towards w, by the largest channel: one number for all, as in
// KHR_materials_specular, so that a coloured reflection does not tint the base. f0 is
// max_component(gltf_dielectric_f0(m)).
float gltf_dielectric_through(IN(BsdfParams) m, float f0, float cos_w, GgxAlbedo e) {
    float f = f0;
    if (m.iridescence > 0.0f) {
        f = max_component(gltf_effective_f0(m, gltf_dielectric_f0(m), m.specular, cos_w));
    }
    return max(1.0f - ggx_albedo_fresnel(e, f, m.specular), 0.0f);
}

bool gltf_has_diffuse(IN(BsdfParams) m) {
    return m.metallic < 1.0f && m.transmission < 1.0f;
}

vec3 gltf_diffuse_color(IN(BsdfParams) m) {
    return m.base_color * ((1.0f - m.metallic) * (1.0f - m.transmission));
}

// What coat and sheen let through towards w, on the outside.
float gltf_coat_through(IN(BsdfParams) m, vec3 w) {
    return m.coat > 0.0f ? 1.0f - coat_albedo(m, w) : 1.0f;
}

float gltf_sheen_through(IN(BsdfParams) m, vec3 w) {
    float color = max_component(m.sheen_color);
    return color > 0.0f ? 1.0f - color * sheen_albedo_white(w.z, m.sheen_alpha) : 1.0f;
}

// Only the interface can be seen from inside of a solid body.
GltfView gltf_view_from_inside(IN(BsdfParams) m, vec3 wo) {
    GltfView view;
    view.o = mirrored_z(wo);
    view.flip = true;
    view.eta = relative_ior(m.ior, -1.0f);
    view.alpha = 1.0f;
    view.f0 = 0.0f;
    view.coat_through = 1.0f;
    view.sheen_through = 1.0f;
    view.base_through = 0.0f;
    view.p_coat = 0.0f;
    view.p_sheen = 0.0f;
    view.p_diffuse = 0.0f;
    return view;
}

// The diffuse part of what interface and diffuse base return, by their albedos; a share at least
// is left to the interface, whose albedo is an estimate and whose peak may be high.
float gltf_diffuse_share(IN(BsdfParams) m, IN(GltfView) view, GgxAlbedo e) {
    float color = max_component(m.base_color);
    float base = color * view.base_through;
    float dielectric = 1.0f - view.base_through + base * m.transmission;
    float interface_weight = dielectric;
    if (m.metallic > 0.0f) {
        interface_weight = mix(dielectric, ggx_albedo_fresnel(e, color, 1.0f), m.metallic);
    }
    float diffuse = base * (1.0f - m.metallic) * (1.0f - m.transmission);
    return min(diffuse / max(diffuse + interface_weight, 1.0e-6f), 0.98f);
}

// Lobes are chosen in proportion to their estimated albedos.
GltfView gltf_view(IN(BsdfParams) m, vec3 wo) {
    if (wo.z < 0.0f && m.thin == 0u) {
        return gltf_view_from_inside(m, wo);
    }
    GltfView view;
    view.flip = wo.z < 0.0f;
    view.o = view.flip ? mirrored_z(wo) : wo;
    view.eta = m.transmission > 0.0f ? relative_ior(m.ior, 1.0f) : 1.0f;
    view.coat_through = gltf_coat_through(m, view.o);
    view.sheen_through = gltf_sheen_through(m, view.o);
    view.p_coat = 1.0f - view.coat_through;
    view.p_sheen = view.coat_through * (1.0f - view.sheen_through);
    view.alpha = mean_alpha(m);
    view.f0 = 0.0f;
    view.base_through = 0.0f;
    view.p_diffuse = 0.0f;
    if (gltf_has_diffuse(m)) {
        GgxAlbedo e = ggx_albedo(view.o.z, view.alpha);
        view.f0 = max_component(gltf_dielectric_f0(m));
        view.base_through = gltf_dielectric_through(m, view.f0, view.o.z, e);
        float share = gltf_diffuse_share(m, view, e);
        view.p_diffuse = (1.0f - view.p_coat - view.p_sheen) * share;
    }
    return view;
}

float gltf_interface_probability(IN(GltfView) view) {
    return 1.0f - view.p_coat - view.p_sheen - view.p_diffuse;
}

// Diffuse reflection under the interface; with F = 1 - E the two sum up to white.
// [Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks", section "Diffuse"]
vec3 gltf_diffuse_f_cos(IN(BsdfParams) m, IN(GltfView) view, vec3 i) {
    float through_i = gltf_dielectric_through(m, view.f0, i.z, ggx_albedo(i.z, view.alpha));
    float scale;
    if (m.iridescence > 0.0f) {
        // The film's average is not known in closed form; the smaller share needs none.
        scale = min(view.base_through, through_i);
    } else {
        GgxAlbedo e = ggx_albedo_average(view.alpha);
        float average = ggx_albedo_fresnel(e, view.f0, m.specular);
        scale = view.base_through * through_i / max(1.0f - average, 1.0e-3f);
    }
    return gltf_diffuse_color(m) * (scale * INV_PI * i.z);
}

// The base's value `base` seen through sheen and coat, and what these two add.
BsdfValue gltf_under_layers(IN(BsdfParams) m, IN(GltfView) view, vec3 i, IN(BsdfValue) base) {
    BsdfValue v = base;
    // The direction on the other side of the layers, were they to be crossed twice: light that
    // enters a solid body crosses them once, on wo's side; light that leaves it, on wi's.
    bool enters = i.z < 0.0f && m.thin == 0u && !view.flip;
    vec3 far_side = vec3(i.x, i.y, abs(i.z));
    if (m.sheen_color != vec3(0.0f)) {
        float through = enters ? 1.0f : gltf_sheen_through(m, far_side);
        v.f_cos *= min(view.sheen_through, through);
        if (i.z > 0.0f) {
            v.f_cos += m.sheen_color * sheen_f_cos(view.o, i, m.sheen_alpha);
            v.pdf += view.p_sheen * uniform_hemisphere_pdf(i);
        }
    }
    if (m.coat > 0.0f) {
        float through = enters ? 1.0f : gltf_coat_through(m, far_side);
        v.f_cos *= min(view.coat_through, through);
        BsdfValue coat = coat_eval(m, view.o, i);
        v.f_cos += coat.f_cos;
        v.pdf += view.p_coat * coat.pdf;
    }
    return v;
}

// All lobes towards wi, in the frame in which the view is above.
BsdfValue gltf_eval_view(IN(BsdfParams) m, IN(GltfView) view, vec3 i) {
    if (i.z < 0.0f && gltf_transmissive_share(m) <= 0.0f) {
        return bsdf_no_value();
    }
    BsdfValue v = gltf_interface_eval(m, view.o, i, view.eta);
    v.pdf *= gltf_interface_probability(view);
    bool inside = view.flip && m.thin == 0u;
    if (i.z > 0.0f && !inside && gltf_has_diffuse(m)) {
        v.f_cos += gltf_diffuse_f_cos(m, view, i);
        v.pdf += view.p_diffuse * cosine_hemisphere_pdf(i);
    }
    if (inside && i.z > 0.0f) {
        return v;
    }
    if (m.coat > 0.0f || m.sheen_color != vec3(0.0f)) {
        return gltf_under_layers(m, view, i, v);
    }
    return v;
}

bool gltf_is_black(IN(BsdfParams) m, vec3 wo) {
    return wo.z == 0.0f || (wo.z < 0.0f && gltf_transmissive_share(m) <= 0.0f);
}

BsdfValue gltf_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (gltf_is_black(m, wo) || wi.z == 0.0f) {
        return bsdf_no_value();
    }
    GltfView view = gltf_view(m, wo);
    return gltf_eval_view(m, view, view.flip ? mirrored_z(wi) : wi);
}

BsdfSample gltf_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (gltf_is_black(m, wo)) {
        return bsdf_no_sample();
    }
    GltfView view = gltf_view(m, wo);
    vec3 i;
    uint lobe = LOBE_DIFFUSE;
    float p_interface = gltf_interface_probability(view);
    if (u_lobe < p_interface) {
        i = gltf_interface_sample(m, view.o, view.eta, u_lobe / p_interface, u);
        lobe = microfacet_lobe(m, i.z < 0.0f ? LOBE_TRANSMISSION : 0u);
    } else if (u_lobe < p_interface + view.p_diffuse) {
        i = square_to_cosine_hemisphere(u);
    } else if (u_lobe < p_interface + view.p_diffuse + view.p_sheen) {
        i = square_to_uniform_hemisphere(u);
    } else {
        i = coat_sample_direction(m, view.o, u);
        if (i.z <= 0.0f) {
            return bsdf_no_sample();
        }
        lobe = alpha_is_specular(m.coat_alpha, m.coat_alpha) ? LOBE_SPECULAR : LOBE_GLOSSY;
    }
    if (i.z == 0.0f) {
        return bsdf_no_sample();
    }
    BsdfValue v = gltf_eval_view(m, view, i);
    return bsdf_sample_of(view.flip ? mirrored_z(i) : i, v, lobe);
}

vec3 gltf_albedo(IN(BsdfParams) m, float cos_o) {
    vec3 wo = vec3(sqrt(max(1.0f - cos_o * cos_o, 0.0f)), 0.0f, cos_o);
    if (gltf_is_black(m, wo)) {
        return vec3(0.0f);
    }
    float c = abs(cos_o);
    GgxAlbedo e = ggx_albedo(c, mean_alpha(m));
    vec3 f0 = gltf_dielectric_f0(m);
    float max_f0 = max_component(f0);
    vec3 metal_f0 = m.base_color;
    if (m.iridescence > 0.0f) {
        f0 = gltf_effective_f0(m, f0, m.specular, c);
        metal_f0 = gltf_effective_f0(m, metal_f0, 1.0f, c);
    }
    vec3 dielectric = ggx_albedo_fresnel(e, f0, vec3(m.specular));
    dielectric += m.base_color * gltf_dielectric_through(m, max_f0, c, e);
    vec3 metal = ggx_albedo_fresnel(e, metal_f0, vec3(1.0f));
    vec3 albedo = mix(dielectric, metal, m.metallic);
    vec3 outer = vec3(wo.x, 0.0f, c);
    albedo = albedo * gltf_sheen_through(m, outer);
    albedo += m.sheen_color * sheen_albedo_white(c, m.sheen_alpha);
    float through = gltf_coat_through(m, outer);
    return albedo * through + vec3(1.0f - through);
}

// f |cos_i| of the diffuse base alone, seen through the layers above it.
vec3 gltf_diffuse_part(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (!(wo.z * wi.z > 0.0f) || !gltf_has_diffuse(m) || (wo.z < 0.0f && m.thin == 0u)) {
        return vec3(0.0f);
    }
    if (gltf_is_black(m, wo)) {
        return vec3(0.0f);
    }
    GltfView view = gltf_view(m, wo);
    vec3 i = view.flip ? mirrored_z(wi) : wi;
    vec3 f_cos = gltf_diffuse_f_cos(m, view, i);
    if (m.sheen_color != vec3(0.0f)) {
        f_cos *= min(view.sheen_through, gltf_sheen_through(m, i));
    }
    if (m.coat > 0.0f) {
        f_cos *= min(view.coat_through, gltf_coat_through(m, i));
    }
    return f_cos;
}

// The albedo of that, but for how much the layers let in from each direction.
vec3 gltf_diffuse_albedo(IN(BsdfParams) m, float cos_o) {
    vec3 wo = vec3(sqrt(max(1.0f - cos_o * cos_o, 0.0f)), 0.0f, abs(cos_o));
    if (!gltf_has_diffuse(m) || wo.z == 0.0f) {
        return vec3(0.0f);
    }
    GltfView view = gltf_view(m, wo);
    return gltf_diffuse_color(m) * (view.base_through * view.sheen_through * view.coat_through);
}

bool gltf_is_specular(IN(BsdfParams) m) {
    bool smooth_coat = m.coat <= 0.0f || alpha_is_specular(m.coat_alpha, m.coat_alpha);
    return !gltf_has_diffuse(m) && m.sheen_color == vec3(0.0f) && smooth_coat
        && alpha_is_specular(m.alpha_x, m.alpha_y);
}

#endif
