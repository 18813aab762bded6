// Directional albedo of rough mirrors (F = 1) by quadrature in double, from the formulas of the
// papers and not from src/shading: what our tables are baked from and tested against.
#pragma once

#include <algorithm>
#include <cmath>

#include "chi2/quadrature.h"

namespace gp::test {

// A distribution of normals with its masking; the order is that of ROUGH_MIRROR_… in
// shading/microfacet/albedo_tables.glsl.
struct RoughMirror {
    bool beckmann = false;
    bool correlated = false;
    const char* name = "";
};
constexpr RoughMirror roughMirrors[] = {{false, false, "ggx separable"},
                                        {false, true, "ggx correlated"},
                                        {true, false, "beckmann separable"},
                                        {true, true, "beckmann correlated"}};

// [Heitz 2014, JCGT 3(2), equations 66 and 72]
inline double lambdaOf(const RoughMirror& m, double alpha, double cosine) {
    const double sine2 = std::max(0.0, 1.0 - cosine * cosine);
    if (sine2 <= 0.0) return 0.0;
    const double t = alpha * std::sqrt(sine2) / cosine;
    if (!m.beckmann) return 0.5 * t * t / (1.0 + std::sqrt(1.0 + t * t));
    const double a = 1.0 / t;
    if (a > 26.0) return 0.0;
    if (a < 5.0) return 0.5 * (std::exp(-a * a) / (a * std::sqrt(M_PI)) - std::erfc(a));
    // Where the two terms cancel, erfc by its asymptotic series.
    const double b = 1.0 / (a * a);
    return 0.5 * std::exp(-a * a) / (a * std::sqrt(M_PI)) * b * (0.5 - b * (0.75 - 1.875 * b));
}

// 1 - E, what one scattering loses. The rule follows the distribution: a share s^2 of the projected
// area is steeper than the slope at s, and half of the azimuths do, the other half being the same.
inline double singleScatteringLoss(const RoughMirror& m, double alpha, double cosO, int rows,
                                   int columns) {
    const double sinO = std::sqrt(std::max(0.0, 1.0 - cosO * cosO));
    const double lambdaO = lambdaOf(m, alpha, cosO);
    double albedo = 0.0;
    for (int i = 0; i < rows; ++i) {
        const double s = (i + 0.5) / rows;
        const double tan2 = alpha * alpha * (m.beckmann ? -2.0 * std::log(s)
                                                        : (1.0 - s * s) / (s * s));
        const double cosM = 1.0 / std::sqrt(1.0 + tan2);
        const double sinM = std::sqrt(tan2) * cosM;
        double row = 0.0;
        for (int j = 0; j < columns; ++j) {
            const double cosH = sinO * sinM * std::cos(M_PI * (j + 0.5) / columns) + cosO * cosM;
            const double cosI = 2.0 * cosH * cosM - cosO;
            if (cosH <= 0.0 || cosI <= 0.0) continue;
            const double lambdaI = lambdaOf(m, alpha, cosI);
            const double g2 = m.correlated ? 1.0 / (1.0 + lambdaO + lambdaI)
                                           : 1.0 / ((1.0 + lambdaO) * (1.0 + lambdaI));
            row += g2 * cosH / (cosO * cosM);
        }
        albedo += row * 2.0 * s / (double(rows) * columns);
    }
    return 1.0 - albedo;
}

// 2 * integral of f(mu) mu over [0, 1], for an f that changes quickly where mu is near `scale`.
template <class F>
double hemisphereAverage(const F& f, double scale) {
    const auto weighted = [&](double mu) { return 2.0 * mu * f(mu); };
    return integratePieces(weighted, 0.0, 1.0, {0.2 * scale, scale, 4.0 * scale, 0.3},
                           {1e-6, 1e-9}, 9);
}

}  // namespace gp::test
