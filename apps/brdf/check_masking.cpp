// The weak white furnace: seen from anywhere, the visible microfacets cover what the surface does.
#include <fmt/format.h>

#include <cmath>

#include "brdf/checks.h"
#include "brdf/directions.h"

namespace gp::tool {
namespace {

// Smith's masking for the distributions without a closed form is fitted: off by at most 0.003.
constexpr double kLimit = 0.005;
constexpr std::size_t kRadii = 512, kSectors = 128;

// Microfacet normals that are dense where the distribution is: even in the fraction that a GGX
// distribution of the same widths has, with the solid angle of each.
struct Normals {
    std::vector<glm::vec3> m;
    std::vector<double> solidAngle;
};

Normals normalsFor(double alphaX, double alphaY) {
    Normals normals;
    for (std::size_t i = 0; i < kRadii; ++i) {
        const double t = (static_cast<double>(i) + 0.5) / kRadii;
        // Slope over width is s = t^2 / (1 - t); its element s ds.
        const double s = t * t / (1.0 - t);
        const double ds = t * (2.0 - t) / ((1.0 - t) * (1.0 - t)) / kRadii;
        for (std::size_t k = 0; k < kSectors; ++k) {
            const double phi = 2.0 * M_PI * (static_cast<double>(k) + 0.5) / kSectors;
            const glm::dvec3 m(-alphaX * s * std::cos(phi), -alphaY * s * std::sin(phi), 1.0);
            const double cosine = 1.0 / glm::length(m);
            normals.m.emplace_back(m * cosine);
            normals.solidAngle.push_back(cosine * cosine * cosine * alphaX * alphaY * s * ds * 2.0 *
                                         M_PI / kSectors);
        }
    }
    return normals;
}

// D from the model without masking, light and viewer both at m: f = D / (4 cos^2).
std::vector<double> distributionAt(GpDevice device, const Bsdf& bare, const Normals& normals) {
    std::vector<double> d;
    const std::vector<GpBsdfValue> values = evaluate(device, bare, normals.m, normals.m);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double z = normals.m[i].z;
        d.push_back(double(values[i].f[0]) * 4.0 * z * z);
    }
    return d;
}

// The share of the projected surface that visible microfacets have; 1 is right.
double coveredShare(GpDevice device, const Bsdf& masked, const Bsdf& bare, const glm::dvec3& wo,
                    const Normals& normals, const std::vector<double>& d) {
    // With the light at the normal, where nothing is shadowed, masking is the whole difference.
    const std::vector<glm::vec3> up = {glm::vec3(0, 0, 1)}, view = {glm::vec3(wo)};
    const double with = evaluate(device, masked, up, view)[0].f[0];
    const double without = evaluate(device, bare, up, view)[0].f[0];
    double sum = 0.0;
    for (std::size_t i = 0; i < d.size(); ++i) {
        sum += std::max(0.0, glm::dot(glm::dvec3(normals.m[i]), wo)) * d[i] *
               normals.solidAngle[i];
    }
    return without > 0.0 ? with / without * sum / wo.z : std::nan("");
}

bool isSmith(const Model& model) {
    const auto& parameters = model.description.at("parameters");
    return model.description.at("model") == "microfacet" &&
           parameters.at("masking").get<std::string>().starts_with("smith_");
}

}  // namespace

Check checkWeakWhiteFurnace(GpDevice device, const Model& model) {
    Check check;
    check.name = "weak white furnace";
    check.verdict = Verdict::notApplicable;
    check.text = "for microfacet with Smith's masking";
    check.json = nlohmann::ordered_json::object();
    if (!isSmith(model)) {
        return check;
    }
    const auto& parameters = model.description.at("parameters");
    const Bsdf masked = variantOf(device, model, {{"fresnel", "none"}});
    const Bsdf bare = variantOf(device, model, {{"fresnel", "none"}, {"masking", "none"}});
    const Normals normals = normalsFor(parameters.at("alpha_x").get<double>(),
                                       parameters.at("alpha_y").get<double>());
    const std::vector<double> d = distributionAt(device, bare, normals);
    double worst = 0.0, where = 0.0;
    int measured = 0;
    for (const double theta : {0.0, 20.0, 40.0, 60.0, 75.0, 85.0}) {
        const glm::dvec3 wo = spherical(theta * M_PI / 180.0, 0.6);
        const double error = std::abs(coveredShare(device, masked, bare, wo, normals, d) - 1.0);
        // Narrow distributions end before the half vector of a slanted view: nothing to divide.
        measured += std::isfinite(error) ? 1 : 0;
        if (std::isfinite(error) && error > worst) {
            worst = error;
            where = theta;
        }
    }
    check.verdict = worst <= kLimit ? Verdict::ok : Verdict::failed;
    check.json = {{"largest_error", worst}, {"theta", where}, {"limit", kLimit},
                  {"views", measured}};
    check.text = fmt::format("off by at most {:.2g} at θ {:g}°, {} views", worst, where, measured);
    return check;
}

}  // namespace gp::tool
