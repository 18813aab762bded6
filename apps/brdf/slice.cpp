// glitterpath brdf slice: f over half and difference angles as pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "brdf/brdf.h"
#include "brdf/directions.h"
#include "brdf/models.h"
#include "csv.h"
#include "gnuplot.h"
#include "metrics/color.h"
#include "output.h"
#include "parse.h"
#include "picture_grid.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kNotes =
    "A picture a model: theta_h (the half vector's angle) to the right, theta_d (the light's\n"
    "angle to it) upwards, both 0 to 90 degrees. The highlight is on the left, the Fresnel\n"
    "reflection above, the light that comes back to its source below. Colours are f times\n"
    "2^exposure, clipped at 1. Below the horizon there is a grey check; what is not finite is\n"
    "magenta.\n\n"
    "--difference: the luminance of the first model minus that of the second, blue to red, with a\n"
    "scale that ends where all but one in twenty differences are, or at 2^-exposure where\n"
    "--exposure is given.\n\n"
    "Examples:\n"
    "  glitterpath brdf slice lambert oren_nayar disney -o slices.png\n"
    "  glitterpath brdf slice ward:form=ward ward:form=duer --difference -o difference.png\n"
    "  glitterpath brdf slice disney --set metallic=1 roughness=0.3 --square-theta-h \\\n"
    "      --exposure -1 -o metal.png";

struct SliceSettings {
    ModelOptions models;
    std::string outputPath, csvPath;
    double phiD = 90, phiH = 0, exposureEv = 0;
    bool exposureGiven = false, chroma = false, squareThetaH = false, difference = false;
    unsigned size = 256;
};

// The centres of the pixels, top row first.
class SliceGrid {
public:
    explicit SliceGrid(const SliceSettings& settings) : m_settings(settings) {}

    std::size_t count() const { return std::size_t{m_settings.size} * m_settings.size; }
    double thetaH(std::size_t i) const {
        const double t = (static_cast<double>(i % m_settings.size) + 0.5) / m_settings.size;
        return 90.0 * (m_settings.squareThetaH ? t * t : t);
    }
    double thetaD(std::size_t i) const {
        const std::size_t row = m_settings.size - 1 - i / m_settings.size;
        return 90.0 * (static_cast<double>(row) + 0.5) / m_settings.size;
    }
    DirectionPair pair(std::size_t i) const {
        constexpr double degree = M_PI / 180.0;
        return fromHalfAndDifference(thetaH(i) * degree, m_settings.phiH * degree,
                                     thetaD(i) * degree, m_settings.phiD * degree);
    }
    bool valid(std::size_t i) const { return pair(i).aboveHorizon(); }

private:
    const SliceSettings& m_settings;
};

std::vector<glm::vec3> valuesOf(GpDevice device, const Model& model, const SliceGrid& grid) {
    std::vector<glm::vec3> wi, wo, result;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const DirectionPair pair = grid.pair(i);
        wi.emplace_back(pair.wi);
        wo.emplace_back(pair.wo);
    }
    for (const GpBsdfValue& value : evaluate(device, model.bsdf, wi, wo)) {
        result.emplace_back(value.f[0], value.f[1], value.f[2]);
    }
    return result;
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Rgb8 outside(std::size_t i, unsigned size) {
    const bool dark = ((i % size) / 8 + (i / size) / 8) % 2 == 0;
    return dark ? Rgb8{150, 150, 150} : Rgb8{190, 190, 190};
}

constexpr Rgb8 kNotFinite = {255, 0, 255};

// Blue, white, red. [Harrower, Brewer 2003, RdBu]
glm::vec3 diverging(double t) {
    const glm::vec3 blue(0.129f, 0.4f, 0.675f), white(0.969f), red(0.698f, 0.094f, 0.169f);
    const auto s = static_cast<float>(std::abs(t));
    return glm::mix(white, t < 0 ? blue : red, glm::min(s, 1.0f));
}

GridPicture pictureOf(const std::string& title, const SliceSettings& settings) {
    GridPicture picture;
    picture.title = title;
    picture.width = picture.height = settings.size;
    return picture;
}

GridPicture slicePicture(const std::string& title, const std::vector<glm::vec3>& values,
                         const SliceGrid& grid, const SliceSettings& settings) {
    GridPicture picture = pictureOf(title, settings);
    const auto scale = static_cast<float>(std::exp2(settings.exposureEv));
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!grid.valid(i)) {
            picture.pixels.push_back(outside(i, settings.size));
            continue;
        }
        if (!isFinite(values[i])) {
            picture.pixels.push_back(kNotFinite);
            continue;
        }
        glm::vec3 shown = values[i] * scale;
        if (settings.chroma) {
            const float largest = std::max({values[i].x, values[i].y, values[i].z});
            shown = largest > 0.0f ? values[i] / largest : glm::vec3(0.0f);
        }
        const glm::vec3 linear = glm::clamp(shown, 0.0f, 1.0f);
        picture.pixels.push_back(rgb8FromSrgb(metrics::srgbFromLinear(linear)));
    }
    return picture;
}

// Highlights and the horizon are so bright that everything else would show no difference: the scale
// ends where all but one in twenty are.
double rangeOf(const std::vector<double>& differences, const SliceSettings& settings) {
    if (settings.exposureGiven) {
        return std::exp2(-settings.exposureEv);
    }
    std::vector<double> sizes;
    for (const double d : differences) {
        if (std::isfinite(d) && d != 0.0) {
            sizes.push_back(std::abs(d));
        }
    }
    if (sizes.empty()) {
        return 1.0;  // two that are the same
    }
    const auto end = sizes.begin() + static_cast<std::ptrdiff_t>(0.95 * double(sizes.size() - 1));
    std::nth_element(sizes.begin(), end, sizes.end());
    return *end;
}

void addDifference(PictureGrid& sheet, const std::vector<std::vector<glm::vec3>>& values,
                   const SliceGrid& grid, const SliceSettings& settings) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const double d = static_cast<double>(metrics::luminance(values[0][i])) -
                         static_cast<double>(metrics::luminance(values[1][i]));
        differences.push_back(grid.valid(i) ? d : 0.0);
    }
    const double range = rangeOf(differences, settings);
    GridPicture picture = pictureOf("first minus second", settings);
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const double d = differences[i];
        picture.pixels.push_back(!grid.valid(i)      ? outside(i, settings.size)
                                 : std::isfinite(d) ? rgb8FromSrgb(diverging(d / range))
                                                    : kNotFinite);
    }
    sheet.pictures.push_back(std::move(picture));
    ColorBar bar;
    bar.label = "difference of luminance (1/sr)";
    bar.minimum = -range;
    bar.maximum = range;
    for (int i = 0; i < 255; ++i) {
        bar.colors.push_back(rgb8FromSrgb(diverging(i / 127.0 - 1.0)));
    }
    sheet.bar = bar;
}

void noteNotFinite(const Model& model, const std::vector<glm::vec3>& values,
                   const SliceGrid& grid) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        count += grid.valid(i) && !isFinite(values[i]) ? 1 : 0;
    }
    if (count > 0) {
        fmt::print(stderr, "glitterpath: note: {}: {} values are not finite\n", model.label, count);
    }
}

std::string csvOf(const std::vector<Model>& models,
                  const std::vector<std::vector<glm::vec3>>& values, const SliceGrid& grid) {
    std::string text = csvLine({"model", "theta_h", "theta_d", "f_r", "f_g", "f_b"});
    for (std::size_t m = 0; m < models.size(); ++m) {
        for (std::size_t i = 0; i < grid.count(); ++i) {
            if (grid.valid(i)) {
                const glm::vec3 f = values[m][i];
                text += csvLine({models[m].label, fmt::format("{:.7g}", grid.thetaH(i)),
                                 fmt::format("{:.7g}", grid.thetaD(i)), fmt::format("{}", f.x),
                                 fmt::format("{}", f.y), fmt::format("{}", f.z)});
            }
        }
    }
    return text;
}

PictureGrid sheetOf(const SliceSettings& settings) {
    PictureGrid sheet;
    sheet.title = fmt::format("φd {:g}°, φh {:g}°", settings.phiD, settings.phiH);
    sheet.axes = PictureAxes{"θ_h (degrees)", "θ_d (degrees)", 0, 90, 0, 90, 30};
    if (settings.squareThetaH) {
        *sheet.axes = PictureAxes{"square root of θ_h / 90 degrees", "θ_d (degrees)", 0, 1, 0, 90,
                                  0};
    }
    return sheet;
}

int runSlice(const SliceSettings& settings) {
    checkDrawable(settings.outputPath);
    if (!settings.csvPath.empty()) {
        checkWritable(settings.csvPath);
    }
    if (settings.difference && settings.models.words.size() != 2) {
        throw UsageError(fmt::format("--difference: takes two models, not {}",
                                     settings.models.words.size()));
    }
    if (settings.chroma && settings.exposureGiven && !settings.difference) {
        throw UsageError("--chroma: shows no brightness, so --exposure means nothing");
    }
    const Device device = newModelDevice();
    const std::vector<Model> models = newModels(device.get(), settings.models);
    const SliceGrid grid(settings);
    PictureGrid sheet = sheetOf(settings);
    std::vector<std::vector<glm::vec3>> values;
    for (const Model& model : models) {
        values.push_back(valuesOf(device.get(), model, grid));
        noteNotFinite(model, values.back(), grid);
        sheet.pictures.push_back(slicePicture(model.label, values.back(), grid, settings));
    }
    if (settings.difference) {
        addDifference(sheet, values, grid, settings);
    }
    sheet.columns = static_cast<unsigned>(std::min<std::size_t>(sheet.pictures.size(), 4));
    drawPictureGrid(sheet, settings.outputPath);
    if (!settings.csvPath.empty()) {
        writeText(settings.csvPath, csvOf(models, values, grid));
    }
    return kExitSuccess;
}

}  // namespace

Command addBrdfSlice(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("slice", "Draw models over half and difference angles");
    const auto settings = std::make_shared<SliceSettings>();
    SliceSettings& s = *settings;
    addModelOptions(*app, s.models);
    addWord(*app, "-o,--output", "FILE", "The picture, .png or .svg",
            [&s](const std::string& word) { s.outputPath = word; })
        ->required();
    addWord(*app, "--csv", "FILE", "The numbers as a table; - is stdout",
            [&s](const std::string& word) { s.csvPath = word; });
    addWord(*app, "--phi-d", "DEG", "Azimuth of the difference; 90",
            [&s](const std::string& word) { s.phiD = parseNumber("--phi-d", word, -360, 360); });
    addWord(*app, "--phi-h", "DEG", "Azimuth of the half vector from the tangent; 0",
            [&s](const std::string& word) { s.phiH = parseNumber("--phi-h", word, -360, 360); });
    addWord(*app, "--exposure", "EV", "Brighter by this many stops; 0", [&s](const std::string& w) {
        s.exposureEv = parseNumber("--exposure", w, -40, 40);
        s.exposureGiven = true;
    });
    app->add_flag("--chroma", s.chroma, "Colours divided by their largest channel");
    app->add_flag("--square-theta-h", s.squareThetaH, "More room for small half angles");
    app->add_flag("--difference", s.difference, "Two models and their difference");
    addWord(*app, "--size", "N", "Pixels of a side of a slice; 256", [&s](const std::string& word) {
        s.size = static_cast<unsigned>(parseInteger("--size", word, 16, 2048));
    });
    app->footer(std::string(kModelSyntax) + "\n\n" + kNotes);
    return {app, [settings] { return runSlice(*settings); }};
}

}  // namespace gp::tool
