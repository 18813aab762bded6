// glitterpath brdf sphere: models as lit spheres, side by side.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "brdf/brdf.h"
#include "brdf/spheres.h"
#include "gnuplot.h"
#include "output.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr const char* kExamples =
    "The picture is a labelled .png or .svg, or an .exr with the radiances of all spheres in a row.\n\n"
    "Examples:\n"
    "  glitterpath brdf sphere lambert oren_nayar disney:metallic=1,roughness=0.3 -o spheres.png\n"
    "  glitterpath brdf sphere ward:alpha_x=0.3,alpha_y=0.05 --light 40,30 -o lit.png\n"
    "  glitterpath brdf sphere ggx_conductor kulla_conty --env studio.hdr --samples 512 -o e.png";

struct Settings {
    ModelOptions models;
    SphereSettings spheres;
    std::string outputPath;
};

bool isExr(const std::string& path) {
    return path.ends_with(".exr");
}

void saveRadiance(GpDevice device, const std::vector<SpherePicture>& spheres,
                  const std::string& path) {
    const unsigned size = spheres.front().size;
    std::vector<float> rgba;
    for (unsigned y = 0; y < size; ++y) {
        for (const SpherePicture& sphere : spheres) {
            const auto row = sphere.rgba.begin() + std::ptrdiff_t{4} * size * y;
            rgba.insert(rgba.end(), row, row + std::ptrdiff_t{4} * size);
        }
    }
    GpImage image{};
    image.width = size * static_cast<unsigned>(spheres.size());
    image.height = size;
    image.pixels = rgba.data();
    check(device, gpSaveImage(device, path.c_str(), &image));
}

int runSphere(const Settings& settings) {
    if (isExr(settings.outputPath)) {
        checkWritable(settings.outputPath);
        if (settings.spheres.exposureEv) {
            throw UsageError("--exposure: an .exr holds radiance");
        }
    } else {
        checkDrawable(settings.outputPath);
    }
    const Device device = newSphereDevice();
    const std::vector<Model> models = newModels(device.get(), settings.models);
    std::vector<GpBsdf> handles;
    for (const Model& model : models) {
        handles.push_back(model.bsdf.get());
    }
    const std::vector<SpherePicture> spheres =
        renderSpheres(device.get(), handles, settings.spheres);
    if (spheres.empty()) {
        fmt::print(stderr, "glitterpath: interrupted: nothing saved\n");
        return kExitInterrupted;
    }
    if (isExr(settings.outputPath)) {
        saveRadiance(device.get(), spheres, settings.outputPath);
        return kExitSuccess;
    }
    PictureGrid sheet;
    sheet.pictures = displayed(spheres, settings.spheres);
    for (std::size_t i = 0; i < models.size(); ++i) {
        sheet.pictures[i].title = models[i].label;
    }
    sheet.columns = static_cast<unsigned>(std::min<std::size_t>(models.size(), 6));
    drawPictureGrid(sheet, settings.outputPath);
    return kExitSuccess;
}

}  // namespace

Command addBrdfSphere(CLI::App& brdf) {
    CLI::App* app = brdf.add_subcommand("sphere", "Draw models as lit spheres");
    const auto settings = std::make_shared<Settings>();
    addModelOptions(*app, settings->models);
    addSphereOptions(*app, settings->spheres);
    addWord(*app, "-o,--output", "FILE", "The picture, .png, .svg or .exr",
            [settings](const std::string& word) { settings->outputPath = word; })
        ->required();
    app->footer(fmt::format("{}\n\n{}\n\n{}", kModelSyntax, kSphereNotes, kExamples));
    return {app, [settings] { return runSphere(*settings); }};
}

}  // namespace gp::tool
