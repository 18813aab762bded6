#include "ocean/ocean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <new>

#include <tbb/parallel_for.h>

#include "ocean/ocean_parts.h"

namespace gp {

static_assert(sizeof(OceanPoint) == 9 * sizeof(float), "isa/waves.inc writes them as floats");

const WaveKernels& waveKernels() {
    __builtin_cpu_init();
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512vl");
    return avx512 ? waves::kernelsAvx512 : avx2 ? waves::kernelsAvx2 : waves::kernelsX86_64;
}

namespace {

// Covariance that the waves of all cascades but one have.
StretchCovariance stretchOfOthers(const std::vector<OceanCascade>& cascades, size_t known,
                                  float choppiness) {
    StretchCovariance sum;
    for (size_t i = 0; i < cascades.size(); ++i) {
        if (i == known) continue;
        const StretchCovariance c = stretchCovariance(cascades[i].waves, choppiness);
        sum.uu += c.uu, sum.vv += c.vv, sum.cc += c.cc;
        sum.uv += c.uv, sum.uc += c.uc, sum.vc += c.vc;
    }
    sum.uu = std::max(sum.uu, breakingLeastWidth * breakingLeastWidth);
    return sum;
}

// Their geometric mean over their product; 0 where a cascade has no foam at all.
float foamScaleOf(const std::vector<OceanCascade>& cascades) {
    double sum = 0.0;
    for (const OceanCascade& c : cascades) {
        const float mean = c.slopes.whole().foam;
        if (mean < 1.0e-12f) return 0.0f;
        sum += std::log(double(mean));
    }
    return float(std::exp(sum / double(cascades.size()) - sum));
}

}  // namespace

OceanCascade::OceanCascade(const OceanSettings& s, uint32_t cascade)
    : waves(makeWaves(s, cascade)), foam(s) {
    const size_t count = size_t(s.size) * s.size;
    points.resize(count + 1);
    squeeze.resize(count);
    const size_t bytes = 8 * count * sizeof(float);
    between.reset(static_cast<float*>(std::aligned_alloc(64, bytes)));
    if (!between) throw std::bad_alloc();
    std::fill(between.get(), between.get() + 8 * count, 0.0f);
}

Ocean::Parts::Parts(const OceanSettings& s)
    : settings(s), kernels(waveKernels()), plan(kernels.newPlan(s.size), kernels.freePlan),
      spectrum(makeSpectrumTable(s)) {
    cascades.reserve(s.cascades);
    for (uint32_t i = 0; i < s.cascades; ++i) cascades.emplace_back(s, i);
    for (size_t i = 0; i < cascades.size(); ++i) {
        cascades[i].breaking = {s.foamThreshold, stretchOfOthers(cascades, i, s.choppiness)};
    }
}

void Ocean::Parts::transform(OceanCascade& cascade, double when, uint16_t* squeeze,
                             bool squeezeOnly) {
    WaveTask task;
    task.waves = &cascade.waves;
    task.plan = plan.get();
    task.between = cascade.between.get();
    task.seconds = when;
    task.choppiness = settings.choppiness;
    task.squeezeOnly = squeezeOnly;
    task.points = cascade.points.data();
    task.breaking = cascade.breaking;
    task.squeeze = squeeze;
    const uint32_t groups = settings.size / kernels.lanes;
    tbb::parallel_for(0u, groups, [&](uint32_t g) { kernels.columns(task, g); });
    tbb::parallel_for(0u, groups, [&](uint32_t g) { kernels.rows(task, g); });
}

void Ocean::Parts::update(double seconds) {
    time = std::clamp(seconds, -1.0e9, 1.0e9);
    for (OceanCascade& cascade : cascades) {
        // Foam first: a tick that it asks for goes through the same memory.
        transform(cascade, time, cascade.squeeze.data(), false);
        cascade.foam.update(time, cascade.squeeze.data(), cascade.points.data(),
                            [&](double when, uint16_t* codes) {
                                transform(cascade, when, codes, true);
                            });
        cascade.slopes.build(cascade.points.data(), settings.size);
    }
    for (const OceanCascade& c : cascades) {
        const float texel = c.waves.length / float(settings.size);
        table.cascades[&c - cascades.data()] = {
            1.0f / c.waves.length, 1.0f / texel, texel, settings.size, c.slopes.levels(),
            c.points.data(), c.slopes.nodes()};
    }
    table.count = uint32_t(cascades.size());
    table.foamScale = foamScaleOf(cascades);
}

Ocean::Ocean(const OceanSettings& settings) : parts_(std::make_unique<Parts>(settings)) {
    parts_->update(0.0);
}
Ocean::~Ocean() = default;
Ocean::Ocean(Ocean&&) noexcept = default;
Ocean& Ocean::operator=(Ocean&&) noexcept = default;

void Ocean::setTime(double seconds) { parts_->update(seconds); }
double Ocean::time() const { return parts_->time; }
const OceanSettings& Ocean::settings() const { return parts_->settings; }

OceanMoments Ocean::momentsAbove(float k) const {
    const SpectrumTable::Node node = parts_->spectrum.above(double(k));
    const double c = std::cos(double(settings().windDirection));
    const double s = std::sin(double(settings().windDirection));
    return {float(node.along * c * c + node.across * s * s),
            float(node.along * s * s + node.across * c * c),
            float((node.along - node.across) * c * s)};
}

OceanMoments Ocean::tail() const { return momentsAbove(band(settings().cascades - 1).end); }

float Ocean::varianceAbove(float k) const {
    return float(parts_->spectrum.above(double(k)).variance);
}

float Ocean::significantHeight() const { return 4.0f * std::sqrt(varianceAbove(0.0f)); }

Ocean::Band Ocean::band(uint32_t cascade) const {
    const WaveBand b = waveBand(settings(), cascade);
    return {b.first, b.end};
}

OceanPoint Ocean::gridPoint(uint32_t cascade, int ix, int iy) const {
    return parts_->cascades[cascade].point(ix, iy);
}

}  // namespace gp
