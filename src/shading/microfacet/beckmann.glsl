// The Beckmann distribution (Gaussian slopes) with the masking of Smith, anisotropic. Conventions
// as in ggx.glsl.
#ifndef GP_SHADING_MICROFACET_BECKMANN_GLSL
#define GP_SHADING_MICROFACET_BECKMANN_GLSL
#include "shading/constants.glsl"
#include "shading/special.glsl"

#define INV_SQRT_PI 0.564189583547756286948f

// exp(x^2) erfc(x) for x >= 0, relative error 1.2e-7: Lambda is a difference of two numbers of
// this size, so that an absolute error would not do.
// [Press et al. 2007, "Numerical Recipes", section 6.2.2, Chebyshev fit "erfcc"]
float erfcx_positive(float x) {
    float t = 1.0f / (1.0f + 0.5f * x);
    float p = -0.82215223f + t * 0.17087277f;
    p = -1.13520398f + t * (1.48851587f + t * p);
    p = -0.18628806f + t * (0.27886807f + t * p);
    p = 0.37409196f + t * (0.09678418f + t * p);
    return t * exp(-1.26551223f + t * (1.00002368f + t * p));
}

float erf_approximation(float x) {
    float a = abs(x);
    float e = 1.0f - exp(-a * a) * erfcx_positive(a);
    return x < 0.0f ? -e : e;
}

// The inverse of the error function on (-1, 1). [Giles 2012, GPU Computing Gems, single precision]
float erf_inverse(float x) {
    float w = -log(max((1.0f - x) * (1.0f + x), 1.0e-20f));
    if (w < 5.0f) {
        w -= 2.5f;
        float p = 3.43273939e-07f + w * 2.81022636e-08f;
        p = -4.39150654e-06f + w * (-3.5233877e-06f + w * p);
        p = -0.00125372503f + w * (0.00021858087f + w * p);
        p = 0.246640727f + w * (-0.00417768164f + w * p);
        return x * (1.50140941f + w * p);
    }
    w = sqrt(w) - 3.0f;
    float p = 0.000100950558f + w * -0.000200214257f;
    p = -0.00367342844f + w * (0.00134934322f + w * p);
    p = -0.0076224613f + w * (0.00573950773f + w * p);
    p = 1.00167406f + w * (0.00943887047f + w * p);
    return x * (2.83297682f + w * p);
}

// [Walter et al. 2007, EGSR, equation 25; anisotropic: Heitz 2014, JCGT 3(2), equation 84]
float beckmann_d(vec3 wm, float alpha_x, float alpha_y) {
    if (wm.z <= 0.0f) {
        return 0.0f;
    }
    float x = wm.x / (alpha_x * wm.z);
    float y = wm.y / (alpha_y * wm.z);
    float e = x * x + y * y;
    float z2 = wm.z * wm.z;
    // Far out the numerator is 0, but so may be the denominator.
    return e < 80.0f ? exp(-e) * INV_PI / (alpha_x * alpha_y * z2 * z2) : 0.0f;
}

// 1 / (alpha tan) of the direction, alpha taken along it; large for the normal itself.
float beckmann_a(vec3 w, float alpha_x, float alpha_y) {
    float x = alpha_x * w.x;
    float y = alpha_y * w.y;
    return abs(w.z) * inversesqrt(max(x * x + y * y, 1.0e-30f));
}

// Smith's integral, exact. [Heitz 2014, equation 66]
float beckmann_lambda(vec3 w, float alpha_x, float alpha_y) {
    float a = beckmann_a(w, alpha_x, alpha_y);
    // Beyond 6 the value is below 1e-17 and a^2 may overflow.
    if (a > 6.0f) {
        return 0.0f;
    }
    return max(0.5f * exp(-a * a) * (INV_SQRT_PI / max(a, 1.0e-20f) - erfcx_positive(a)), 0.0f);
}

// Its rational fit; cheaper, off by at most 4e-3 in G1, and not continuous at a = 1.6.
// [Walter et al. 2007, equation 27; Lambda: Heitz 2014, section 5.2]
float beckmann_lambda_rational(vec3 w, float alpha_x, float alpha_y) {
    float a = beckmann_a(w, alpha_x, alpha_y);
    if (a >= 1.6f) {
        return 0.0f;
    }
    return (1.0f - 1.259f * a + 0.396f * a * a) / (3.535f * a + 2.181f * a * a);
}

float beckmann_g1(vec3 w, float alpha_x, float alpha_y) {
    return 1.0f / (1.0f + beckmann_lambda(w, alpha_x, alpha_y));
}

// [Heitz 2014, equation 98]
float beckmann_g2_separable(vec3 wo, vec3 wi, float alpha_x, float alpha_y) {
    return beckmann_g1(wo, alpha_x, alpha_y) * beckmann_g1(wi, alpha_x, alpha_y);
}

// [Heitz 2014, equation 99]
float beckmann_g2_correlated(vec3 wo, vec3 wi, float alpha_x, float alpha_y) {
    return 1.0f / (1.0f + beckmann_lambda(wo, alpha_x, alpha_y)
                        + beckmann_lambda(wi, alpha_x, alpha_y));
}

// [Heitz and d'Eon 2014, EGSR, equation 2]
float beckmann_vndf_pdf(vec3 wo, vec3 wm, float alpha_x, float alpha_y) {
    float visible = max(dot(wo, wm), 0.0f);
    return beckmann_g1(wo, alpha_x, alpha_y) * visible * beckmann_d(wm, alpha_x, alpha_y)
         / max(abs(wo.z), 1.0e-20f);
}

// A normal with the density D cos, whoever sees it. [Walter et al. 2007, EGSR, equations 28 and 29;
// anisotropic: the disk of slopes is stretched to an ellipse]
vec3 beckmann_sample_d(vec2 u, float alpha_x, float alpha_y) {
    float r = sqrt(-log1p_accurate(-u.x));
    float phi = TWO_PI * u.y;
    return normalize(vec3(alpha_x * r * cos(phi), alpha_y * r * sin(phi), 1.0f));
}

// The slope along the view of the facets that a direction of the given cotangent sees, alpha = 1:
// inverts (1 + erf(s) + tan exp(-s^2) / sqrt(pi)) = u * (its value at s = cot) by Newton steps
// that a shrinking bracket keeps safe. [Jakob 2014, "An Improved Visible Normal Sampling Routine
// for the Beckmann Distribution"]
float beckmann_visible_slope(float cot_theta, float u) {
    float tan_theta = 1.0f / cot_theta;
    // The density beyond a slope of 4 is 1e-7 of the whole.
    float low = -4.0f;
    float high = min(cot_theta, 4.0f);
    float total = 1.0f + erf_approximation(high)
                + tan_theta * INV_SQRT_PI * exp(-high * high);
    float target = u * total;
    // Where the unmasked distribution would be: a good start except at grazing angles.
    float s = clamp(erf_inverse(clamp(2.0f * u - 1.0f, -0.9999f, 0.9999f)) - 0.3f, low, high);
    for (int i = 0; i < 20; ++i) {
        float gauss = INV_SQRT_PI * exp(-s * s);
        float excess = 1.0f + erf_approximation(s) + tan_theta * gauss - target;
        if (excess > 0.0f) {
            high = s;
        } else {
            low = s;
        }
        float slope = 2.0f * gauss * (1.0f - s * tan_theta);
        float next = slope > 0.0f ? s - excess / slope : low;
        next = next > low && next < high ? next : 0.5f * (low + high);
        // Newton's steps square the error: after one of 1e-4 only rounding is left.
        if (abs(next - s) < 1.0e-4f) {
            return next;
        }
        s = next;
    }
    return s;
}

// A normal as wo sees them; wo.z > 0. [Heitz and d'Eon 2014, algorithm 4]
vec3 beckmann_sample_vndf(vec3 wo, float alpha_x, float alpha_y, vec2 u) {
    vec3 w = normalize(vec3(alpha_x * wo.x, alpha_y * wo.y, wo.z));
    float sin2 = w.x * w.x + w.y * w.y;
    // Across the view the slopes are Gaussian whatever the angle.
    float across = erf_inverse(clamp(2.0f * u.y - 1.0f, -0.9999999f, 0.9999999f));
    vec2 slope;
    if (sin2 < 1.0e-8f) {
        // Seen from above, nothing is hidden and the azimuth has no direction of its own.
        slope = vec2(erf_inverse(clamp(2.0f * u.x - 1.0f, -0.9999999f, 0.9999999f)), across);
    } else {
        float inv_sin = inversesqrt(sin2);
        float along = beckmann_visible_slope(max(w.z * inv_sin, 1.0e-6f), u.x);
        float cos_phi = w.x * inv_sin;
        float sin_phi = w.y * inv_sin;
        slope = vec2(cos_phi * along - sin_phi * across, sin_phi * along + cos_phi * across);
    }
    return normalize(vec3(-alpha_x * slope.x, -alpha_y * slope.y, 1.0f));
}

#endif
