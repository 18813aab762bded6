// The surface of the sea: that it is the sum of its waves, as high as the spectrum says, the same
// however it was reached, and as Gerstner has single waves.
#include <cmath>
#include <complex>
#include <cstdlib>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "ocean/ocean.h"
#include "ocean/wave_kernels.h"

namespace gp {
namespace {

OceanSettings smallSea() {
    OceanSettings s;
    s.size = 64;
    s.lengths = {301.0f, 41.3f, 5.23f, 0.0f};
    return s;
}

// Variances of height and slope of one cascade.
struct Measured {
    double height = 0.0, along = 0.0, across = 0.0;
};

Measured measure(const Ocean& ocean, uint32_t cascade) {
    Measured sum;
    const int n = int(ocean.settings().size);
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const OceanPoint p = ocean.gridPoint(cascade, x, y);
            sum.height += double(p.displacement.z) * double(p.displacement.z) / (n * n);
            sum.along += double(p.gradient.x) * double(p.gradient.x) / (n * n);
            sum.across += double(p.gradient.y) * double(p.gradient.y) / (n * n);
        }
    }
    return sum;
}

// Mean over seeds of what is measured over what the spectrum says, and its standard error.
struct Ratio {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    double mean() const { return sum / count; }
    double error() const {
        return std::sqrt((squares / count - mean() * mean()) / (count - 1));
    }
};

struct Ratios {
    Ratio height, along, across;
};

Ratios ratiosOver(OceanSettings s, uint32_t cascade, int seeds) {
    s.foamDecay = 0.0f;
    Ratios ratios;
    for (int i = 0; i < seeds; ++i) {
        s.seed = uint32_t(i);
        const Ocean ocean(s);
        const Ocean::Band band = ocean.band(cascade);
        const OceanMoments a = ocean.momentsAbove(band.first), b = ocean.momentsAbove(band.end);
        const double height = double(ocean.varianceAbove(band.first))
                            - double(ocean.varianceAbove(band.end));
        const Measured m = measure(ocean, cascade);
        ratios.height.add(m.height / height);
        ratios.along.add(m.along / double(a.xx - b.xx));
        ratios.across.add(m.across / double(a.yy - b.yy));
    }
    return ratios;
}

// The convention of amplitudes. So large a square has so many large waves that one sea is off by
// 4 %, and the mean of 24 by 1 %.
TEST(OceanSurface, VarianceIsTheIntegralOfTheSpectrum) {
    OceanSettings s;
    s.cascades = 1;
    s.lengths[0] = 1501.0f;
    const Ratios ratios = ratiosOver(s, 0, 24);
    EXPECT_LT(ratios.height.error(), 0.01);
    EXPECT_NEAR(ratios.height.mean(), 1.0, 0.02);
    EXPECT_NEAR(ratios.along.mean(), 1.0, 0.02);
    EXPECT_NEAR(ratios.across.mean(), 1.0, 0.02);
}

TEST(OceanSurface, VarianceOfEachCascadeIsThatOfItsBand) {
    for (uint32_t c = 0; c < 3; ++c) {
        const Ratios ratios = ratiosOver(smallSea(), c, 12);
        for (const Ratio& r : {ratios.height, ratios.along, ratios.across}) {
            EXPECT_NEAR(r.mean(), 1.0, 4.0 * r.error() + 0.005) << c;
            EXPECT_LT(r.error(), 0.1) << c;
        }
    }
}

TEST(OceanSurface, SignificantHeightIsFourDeviations) {
    const Ocean ocean{OceanSettings()};
    EXPECT_NEAR(ocean.significantHeight(), 2.13857f, 2e-3f);  // golden_ocean_moments.csv
}

TEST(OceanSurface, BinsOfAllCascadesAreTheWholeSpectrum) {
    // The last length: its peak is within the third bin of the first grid.
    for (const float length : {301.0f, 701.0f, 2500.0f}) {
        OceanSettings s;
        s.size = 128;
        s.windSpeed = length > 2000.0f ? 20.0f : 8.0f;
        s.fetch = length > 2000.0f ? 1.0e6f : 50.0e3f;
        s.lengths = {length, 41.3f, 5.23f, 0.0f};
        if (length > 2000.0f) s.lengths = {length, 141.3f, 15.23f, 0.0f};
        ASSERT_EQ(oceanFault(s), "");
        const SpectrumTable table = makeSpectrumTable(s);
        double all = 0.0;
        for (uint32_t c = 0; c < s.cascades; ++c) {
            const WaveBand band = waveBand(s, c);
            if (c > 0) {
                EXPECT_EQ(band.first, waveBand(s, c - 1).end);
            }
            double sum = 0.0;
            for (int y = -64; y < 64; ++y) {
                for (int x = -64; x < 64; ++x) sum += waveBinVariance(s, c, x, y);
            }
            const double whole = table.above(double(band.first)).variance
                               - table.above(double(band.end)).variance;
            // The rim of a band is met by 8 x 8 samples of a bin.
            EXPECT_NEAR(sum / whole, 1.0, 0.01) << length << ", cascade " << c;
            all += sum;
        }
        EXPECT_NEAR(all / table.above(0.0).variance, 1.0, 0.005) << length;
    }
}

// What FFTs compute, wave by wave; that the sum has no imaginary part is what lets two real fields
// go through one transform.
TEST(OceanSurface, IsTheSumOfItsWaves) {
    OceanSettings s = smallSea();
    s.choppiness = 0.7f;
    s.windDirection = 0.4f;
    Ocean ocean(s);
    const double time = 12.34;
    ocean.setTime(time);
    using Complex = std::complex<double>;
    for (uint32_t c = 0; c < 3; ++c) {
        const Waves waves = makeWaves(s, c);
        const int n = int(s.size);
        const double dk = 2.0 * M_PI / double(s.lengths[c]);
        for (const auto& [px, py] : {std::pair(0, 0), std::pair(5, 11), std::pair(63, 40)}) {
            Complex h, dx, dy, hx, hy, xx, yy, xy;
            for (int mx = -n / 2 + 1; mx < n / 2; ++mx) {
                for (int my = -n / 2 + 1; my < n / 2; ++my) {
                    const size_t i = size_t((mx + n) % n) * size_t(n) + size_t((my + n) % n);
                    const double phase = 2.0 * M_PI * waves.turns[i] * time;
                    const Complex amplitude =
                        Complex(double(waves.cosRe[i]), double(waves.cosIm[i])) * std::cos(phase) +
                        Complex(double(waves.sinRe[i]), double(waves.sinIm[i])) * std::sin(phase);
                    const Complex wave =
                        amplitude * std::polar(1.0, 2.0 * M_PI * (mx * px + my * py) / n);
                    const double kx = dk * mx, ky = dk * my, k = std::hypot(kx, ky);
                    if (k == 0.0) continue;
                    const Complex i1(0.0, 1.0);
                    const double l = double(s.choppiness) / k;
                    h += wave;
                    dx += i1 * kx * l * wave;
                    dy += i1 * ky * l * wave;
                    hx += i1 * kx * wave;
                    hy += i1 * ky * wave;
                    xx -= kx * kx * l * wave;
                    yy -= ky * ky * l * wave;
                    xy -= kx * ky * l * wave;
                }
            }
            const OceanPoint p = ocean.gridPoint(c, px, py);
            // Single-precision FFTs of sums of some hundred waves.
            const double height = 2e-5 * std::sqrt(double(ocean.varianceAbove(0.0f)));
            const auto near = [&](double value, Complex sum, double tolerance, const char* what) {
                EXPECT_NEAR(value, sum.real(), tolerance) << what << ", cascade " << c;
                EXPECT_NEAR(0.0, sum.imag(), 0.1 * tolerance) << what << ", cascade " << c;
            };
            near(double(p.displacement.z), h, height, "h");
            near(double(p.displacement.x), dx, height, "Dx");
            near(double(p.displacement.y), dy, height, "Dy");
            near(double(p.gradient.x), hx, 5e-6, "dh/dx");
            near(double(p.gradient.y), hy, 5e-6, "dh/dy");
            near(double(p.stretch.x), xx, 5e-6, "dDx/dx");
            near(double(p.stretch.y), yy, 5e-6, "dDy/dy");
            near(double(p.stretch.z), xy, 5e-6, "dDx/dy");
        }
    }
}

bool sameSea(const Ocean& a, const Ocean& b) {
    const int n = int(a.settings().size);
    for (uint32_t c = 0; c < a.settings().cascades; ++c) {
        for (int i = 0; i < n * n; ++i) {
            const OceanPoint p = a.gridPoint(c, i % n, i / n), q = b.gridPoint(c, i % n, i / n);
            if (p.displacement != q.displacement || p.foam != q.foam || p.gradient != q.gradient ||
                p.stretch != q.stretch) {
                return false;
            }
        }
    }
    const OceanSlopes s = a.slopes({3.0f, 4.0f}, {7.0f, 0.0f}, {0.0f, 3.0f});
    const OceanSlopes t = b.slopes({3.0f, 4.0f}, {7.0f, 0.0f}, {0.0f, 3.0f});
    return s.mean == t.mean && s.varX == t.varX && s.cov == t.cov && s.foam == t.foam;
}

TEST(OceanSurface, IsTheSameHoweverTimeGotThereAndOnOneThread) {
    const OceanSettings s = smallSea();
    Ocean leapt(s), walked(s), back(s), alone(s);
    leapt.setTime(7.3);
    for (int i = 1; i <= 73; ++i) walked.setTime(i == 73 ? 7.3 : 0.1 * i);
    back.setTime(-1000.0);
    back.setTime(1.0e6);
    EXPECT_FALSE(sameSea(leapt, back));
    back.setTime(7.3);
    {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        alone.setTime(7.3);
    }
    EXPECT_TRUE(sameSea(leapt, walked));
    EXPECT_TRUE(sameSea(leapt, back));
    EXPECT_TRUE(sameSea(leapt, alone));
    EXPECT_EQ(leapt.time(), 7.3);
}

TEST(OceanSurface, GoesWithTheWind) {
    for (const float direction : {0.0f, 2.0f, -2.5f}) {
        OceanSettings s = smallSea();
        s.swell = 1.0f;
        s.windDirection = direction;
        Ocean ocean(s);
        const int n = int(s.size);
        std::vector<float> before;
        for (int i = 0; i < n * n; ++i) {
            before.push_back(ocean.gridPoint(0, i % n, i / n).displacement.z);
        }
        const double step = 0.05;
        ocean.setTime(step);
        // What moves at velocity c has dh/dt = -c dh/dx.
        glm::vec2 flow(0.0f);
        for (int i = 0; i < n * n; ++i) {
            const OceanPoint p = ocean.gridPoint(0, i % n, i / n);
            flow -= p.gradient * (p.displacement.z - before[size_t(i)]);
        }
        const glm::vec2 wind(std::cos(direction), std::sin(direction));
        EXPECT_GT(glm::dot(glm::normalize(flow), wind), 0.9f) << direction;
    }
}

TEST(OceanSurface, WindOfNothingIsAFlatSea) {
    for (const bool byWind : {true, false}) {
        OceanSettings s = smallSea();
        (byWind ? s.windSpeed : s.amplitude) = 0.0f;
        Ocean ocean(s);
        ocean.setTime(5.0);
        EXPECT_EQ(ocean.significantHeight(), 0.0f);
        const OceanPoint p = ocean.at({12.3f, 4.5f});
        EXPECT_EQ(p.displacement, glm::vec3(0.0f));
        EXPECT_EQ(p.slope(), glm::vec2(0.0f));
        EXPECT_EQ(p.foam, 0.0f);
        const OceanSlopes slopes = ocean.slopes({1.0f, 2.0f}, {5.0f, 0.0f}, {0.0f, 5.0f});
        EXPECT_EQ(slopes.varX, 0.0f);
        EXPECT_EQ(slopes.foam, 0.0f);
        EXPECT_EQ(ocean.tail().xx, 0.0f);
    }
}

// One wave by each set of instructions that this processor has.
struct OneWave {
    static constexpr uint32_t size = 32;
    static constexpr double amplitude = 0.3;
    Waves waves;
    std::vector<OceanPoint> points{size * size};

    OneWave(const WaveKernels& kernels, float length, int bin, float choppiness) {
        waves.size = size;
        waves.length = length;
        waves.reach = bin;
        for (auto* plane : {&waves.cosRe, &waves.cosIm, &waves.sinRe, &waves.sinIm}) {
            plane->assign(size * size, 0.0f);
        }
        waves.turns.assign(size * size, 0.0);
        waves.cosRe[size_t(bin) * size] = waves.cosRe[(size - size_t(bin)) * size] =
            float(0.5 * amplitude);
        const std::unique_ptr<void, void (*)(void*)> plan(kernels.newPlan(size),
                                                          kernels.freePlan);
        const std::unique_ptr<float, void (*)(float*)> between(
            static_cast<float*>(std::aligned_alloc(64, 8 * size * size * sizeof(float))),
            [](float* p) { std::free(p); });
        std::fill(between.get(), between.get() + 8 * size * size, 0.0f);
        std::vector<uint16_t> squeeze(size * size);
        WaveTask task;
        task.waves = &waves;
        task.plan = plan.get();
        task.between = between.get();
        task.choppiness = choppiness;
        task.points = points.data();
        task.squeeze = squeeze.data();
        for (uint32_t g = 0; g < size / kernels.lanes; ++g) kernels.columns(task, g);
        for (uint32_t g = 0; g < size / kernels.lanes; ++g) kernels.rows(task, g);
    }
};

TEST(OceanSurface, OneWaveIsGerstners) {
    std::vector<const WaveKernels*> sets = {&waves::kernelsX86_64};
    if (waveKernels().lanes >= 8) sets.push_back(&waves::kernelsAvx2);
    if (waveKernels().lanes >= 16) sets.push_back(&waves::kernelsAvx512);
    for (const WaveKernels* kernels : sets) {
        const float length = 10.0f, choppiness = 0.8f;
        const OneWave wave(*kernels, length, 2, choppiness);
        const double k = 2.0 * M_PI * 2.0 / double(length), a = OneWave::amplitude;
        for (uint32_t x = 0; x < OneWave::size; ++x) {
            const double phase = k * double(length) * x / OneWave::size;
            const OceanPoint& p = wave.points[7 * OneWave::size + x];
            const double dx = -double(choppiness) * a * std::sin(phase);
            const double xx = -double(choppiness) * a * k * std::cos(phase);
            const double hx = -a * k * std::sin(phase);
            EXPECT_NEAR(p.displacement.z, a * std::cos(phase), 1e-6) << kernels->name;
            EXPECT_NEAR(p.displacement.x, dx, 1e-6) << kernels->name;
            EXPECT_NEAR(p.displacement.y, 0.0, 1e-6) << kernels->name;
            EXPECT_NEAR(p.jacobian(), 1.0 + xx, 2e-6) << kernels->name;
            EXPECT_NEAR(p.slope().x, hx / (1.0 + xx), 1e-5) << kernels->name;
            EXPECT_NEAR(p.slope().y, 0.0, 1e-6) << kernels->name;
        }
        // Crests are narrow: water is drawn towards them.
        EXPECT_LT(wave.points[0].jacobian(), 1.0f);
        EXPECT_LT(wave.points[1].displacement.x, 0.0f);
    }
}

TEST(OceanSurface, SlopeSolvesTheTransposedSystem) {
    OceanPoint p;
    p.gradient = {0.3f, -0.2f};
    p.stretch = {0.2f, -0.3f, 0.15f};
    const glm::vec2 s = p.slope();
    EXPECT_NEAR(1.2f * s.x + 0.15f * s.y, 0.3f, 1e-6f);
    EXPECT_NEAR(0.15f * s.x + 0.7f * s.y, -0.2f, 1e-6f);
    // Folded over: bounded, not infinite or turned around.
    p.stretch = {-1.0f, 0.0f, 0.0f};
    EXPECT_NEAR(p.slope().x, 0.3f / oceanLeastJacobian, 1e-5f);
}

}  // namespace
}  // namespace gp
