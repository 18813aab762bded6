// glitterpath compare: how far apart two pictures are.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "commands.h"
#include "library.h"
#include "metrics/color.h"
#include "metrics/compare_pictures.h"
#include "metrics/magma.h"
#include "metrics/pixel_errors.h"
#include "output.h"
#include "parse.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;
using metrics::Comparison;
using metrics::Picture;
using metrics::PictureKind;

constexpr const char* kNotes =
    "rmse and relmse are of linear values, over all pixels and R, G, B; relmse is the mean of\n"
    "(A - B)^2 / (B^2 + 0.01). psnr (dB) and ssim are of sRGB-encoded values. flip is LDR-FLIP\n"
    "for PNG and JPEG, HDR-FLIP for EXR and HDR (67 pixels a degree), of which psnr and ssim then\n"
    "use the middle exposure and the tone map. Alpha is not looked at.\n\n"
    "Examples:\n"
    "  glitterpath compare test.png reference.png\n"
    "  glitterpath compare test.exr reference.exr --json - --heatmap flip.png\n"
    "  glitterpath compare test.exr reference.exr --threshold flip=0.05 --threshold psnr=35";

struct Threshold {
    std::string metric;
    double limit = 0;
};

struct CompareSettings {
    std::string testPath, referencePath, jsonPath, heatmapPath;
    std::vector<std::string> thresholdWords;
};

// Both kinds of metrics: those that grow with the difference, and those that fall.
bool largerIsBetter(const std::string& metric) {
    return metric == "psnr" || metric == "ssim";
}

double valueOf(const Comparison& c, const std::string& metric) {
    if (metric == "rmse") return c.rmse;
    if (metric == "relmse") return c.relmse;
    if (metric == "psnr") return c.psnr;
    if (metric == "ssim") return c.ssim;
    return c.flip;
}

std::vector<Threshold> parseThresholds(const std::vector<std::string>& words) {
    const std::vector<std::string> metrics = {"rmse", "relmse", "psnr", "ssim", "flip"};
    std::vector<Threshold> thresholds;
    for (const std::string& word : words) {
        const auto [metric, value] = parseAssignment("--threshold", word);
        if (std::find(metrics.begin(), metrics.end(), metric) == metrics.end()) {
            failChoice("--threshold", metric, metrics);
        }
        thresholds.push_back({metric, parseNumber("--threshold", value)});
    }
    return thresholds;
}

Picture pictureOf(const GpImage& image, const std::string& path) {
    Picture picture(static_cast<int>(image.width), static_cast<int>(image.height));
    std::size_t bad = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const float* p = image.pixels + 4 * i;
        picture.pixels[i] = glm::vec3(p[0], p[1], p[2]);
        bad += std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) ? 0u : 1u;
    }
    if (bad > 0) {
        throw RunError(fmt::format("{}: {} pixels are infinite or not a number", path, bad));
    }
    return picture;
}

Comparison compareFiles(GpDevice device, const CompareSettings& s) {
    const LoadedImage test(device, s.testPath);
    const LoadedImage reference(device, s.referencePath);
    const GpImage& a = test.get();
    const GpImage& b = reference.get();
    if (a.width != b.width || a.height != b.height) {
        throw RunError(fmt::format("the sizes differ: {} is {}x{}, {} is {}x{}", s.testPath,
                                   a.width, a.height, s.referencePath, b.width, b.height));
    }
    const bool bothDisplay = a.displayReferred != 0 && b.displayReferred != 0;
    if (!bothDisplay && (a.displayReferred != 0 || b.displayReferred != 0)) {
        fmt::print(stderr, "glitterpath: one picture is for display and one is radiance: both are "
                           "taken for radiance\n");
    }
    return metrics::comparePictures(pictureOf(a, s.testPath), pictureOf(b, s.referencePath),
                                    bothDisplay ? PictureKind::display : PictureKind::scene);
}

Json channels(glm::dvec3 mean) {
    return Json::array({mean.x, mean.y, mean.z});
}

Json comparisonJson(const Comparison& c, const CompareSettings& s) {
    const bool hdr = c.kind == PictureKind::scene;
    Json json;
    json["a"] = s.testPath;
    json["b"] = s.referencePath;
    json["width"] = c.flipMap.width;
    json["height"] = c.flipMap.height;
    json["identical"] = c.identical;
    json["rmse"] = c.rmse;
    json["relmse"] = c.relmse;
    json["relmse_epsilon"] = metrics::kRelativeMseEpsilon;
    json["psnr"] = std::isfinite(c.psnr) ? Json(c.psnr) : Json(nullptr);  // JSON has no infinity
    json["ssim"] = c.ssim;
    json["flip"] = c.flip;
    json["flip_kind"] = hdr ? "hdr" : "ldr";
    if (hdr) {
        json["flip_exposures"] = {{"start", c.exposures.start},
                                  {"stop", c.exposures.stop},
                                  {"count", c.exposures.count}};
    }
    json["mean_a"] = channels(c.meanTest);
    json["mean_b"] = channels(c.meanReference);
    return json;
}

std::string comparisonText(const Comparison& c) {
    const char* const rgb = "{:<8} {:.6g} {:.6g} {:.6g}\n";
    std::string text = fmt::format("{:<8} {:.6g}\n", "rmse", c.rmse);
    text += fmt::format("{:<8} {:.6g}\n", "relmse", c.relmse);
    text += fmt::format("{:<8} {:.4f} dB\n", "psnr", c.psnr);
    text += fmt::format("{:<8} {:.6f}\n", "ssim", c.ssim);
    text += fmt::format("{:<8} {:.6f} ({})\n", "flip", c.flip,
                        c.kind == PictureKind::scene ? "HDR-FLIP" : "LDR-FLIP");
    text += fmt::format(fmt::runtime(rgb), "mean A", c.meanTest.x, c.meanTest.y, c.meanTest.z);
    text += fmt::format(fmt::runtime(rgb), "mean B", c.meanReference.x, c.meanReference.y,
                        c.meanReference.z);
    return text + (c.identical ? "the pictures are identical\n" : "");
}

void saveHeatmap(GpDevice device, const metrics::Plane& map, const std::string& path) {
    std::vector<float> pixels;
    pixels.reserve(4 * map.pixels.size());
    for (float error : map.pixels) {
        // The library encodes PNG itself, so it is given linear values.
        const glm::vec3 color = metrics::linearFromSrgb(metrics::magmaSrgb(error));
        pixels.insert(pixels.end(), {color.x, color.y, color.z, 1.0f});
    }
    GpImage image{};
    image.width = static_cast<std::uint32_t>(map.width);
    image.height = static_cast<std::uint32_t>(map.height);
    image.pixels = pixels.data();
    check(device, gpSaveImage(device, path.c_str(), &image));
}

int applyThresholds(const Comparison& c, const std::vector<Threshold>& thresholds) {
    int exitCode = kExitSuccess;
    for (const Threshold& t : thresholds) {
        const double value = valueOf(c, t.metric);
        const bool holds = largerIsBetter(t.metric) ? value >= t.limit : value <= t.limit;
        if (!holds) {
            fmt::print(stderr, "glitterpath: {} is {:.6g}: {} {:.6g}\n", t.metric, value,
                       largerIsBetter(t.metric) ? "less than" : "more than", t.limit);
            exitCode = kExitFailure;
        }
    }
    return exitCode;
}

void checkHeatmapPath(const std::string& path) {
    if (!path.ends_with(".png") && !path.ends_with(".PNG")) {
        throw UsageError(fmt::format("--heatmap: '{}' does not end in .png", path));
    }
    checkWritable(path);
}

int runCompare(const CompareSettings& s) {
    const std::vector<Threshold> thresholds = parseThresholds(s.thresholdWords);
    if (!s.heatmapPath.empty()) {
        checkHeatmapPath(s.heatmapPath);
    }
    if (!s.jsonPath.empty()) {
        checkWritable(s.jsonPath);
    }
    GpDeviceDesc desc{};
    desc.backend = GP_BACKEND_NULL;  // files are read without a renderer
    const Device device = newDevice(desc);
    const Comparison comparison = compareFiles(device.get(), s);
    if (!s.heatmapPath.empty()) {
        saveHeatmap(device.get(), comparison.flipMap, s.heatmapPath);
    }
    if (!s.jsonPath.empty()) {
        writeJson(s.jsonPath, comparisonJson(comparison, s));
    }
    if (s.jsonPath != "-") {
        writeText("-", comparisonText(comparison));
    }
    return applyThresholds(comparison, thresholds);
}

}  // namespace

Command addCompareCommand(CLI::App& tool) {
    CLI::App* app = tool.add_subcommand("compare", "Measure how far picture A is from reference B");
    const auto settings = std::make_shared<CompareSettings>();
    app->add_option("A", settings->testPath, "The picture in question: PNG, JPEG, HDR or EXR")
        ->required();
    app->add_option("B", settings->referencePath, "The reference, of the same size")->required();
    addWord(*app, "--json", "FILE", "Write the numbers as JSON; - is stdout",
            [settings](const std::string& word) { settings->jsonPath = word; });
    addWord(*app, "--heatmap", "OUT.png", "Write FLIP's map: black where alike, yellow where not",
            [settings](const std::string& word) { settings->heatmapPath = word; });
    app->add_option("--threshold", settings->thresholdWords,
                    "Exit with 1 if rmse, relmse or flip is more, or psnr or ssim less,\n"
                    "than this; may be repeated")
        ->type_name("METRIC=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app->footer(kNotes);
    return {app, [settings] { return runCompare(*settings); }};
}

}  // namespace gp::tool
