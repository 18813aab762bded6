#include "brdf/albedo.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "chi2/random.h"

namespace gp::tool {
namespace {

// So many independent estimates tell their error; each is of even points with a shift of its own.
constexpr std::size_t kReplicates = 16;

// Points that fill a cube evenly: multiples of powers of the root of x^(d + 1) = x + 1.
// [Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"]
class EvenPoints {
public:
    static constexpr std::size_t dimensions = 5;
    using Point = std::array<double, dimensions>;

    explicit EvenPoints(Random& random) {
        double root = 1.0;
        for (int i = 0; i < 60; ++i) {
            root = std::pow(1.0 + root, 1.0 / (dimensions + 1.0));
        }
        for (std::size_t k = 0; k < dimensions; ++k) {
            m_step[k] = std::pow(root, -static_cast<double>(k + 1));
            m_shift[k] = random.uniform();
        }
    }

    Point operator()(std::size_t index) const {
        Point point{};
        for (std::size_t k = 0; k < dimensions; ++k) {
            const double x = m_shift[k] + m_step[k] * static_cast<double>(index);
            point[k] = x - std::floor(x);
        }
        return point;
    }

private:
    Point m_step{}, m_shift{};
};

// Below 1 as a float, too.
float unitFloat(double x) {
    return std::min(static_cast<float>(x), 0x1.fffffep-1f);
}

glm::vec3 vectorOf(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

// Refraction squeezes radiance, and the weights of samples are those of radiance that arrives. What
// leaves of the light that comes from wo is told by f with light and viewer exchanged: the same but
// for the factor of the two indices, which then cancels.
std::vector<glm::dvec3> energies(GpDevice device, const Bsdf& bsdf,
                                 const std::vector<glm::vec3>& wo,
                                 const std::vector<GpBsdfSample>& samples) {
    std::vector<glm::dvec3> result;
    std::vector<std::size_t> through;
    std::vector<glm::vec3> light, viewer;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const GpBsdfSample& s = samples[i];
        result.emplace_back(vectorOf(s.weight));
        if ((s.lobe & GP_LOBE_TRANSMISSION) != 0) {
            through.push_back(i);
            light.push_back(wo[i]);
            viewer.push_back(vectorOf(s.wi));
        }
    }
    const std::vector<GpBsdfValue> values = evaluate(device, bsdf, light, viewer);
    for (std::size_t k = 0; k < through.size(); ++k) {
        const GpBsdfSample& s = samples[through[k]];
        const double factor = std::abs(static_cast<double>(s.wi[2])) / s.pdf;
        result[through[k]] = glm::dvec3(vectorOf(values[k].f)) * factor;
    }
    return result;
}

using ViewOf = std::function<glm::vec3(const EvenPoints::Point&)>;

Albedo estimate(GpDevice device, const Bsdf& bsdf, std::size_t samples, const ViewOf& viewOf) {
    Random random(1);
    const std::size_t count = std::max<std::size_t>(samples / kReplicates, 1);
    std::vector<glm::vec3> wo, u;
    for (std::size_t r = 0; r < kReplicates; ++r) {
        const EvenPoints points(random);
        for (std::size_t i = 0; i < count; ++i) {
            const EvenPoints::Point p = points(i);
            wo.push_back(viewOf(p));
            u.emplace_back(unitFloat(p[0]), unitFloat(p[1]), unitFloat(p[2]));
        }
    }
    const std::vector<glm::dvec3> energy =
        energies(device, bsdf, wo, sample(device, bsdf, wo, u));
    glm::dvec3 sum(0.0), squares(0.0);
    for (std::size_t r = 0; r < kReplicates; ++r) {
        glm::dvec3 part(0.0);
        for (std::size_t i = 0; i < count; ++i) {
            part += energy[r * count + i];
        }
        part /= static_cast<double>(count);
        sum += part;
        squares += part * part;
    }
    const auto n = static_cast<double>(kReplicates);
    Albedo albedo;
    albedo.mean = sum / n;
    const glm::dvec3 variance = (squares / n - albedo.mean * albedo.mean) / (n - 1.0);
    albedo.error = glm::sqrt(glm::max(variance, glm::dvec3(0.0)));
    return albedo;
}

}  // namespace

Albedo directionalAlbedo(GpDevice device, const Bsdf& bsdf, const glm::dvec3& direction,
                         std::size_t samples) {
    const glm::vec3 wo(direction);
    return estimate(device, bsdf, samples, [&](const EvenPoints::Point&) { return wo; });
}

Albedo averageAlbedo(GpDevice device, const Bsdf& bsdf, std::size_t samples) {
    // Evenly from above: as many as their cosines.
    return estimate(device, bsdf, samples, [](const EvenPoints::Point& p) {
        const double r = std::sqrt(p[3]), phi = 2.0 * M_PI * p[4];
        return glm::vec3(glm::dvec3(r * std::cos(phi), r * std::sin(phi),
                                    std::sqrt(std::max(1e-12, 1.0 - p[3]))));
    });
}

}  // namespace gp::tool
