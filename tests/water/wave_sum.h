// The sea wave by wave, anywhere and without a grid: what FFTs and their interpolation are held to.
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "ocean/ocean.h"
#include "ocean/wave_spectrum.h"

namespace gp::test {

class WaveSum {
public:
    explicit WaveSum(const OceanSettings& settings) : settings_(settings) {
        for (uint32_t c = 0; c < settings.cascades; ++c) waves_.push_back(makeWaves(settings, c));
    }

    // Gradient and stretch, of time 0, at (xs[i], ys[j]): row j, column i.
    std::vector<OceanPoint> derivatives(const std::vector<double>& xs,
                                        const std::vector<double>& ys) const {
        std::vector<OceanPoint> points(xs.size() * ys.size());
        for (const Waves& waves : waves_) addCascade(waves, xs, ys, points);
        return points;
    }

private:
    using Complex = std::complex<double>;

    // First the sums over kx at each x, for the powers of 1, kx and kx^2 that the fields have.
    void addCascade(const Waves& waves, const std::vector<double>& xs,
                    const std::vector<double>& ys, std::vector<OceanPoint>& points) const {
        const double dk = 2.0 * M_PI / double(waves.length);
        const Complex i1(0.0, 1.0);
        for (size_t i = 0; i < xs.size(); ++i) {
            for (int my = -waves.reach; my <= waves.reach; ++my) {
                const double ky = dk * my;
                Complex one, x, xOverK, xxOverK, overK;
                for (int mx = -waves.reach; mx <= waves.reach; ++mx) {
                    if (mx == 0 && my == 0) continue;
                    const double kx = dk * mx, k = std::hypot(kx, ky);
                    const Complex h = amplitude(waves, mx, my) * std::polar(1.0, kx * xs[i]);
                    one += h;
                    x += kx * h;
                    overK += h / k;
                    xOverK += kx * h / k;
                    xxOverK += kx * kx * h / k;
                }
                const double l = double(settings_.choppiness);
                for (size_t j = 0; j < ys.size(); ++j) {
                    const Complex e = std::polar(1.0, ky * ys[j]);
                    OceanPoint& p = points[j * xs.size() + i];
                    p.gradient += glm::vec2((i1 * x * e).real(), (i1 * ky * one * e).real());
                    p.stretch -= glm::vec3(l * (xxOverK * e).real(),
                                           l * ky * ky * (overK * e).real(),
                                           l * ky * (xOverK * e).real());
                }
            }
        }
    }

    static Complex amplitude(const Waves& waves, int mx, int my) {
        const int n = int(waves.size);
        const size_t i = size_t((mx + n) % n) * size_t(n) + size_t((my + n) % n);
        return {double(waves.cosRe[i]), double(waves.cosIm[i])};
    }

    OceanSettings settings_;
    std::vector<Waves> waves_;
};

}  // namespace gp::test
