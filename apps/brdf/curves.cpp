#include "brdf/curves.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "brdf/albedo.h"
#include "brdf/directions.h"
#include "csv.h"

namespace gp::tool {
namespace {

constexpr std::size_t kPlaces = 361;  // evenly spread ones of a curve
constexpr double kLargestAlbedoAngle = 89.5;

double radians(double degrees) {
    return degrees * M_PI / 180.0;
}

double phiIOf(const CurveSettings& settings) {
    return settings.phiI.value_or(settings.phiV + 180.0);
}

bool anyTransmits(const std::vector<Model>& models) {
    for (const Model& model : models) {
        if (model.transmissive) {
            return true;
        }
    }
    return false;
}

// The fixed angles of a kind, one curve for each.
const std::vector<double>& fixedAngles(const CurveSettings& settings) {
    static const std::vector<double> none = {0};
    switch (settings.kind) {
    case PlotKind::polar:
    case PlotKind::thetaV:
    case PlotKind::lobe: return settings.thetaI;
    case PlotKind::thetaH: return settings.thetaD;
    case PlotKind::thetaD: return settings.thetaH;
    case PlotKind::albedo: break;
    }
    return none;
}

const char* fixedName(PlotKind kind) {
    return kind == PlotKind::thetaH ? "θd" : kind == PlotKind::thetaD ? "θh" : "θi";
}

// A narrow lobe stands at the mirror's angle, or looks back at the light.
std::vector<double> placesOf(const CurveSettings& settings, double fixed, bool transmits) {
    switch (settings.kind) {
    case PlotKind::thetaH: return placesBetween(0, 90, kPlaces, {0});
    case PlotKind::thetaD: return placesBetween(0, 90, kPlaces, {});
    case PlotKind::albedo: return placesBetween(0, kLargestAlbedoAngle, 46, {});
    default: break;
    }
    const double end = transmits ? 180 : 90;
    return placesBetween(-end, end, kPlaces, {fixed, -fixed});
}

DirectionPair pairOf(const CurveSettings& settings, double fixed, double x) {
    switch (settings.kind) {
    case PlotKind::thetaH:
        return fromHalfAndDifference(radians(x), radians(settings.phiH), radians(fixed),
                                     radians(settings.phiD));
    case PlotKind::thetaD:
        return fromHalfAndDifference(radians(fixed), radians(settings.phiH), radians(x),
                                     radians(settings.phiD));
    default: break;
    }
    DirectionPair pair;
    pair.wi = spherical(radians(fixed), radians(phiIOf(settings)));
    pair.wo = spherical(radians(x), radians(settings.phiV));
    return pair;
}

// Below the horizon of an opaque model f is 0; there is nothing to see where half vectors and
// differences lead there, so that those are gaps.
std::vector<glm::dvec3> valuesOf(GpDevice device, const Model& model,
                                 const std::vector<DirectionPair>& pairs, bool gaps,
                                 bool timesCosine) {
    std::vector<glm::vec3> wi, wo;
    for (const DirectionPair& pair : pairs) {
        wi.emplace_back(pair.wi);
        wo.emplace_back(pair.wo);
    }
    const std::vector<GpBsdfValue> values = evaluate(device, model.bsdf, wi, wo);
    std::vector<glm::dvec3> result;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double factor = timesCosine ? std::abs(pairs[i].wi.z) : 1.0;
        const bool gap = gaps && !pairs[i].aboveHorizon();
        const auto& f = values[i].f;
        result.push_back(gap ? glm::dvec3(std::numeric_limits<double>::quiet_NaN())
                             : glm::dvec3(f[0], f[1], f[2]) * factor);
    }
    return result;
}

std::vector<CurvePoint> albedoPoints(GpDevice device, const Model& model,
                                     const CurveSettings& settings) {
    std::vector<CurvePoint> points;
    for (const double x : placesOf(settings, 0, false)) {
        const glm::dvec3 direction = spherical(radians(x), radians(settings.phiV));
        const Albedo albedo =
            directionalAlbedo(device, model.bsdf, direction, settings.samples);
        points.push_back({x, albedo.mean, albedo.error});
    }
    return points;
}

std::vector<CurvePoint> pointsOf(GpDevice device, const Model& model,
                                 const CurveSettings& settings, double fixed, bool transmits) {
    if (settings.kind == PlotKind::albedo) {
        return albedoPoints(device, model, settings);
    }
    const bool gaps = settings.kind == PlotKind::thetaH || settings.kind == PlotKind::thetaD;
    std::vector<DirectionPair> pairs;
    const std::vector<double> places = placesOf(settings, fixed, transmits);
    for (const double x : places) {
        pairs.push_back(pairOf(settings, fixed, x));
    }
    const std::vector<glm::dvec3> values =
        valuesOf(device, model, pairs, gaps, settings.timesCosine);
    std::vector<CurvePoint> points;
    for (std::size_t i = 0; i < places.size(); ++i) {
        points.push_back({places[i], values[i], glm::dvec3(0.0)});
    }
    return points;
}

std::string labelOf(GpDevice device, const Model& model, const CurveSettings& settings,
                    double fixed) {
    if (settings.kind == PlotKind::albedo) {
        const glm::dvec3 mean = averageAlbedo(device, model.bsdf, 16 * settings.samples).mean;
        return mean.x == mean.y && mean.y == mean.z
                   ? fmt::format("{}, average {:.4f}", model.label, mean.x)
                   : fmt::format("{}, average {:.4f} {:.4f} {:.4f}", model.label, mean.x, mean.y,
                                 mean.z);
    }
    return fixedAngles(settings).size() == 1
               ? model.label
               : fmt::format("{}, {} {:g}°", model.label, fixedName(settings.kind), fixed);
}

std::vector<std::string> columnsOf(const CurveSettings& settings) {
    const bool cosine = settings.timesCosine;
    const char *r = cosine ? "fcos_r" : "f_r", *g = cosine ? "fcos_g" : "f_g",
               *b = cosine ? "fcos_b" : "f_b";
    switch (settings.kind) {
    case PlotKind::thetaH: return {"model", "theta_d", "theta_h", r, g, b};
    case PlotKind::thetaD: return {"model", "theta_h", "theta_d", r, g, b};
    case PlotKind::albedo:
        return {"model", "theta_o", "r", "g", "b", "error_r", "error_g", "error_b"};
    case PlotKind::lobe: return {"model", "theta_i", "theta_v", "phi_v", r, g, b};
    default: return {"model", "theta_i", "theta_v", r, g, b};
    }
}

std::vector<std::string> textOf(const glm::dvec3& v) {
    if (std::isnan(v.x)) {
        return {"", "", ""};  // below the horizon
    }
    return {fmt::format("{:.9g}", v.x), fmt::format("{:.9g}", v.y), fmt::format("{:.9g}", v.z)};
}

std::string row(std::vector<std::string> fields, const std::vector<std::string>& more) {
    fields.insert(fields.end(), more.begin(), more.end());
    return csvLine(fields);
}

}  // namespace

std::vector<Curve> computeCurves(GpDevice device, const std::vector<Model>& models,
                                 const CurveSettings& settings) {
    const bool transmits = anyTransmits(models);
    const std::vector<double>& fixed = fixedAngles(settings);
    std::vector<Curve> curves;
    for (std::size_t m = 0; m < models.size(); ++m) {
        for (std::size_t a = 0; a < fixed.size(); ++a) {
            Curve curve;
            curve.model = m;
            curve.angle = a;
            curve.label = labelOf(device, models[m], settings, fixed[a]);
            curve.points = pointsOf(device, models[m], settings, fixed[a], transmits);
            curves.push_back(std::move(curve));
        }
    }
    return curves;
}

std::vector<Lobe> computeLobes(GpDevice device, const std::vector<Model>& models,
                               const CurveSettings& settings) {
    std::vector<Lobe> lobes;
    for (const Model& model : models) {
        for (const double thetaI : settings.thetaI) {
            Lobe lobe;
            lobe.label = labelOf(device, model, settings, thetaI);
            lobe.thetaI = thetaI;
            lobe.theta = placesBetween(0, model.transmissive ? 180 : 90, 61, {thetaI});
            const double mirror = std::fmod(phiIOf(settings) + 180.0, 360.0);
            lobe.phi = placesBetween(0, 360, 91, {mirror, mirror + 360, mirror - 360});
            std::vector<DirectionPair> pairs;
            for (const double theta : lobe.theta) {
                for (const double phi : lobe.phi) {
                    pairs.push_back({spherical(radians(thetaI), radians(phiIOf(settings))),
                                     spherical(radians(theta), radians(phi))});
                }
            }
            lobe.values = valuesOf(device, model, pairs, false, settings.timesCosine);
            lobes.push_back(std::move(lobe));
        }
    }
    return lobes;
}

std::string curvesCsv(const std::vector<Curve>& curves, const std::vector<Model>& models,
                      const CurveSettings& settings) {
    std::string text = csvLine(columnsOf(settings));
    for (const Curve& curve : curves) {
        const std::string& label = models[curve.model].label;
        for (const CurvePoint& p : curve.points) {
            const std::string x = fmt::format("{:.9g}", p.x);
            if (settings.kind == PlotKind::albedo) {
                std::vector<std::string> fields = textOf(p.value), errors = textOf(p.error);
                fields.insert(fields.end(), errors.begin(), errors.end());
                text += row({label, x}, fields);
                continue;
            }
            const double fixed = fixedAngles(settings)[curve.angle];
            text += row({label, fmt::format("{:g}", fixed), x}, textOf(p.value));
        }
    }
    return text;
}

std::string lobesCsv(const std::vector<Lobe>& lobes, const CurveSettings& settings) {
    std::string text = csvLine(columnsOf(settings));
    for (const Lobe& lobe : lobes) {
        std::size_t i = 0;
        for (const double theta : lobe.theta) {
            for (const double phi : lobe.phi) {
                text += row({lobe.label, fmt::format("{:g}", lobe.thetaI),
                             fmt::format("{:.9g}", theta), fmt::format("{:.9g}", phi)},
                            textOf(lobe.values[i++]));
            }
        }
    }
    return text;
}

}  // namespace gp::tool
