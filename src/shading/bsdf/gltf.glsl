// The glTF 2.0 metallic-roughness material with ior, specular, clearcoat, sheen, transmission (thin
// or solid), anisotropy and iridescence:
//
//   coat + T_coat (sheen + T_sheen (interface + diffuse))
//
// It follows appendix B of the specification and the extensions, with these differences, all of
// them so that no more light leaves than arrives, and the same for wo and wi exchanged:
// - The diffuse base gets what the interface lets in and out again, (1 - E(o)) (1 - E(i)) over
//   (1 - E_avg), not 1 - F(h), which at grazing angles returns up to 1.9 times the light.
// - T of coat and sheen is the smaller of 1 - E at wo and at wi (layers.glsl); the
//   specification's coat looks at the view's angle only.
#ifndef GP_SHADING_BSDF_GLTF_GLSL
#define GP_SHADING_BSDF_GLTF_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/microfacet/ggx_albedo.glsl"
#include "shading/bsdf/params.glsl"
#include "shading/bsdf/gltf_interface.glsl"
#include "shading/bsdf/layers.glsl"

// What depends on the view alone, and how probable each lobe is; the interface has the rest.
struct GltfView {
    vec3 o;            // wo, mirrored to z > 0
    bool flip;
    float eta;
    float alpha;       // one width for the fits of albedos
    float f0;          // of the dielectric, the largest channel
    float base_through;  // 1 - E(o) of the dielectric
    float p_diffuse;
    Layers layers;
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

// Only the interface can be seen from inside of a solid body.
GltfView gltf_view_from_inside(IN(BsdfParams) m, vec3 wo) {
    GltfView view;
    view.o = mirrored_z(wo);
    view.flip = true;
    view.eta = relative_ior(m.ior, -1.0f);
    view.alpha = 1.0f;
    view.f0 = 0.0f;
    view.base_through = 0.0f;
    view.p_diffuse = 0.0f;
    view.layers = layers_none();
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
    view.layers = layers_seen(m, view.o);
    view.alpha = mean_alpha(m);
    view.f0 = 0.0f;
    view.base_through = 0.0f;
    view.p_diffuse = 0.0f;
    if (gltf_has_diffuse(m)) {
        GgxAlbedo e = ggx_albedo(view.o.z, view.alpha);
        view.f0 = max_component(gltf_dielectric_f0(m));
        view.base_through = gltf_dielectric_through(m, view.f0, view.o.z, e);
        float share = gltf_diffuse_share(m, view, e);
        view.p_diffuse = (1.0f - view.layers.p_coat - view.layers.p_sheen) * share;
    }
    return view;
}

float gltf_interface_probability(IN(GltfView) view) {
    return 1.0f - view.layers.p_coat - view.layers.p_sheen - view.p_diffuse;
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
    if (has_layers(m)) {
        bool enters = i.z < 0.0f && m.thin == 0u && !view.flip;
        return under_layers(m, view.layers, view.o, i, enters, v);
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
    } else if (u_lobe < p_interface + view.p_diffuse + view.layers.p_sheen) {
        i = square_to_uniform_hemisphere(u);
    } else {
        i = coat_sample_direction(m, view.o, u);
        if (i.z <= 0.0f) {
            return bsdf_no_sample();
        }
        lobe = coat_lobe(m);
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
    return albedo_under_layers(m, vec3(wo.x, 0.0f, c), albedo);
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
    return gltf_diffuse_f_cos(m, view, i) * layers_through(m, view.layers, i);
}

// The albedo of that, but for how much the layers let in from each direction.
vec3 gltf_diffuse_albedo(IN(BsdfParams) m, float cos_o) {
    vec3 wo = vec3(sqrt(max(1.0f - cos_o * cos_o, 0.0f)), 0.0f, abs(cos_o));
    if (!gltf_has_diffuse(m) || wo.z == 0.0f) {
        return vec3(0.0f);
    }
    GltfView view = gltf_view(m, wo);
    float through = view.layers.sheen_through * view.layers.coat_through;
    return gltf_diffuse_color(m) * (view.base_through * through);
}

bool gltf_is_specular(IN(BsdfParams) m) {
    bool smooth_coat = m.coat <= 0.0f || alpha_is_specular(m.coat_alpha, m.coat_alpha);
    return !gltf_has_diffuse(m) && m.sheen_color == vec3(0.0f) && smooth_coat
        && alpha_is_specular(m.alpha_x, m.alpha_y);
}

#endif
