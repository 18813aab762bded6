// Makes the numbers of smith_fit.glsl for a distribution: some thousand evaluations of D, once for
// a material. With t the tangent of a normal and P22 = D cos^4, a direction of cotangent c has
//
//   Lambda = 2 integral_c^inf P22(t) t (sqrt(t^2 / c^2 - 1) - acos(c / t)) dt,
//
// the area of the facets that look away from it (the azimuth is integrated in closed form), and the
// mean slope is m = 2 integral P22 t^2 dt. Both are sums at equal steps in the logarithm of t,
// which converge fast for functions as smooth as these.
#ifndef GP_SHADING_MICROFACET_SMITH_QUADRATURE_GLSL
#define GP_SHADING_MICROFACET_SMITH_QUADRATURE_GLSL
#include "shading/microfacet/distribution.glsl"

#define SMITH_STEPS 64

// P22 of the isotropic surface.
float slope_density(IN(Distribution) d, float alpha, float t) {
    float z = inversesqrt(1.0f + t * t);
    float z2 = z * z;
    return isotropic_d(d, vec3(t * z, 0.0f, z), alpha) * z2 * z2;
}

// Steeper slopes do not count.
float steepest_slope(IN(Distribution) d, float alpha) {
    switch (d.kind) {
    case DISTRIBUTION_BLINN_PHONG:
        return sqrt(exp(min(40.0f / (1.0f / (alpha * alpha) + 1.0f), 18.0f)) - 1.0f);
    case DISTRIBUTION_SHIFTED_GAMMA: return sqrt(20.0f * alpha);
    case DISTRIBUTION_BECKMANN: return 6.3f * alpha;
    case DISTRIBUTION_EXPONENTIAL_POWER: return alpha * pow(40.0f, 0.5f / d.shape);
    default: break;
    }
    return 1.0e4f;
}

float mean_slope_of(IN(Distribution) d, float alpha) {
    float first = log(alpha) - 6.0f;
    float step_size = (log(steepest_slope(d, alpha)) - first) / float(SMITH_STEPS);
    float sum = 0.0f;
    for (int i = 0; i < SMITH_STEPS; ++i) {
        float t = exp(first + (float(i) + 0.5f) * step_size);
        sum += slope_density(d, alpha, t) * t * t * t;
    }
    return 2.0f * step_size * sum;
}

// [Heitz 2014, JCGT 3(2), section 4.2; the integral above: what faces away, over the cosine]
float smith_lambda_by_quadrature(IN(Distribution) d, float alpha, float c) {
    // Flatter slopes than 1/50 of alpha do not count either.
    float first = max(c, 0.02f * alpha);
    float last = steepest_slope(d, alpha);
    if (first >= last) {
        return 0.0f;
    }
    // t = first e^(q^2): at t = c the integrand then begins like q^4, which equal steps like.
    float step_size = sqrt(log(last / first)) / float(SMITH_STEPS);
    float sum = 0.0f;
    for (int i = 1; i <= SMITH_STEPS; ++i) {
        float q = float(i) * step_size;
        float t = first * exp(q * q);
        float ratio = t / c;
        float away = sqrt(max((ratio - 1.0f) * (ratio + 1.0f), 0.0f))
                   - acos(min(1.0f / ratio, 1.0f));
        sum += slope_density(d, alpha, t) * t * t * away * q;
    }
    return 4.0f * step_size * sum;
}

SmithFit smith_fit_of(IN(Distribution) d) {
    SmithFit f = smith_fit_none();
    if (!distribution_needs_fit(d.kind)) {
        return f;
    }
    float alpha = distribution_mean_alpha(d);
    float m = mean_slope_of(d, alpha);
    f.low.x = m;
    for (int node = 0; node < 7; ++node) {
        float angle = smith_fit_angle(node);
        float place = 0.5f + 0.5f * cos(angle);
        float c = 4.0f * m * place / (1.0f - place);
        float u = c / (c + m);
        float g1 = 1.0f / (1.0f + smith_lambda_by_quadrature(d, alpha, c));
        f = smith_fit_with_node(f, (g1 / u - 1.0f) / (u * (1.0f - u)), angle);
    }
    return f;
}

#endif
