// Reflectance and transmission of surfaces: one interface for all models of models.def. The
// conventions (frame, radiance, what a weight of zero means) stand in params.glsl.
#ifndef GP_SHADING_BSDF_BSDF_GLSL
#define GP_SHADING_BSDF_BSDF_GLSL
#include "shading/bsdf/params.glsl"

#define BSDF_MODEL_FILES
#include "shading/bsdf/models.def"
#undef BSDF_MODEL_FILES

// White Lambert; every parameter has the value that switches its feature off. What the renderer
// fills in point by point: the slots of the library's models are not written.
BsdfParams bsdf_default() {
    return bsdf_fields_of(MODEL_LAMBERT);
}

// The models of the library, out of line and with a copy of the parameters: inlined into the hot
// code, or with a reference to its parameters, they would cost every path of the renderer.
OUT_OF_LINE BsdfValue bsdf_library_eval(BsdfParams m, vec3 wo, vec3 wi) {
    switch (m.model) {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text)
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    case number: return eval(m, wo, wi);
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
    default: break;
    }
    return bsdf_no_value();
}

OUT_OF_LINE BsdfSample bsdf_library_sample(BsdfParams m, vec3 wo, float u_lobe, vec2 u) {
    switch (m.model) {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text)
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    case number: return sample_fn(m, wo, u_lobe, u);
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
    default: break;
    }
    return bsdf_no_sample();
}

OUT_OF_LINE vec3 bsdf_library_albedo(BsdfParams m, float cos_o) {
    switch (m.model) {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text)
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    case number: return albedo(m, cos_o);
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
    default: break;
    }
    return vec3(0.0f);
}

OUT_OF_LINE bool bsdf_library_is_specular(BsdfParams m) {
    switch (m.model) {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text)
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    case number: return is_specular(m);
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
    default: break;
    }
    return false;
}

// Whether bsdf_prepared changes anything that bsdf_eval reads.
bool bsdf_needs_preparation(uint model) {
    return model == MODEL_MICROFACET || model == MODEL_KULLA_CONTY || model == MODEL_GLINT;
}

// Parameters with what a model derives from them: once when they are set, before everything below.
BsdfParams bsdf_prepared(BsdfParams m) {
    if (m.model == MODEL_MICROFACET) {
        return microfacet_prepared(m);
    }
    if (m.model == MODEL_KULLA_CONTY) {
        return kulla_conty_prepared(m);
    }
    if (m.model == MODEL_GLINT) {
        return glint_prepared(m);
    }
    // What integrators and guides read of every model: the width of its lobe, the medium behind it.
    if (m.model == MODEL_DISNEY || m.model == MODEL_DISNEY_BSDF) {
        float roughness = m.model == MODEL_DISNEY ? disney_roughness(m)
                                                  : disney_bsdf_roughness(m);
        m.alpha_x = max(roughness * roughness, BSDF_MIN_ALPHA);
        m.alpha_y = m.alpha_x;
    }
    if (m.model == MODEL_GGX_DIELECTRIC) {
        m.thin = 0u;
    }
    return m;
}

// f |cos_i| and the density of wi.
BsdfValue bsdf_eval(IN(BsdfParams) m, vec3 wo, vec3 wi) {
    switch (m.model) {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    case number: return eval(m, wo, wi);
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text)
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
    default: break;
    }
    return bsdf_library_eval(m, wo, wi);
}

// A direction wi for the given wo; u_lobe chooses the lobe, u the direction, both in [0, 1).
BsdfSample bsdf_sample(IN(BsdfParams) m, vec3 wo, float u_lobe, vec2 u) {
    switch (m.model) {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    case number: return sample_fn(m, wo, u_lobe, u);
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text)
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
    default: break;
    }
    return bsdf_library_sample(m, wo, u_lobe, u);
}

// Directional albedo, approximately: for guide images and for choosing, never for the light itself.
vec3 bsdf_albedo(IN(BsdfParams) m, float cos_o) {
    switch (m.model) {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    case number: return albedo(m, cos_o);
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text)
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
    default: break;
    }
    return bsdf_library_albedo(m, cos_o);
}

// Every lobe is so narrow that light sampling is pointless: the integrator then leaves it out and
// gives BSDF sampling the full weight.
bool bsdf_is_specular(IN(BsdfParams) m) {
    switch (m.model) {
#define BSDF_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text) \
    case number: return is_specular(m);
#define BSDF_LIBRARY_MODEL(number, name, eval, sample_fn, albedo, is_specular, flags, cite, text)
#include "shading/bsdf/models.def"
#undef BSDF_MODEL
#undef BSDF_LIBRARY_MODEL
    default: break;
    }
    return bsdf_library_is_specular(m);
}

#endif
