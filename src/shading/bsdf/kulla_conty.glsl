// A rough surface that loses nothing: one reflection at a microfacet of any distribution with any
// masking that keeps energy, what is reflected twice and more as a wide lobe beside it, and a matte
// base that gets what these two let through. White or coloured metals have a black base; with
// base_color = 0.04 it is a rough plastic.
#ifndef GP_SHADING_BSDF_KULLA_CONTY_GLSL
#define GP_SHADING_BSDF_KULLA_CONTY_GLSL
#include "shading/fresnel.glsl"
#include "shading/sampling/warps.glsl"
#include "shading/microfacet/facet_sampling.glsl"
#include "shading/microfacet/mirror_albedo.glsl"
#include "shading/bsdf/params.glsl"

// Of sampling: facets must be met even where they reflect nearly nothing.
#define KULLA_CONTY_LEAST_NARROW 0.05f

Distribution kulla_conty_normals(IN(BsdfParams) m) {
    Distribution d;
    d.kind = kulla_conty_distribution(m);
    d.alpha_x = m.alpha_x;
    d.alpha_y = m.alpha_x;
    d.shape = kulla_conty_shape(m);
    d.fit.low = m.slot_e;
    d.fit.high = m.slot_f;
    return d;
}

// The mirrors that have tables: GGX and Beckmann with Smith's masking, separable or correlated.
bool kulla_conty_has_table(IN(BsdfParams) m) {
    return kulla_conty_distribution(m) <= DISTRIBUTION_BECKMANN
        && kulla_conty_masking(m) <= MASKING_SEPARABLE;
}

uint kulla_conty_table(IN(BsdfParams) m) {
    bool beckmann = kulla_conty_distribution(m) == DISTRIBUTION_BECKMANN;
    uint first = beckmann ? ROUGH_MIRROR_BECKMANN_SEPARABLE : ROUGH_MIRROR_GGX_SEPARABLE;
    return first + (kulla_conty_masking(m) == MASKING_CORRELATED ? 1u : 0u);
}

bool kulla_conty_has_base(IN(BsdfParams) m) {
    return max_component(kulla_conty_diffuse(m)) > 0.0f;
}

ScatteringLoss kulla_conty_losses(IN(BsdfParams) m) {
    ScatteringLoss l;
    l.loss.low = m.slot_c;
    l.loss.middle = m.slot_d;
    l.loss.high = m.slot_g;
    l.average = m.slot_b.w;
    l.width = m.slot_j.y;
    l.root = kulla_conty_has_table(m) && kulla_conty_table(m) == ROUGH_MIRROR_GGX_CORRELATED;
    return l;
}

SchlickShare kulla_conty_schlick(IN(BsdfParams) m) {
    SchlickShare s;
    s.fifth_root.low = m.slot_h;
    s.fifth_root.middle = m.slot_i;
    s.fifth_root.high = vec4(0.0f);
    s.average = m.slot_j.x;
    return s;
}

// With the losses, which the other functions read; again after each change of the parameters.
BsdfParams kulla_conty_prepared(BsdfParams m) {
    SmithFit f = smith_fit_of(kulla_conty_normals(m));
    m.slot_e = f.low;
    m.slot_f = f.high;
    Distribution d = kulla_conty_normals(m);
    ScatteringLoss l;
    if (kulla_conty_has_table(m)) {
        l = scattering_loss_of(kulla_conty_table(m), m.alpha_x);
    } else {
        l = scattering_loss_by_quadrature(d, kulla_conty_masking(m));
    }
    m.slot_c = l.loss.low;
    m.slot_d = l.loss.middle;
    m.slot_g = l.loss.high;
    m.slot_b.w = l.average;
    m.slot_j.y = l.width;
    if (kulla_conty_has_base(m)) {
        SchlickShare s = schlick_share_by_quadrature(d, kulla_conty_masking(m), l);
        m.slot_h = s.fifth_root.low;
        m.slot_i = s.fifth_root.middle;
        m.slot_j.x = s.average;
    }
    return m;
}

// The albedo of the facets from the loss at an angle, and how much of it Schlick's term adds.
vec3 kulla_conty_facets(IN(BsdfParams) m, float loss, float schlick) {
    return m.base_color * (1.0f - loss - schlick) + vec3(schlick);
}

// The colour of the wide lobe: black if multiple scattering is off.
vec3 kulla_conty_wide_color(IN(BsdfParams) m, float loss_average) {
    vec3 f_average = fresnel_schlick_average(m.base_color, vec3(1.0f));
    return kulla_conty_multiple(m) ? multiple_scattering_color(f_average, loss_average)
                                   : vec3(0.0f);
}

// What depends on one direction.
struct KullaContyView {
    float loss;
    vec3 facets;   // albedo of one reflection; only with a base
    vec3 through;  // what the mirror lets through to the base
};

KullaContyView kulla_conty_view(IN(BsdfParams) m, IN(ScatteringLoss) losses, vec3 wide,
                                float cos_w) {
    KullaContyView view;
    view.loss = scattering_loss(losses, cos_w);
    view.facets = vec3(1.0f);
    view.through = vec3(0.0f);
    if (kulla_conty_has_base(m)) {
        float share = schlick_share(kulla_conty_schlick(m), cos_w);
        view.facets = kulla_conty_facets(m, view.loss, (1.0f - view.loss) * share);
        view.through = clamp(vec3(1.0f) - view.facets - view.loss * wide, 0.0f, 1.0f);
    }
    return view;
}

// The probability of the cosine: by what the wide lobe and the base return.
float kulla_conty_wide_share(IN(BsdfParams) m, IN(KullaContyView) view) {
    float wide = kulla_conty_multiple(m) ? view.loss : 0.0f;
    if (!kulla_conty_has_base(m)) {
        return wide;
    }
    wide += max_component(kulla_conty_diffuse(m) * view.through);
    float share = wide / (wide + max_component(view.facets));
    return min(share, 1.0f - KULLA_CONTY_LEAST_NARROW);
}

// One reflection, without F. [Walter et al. 2007, EGSR, equation 20]
BsdfValue kulla_conty_mirror(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    Distribution d = kulla_conty_normals(m);
    vec3 h = wo + wi;
    float h_length = length(h);
    vec3 wm = h / h_length;
    float cos_h = 0.5f * h_length;
    float d_value = distribution_d(d, wm);
    MirrorView view = mirror_view(d, kulla_conty_masking(m), wo);
    float g = mirror_masking(d, view, wi, wm.z, cos_h);
    BsdfValue v;
    v.pdf = facet_reflection_pdf(d, view.masking == MASKING_V_CAVITY, wo, wm, cos_h, d_value);
    vec3 f = fresnel_schlick(m.base_color, vec3(1.0f), cos_h);
    v.f_cos = v.pdf > 0.0f ? f * (0.25f * d_value * g / wo.z) : vec3(0.0f);
    return v;
}

// [Kulla and Conty 2017]
BsdfValue kulla_conty_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    BsdfValue v = kulla_conty_mirror(m, wo, wi);
    if (!kulla_conty_multiple(m) && !kulla_conty_has_base(m)) {
        return v;
    }
    ScatteringLoss losses = kulla_conty_losses(m);
    vec3 wide = kulla_conty_wide_color(m, losses.average);
    KullaContyView o = kulla_conty_view(m, losses, wide, wo.z);
    KullaContyView i = kulla_conty_view(m, losses, wide, wi.z);
    v.f_cos += wide * (multiple_scattering(o.loss, i.loss, losses.average) * wi.z);
    if (kulla_conty_has_base(m)) {
        vec3 facets = kulla_conty_facets(m, losses.average, kulla_conty_schlick(m).average);
        vec3 average = vec3(1.0f) - facets - losses.average * wide;
        v.f_cos += coupled_diffuse(kulla_conty_diffuse(m), o.through, i.through, average) * wi.z;
    }
    v.pdf = mix(v.pdf, cosine_hemisphere_pdf(wi), kulla_conty_wide_share(m, o));
    return v;
}

bool kulla_conty_is_specular(IN(BsdfParams) m) {
    return !kulla_conty_has_base(m) && alpha_is_specular(m.alpha_x, m.alpha_x)
        && distribution_has_short_tail(kulla_conty_distribution(m));
}

BsdfSample kulla_conty_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    if (wo.z <= 0.0f) {
        return bsdf_no_sample();
    }
    ScatteringLoss losses = kulla_conty_losses(m);
    vec3 color = kulla_conty_wide_color(m, losses.average);
    float wide = kulla_conty_wide_share(m, kulla_conty_view(m, losses, color, wo.z));
    if (u_lobe < wide) {
        vec3 wi = square_to_cosine_hemisphere(u);
        return bsdf_sample_of(wi, kulla_conty_eval(m, wo, wi), LOBE_DIFFUSE);
    }
    float u_side = min((u_lobe - wide) / (1.0f - wide), ONE_MINUS_EPSILON);
    vec3 wm = facet_sample(kulla_conty_normals(m), kulla_conty_masking(m) == MASKING_V_CAVITY, wo,
                           u_side, u);
    vec3 wi = reflect(-wo, wm);
    return bsdf_sample_of(wi, kulla_conty_eval(m, wo, wi),
                          kulla_conty_is_specular(m) ? LOBE_SPECULAR : LOBE_GLOSSY);
}

vec3 kulla_conty_albedo(IN(BsdfParams) m, float cos_o) {
    if (cos_o <= 0.0f) {
        return vec3(0.0f);
    }
    ScatteringLoss losses = kulla_conty_losses(m);
    vec3 wide = kulla_conty_wide_color(m, losses.average);
    KullaContyView view = kulla_conty_view(m, losses, wide, cos_o);
    if (kulla_conty_has_base(m)) {
        return view.facets + view.loss * wide + kulla_conty_diffuse(m) * view.through;
    }
    // Schlick's term where most light meets the microfacets: at their own angles for a rough
    // surface, at the view's for a smooth one.
    vec3 f_average = fresnel_schlick_average(m.base_color, vec3(1.0f));
    vec3 one = mix(fresnel_schlick(m.base_color, vec3(1.0f), cos_o), f_average, view.loss);
    return one * (1.0f - view.loss) + view.loss * wide;
}

#endif
