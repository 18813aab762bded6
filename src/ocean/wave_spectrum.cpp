#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/ocean/spreading.glsl"
#include "shading/sampling/hash.glsl"
#include "shading/slope/slopes.glsl"
GP_SHADING_END

#include "ocean/wave_spectrum.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <tbb/parallel_for.h>

#include "ocean/ocean.h"

namespace gp {

namespace {

using namespace shading;

static_assert(uint(OceanSpectrum::jonswap) == OCEAN_JONSWAP &&
              uint(OceanSpectrum::tma) == OCEAN_TMA &&
              uint(OceanSpectrum::phillips) == OCEAN_PHILLIPS &&
              uint(OceanSpectrum::piersonMoskowitz) == OCEAN_PIERSON_MOSKOWITZ);
static_assert(uint(OceanSpreading::hasselmann) == OCEAN_SPREAD_HASSELMANN &&
              uint(OceanSpreading::donelanBanner) == OCEAN_SPREAD_DONELAN_BANNER &&
              uint(OceanSpreading::cosineSquared) == OCEAN_SPREAD_COSINE_SQUARED);

// Below, there is no energy in any wind that the settings allow.
constexpr double leastWaveNumber = 1.0e-4;

bool isFlat(const OceanSettings& s) { return s.windSpeed <= 0.0f || s.amplitude <= 0.0f; }

OceanWind windOf(const OceanSettings& s) {
    OceanWind wind;
    wind.speed = s.windSpeed;
    wind.fetch = s.fetch;
    wind.depth = std::min(s.depth, OCEAN_DEEP);
    wind.gravity = s.gravity;
    wind.spectrum = uint(s.spectrum);
    wind.spreading = uint(s.spreading);
    wind.swell = s.swell;
    wind.peak = 0.0f;
    wind.peak = ocean_peak(wind);
    return wind;
}

// Density of variance over wave vectors, m^4.
double density(const OceanWind& wind, float windDirection, double kx, double ky) {
    const double k = std::hypot(kx, ky);
    const float radial = ocean_radial_density(wind, float(k));
    if (radial <= 0.0f) return 0.0;
    const float omega = ocean_gravity_frequency(float(k), wind.depth, wind.gravity).omega;
    const double angle = std::remainder(std::atan2(ky, kx) - double(windDirection), 2.0 * M_PI);
    return double(radial) / k
         * double(ocean_spread_density(ocean_spread(wind, omega), float(angle)));
}

// Points along each side of a bin at which the spectrum is read: many where it changes within a
// bin, near k = 0 (the peak may lie within the first few bins) and where a band ends.
int samplesOfBin(double k, double dk, WaveBand band) {
    const auto crosses = [&](double edge) { return std::abs(k - edge) < 0.71 * dk; };
    if (k < 4.0 * dk) return 24;
    if (k < 16.0 * dk || crosses(double(band.first)) || crosses(double(band.end))) return 8;
    return k < 48.0 * dk ? 2 : 1;
}

double binVariance(const OceanSettings& s, const OceanWind& wind, WaveBand band, double dk,
                   int mx, int my) {
    const double k = dk * std::hypot(double(mx), double(my));
    if ((mx == 0 && my == 0) || k + 0.71 * dk < double(band.first)
        || k - 0.71 * dk > double(band.end)) {
        return 0.0;
    }
    const int n = samplesOfBin(k, dk, band);
    double sum = 0.0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double kx = dk * (mx - 0.5 + (i + 0.5) / n);
            const double ky = dk * (my - 0.5 + (j + 0.5) / n);
            const double length = std::hypot(kx, ky);
            if (length >= double(band.first) && length < double(band.end)) {
                sum += density(wind, s.windDirection, kx, ky);
            }
        }
    }
    const double scale = double(s.amplitude) * double(s.amplitude);
    return scale * sum * dk * dk / (n * n);
}

// Two independent normal numbers of a bin: the same whatever the size of the grid, so that a finer
// one only adds waves.
vec2 normalPair(uint32_t seed, uint32_t cascade, int mx, int my) {
    const uvec3 h = hash_u32x3(uvec3(uint(mx), uint(my), hash_u32(seed) + cascade));
    return gaussian_pair(vec2(float(h.x >> 8u), float(h.y >> 8u)) * EXP2_MINUS_24
                         + 0.5f * EXP2_MINUS_24);
}

int signedIndex(uint32_t i, uint32_t size) { return i < size / 2 ? int(i) : int(i) - int(size); }

}  // namespace

WaveBand waveBand(const OceanSettings& s, uint32_t cascade) {
    // Three periods are the fewest that look like waves and not like the grid.
    const auto first = [&](uint32_t i) { return 6.0f * PI / s.lengths[i]; };
    // The grid resolves bins up to size / 2 - 1, each half a bin to both sides.
    const float limit = PI * float(s.size - 1u) / s.lengths[cascade];
    WaveBand band;
    band.first = cascade == 0 ? 0.0f : first(cascade);
    band.end = std::min(cascade + 1 < s.cascades ? first(cascade + 1) : limit, oceanTailEnd);
    return band;
}

double waveBinVariance(const OceanSettings& s, uint32_t cascade, int mx, int my) {
    if (isFlat(s)) return 0.0;
    const double dk = 2.0 * M_PI / double(s.lengths[cascade]);
    return binVariance(s, windOf(s), waveBand(s, cascade), dk, mx, my);
}

Waves makeWaves(const OceanSettings& s, uint32_t cascade) {
    const uint32_t n = s.size;
    const size_t count = size_t(n) * n;
    Waves waves;
    waves.size = n;
    waves.length = s.lengths[cascade];
    for (auto* plane : {&waves.cosRe, &waves.cosIm, &waves.sinRe, &waves.sinIm}) {
        plane->assign(count, 0.0f);
    }
    waves.turns.assign(count, 0.0);
    if (isFlat(s)) return waves;

    const OceanWind wind = windOf(s);
    const WaveBand band = waveBand(s, cascade);
    const double dk = 2.0 * M_PI / double(waves.length);
    waves.reach = std::min(int(double(band.end) / dk + 1.0), int(n / 2) - 1);
    std::vector<vec2> h0(count, vec2(0.0f));
    tbb::parallel_for(0u, n, [&](uint32_t ix) {
        const int mx = signedIndex(ix, n);
        for (uint32_t iy = 0; iy < n && std::abs(mx) <= waves.reach; ++iy) {
            const int my = signedIndex(iy, n);
            if (std::abs(my) > waves.reach) continue;
            // Half of the variance each for both parts and both senses of time.
            // [Tessendorf 2001, equation 42, for a spectrum of which each k is one direction]
            const double v = binVariance(s, wind, band, dk, mx, my);
            h0[ix * n + iy] = normalPair(s.seed, cascade, mx, my) * float(0.5 * std::sqrt(v));
            const float k = float(dk * std::hypot(double(mx), double(my)));
            if (k > 0.0f) {
                const float omega = ocean_frequency(k, wind.depth, wind.gravity);
                waves.turns[ix * n + iy] = double(omega) / (2.0 * M_PI);
            }
        }
    });
    // h0(k) e^(-i w t) + conj(h0(-k)) e^(i w t): the first goes along k.
    for (uint32_t ix = 0; ix < n; ++ix) {
        for (uint32_t iy = 0; iy < n; ++iy) {
            const size_t i = size_t(ix) * n + iy;
            const vec2 a = h0[i];
            const vec2 b = h0[size_t((n - ix) % n) * n + (n - iy) % n];
            waves.cosRe[i] = a.x + b.x;
            waves.cosIm[i] = a.y - b.y;
            waves.sinRe[i] = a.y + b.y;
            waves.sinIm[i] = b.x - a.x;
        }
    }
    return waves;
}

StretchCovariance stretchCovariance(const Waves& w, float choppiness) {
    double uu = 0.0, vv = 0.0, cc = 0.0, uv = 0.0, uc = 0.0, vc = 0.0;
    const double dk = 2.0 * M_PI / double(w.length);
    for (int mx = -w.reach; mx <= w.reach; ++mx) {
        for (int my = -w.reach; my <= w.reach; ++my) {
            const size_t i = size_t(uint32_t(mx) & (w.size - 1)) * w.size
                           + (uint32_t(my) & (w.size - 1));
            const auto square = [](float x) { return double(x) * double(x); };
            const double variance = 0.5 * (square(w.cosRe[i]) + square(w.cosIm[i])
                                           + square(w.sinRe[i]) + square(w.sinIm[i]));
            if (variance <= 0.0) continue;
            // The stretch is -k k^T / |k| of the height: of u, v and c with twice the angle of k.
            const double kx = dk * mx, ky = dk * my, k2 = kx * kx + ky * ky;
            const double cosine = (kx * kx - ky * ky) / k2, sine = 2.0 * kx * ky / k2;
            const double e = 0.25 * k2 * variance;
            uu += e, vv += e * cosine * cosine, cc += e * sine * sine;
            uv += e * cosine, uc += e * sine, vc += e * cosine * sine;
        }
    }
    const double l2 = double(choppiness) * double(choppiness);
    return {float(l2 * uu), float(l2 * vv), float(l2 * cc),
            float(l2 * uv), float(l2 * uc), float(l2 * vc)};
}

SpectrumTable makeSpectrumTable(const OceanSettings& s) {
    constexpr int count = 2048;
    SpectrumTable table;
    table.firstLog = std::log(leastWaveNumber);
    table.step = (std::log(double(oceanTailEnd)) - table.firstLog) / (count - 1);
    table.nodes.resize(count);
    if (isFlat(s)) return table;

    const OceanWind wind = windOf(s);
    // Densities over the logarithm of k first, then sums from the end.
    tbb::parallel_for(0, count, [&](int i) {
        const double k = std::exp(table.firstLog + i * table.step);
        const OceanFrequency f = ocean_gravity_frequency(float(k), wind.depth, wind.gravity);
        const OceanSpread spread = ocean_spread(wind, f.omega);
        double along = 0.0, all = 0.0;
        constexpr int angles = 128;
        for (int j = 0; j < angles; ++j) {
            const double angle = 2.0 * M_PI * ((j + 0.5) / angles - 0.5);
            const double d = double(ocean_spread_density(spread, float(angle)));
            along += d * std::cos(angle) * std::cos(angle);
            all += d;
        }
        along /= all;
        const double scale = double(s.amplitude) * double(s.amplitude);
        const double e = scale * k * double(ocean_radial_density(wind, float(k)));
        table.nodes[size_t(i)] = {e, e * k * k * along, e * k * k * (1.0 - along)};
    });
    SpectrumTable::Node last = table.nodes.back(), sum;
    table.nodes.back() = sum;
    for (int i = count - 2; i >= 0; --i) {
        SpectrumTable::Node& node = table.nodes[size_t(i)];
        const SpectrumTable::Node here = node;
        sum.variance += 0.5 * table.step * (here.variance + last.variance);
        sum.along += 0.5 * table.step * (here.along + last.along);
        sum.across += 0.5 * table.step * (here.across + last.across);
        last = here;
        node = sum;
    }
    return table;
}

SpectrumTable::Node SpectrumTable::above(double k) const {
    const double at = k > 0.0 ? (std::log(k) - firstLog) / step : 0.0;
    const double x = std::clamp(at, 0.0, double(nodes.size() - 1));
    const size_t i = std::min(size_t(x), nodes.size() - 2);
    const double f = x - double(i);
    const Node &a = nodes[i], &b = nodes[i + 1];
    return {a.variance + f * (b.variance - a.variance), a.along + f * (b.along - a.along),
            a.across + f * (b.across - a.across)};
}

}  // namespace gp
