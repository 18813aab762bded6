// How the waves of one frequency share themselves out over directions: densities over the angle
// from the wind, whose integral over a turn is 1.
// Based on: Horvath 2015, "Empirical Directional Wave Spectra for Computer Graphics", DigiPro.
#ifndef GP_SHADING_OCEAN_SPREADING_GLSL
#define GP_SHADING_OCEAN_SPREADING_GLSL
#include "shading/ocean/spectrum.glsl"
#include "shading/special.glsl"

#define OCEAN_SPREAD_HASSELMANN 0u
#define OCEAN_SPREAD_DONELAN_BANNER 1u
#define OCEAN_SPREAD_COSINE_SQUARED 2u
// Nodes of the quadrature over angles; the narrowest product here needs 24 for 1e-5.
#define OCEAN_SPREAD_NODES 32

// The directions of one frequency: scale |cos(theta/2)|^exponent sech(beta theta)^2, or with
// cos(theta)^2 on the side downwind.
struct OceanSpread {
    float exponent;
    float beta;          // 0: without
    float downwind;      // 1: with cos(theta)^2, 0: without
    float scale;
};

// [Hasselmann, Dunckel and Ewing 1980, J. Physical Oceanography 10(8)]
float ocean_hasselmann_exponent(IN(OceanWind) wind, float omega) {
    float x = omega / wind.peak;
    float age = wind.speed * wind.peak / wind.gravity;
    return omega <= wind.peak ? 6.97f * pow(x, 4.06f)
                              : 9.77f * pow(x, -2.33f - 1.45f * (age - 1.17f));
}

// [Donelan et al. 1985, Phil. Trans. A 315; above 1.6: Banner 1990, J. Phys. Oceanography 20(7)]
float ocean_donelan_banner_beta(float omega_over_peak) {
    float x = max(omega_over_peak, 0.56f);
    if (x < 0.95f) {
        return 2.61f * pow(x, 1.3f);
    }
    if (x < 1.6f) {
        return 2.28f * pow(x, -1.3f);
    }
    return pow(10.0f, -0.4f + 0.8393f * exp(-0.567f * 2.0f * log(x)));
}

// Of theta in -pi..pi.
float ocean_spread_density(IN(OceanSpread) spread, float theta) {
    float d = spread.scale * pow(abs(cos(0.5f * theta)), spread.exponent);
    float c = cosh(spread.beta * theta);
    float along = max(cos(theta), 0.0f);
    return d / (c * c) * (spread.downwind > 0.0f ? along * along : 1.0f);
}

// One over the integral of |cos(theta/2)|^2s over a turn.
// [Longuet-Higgins, Cartwright and Smith 1963, by Legendre's duplication formula]
float ocean_cosine_scale(float s) {
    return exp(log_gamma(s + 1.0f) - log_gamma(s + 0.5f)) * 0.5f * 0.564189583547756f;
}

// The same for any product, by the trapezoidal rule, which is exact for what is smooth around.
float ocean_spread_scale(IN(OceanSpread) spread) {
    float sum = 0.0f;
    for (int i = 0; i < OCEAN_SPREAD_NODES; ++i) {
        float turn = (float(i) + 0.5f) / float(OCEAN_SPREAD_NODES) - 0.5f;
        sum += ocean_spread_density(spread, TWO_PI * turn);
    }
    return float(OCEAN_SPREAD_NODES) * INV_TWO_PI / sum;
}

// The directions of waves of angular frequency omega.
OceanSpread ocean_spread(IN(OceanWind) wind, float omega) {
    OceanSpread spread;
    // Swell lengthens crests, most at low frequencies. [Horvath 2015, section on swell]
    float s = 16.0f * tanh(wind.peak / omega) * wind.swell * wind.swell;
    spread.beta = 0.0f;
    spread.downwind = 0.0f;
    if (wind.spreading == OCEAN_SPREAD_HASSELMANN) {
        s += ocean_hasselmann_exponent(wind, omega);
    } else if (wind.spreading == OCEAN_SPREAD_DONELAN_BANNER) {
        spread.beta = ocean_donelan_banner_beta(omega / wind.peak);
    } else {
        spread.downwind = 1.0f;
    }
    spread.exponent = 2.0f * s;
    spread.scale = 1.0f;
    if (wind.spreading == OCEAN_SPREAD_HASSELMANN) {
        spread.scale = ocean_cosine_scale(s);
    } else if (s > 0.0f) {
        spread.scale = ocean_spread_scale(spread);
    } else if (wind.spreading == OCEAN_SPREAD_DONELAN_BANNER) {
        spread.scale = 0.5f * spread.beta / tanh(spread.beta * PI);
    } else {
        spread.scale = 2.0f * INV_PI;
    }
    return spread;
}

#endif
