#include "brdf/plot_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brdf/directions.h"
#include "metrics/color.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

// Told apart by people who see fewer colours, too.
// [Okabe, Ito 2008, "Color Universal Design"]
constexpr const char* kColors[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                   "#E69F00", "#56B4E9", "#000000", "#999933"};
constexpr const char* kChannelColors[] = {"#D62728", "#2CA02C", "#1F77B4"};
constexpr const char* kChannelNames[] = {"R", "G", "B"};
constexpr double kDecades = 1e-6;  // of the largest value: less is not drawn on logarithmic axes

struct Line {
    std::string title, style;
    std::vector<std::pair<double, double>> points;  // y is NaN in gaps
};

std::vector<Line> linesOf(const std::vector<Curve>& curves, Channel channel) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Curve& curve = curves[i];
        const int count = channel == Channel::rgb ? 3 : 1;
        for (int c = 0; c < count; ++c) {
            const bool all = channel == Channel::rgb;
            Line line;
            line.title = all ? fmt::format("{} {}", curve.label, kChannelNames[c]) : curve.label;
            line.style = all ? fmt::format("lc rgb '{}' dt {}", kChannelColors[c], i + 1)
                             : fmt::format("lc rgb '{}' dt {}",
                                           kColors[curve.model % std::size(kColors)],
                                           curve.angle + 1);
            for (const CurvePoint& p : curve.points) {
                line.points.emplace_back(
                    p.x, channelOf(p.value, all ? static_cast<Channel>(c) : channel));
            }
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

// Several models grow without bound towards the horizon: the axes leave the last degrees out.
bool isGrazing(double degrees) {
    return std::abs(std::abs(degrees) - 90.0) < 3.0;
}

double largestOf(const std::vector<Line>& lines, PlotKind kind) {
    const bool directions = kind != PlotKind::albedo;
    double largest = 0.0;
    for (const Line& line : lines) {
        for (const auto& [x, y] : line.points) {
            const bool grazing = directions && isGrazing(x);
            largest = std::isfinite(y) && !grazing ? std::max(largest, y) : largest;
        }
    }
    return largest;
}

std::string quantity(const CurveSettings& settings) {
    if (settings.kind == PlotKind::albedo) {
        return "directional albedo";
    }
    return settings.timesCosine ? "f cos θ_i (1/sr)" : "f (1/sr)";
}

std::string numbers(const std::vector<std::pair<double, double>>& points) {
    std::string text;
    for (const auto& [x, y] : points) {
        text += std::isfinite(y) ? fmt::format("{:.9g} {:.9g}\n", x, y)
                                 : fmt::format("{:.9g} NaN\n", x);
    }
    return text + "\n\n";
}

std::string xLabel(PlotKind kind) {
    switch (kind) {
    case PlotKind::thetaH: return "θ_h (degrees)";
    case PlotKind::thetaD: return "θ_d (degrees)";
    case PlotKind::albedo: return "θ_o (degrees)";
    default: return "θ_v (degrees)";
    }
}

std::string titleOf(const CurveSettings& s) {
    switch (s.kind) {
    case PlotKind::thetaH:
        return s.thetaD.size() > 1 ? fmt::format("φd {:g}°", s.phiD)
                                   : fmt::format("θd {:g}°, φd {:g}°", s.thetaD[0], s.phiD);
    case PlotKind::thetaD:
        return s.thetaH.size() > 1 ? fmt::format("φd {:g}°", s.phiD)
                                   : fmt::format("θh {:g}°, φd {:g}°", s.thetaH[0], s.phiD);
    case PlotKind::albedo: return fmt::format("φo {:g}°", s.phiV);
    default: break;
    }
    const std::string angle = s.thetaI.size() > 1 ? "" : fmt::format("θi {:g}°, ", s.thetaI[0]);
    return angle + fmt::format("φi {:g}°, φv {:g}°", s.phiI.value_or(s.phiV + 180.0), s.phiV);
}

std::string plotCommand(const std::vector<Line>& lines) {
    std::string text = "plot ";
    for (std::size_t i = 0; i < lines.size(); ++i) {
        text += fmt::format("{}'curves' index {} using 1:2 with lines lw 2 {} title {}",
                            i == 0 ? "" : ", \\\n  ", i, lines[i].style,
                            gnuplotText(lines[i].title));
    }
    return text + "\n";
}

std::string cartesianScript(const CurveSettings& settings, const PlotLook& look,
                            const std::vector<Line>& lines, double largest) {
    const double low = lines[0].points.front().first;
    const double high = settings.kind == PlotKind::albedo ? 90 : lines[0].points.back().first;
    std::string text = fmt::format(
        "set xrange [{}:{}]\nset xtics {}\nset xlabel '{}'\nset ylabel '{}'\nset grid\n", low, high,
        high - low > 180 ? 45 : 15, xLabel(settings.kind), quantity(settings));
    text += look.logarithmic
                ? fmt::format("set logscale y\nset format y '%g'\nset yrange [{}:{}]\n",
                              kDecades * largest, 2 * largest)
                : fmt::format("set yrange [0:{}]\n", largest > 0 ? 1.05 * largest : 1);
    return text + plotCommand(lines);
}

// A round number from 1, 2 and 5, at most a fourth of the value.
double stepFor(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value / 4.0)));
    const double rest = value / 4.0 / power;
    return power * (rest >= 5.0 ? 5.0 : rest >= 2.0 ? 2.0 : 1.0);
}

// Angles from the normal, which points up, the viewer's side to the right.
std::string polarScript(const CurveSettings& settings, const PlotLook& look, double largest,
                        const std::vector<Line>& lines) {
    const bool whole = lines[0].points.back().first > 90;
    // gnuplot draws its outer circle at a mark, so the range ends at one.
    const double step = stepFor(largest > 0 ? largest : 1);
    const double r = step * std::ceil(1.001 * std::max(largest, step) / step);
    const double t = 1.12 * r;
    std::string text = fmt::format(
        "set polar\nset angles degrees\nset theta top cw\nset rrange [0:{0}]\nunset border\n"
        "unset xtics\nunset ytics\nset rtics {6} scale 0.5\nset grid polar 15\n"
        "set ttics ('0°' 0, '30°' 30, '60°' 60, '90°' 90, '120°' 120, '150°' 150, '±180°' 180, "
        "'-30°' 330, '-60°' 300, '-90°' 270, '-120°' 240, '-150°' 210)\n"
        "set xrange [{1}:{2}]\nset yrange [{3}:{2}]\nset size ratio -1\n"
        "set label '{4}{5}' at graph 0.5, graph -0.03 center\n",
        r, -t, t, whole ? -t : -0.12 * r, look.logarithmic ? "log10(1 + value), value: " : "",
        quantity(settings), step);
    for (const double thetaI : settings.thetaI) {
        const double angle = -thetaI * M_PI / 180.0;
        text += fmt::format("set arrow from {},{} to 0,0 lw 1.5 lc rgb '#808080'\n",
                            0.93 * r * std::sin(angle), 0.93 * r * std::cos(angle));
    }
    return text + plotCommand(lines);
}

std::string lobeData(const Lobe& lobe, const PlotLook& look) {
    std::string text;
    std::size_t i = 0;
    for (const double theta : lobe.theta) {
        for (const double phi : lobe.phi) {
            double r = channelOf(lobe.values[i++], look.channel);
            r = !std::isfinite(r) ? 0.0 : look.logarithmic ? std::log10(1.0 + r) : r;
            const glm::dvec3 p = r * spherical(theta * M_PI / 180.0, phi * M_PI / 180.0);
            text += fmt::format("{:.7g} {:.7g} {:.7g} {:.7g}\n", p.x, p.y, p.z, r);
        }
        text += "\n";
    }
    return text;
}

double largestOf(const Lobe& lobe, const PlotLook& look) {
    double largest = 0.0;
    for (std::size_t i = 0; i < lobe.values.size(); ++i) {
        const double r = channelOf(lobe.values[i], look.channel);
        const bool grazing = isGrazing(lobe.theta[i / lobe.phi.size()]);
        largest = std::isfinite(r) && !grazing ? std::max(largest, r) : largest;
    }
    return look.logarithmic ? std::log10(1.0 + largest) : largest;
}

std::string lobeScript(std::size_t index, const Lobe& lobe, const CurveSettings& settings,
                       double r, bool transmissive) {
    const glm::dvec3 light = 1.2 * r * spherical(lobe.thetaI * M_PI / 180.0,
                                                 settings.phiI.value_or(settings.phiV + 180.0) *
                                                     M_PI / 180.0);
    return fmt::format(
        "unset arrow\nset arrow from {},{},{} to 0,0,0 lw 2 lc rgb '#D55E00'\n"
        "set arrow from 0,0,0 to 0,0,{} lw 1 lc rgb '#404040'\n"
        "set xrange [{}:{}]\nset yrange [{}:{}]\nset zrange [{}:{}]\n"
        "set title {} noenhanced\n"
        "splot 'lobe{}' using 1:2:3:4 with pm3d notitle, \\\n"
        "  'circle' using ({}*cos($1)):({}*sin($1)):(0) with lines lw 1 lc rgb '#404040' notitle\n",
        light.x, light.y, light.z, 1.2 * r, -r, r, -r, r, transmissive ? -r : 0.0, 1.2 * r,
        gnuplotText(lobe.label), index, r, r);
}

void refuseNothing(double largest, bool logarithmic) {
    if (logarithmic && !(largest > 0)) {
        throw RunError("there is nothing above 0 to draw on a logarithmic axis");
    }
}

}  // namespace

double channelOf(const glm::dvec3& value, Channel channel) {
    switch (channel) {
    case Channel::red: return value.x;
    case Channel::green: return value.y;
    case Channel::blue: return value.z;
    default: break;
    }
    return metrics::luminance(glm::vec3(value));
}

GnuplotJob curvesJob(const std::vector<Curve>& curves, const CurveSettings& settings,
                     const PlotLook& look) {
    std::vector<Line> lines = linesOf(curves, look.channel);
    const bool polar = settings.kind == PlotKind::polar;
    for (Line& line : lines) {
        for (auto& [x, y] : line.points) {
            y = polar && look.logarithmic ? std::log10(1.0 + y) : y;
        }
    }
    const double largest = largestOf(lines, settings.kind);
    refuseNothing(largest, look.logarithmic);
    GnuplotJob job;
    job.width = look.width;
    job.height = look.height;
    job.script = fmt::format("set key outside bottom center horizontal reverse Left\n"
                             "set title {} noenhanced\n", gnuplotText(titleOf(settings)));
    job.script += polar ? polarScript(settings, look, largest, lines)
                        : cartesianScript(settings, look, lines, largest);
    std::string data;
    for (const Line& line : lines) {
        data += numbers(line.points);
    }
    job.files = {{"curves", data}};
    return job;
}

GnuplotJob lobesJob(const std::vector<Lobe>& lobes, const CurveSettings& settings,
                    const PlotLook& look) {
    const std::size_t columns = std::min<std::size_t>(lobes.size(), 3);
    const std::size_t rows = (lobes.size() + columns - 1) / columns;
    GnuplotJob job;
    job.width = look.width;
    job.height = look.height;
    job.script = fmt::format(
        "set multiplot layout {},{} title '{}{}'\nunset key\nset view equal xyz\n"
        "set view 62,330,1.2\nset ticslevel 0\n"
        "set pm3d depthorder noborder lighting primary 0.6 specular 0.1\nset palette defined "
        "(0 '#1B3A5C', 0.35 '#2C8C99', 0.7 '#A8D08D', 1 '#FFE066')\nunset colorbox\n"
        "set xlabel 'x'\nset ylabel 'y'\n",
        rows, columns, look.logarithmic ? "log10(1 + value), value: " : "", quantity(settings));
    std::string circle;
    for (int i = 0; i <= 72; ++i) {
        circle += fmt::format("{:.5f}\n", i * M_PI / 36.0);
    }
    job.files.push_back({"circle", circle});
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        const double largest = largestOf(lobes[i], look);
        refuseNothing(largest, look.logarithmic);
        job.script += lobeScript(i, lobes[i], settings, largest > 0 ? largest : 1,
                                 lobes[i].theta.back() > 90);
        job.files.push_back({fmt::format("lobe{}", i), lobeData(lobes[i], look)});
    }
    job.script += "unset multiplot\n";
    return job;
}

}  // namespace gp::tool
