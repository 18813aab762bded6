// glitterpath brdf plot: the numbers behind its pictures.
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

#include "brdf/models.h"

namespace gp::tool {

enum class PlotKind { polar, thetaV, thetaH, thetaD, albedo, lobe };

// Angles in degrees, as they are typed. Which of them a kind uses: kPlotKindNotes.
struct CurveSettings {
    PlotKind kind = PlotKind::thetaV;
    std::vector<double> thetaI = {45}, thetaH = {0}, thetaD = {0};
    double phiV = 0, phiH = 0, phiD = 90;
    std::optional<double> phiI;  // without it opposite to phiV: the plane of incidence
    bool timesCosine = false;
    std::size_t samples = 16384;
};

struct CurvePoint {
    double x = 0;          // degrees
    glm::dvec3 value{0};   // NaN where a direction lies below the horizon
    glm::dvec3 error{0};   // of albedos
};

struct Curve {
    std::size_t model = 0;
    std::size_t angle = 0;  // which of the several incident (or other fixed) angles
    std::string label;
    std::vector<CurvePoint> points;
};

// A model's lobe over directions of view: a grid of theta and phi.
struct Lobe {
    std::string label;
    double thetaI = 0;                // degrees
    std::vector<double> theta, phi;   // degrees
    std::vector<glm::dvec3> values;   // all phi of the first theta first
};

// All but lobes; model after model.
std::vector<Curve> computeCurves(GpDevice device, const std::vector<Model>& models,
                                 const CurveSettings& settings);
std::vector<Lobe> computeLobes(GpDevice device, const std::vector<Model>& models,
                               const CurveSettings& settings);

// Rows of angles and values of everything that is drawn.
std::string curvesCsv(const std::vector<Curve>& curves, const std::vector<Model>& models,
                      const CurveSettings& settings);
std::string lobesCsv(const std::vector<Lobe>& lobes, const CurveSettings& settings);

}  // namespace gp::tool
