#include "brdf/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "brdf/albedo.h"
#include "brdf/directions.h"
#include "chi2/random.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPairs = 20'000;
constexpr double kReciprocityLimit = 0.01;
// The fits of albedos that split the light among layers are off by up to 0.007.
constexpr double kAlbedoLimit = 1.008;
constexpr std::size_t kAlbedoSamples = 32768;
constexpr float kHorizon = 0.01f;  // nearer to it float has few digits of the cosines

struct Pairs {
    std::vector<glm::vec3> wi, wo;
};

glm::vec3 uniformDirection(Random& random, bool wholeSphere) {
    const double z = wholeSphere ? 2.0 * random.uniform() - 1.0 : double(random.uniform());
    return glm::vec3(spherical(std::acos(z), 2.0 * M_PI * random.uniform()));
}

// Half of the lights are samples, as random ones never meet a narrow lobe.
Pairs drawPairs(GpDevice device, const Model& model) {
    Random random(5);
    std::vector<glm::vec3> wo, u;
    for (std::size_t i = 0; i < kPairs; ++i) {
        wo.push_back(uniformDirection(random, model.transmissive));
        const float a = random.uniform(), b = random.uniform();
        u.emplace_back(a, b, random.uniform());
    }
    const std::vector<GpBsdfSample> samples = sample(device, model.bsdf, wo, u);
    Pairs pairs;
    for (std::size_t i = 0; i < kPairs; ++i) {
        const auto& s = samples[i].wi;
        const bool sampled = i % 2 == 1 && samples[i].pdf > 0.0f;
        const glm::vec3 wi = sampled ? glm::vec3(s[0], s[1], s[2])
                                     : uniformDirection(random, model.transmissive);
        if (std::abs(wi.z) > kHorizon && std::abs(wo[i].z) > kHorizon) {
            pairs.wi.push_back(wi);
            pairs.wo.push_back(wo[i]);
        }
    }
    return pairs;
}

double sumOf(const GpBsdfValue& value) {
    return double(value.f[0]) + double(value.f[1]) + double(value.f[2]);
}

// How much a value changes when its light moves by a rounding error.
std::vector<double> noiseOf(GpDevice device, const Model& model, const Pairs& pairs,
                            const std::vector<GpBsdfValue>& values) {
    std::vector<double> noise(values.size(), 0.0);
    for (const glm::vec3 step : {glm::vec3(3e-7f, 0, 1e-7f), glm::vec3(1e-7f, 3e-7f, 0)}) {
        std::vector<glm::vec3> moved;
        for (const glm::vec3& wi : pairs.wi) {
            moved.push_back(glm::normalize(wi + step));
        }
        const std::vector<GpBsdfValue> others = evaluate(device, model.bsdf, moved, pairs.wo);
        for (std::size_t i = 0; i < values.size(); ++i) {
            noise[i] += std::abs(sumOf(others[i]) - sumOf(values[i]));
        }
    }
    return noise;
}

bool crosses(const Pairs& pairs, std::size_t i) {
    return (pairs.wi[i].z > 0) != (pairs.wo[i].z > 0);
}

// f(wo, wi) / f(wi, wo) from above to below, which is one over the square of the index: the same
// for all pairs where light can go back as it came.
double refractionRatio(const Pairs& pairs, const std::vector<GpBsdfValue>& forwards,
                       const std::vector<GpBsdfValue>& backwards) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < forwards.size(); ++i) {
        const double f = sumOf(forwards[i]), b = sumOf(backwards[i]);
        if (crosses(pairs, i) && f > 1e-3 && b > 1e-3) {
            ratios.push_back(pairs.wo[i].z > 0 ? f / b : b / f);
        }
    }
    if (ratios.empty()) {
        return 1.0;
    }
    std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
    return ratios[ratios.size() / 2];
}

std::string numberText(double value) {
    return fmt::format("{:.3g}", value);
}

Verdict verdictOf(bool claimed, bool good) {
    return good ? Verdict::ok : claimed ? Verdict::failed : Verdict::notClaimed;
}

// Lights all around: degrees of theta, phi.
std::vector<std::pair<double, double>> albedoAngles(const Model& model) {
    std::vector<double> thetas = {0, 15, 30, 45, 60, 70, 80, 85, 88, 89};
    if (model.transmissive) {
        thetas.insert(thetas.end(), {91, 95, 110, 125, 140, 160, 180});
    }
    std::vector<std::pair<double, double>> angles;
    for (const double theta : thetas) {
        for (const double phi : {0.0, 45.0, 90.0}) {
            angles.emplace_back(theta, phi);
        }
    }
    return angles;
}

struct Extremes {
    double largest = -1, largestError = 0, largestTheta = 0, largestPhi = 0;
    double smallest = std::numeric_limits<double>::infinity(), smallestTheta = 0;
    bool finite = true;
};

Extremes albedoExtremes(GpDevice device, const Model& model, const Bsdf& bsdf) {
    Extremes e;
    for (const auto& [theta, phi] : albedoAngles(model)) {
        const glm::dvec3 direction = spherical(theta * M_PI / 180.0, phi * M_PI / 180.0);
        const Albedo albedo = directionalAlbedo(device, bsdf, direction, kAlbedoSamples);
        for (int k = 0; k < 3; ++k) {
            const double mean = albedo.mean[k];
            e.finite = e.finite && std::isfinite(mean);
            if (mean > e.largest) {
                e.largest = mean;
                e.largestError = albedo.error[k];
                e.largestTheta = theta;
                e.largestPhi = phi;
            }
            if (mean < e.smallest) {
                e.smallest = mean;
                e.smallestTheta = theta;
            }
        }
    }
    return e;
}

bool conserves(const Extremes& e) {
    return e.finite && e.largest <= kAlbedoLimit + 4.0 * e.largestError;
}

bool hasParameter(const Model& model, const char* name) {
    return model.description.at("parameters").contains(name);
}

// Only parameters that say by themselves what white is.
ParameterWords whiteningOf(const Model& model) {
    ParameterWords words;
    if (hasParameter(model, "base_color")) {
        words.emplace_back("base_color", "1");
    } else if (hasParameter(model, "sheen_color")) {
        words.emplace_back("sheen_color", "1");  // of sheen alone; elsewhere it is a layer
    }
    if (hasParameter(model, "fresnel")) {
        words.emplace_back("fresnel", "none");
    }
    return words;
}

std::string textOf(const ParameterWords& words) {
    std::string text;
    for (const auto& [name, value] : words) {
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
    }
    return text;
}

}  // namespace

Check checkReciprocity(GpDevice device, const Model& model, const Claims& claims) {
    const Pairs pairs = drawPairs(device, model);
    const std::vector<GpBsdfValue> forwards =
        evaluate(device, model.bsdf, pairs.wi, pairs.wo);
    const std::vector<GpBsdfValue> backwards =
        evaluate(device, model.bsdf, pairs.wo, pairs.wi);
    const std::vector<double> noise = noiseOf(device, model, pairs, forwards);
    const double ratio = refractionRatio(pairs, forwards, backwards);
    double worst = 0.0;
    std::size_t where = 0;
    for (std::size_t i = 0; i < forwards.size(); ++i) {
        const double factor = !crosses(pairs, i) ? 1.0 : pairs.wo[i].z > 0 ? ratio : 1.0 / ratio;
        const double f = sumOf(forwards[i]), b = sumOf(backwards[i]) * factor;
        const double difference = std::abs(f - b) - 4.0 * noise[i] - 1e-6;
        const double error = difference / std::max({f, b, 1e-30});
        if (error > worst) {
            worst = error;
            where = i;
        }
    }
    Check check;
    check.name = "reciprocity";
    check.verdict = verdictOf(claims.reciprocal, worst <= kReciprocityLimit);
    check.json = {{"largest_relative_error", worst}, {"limit", kReciprocityLimit},
                  {"pairs", forwards.size()}, {"claimed", claims.reciprocal}};
    check.text = fmt::format("largest relative error {}", numberText(worst));
    if (worst > 0.0) {
        const glm::vec3 wi = pairs.wi[where], wo = pairs.wo[where];
        check.json["wi"] = {wi.x, wi.y, wi.z};
        check.json["wo"] = {wo.x, wo.y, wo.z};
        check.text += fmt::format(" at cosines {:.3f}, {:.3f}", wi.z, wo.z);
    }
    if (model.transmissive) {
        check.json["squared_index"] = 1.0 / ratio;
        check.text += fmt::format("; squared index {:.4f}", 1.0 / ratio);
    }
    return check;
}

Check checkPositivity(GpDevice device, const Model& model) {
    Pairs pairs = drawPairs(device, model);
    for (const float z : {1.0f, 1e-3f, 1e-6f, 1e-20f}) {
        for (const float x : {1.0f, 0.5f, -0.3f}) {
            pairs.wi.emplace_back(std::sqrt(1.0f - z * z), 0.0f, z);
            pairs.wo.push_back(glm::normalize(glm::vec3(x, 0.2f, z)));
        }
    }
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t infinite = 0;
    for (const GpBsdfValue& value : evaluate(device, model.bsdf, pairs.wi, pairs.wo)) {
        for (const float x : {value.f[0], value.f[1], value.f[2], value.pdf}) {
            infinite += std::isfinite(x) ? 0 : 1;
            smallest = std::isfinite(x) ? std::min(smallest, double(x)) : smallest;
        }
    }
    Check check;
    check.name = "positivity";
    check.verdict = verdictOf(true, smallest >= 0.0 && infinite == 0);
    check.json = {{"smallest_value", smallest}, {"not_finite", infinite},
                  {"pairs", pairs.wi.size()}};
    check.text = fmt::format("smallest value {}, {} not finite", numberText(smallest), infinite);
    return check;
}

Check checkAlbedo(GpDevice device, const Model& model, const Claims& claims) {
    const Extremes e = albedoExtremes(device, model, model.bsdf);
    Check check;
    check.name = "albedo";
    check.verdict = verdictOf(claims.conserving, conserves(e));
    check.json = {{"largest", e.largest}, {"error", e.largestError}, {"limit", kAlbedoLimit},
                  {"theta", e.largestTheta}, {"phi", e.largestPhi},
                  {"claimed", claims.conserving}};
    check.text = fmt::format("at most {:.4f} ± {:.4f}, at θ {:g}°, φ {:g}°", e.largest,
                             e.largestError, e.largestTheta, e.largestPhi);
    return check;
}

Check checkWhiteFurnace(GpDevice device, const Model& model, const Claims& claims) {
    const ParameterWords white = whiteningOf(model);
    Check check;
    check.name = "white furnace";
    if (white.empty()) {
        check.verdict = Verdict::notApplicable;
        check.text = "no parameter makes it white";
        check.json = Json::object();
        return check;
    }
    const Bsdf bsdf = variantOf(device, model, white);
    const Extremes e = albedoExtremes(device, model, bsdf);
    check.verdict = verdictOf(claims.conserving, conserves(e));
    check.json = {{"set", textOf(white)}, {"smallest", e.smallest},
                  {"smallest_theta", e.smallestTheta}, {"largest", e.largest},
                  {"error", e.largestError}, {"largest_theta", e.largestTheta},
                  {"limit", kAlbedoLimit}, {"claimed", claims.conserving}};
    check.text = fmt::format("albedo {:.4f} (θ {:g}°) to {:.4f} (θ {:g}°) with {}", e.smallest,
                             e.smallestTheta, e.largest, e.largestTheta, textOf(white));
    return check;
}

}  // namespace gp::tool
