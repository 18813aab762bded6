// Sheen: the shine of fibres that stand up from cloth, strongest at grazing angles.
#ifndef GP_SHADING_BSDF_SHEEN_GLSL
#define GP_SHADING_BSDF_SHEEN_GLSL
#include "shading/sampling/warps.glsl"
#include "shading/bsdf/params.glsl"

// Below this width the published masking fit returns more light than came in (albedo 2.1 at
// alpha = 0.01, grazing); our own limit, it stands for a sheenRoughness of 0.26.
#define SHEEN_MIN_ALPHA 0.07f

// "Charlie". [Estevez and Kulla 2017, "Production Friendly Microfacet Sheen BRDF", equation 2]
float sheen_d(float sin2_h, float alpha) {
    float inv_alpha = 1.0f / alpha;
    return (2.0f + inv_alpha) * pow(max(sin2_h, 1.0e-20f), 0.5f * inv_alpha) * INV_TWO_PI;
}

// The logarithm of Lambda for cosines up to 1/2. [Estevez and Kulla 2017, equation 3 and table 1]
float sheen_l(float x, float alpha) {
    float t = (1.0f - alpha) * (1.0f - alpha);
    float a = mix(21.5473f, 25.3245f, t);
    float b = mix(3.82987f, 3.32435f, t);
    float c = mix(0.19823f, 0.16801f, t);
    float d = mix(-1.97760f, -1.27393f, t);
    float e = mix(-4.32054f, -4.85967f, t);
    return a / (1.0f + b * pow(x, c)) + d * x + e;
}

float sheen_lambda(float cos_theta, float alpha) {
    if (cos_theta < 0.5f) {
        return exp(sheen_l(cos_theta, alpha));
    }
    return exp(2.0f * sheen_l(0.5f, alpha) - sheen_l(1.0f - cos_theta, alpha));
}

// Albedo of white sheen; our own fit to a quadrature of 1200 x 360 directions, error 0.0084.
float sheen_albedo_white(float cos_o, float sheen_alpha) {
    float r = 2.0f * sqrt(clamp(sheen_alpha, SHEEN_MIN_ALPHA, 1.0f)) - 1.25f;
    float x = 2.0f * sqrt(clamp(cos_o, 0.0f, 1.0f)) - 1.0f;
    float c0 = 0.418354f + r * (0.233771f + r * (-0.010362f
             + r * (-0.103385f + r * (-0.096069f + r * 0.054204f))));
    float c1 = -0.451899f + r * (-0.000521f + r * (-0.165232f
             + r * (0.218536f + r * (0.052818f - r * 0.024792f))));
    float c2 = 0.22676f + r * (-0.045615f + r * (0.135878f
             + r * (-0.190165f + r * (0.376184f - r * 0.377352f))));
    float c3 = -0.177778f + r * (-0.02627f + r * (0.082303f
             + r * (-0.097759f + r * (-0.243191f + r * 0.332205f))));
    float c4 = -0.226492f + r * (-0.021557f + r * (-0.006268f
             + r * (0.071603f + r * (-0.190064f + r * 0.214215f))));
    float c5 = 0.280345f + r * (0.013594f + r * (0.007427f
             + r * (0.004328f + r * (0.089287f - r * 0.166939f))));
    float e = c0 + x * (c1 + x * (c2 + x * (c3 + x * (c4 + x * c5))));
    return clamp(e, 0.0f, 1.0f);
}

// White sheen times cos_i; wo.z > 0 and wi.z > 0. [KHR_materials_sheen, "Implementation Notes"]
float sheen_f_cos(vec3 wo, vec3 wi, float sheen_alpha) {
    float alpha = clamp(sheen_alpha, SHEEN_MIN_ALPHA, 1.0f);
    vec3 h = wo + wi;
    float sin2_h = (h.x * h.x + h.y * h.y) / dot(h, h);
    // The fit of Lambda is finite at the horizon, where it should grow like 1 / cos; clamped, the
    // quotient stays bounded.
    float cos_o = max(wo.z, 1.0e-4f);
    float cos_i = max(wi.z, 1.0e-4f);
    float lambda = sheen_lambda(cos_o, alpha) + sheen_lambda(cos_i, alpha);
    return sheen_d(sin2_h, alpha) * (wi.z / cos_i) / (4.0f * cos_o * (1.0f + lambda));
}

BsdfValue sheen_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0f || wi.z <= 0.0f) {
        return bsdf_no_value();
    }
    BsdfValue v;
    v.f_cos = m.sheen_color * sheen_f_cos(wo, wi, m.sheen_alpha);
    v.pdf = uniform_hemisphere_pdf(wi);
    return v;
}

// Uniformly over the hemisphere: the lobe is wide, and cosine sampling would starve its brightest
// part at the horizon. [Estevez and Kulla 2017, section "Importance sampling"]
BsdfSample sheen_sample(IN(BsdfParams) m, vec3 wo, float, vec2 u) {
    vec3 wi = square_to_uniform_hemisphere(u);
    return bsdf_sample_of(wi, sheen_eval(m, wo, wi), LOBE_DIFFUSE);
}

vec3 sheen_albedo(IN(BsdfParams) m, float cos_o) {
    return cos_o > 0.0f ? m.sheen_color * sheen_albedo_white(cos_o, m.sheen_alpha) : vec3(0.0f);
}

bool sheen_is_specular(IN(BsdfParams)) {
    return false;
}

#endif
