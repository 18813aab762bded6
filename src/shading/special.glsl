// Functions that GLSL lacks and some distributions need, in float32: exponentials and logarithms
// that keep their digits near zero, the gamma function and its incomplete form.
#ifndef GP_SHADING_SPECIAL_GLSL
#define GP_SHADING_SPECIAL_GLSL

// (e^x - 1) / x; 1 at 0.
float expm1_over(float x) {
    if (abs(x) < 0.5f) {
        float p = 1.0f / 720.0f + x * (1.0f / 5040.0f + x * (1.0f / 40320.0f));
        p = 1.0f / 24.0f + x * (1.0f / 120.0f + x * p);
        return 1.0f + x * (0.5f + x * (1.0f / 6.0f + x * p));
    }
    return (exp(x) - 1.0f) / x;
}

// log(1 + x) / x for x > -1; 1 at 0.
float log1p_over(float x) {
    if (abs(x) < 0.25f) {
        // log((1 + z) / (1 - z)) = 2 z (1 + z^2 / 3 + z^4 / 5 + …) with z = x / (2 + x).
        float z = x / (2.0f + x);
        float z2 = z * z;
        float p = 1.0f / 5.0f + z2 * (1.0f / 7.0f + z2 * (1.0f / 9.0f));
        return 2.0f / (2.0f + x) * (1.0f + z2 * (1.0f / 3.0f + z2 * p));
    }
    return log(1.0f + x) / x;
}

// log(1 + x), by way of the above.
float log1p_accurate(float x) {
    return x * log1p_over(x);
}

// The logarithm of the gamma function for a > 0, absolute error 1e-6 up to a = 20.
// [Press et al. 2007, "Numerical Recipes", section 6.1, Lanczos' approximation]
float log_gamma(float a) {
    float series = 1.000000000190015f + 76.18009172947146f / (a + 1.0f)
                 - 86.50532032941677f / (a + 2.0f) + 24.01409824083091f / (a + 3.0f)
                 - 1.231739572450155f / (a + 4.0f) + 0.001208650973866179f / (a + 5.0f);
    float t = a + 5.5f;
    return (a + 0.5f) * log(t) - t + log(2.5066282746310005f * series / a);
}

// Gamma(a, x) / (x^a e^-x), the upper incomplete gamma function without its front, for x >= 1 or
// x >= a + 1: Lentz's continued fraction. a may be negative.
// [Press et al. 2007, "Numerical Recipes", section 6.2]
float gamma_upper_fraction(float a, float x) {
    float b = x + 1.0f - a;
    float c = 1.0e30f;
    float d = 1.0f / b;
    float h = d;
    for (int i = 1; i < 64; ++i) {
        float n = float(i);
        float an = -n * (n - a);
        b += 2.0f;
        d = an * d + b;
        d = abs(d) < 1.0e-30f ? 1.0e-30f : d;
        c = b + an / c;
        c = abs(c) < 1.0e-30f ? 1.0e-30f : c;
        d = 1.0f / d;
        h *= c * d;
        if (abs(c * d - 1.0f) < 1.0e-7f) {
            break;
        }
    }
    return h;
}

// P(a, x), the regularised lower incomplete gamma function, a > 0 and x >= 0; log_gamma_a is that
// of a. [Press et al. 2007, "Numerical Recipes", section 6.2]
float gamma_p(float a, float x, float log_gamma_a) {
    if (x <= 0.0f) {
        return 0.0f;
    }
    float front = exp(a * log(x) - x - log_gamma_a);
    if (x >= a + 1.0f) {
        return 1.0f - front * gamma_upper_fraction(a, x);
    }
    float term = 1.0f / a;
    float sum = term;
    for (int i = 1; i < 64; ++i) {
        term *= x / (a + float(i));
        sum += term;
        if (term < 1.0e-7f * sum) {
            break;
        }
    }
    return sum * front;
}

// The x at which P(a, x) = p, p in [0, 1): Halley's steps from a start by Wilson and Hilferty.
// [Press et al. 2007, "Numerical Recipes", section 6.2.1]
float gamma_p_inverse(float a, float p) {
    float log_gamma_a = log_gamma(a);
    float x;
    if (a > 1.0f) {
        float half_p = max(p < 0.5f ? p : 1.0f - p, 1.0e-20f);
        float t = sqrt(-2.0f * log(half_p));
        float z = (2.30753f + t * 0.27061f) / (1.0f + t * (0.99229f + t * 0.04481f)) - t;
        z = p < 0.5f ? z : -z;
        float root = 1.0f - 1.0f / (9.0f * a) + z / (3.0f * sqrt(a));
        x = max(a * root * root * root, 1.0e-3f);
    } else {
        float t = 1.0f - a * (0.253f + a * 0.12f);
        x = p < t ? pow(p / t, 1.0f / a) : 1.0f - log(max((1.0f - p) / (1.0f - t), 1.0e-20f));
    }
    // Where P is the first term of its series, that is the answer: float cannot improve it.
    if (x < 1.0e-5f) {
        return exp((log(max(p, 1.0e-37f)) + log_gamma_a + log(a)) / a);
    }
    for (int i = 0; i < 8; ++i) {
        float density = exp((a - 1.0f) * log(x) - x - log_gamma_a);
        if (density <= 0.0f) {
            break;
        }
        float u = (gamma_p(a, x, log_gamma_a) - p) / density;
        float t = u / (1.0f - 0.5f * min(1.0f, u * ((a - 1.0f) / x - 1.0f)));
        // Never beyond half of the way to zero.
        t = min(t, 0.5f * x);
        x -= t;
        if (abs(t) < 1.0e-5f * x) {
            break;
        }
    }
    return x;
}

#endif
