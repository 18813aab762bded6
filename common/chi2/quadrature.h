// Adaptive quadrature for densities that are smooth except at known places.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gp {

struct QuadratureTolerance {
    double relative = 3e-4;
    double absolute = 0.0;
};

struct GaussKronrod {
    double value;
    double error;
};

// The 15 points of Kronrod, which contain the 7 points of Gauss: value and error from one set.
// [Piessens et al. 1983, "QUADPACK", rule QK15]
template <class F>
GaussKronrod gaussKronrod15(const F& f, double a, double b) {
    static constexpr std::array<double, 8> x = {
        0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
        0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
        0.586087235467691130294144691693169, 0.405845151377397166906606412076961,
        0.207784955007898467600689403773245, 0.0};
    static constexpr std::array<double, 8> wKronrod = {
        0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
        0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
        0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
        0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
    static constexpr std::array<double, 4> wGauss = {
        0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
        0.381830050505118944950369775488975, 0.417959183673469387755102040816327};
    const double center = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    const double middle = f(center);
    double kronrod = wKronrod[7] * middle;
    double gauss = wGauss[3] * middle;
    for (std::size_t i = 0; i < 7; ++i) {
        const double pair = f(center - half * x[i]) + f(center + half * x[i]);
        kronrod += wKronrod[i] * pair;
        if (i % 2 == 1) gauss += wGauss[i / 2] * pair;
    }
    // The raw difference is the error of the 7 points; QUADPACK's exponent makes it that of the 15.
    const double value = kronrod * half;
    const double difference = std::abs((kronrod - gauss) * half);
    const double scale = std::abs(value);
    const double error = scale > 0.0
        ? scale * std::min(difference / scale, std::pow(200.0 * difference / scale, 1.5))
        : difference;
    return {value, error};
}

// Halves the interval until the error is within the tolerance, at most `depth` times.
template <class F>
double integrate(const F& f, double a, double b, QuadratureTolerance tolerance, int depth = 12) {
    const GaussKronrod whole = gaussKronrod15(f, a, b);
    const double allowed = std::max(tolerance.absolute, tolerance.relative * std::abs(whole.value));
    if (depth == 0 || whole.error <= allowed) return whole.value;
    const double middle = 0.5 * (a + b);
    // A half may have the whole's error to itself only relative to what the whole is worth.
    const QuadratureTolerance part{tolerance.relative, 0.5 * allowed};
    return integrate(f, a, middle, part, depth - 1) + integrate(f, middle, b, part, depth - 1);
}

// The same over pieces: `breaks` are the places in any order, inside or outside of [a, b], where
// the integrand or its derivative jumps.
template <class F>
double integratePieces(const F& f, double a, double b, std::vector<double> breaks,
                       QuadratureTolerance tolerance, int depth = 12) {
    std::sort(breaks.begin(), breaks.end());
    double sum = 0.0;
    double from = a;
    for (const double at : breaks) {
        if (at <= from || at >= b) continue;
        sum += integrate(f, from, at, tolerance, depth);
        from = at;
    }
    return sum + integrate(f, from, b, tolerance, depth);
}

}  // namespace gp
