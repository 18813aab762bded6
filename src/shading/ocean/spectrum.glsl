// How the energy of wind waves is shared out over wave numbers: measured spectra as densities of
// the variance of height. Based on: Horvath 2015, "Empirical Directional Wave Spectra for Computer
// Graphics", DigiPro. Spectra of frequency are carried over to wave numbers by the dispersion of
// gravity waves, on which they were measured; capillarity (dispersion.glsl) moves phases only.
#ifndef GP_SHADING_OCEAN_SPECTRUM_GLSL
#define GP_SHADING_OCEAN_SPECTRUM_GLSL
#include "shading/ocean/dispersion.glsl"

#define OCEAN_JONSWAP 0u
#define OCEAN_TMA 1u
#define OCEAN_PHILLIPS 2u
#define OCEAN_PIERSON_MOSKOWITZ 3u

struct OceanWind {
    float speed;       // m/s at 10 m, above 0
    float fetch;       // m
    float depth;       // m, finite: OCEAN_DEEP and more is deep water
    float gravity;     // m/s^2
    uint spectrum;     // OCEAN_...
    uint spreading;    // OCEAN_SPREAD_... of spreading.glsl
    float swell;       // 0..1
    float peak;        // rad/s, by ocean_peak
};

// The constant of the equilibrium range. [Pierson and Moskowitz 1964, JGR 69(24)]
#define OCEAN_EQUILIBRIUM 8.1e-3f

// Angular frequency of the highest waves; field `peak` is not read.
float ocean_peak(IN(OceanWind) wind) {
    float g = wind.gravity;
    if (wind.spectrum == OCEAN_JONSWAP || wind.spectrum == OCEAN_TMA) {
        // [Hasselmann et al. 1973, "Measurements of Wind-Wave Growth and Swell Decay", JONSWAP]
        return 22.0f * pow(g / wind.speed * (g / wind.fetch), 1.0f / 3.0f);
    }
    // (4/5 0.74)^(1/4) g / U at 19.5 m, which is 1.026 U at 10 m.
    // [Pierson and Moskowitz 1964, JGR 69(24)]
    return 0.855f * g / wind.speed;
}

// Constant of the JONSWAP spectrum. [Hasselmann et al. 1973]
float ocean_jonswap_alpha(IN(OceanWind) wind) {
    return 0.076f * pow(wind.speed / wind.fetch * (wind.speed / wind.gravity), 0.22f);
}

// How depth weakens waves of frequency omega. [Bouws et al. 1985, JGR 90(C1), with the
// approximation of Thompson and Vincent 1983 of Kitaigorodskii's factor]
float ocean_depth_factor(float omega, float depth, float gravity) {
    float w = min(omega * sqrt(depth / gravity), 2.0f);
    return w <= 1.0f ? 0.5f * w * w : 1.0f - 0.5f * (2.0f - w) * (2.0f - w);
}

// Density of variance over angular frequency, m^2 s; Phillips' has none (ocean_radial_density).
float ocean_frequency_density(IN(OceanWind) wind, float omega) {
    float x = wind.peak / omega;
    if (x > 3.0f) {
        return 0.0f;  // exp(-100): nothing, but omega^-5 need not be finite
    }
    float g = wind.gravity;
    float omega2 = omega * omega;
    float x2 = x * x;
    float s = g * g / (omega2 * omega2 * omega) * exp(-1.25f * x2 * x2);
    if (wind.spectrum == OCEAN_PIERSON_MOSKOWITZ) {
        return OCEAN_EQUILIBRIUM * s;
    }
    float width = omega <= wind.peak ? 0.07f : 0.09f;
    float d = (omega / wind.peak - 1.0f) / width;
    s *= ocean_jonswap_alpha(wind) * pow(3.3f, exp(-0.5f * d * d));
    return wind.spectrum == OCEAN_TMA ? s * ocean_depth_factor(omega, wind.depth, g) : s;
}

// Density of variance over wave numbers k in rad/m, all directions together, m^3; k above 0.
float ocean_radial_density(IN(OceanWind) wind, float k) {
    if (wind.spectrum == OCEAN_PHILLIPS) {
        // [Tessendorf 2001, equations 40 and 41], as the equilibrium range has it:
        // alpha g^2 omega^-5 over deep water is alpha / 2 k^-3.
        float longest = wind.speed * wind.speed / wind.gravity;
        float a = 1.0f / (k * longest);
        float b = k * longest * 0.001f;
        return 0.5f * OCEAN_EQUILIBRIUM / k / (k * k) * exp(-a * a - b * b);
    }
    OceanFrequency f = ocean_gravity_frequency(k, wind.depth, wind.gravity);
    return ocean_frequency_density(wind, f.omega) * f.by_k;
}

#endif
