// glitterpath brdf plot: what gnuplot is told.
#pragma once

#include "brdf/curves.h"
#include "gnuplot.h"

namespace gp::tool {

enum class Channel { red, green, blue, luminance, rgb };

struct PlotLook {
    Channel channel = Channel::luminance;
    bool logarithmic = false;
    unsigned width = 900, height = 600;
};

double channelOf(const glm::dvec3& value, Channel channel);  // not rgb

// Throw RunError where there is nothing to draw.
GnuplotJob curvesJob(const std::vector<Curve>& curves, const CurveSettings& settings,
                     const PlotLook& look);
GnuplotJob lobesJob(const std::vector<Lobe>& lobes, const CurveSettings& settings,
                    const PlotLook& look);

}  // namespace gp::tool
