// The page of an evaluation: one file, with its plots and pictures inside.
#include <fmt/format.h>

#include "animate/evaluation_report.h"
#include "gnuplot.h"
#include "library.h"
#include "metrics/color.h"
#include "metrics/magma.h"
#include "temporary_folder.h"

namespace gp::tool {
namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 sans-serif;max-width:1000px;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}td,th{padding:.3em .8em;text-align:right;"
    "border-bottom:1px solid #ccc}td:first-child,th:first-child{text-align:left}"
    "figure{display:inline-block;margin:.5em 1em .5em 0}figcaption{font-size:13px}"
    "img{max-width:100%}.wide{display:block}";

// [RFC 4648, section 4]
std::string base64(const std::string& bytes) {
    constexpr const char* digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool there = i + k < bytes.size();
            bits = bits << 8 | (there ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63u];
        }
    }
    return text;
}

// Names of files and variants may hold anything.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += c;
        }
    }
    return result;
}

std::string figure(const std::string& type, const std::string& bytes, const std::string& caption) {
    return fmt::format("<figure><img alt=\"{0}\" src=\"data:image/{1};base64,{2}\">"
                       "<figcaption>{0}</figcaption></figure>\n", escaped(caption), type,
                       base64(bytes));
}

struct Plot {
    const char* title;
    const std::vector<double> VariantResult::*values;
    std::uint32_t first;  // the frame of the first value
    bool squares;         // whose roots are shown
};

// A line for each variant, frames to the right.
std::string plotFigure(const TemporaryFolder& folder, const Evaluation& e, const Plot& plot) {
    GnuplotJob job;
    job.width = 480;
    job.height = 300;
    job.script = fmt::format("set title {}\nset xlabel 'frame'\nset key outside bottom center\n"
                             "set grid\nplot ", gnuplotText(plot.title));
    for (std::size_t v = 0; v < e.variants.size(); ++v) {
        const std::string file = fmt::format("data{}", v);
        std::string data;
        const std::vector<double>& all = e.variants[v].*plot.values;
        const std::vector<double> values = plot.squares ? rootsOf(all) : all;
        for (std::size_t i = 0; i < values.size(); ++i) {
            data += fmt::format("{} {}\n", plot.first + i, values[i]);
        }
        job.script += fmt::format("{}'{}' with linespoints pt 7 ps 0.3 title {}",
                                  v == 0 ? "" : ", ", file, gnuplotText(e.variants[v].name));
        job.files.push_back({file, data});
    }
    job.script += "\n";
    drawWithGnuplot(job, folder("plot.svg"));
    return figure("svg+xml", bytesOfFile(folder("plot.svg")), plot.title);
}

// An sRGB-encoded picture as a PNG file.
std::string pictureFigure(GpDevice device, const TemporaryFolder& folder,
                          const metrics::Picture& picture, const std::string& caption) {
    std::vector<float> rgba;
    for (const glm::vec3& p : picture.pixels) {
        const glm::vec3 linear = metrics::linearFromSrgb(p);
        rgba.insert(rgba.end(), {linear.r, linear.g, linear.b, 1.0f});
    }
    GpImage image{};
    image.width = static_cast<std::uint32_t>(picture.width);
    image.height = static_cast<std::uint32_t>(picture.height);
    image.pixels = rgba.data();
    check(device, gpSaveImage(device, folder("picture.png").c_str(), &image));
    return figure("png", bytesOfFile(folder("picture.png")), caption);
}

metrics::Picture heatmap(const metrics::Plane& flip) {
    metrics::Picture picture(flip.width, flip.height);
    for (std::size_t i = 0; i < flip.pixels.size(); ++i) {
        picture.pixels[i] = metrics::magmaSrgb(flip.pixels[i]);
    }
    return picture;
}

std::string table(const Evaluation& e, const EvaluateSettings& s) {
    std::string html = "<table><tr><th></th><th>ms a frame</th><th>RMSE</th><th>SSIM</th>"
                       "<th>FLIP</th><th>flicker</th>";
    html += s.lamp ? "<th>lag, frames</th></tr>\n" : "</tr>\n";
    const nlohmann::ordered_json json = evaluationJson(e, s);
    for (const auto& v : json["variants"]) {
        html += fmt::format("<tr><td>{}</td><td>{:.2f}</td><td>{:.4f}</td><td>{:.4f}</td>"
                            "<td>{:.4f}</td><td>{:.4f}</td>",
                            escaped(v["name"].get<std::string>()), v["milliseconds"].get<double>(),
                            v["rmse"].get<double>(), v["ssim"].get<double>(),
                            v["flip"].get<double>(), v["flicker"].get<double>());
        if (s.lamp) {
            const auto& lag = v["lag_frames"];
            html += fmt::format("<td>{}</td>", lag.is_null() ? "more than there were"
                                                             : lag.dump());
        }
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

}  // namespace

std::string evaluationHtml(GpDevice device, const Evaluation& e, const EvaluateSettings& s) {
    const RenderSettings& r = s.motion.render;
    const TemporaryFolder folder;
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>{0}</title>"
        "<style>{1}</style>\n<h1>{0}</h1>\n<p>{2} frames of {3}x{4}, {5} a second; reference of "
        "{6} samples a pixel; exposure {7:+.2f} EV; {8}. Means leave out the first {9} frames."
        "</p>\n",
        escaped(r.scenePath), kStyle, s.motion.frames, r.size.width, r.size.height,
        s.motion.framesPerSecond, r.options.samplesPerPixel, e.exposureEv, escaped(e.device),
        s.skip);
    html += table(e, s);
    html += "<p>Pictures are compared as they are shown. RMSE is of linear values, SSIM and "
            "flicker of sRGB-encoded luma. Flicker: root mean square of how errors change along "
            "the motion of what is seen. References are two pictures of half of the samples, so "
            "that their noise averages out of all but FLIP.";
    if (s.lamp) {
        html += fmt::format(" Lag: frames after the lamp went out (frame {}) until less than "
                            "{:.0f} % of its light are left.", s.lamp->offFrame,
                            100 * EvaluateSettings::lagLimit);
    }
    html += "</p>\n";
    std::vector<Plot> plots = {{"SSIM", &VariantResult::ssim, 0, false},
                               {"FLIP", &VariantResult::flip, 0, false},
                               {"RMSE", &VariantResult::mse, 0, true},
                               {"flicker", &VariantResult::squaredFlicker, 1, true}};
    if (s.lamp) {
        plots.push_back({"afterglow", &VariantResult::afterglow, s.lamp->offFrame, false});
    }
    for (const Plot& plot : plots) {
        html += plotFigure(folder, e, plot);
    }
    html += "<h2>The last frame</h2>\n" +
            pictureFigure(device, folder, e.lastReference, "reference") + "<br>\n";
    for (const VariantResult& v : e.variants) {
        html += pictureFigure(device, folder, v.lastPicture, v.name);
        html += pictureFigure(device, folder, heatmap(v.lastFlip), v.name + ": FLIP") + "<br>\n";
    }
    return html + "</html>\n";
}

}  // namespace gp::tool
