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

// Standard deviation of the Jacobian by all cascades but one: to first order that of the sum of
// both stretches, whose variance is choppiness^2 times that of the slope.
float squeezeOfOthers(const OceanSettings& s, const SpectrumTable& table, uint32_t cascade) {
    double variance = 0.0;
    for (uint32_t i = 0; i < s.cascades; ++i) {
        if (i == cascade) continue;
        const WaveBand band = waveBand(s, i);
        const SpectrumTable::Node a = table.above(double(band.first));
        const SpectrumTable::Node b = table.above(double(band.end));
        variance += a.along + a.across - b.along - b.across;
    }
    return s.choppiness * float(std::sqrt(std::max(variance, 0.0)));
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

OceanCascade::OceanCascade(const OceanSettings& s, uint32_t cascade, float others)
    : waves(makeWaves(s, cascade)), foam(s, others) {
    const size_t count = size_t(s.size) * s.size;
    points.resize(count);
    squeeze.resize(count);
    const size_t bytes = 8 * count * sizeof(float);
    between.reset(static_cast<float*>(std::aligned_alloc(64, bytes)));
    if (!between) throw std::bad_alloc();
    std::fill(between.get(), between.get() + 8 * count, 0.0f);
}

Ocean::Parts::Parts(const OceanSettings& s)
    : settings(s), kernels(waveKernels()), plan(kernels.newPlan(s.size), kernels.freePlan),
      table(makeSpectrumTable(s)) {
    cascades.reserve(s.cascades);
    for (uint32_t i = 0; i < s.cascades; ++i) {
        cascades.emplace_back(s, i, squeezeOfOthers(s, table, i));
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
    foamScale = foamScaleOf(cascades);
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
    const SpectrumTable::Node node = parts_->table.above(double(k));
    const double c = std::cos(double(settings().windDirection));
    const double s = std::sin(double(settings().windDirection));
    return {float(node.along * c * c + node.across * s * s),
            float(node.along * s * s + node.across * c * c),
            float((node.along - node.across) * c * s)};
}

OceanMoments Ocean::tail() const { return momentsAbove(band(settings().cascades - 1).end); }

float Ocean::varianceAbove(float k) const { return float(parts_->table.above(double(k)).variance); }

float Ocean::significantHeight() const { return 4.0f * std::sqrt(varianceAbove(0.0f)); }

Ocean::Band Ocean::band(uint32_t cascade) const {
    const WaveBand b = waveBand(settings(), cascade);
    return {b.first, b.end};
}

OceanPoint Ocean::gridPoint(uint32_t cascade, int ix, int iy) const {
    return parts_->cascades[cascade].point(ix, iy);
}

}  // namespace gp
