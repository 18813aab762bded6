// The chi-square test of a model's samples, through the C interface.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brdf/checks.h"
#include "brdf/directions.h"
#include "chi2/grids.h"

namespace gp::tool {
namespace {

constexpr std::size_t kBatch = 4096;
// Of all tests of a model together: so rarely may one that is right fail by chance.
constexpr double kSignificance = 1e-4;

// Samples are drawn many at a time, and handed out one by one.
class SampleSource {
public:
    SampleSource(GpDevice device, const Model& model, const glm::vec3& wo)
        : m_device(device), m_model(model), m_wo(kBatch, wo), m_u(kBatch) {}

    // The zero vector where the sample failed.
    glm::vec3 operator()(Random& random) {
        if (m_next == m_samples.size()) {
            for (glm::vec3& u : m_u) {
                u.x = random.uniform();
                u.y = random.uniform();
                u.z = random.uniform();
            }
            m_samples = sample(m_device, m_model.bsdf, m_wo, m_u);
            m_next = 0;
        }
        const GpBsdfSample& s = m_samples[m_next++];
        return {s.wi[0], s.wi[1], s.wi[2]};
    }

private:
    GpDevice m_device;
    const Model& m_model;
    std::vector<glm::vec3> m_wo, m_u;
    std::vector<GpBsdfSample> m_samples;
    std::size_t m_next = 0;
};

struct Worst {
    Chi2Result result;
    double wo = 0, integralError = 0;
    std::size_t tests = 0;
    bool passed = true;
};

// Near the normal, oblique, grazing; from below too where light goes through.
std::vector<double> viewCosines(const Model& model) {
    std::vector<double> cosines = {0.999, 0.6, 0.12};
    if (model.transmissive) {
        cosines.insert(cosines.end(), {-0.87, -0.5});
    }
    return cosines;
}

// One hemisphere of one view.
void test(GpDevice device, const Model& model, double cosine, int hemisphere,
          const Chi2Options& options, Worst& worst) {
    const glm::vec3 wo(spherical(std::acos(cosine), 0.4 + 1.1 * cosine));
    SphereDomain domain;
    domain.hemisphere = hemisphere;
    const std::vector<glm::vec3> view = {wo};
    std::vector<glm::vec3> light(1);
    const auto pdf = [&](glm::vec3 wi) {
        light[0] = wi;
        return evaluate(device, model.bsdf, light, view)[0].pdf;
    };
    const Chi2Result result =
        chi2Sphere(options, domain, SampleSource(device, model, wo), pdf);
    ++worst.tests;
    worst.integralError = std::max(worst.integralError,
                                   std::abs(result.pdfIntegral - result.acceptedFraction));
    if (result.acceptedFraction < 1e-4 && result.pdfIntegral < 2e-4) {
        return;  // practically nothing goes there, as past the critical angle
    }
    worst.passed = worst.passed && result.passed;
    if (worst.result.degrees == 0 || result.pValue < worst.result.pValue) {
        worst.result = result;
        worst.wo = cosine;
    }
}

}  // namespace

Check checkSampling(GpDevice device, const Model& model, std::size_t samples) {
    const std::vector<double> cosines = viewCosines(model);
    Chi2Options options;
    options.name = model.label;
    options.samples = samples;
    options.significance = kSignificance;
    options.testCount = cosines.size() * (model.transmissive ? 2 : 1);
    Worst worst;
    for (const double cosine : cosines) {
        const int side = cosine > 0 ? 1 : -1;
        test(device, model, cosine, side, options, worst);
        if (model.transmissive) {
            test(device, model, cosine, -side, options, worst);
        }
        ++options.seed;
    }
    const double tests = static_cast<double>(options.testCount);
    const double needed = 1.0 - std::pow(1.0 - options.significance, 1.0 / tests);
    Check check;
    check.name = "sampling";
    check.verdict = worst.passed ? Verdict::ok : Verdict::failed;
    check.json = {{"p_value", worst.result.pValue}, {"needed", needed},
                  {"chi2", worst.result.statistic}, {"degrees", worst.result.degrees},
                  {"cosine", worst.wo}, {"tests", worst.tests}, {"samples", samples},
                  {"integral_error", worst.integralError}};
    check.text = fmt::format("chi-square p = {:.3g}, the least of {} (needed {:.2g}); ∫pdf off by "
                             "{:.2g}",
                             worst.result.pValue, worst.tests, needed, worst.integralError);
    return check;
}

}  // namespace gp::tool
