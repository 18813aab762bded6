#include "picture_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "gnuplot.h"

namespace gp::tool {
namespace {

// In pixels, for a font of 11 points.
constexpr unsigned kGap = 14, kLine = 18, kLetter = 8, kMostTitleLines = 4;
constexpr unsigned kAxisLeft = 62, kAxisBelow = 62, kBarWidth = 18, kBarText = 90;

// Broken after commas, colons and spaces, else anywhere; what does not fit ends in dots.
std::vector<std::string> linesOf(const std::string& text, unsigned pixels) {
    const std::size_t most = std::max<std::size_t>(pixels / kLetter, 4);
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size();) {
        std::size_t length = std::min(most, text.size() - from);
        if (from + length < text.size()) {
            const std::size_t at = text.find_last_of(",: ", from + length - 1);
            if (at != std::string::npos && at > from) {
                length = at + 1 - from;
            }
        }
        lines.push_back(text.substr(from, length));
        from += length;
        if (lines.size() == kMostTitleLines && from < text.size()) {
            lines.back().replace(lines.back().size() - std::min<std::size_t>(length, 3), 3, "...");
            break;
        }
    }
    return lines;
}

struct Box {
    double x, y, width, height;  // pixels of the sheet; y is the upper edge
};

class Sheet {
public:
    explicit Sheet(const PictureGrid& grid) : m_grid(grid) { lay(); }

    GnuplotJob job() {
        GnuplotJob job;
        job.width = m_width;
        job.height = m_height;
        m_job = &job;
        job.script = "set multiplot\nunset key\nset tics out nomirror\n";
        if (!m_grid.title.empty()) {
            label(m_grid.title, 0.5 * m_width, kGap + 0.5 * kLine, "center");
        }
        for (std::size_t i = 0; i < m_grid.rowTitles.size(); ++i) {
            const Box box = boxOf(i * m_grid.columns);
            label(m_grid.rowTitles[i], kGap, box.y + 0.5 * m_cellHeight, "left");
        }
        for (std::size_t i = 0; i < m_grid.pictures.size(); ++i) {
            if (!m_grid.pictures[i].pixels.empty()) {
                picture(i);
            }
        }
        if (m_grid.bar) {
            colorBar(*m_grid.bar);
        }
        job.script += "unset multiplot\n";
        return job;
    }

private:
    void lay() {
        for (const GridPicture& p : m_grid.pictures) {
            if (p.pixels.size() != std::size_t{p.width} * p.height) {
                throw std::logic_error("a picture of a grid has not as many pixels as it says");
            }
            m_cellWidth = std::max(m_cellWidth, p.width);
            m_cellHeight = std::max(m_cellHeight, p.height);
        }
        for (const std::string& title : m_grid.rowTitles) {
            m_left = std::max(m_left, kGap + kLetter * static_cast<unsigned>(title.size()));
        }
        m_height = kGap / 2 + (m_grid.title.empty() ? 0 : kLine + kGap / 2);
        for (std::size_t i = 0; i < m_grid.pictures.size(); i += m_grid.columns) {
            layRow(i);
        }
        m_height += kGap;
        m_width = m_left + m_grid.columns * stepX() + kGap +
                  (m_grid.bar ? kBarWidth + kBarText : 0);
    }

    // Titles may have several lines; their row then is higher.
    void layRow(std::size_t first) {
        std::size_t lines = 0;
        for (std::size_t i = first;
             i < std::min(first + m_grid.columns, m_grid.pictures.size()); ++i) {
            lines = std::max(lines, linesOf(m_grid.pictures[i].title, m_cellWidth).size());
        }
        m_height += kGap / 2 + static_cast<unsigned>(lines) * kLine;
        m_rowTops.push_back(m_height);
        m_height += m_cellHeight + (m_grid.axes ? kAxisBelow : 0);
    }

    unsigned stepX() const { return kGap + (m_grid.axes ? kAxisLeft : 0) + m_cellWidth; }

    Box boxOf(std::size_t index) const {
        const auto column = static_cast<unsigned>(index % m_grid.columns);
        const unsigned x = m_left + (column + 1) * stepX() - m_cellWidth;
        Box box{double(x), double(m_rowTops[index / m_grid.columns]), double(m_cellWidth),
                double(m_cellHeight)};
        if (index < m_grid.pictures.size() && !m_grid.pictures[index].pixels.empty()) {
            box.width = m_grid.pictures[index].width;
            box.height = m_grid.pictures[index].height;
        }
        return box;
    }

    void label(const std::string& text, double x, double y, const char* where) {
        m_job->script += fmt::format("set label {} at screen {:.6f},{:.6f} {} noenhanced\n",
                                     gnuplotText(text), x / m_width, 1.0 - y / m_height, where);
    }

    void margins(const Box& box) {
        m_job->script += fmt::format(
            "set lmargin at screen {:.8f}\nset rmargin at screen {:.8f}\n"
            "set tmargin at screen {:.8f}\nset bmargin at screen {:.8f}\n",
            box.x / m_width, (box.x + box.width) / m_width, 1.0 - box.y / m_height,
            1.0 - (box.y + box.height) / m_height);
    }

    // Pixels as a file, and the words that plot it over the given ranges.
    std::string image(const std::vector<Rgb8>& pixels, unsigned width, unsigned height,
                      const PictureAxes& axes) {
        GnuplotFile file;
        file.name = fmt::format("{}.rgb", m_job->files.size());
        for (const Rgb8& p : pixels) {
            file.bytes.append({static_cast<char>(p[0]), static_cast<char>(p[1]),
                               static_cast<char>(p[2])});
        }
        m_job->files.push_back(file);
        const double dx = (axes.xMaximum - axes.xMinimum) / width;
        const double dy = (axes.yMaximum - axes.yMinimum) / height;
        return fmt::format("'{}' binary array=({},{}) flipy format='%uchar' dx={} dy={} "
                           "origin=({},{}) with rgbimage",
                           file.name, width, height, dx, dy, axes.xMinimum + 0.5 * dx,
                           axes.yMinimum + 0.5 * dy);
    }

    void picture(std::size_t index) {
        const GridPicture& p = m_grid.pictures[index];
        const Box box = boxOf(index);
        const std::vector<std::string> title = linesOf(p.title, m_cellWidth);
        for (std::size_t i = 0; i < title.size(); ++i) {
            const double below = static_cast<double>(title.size() - i) - 0.5;
            label(title[i], box.x + 0.5 * box.width, box.y - 2 - kLine * below, "center");
        }
        const PictureAxes axes = m_grid.axes.value_or(PictureAxes{});
        margins(box);
        m_job->script += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", axes.xMinimum,
                                     axes.xMaximum, axes.yMinimum, axes.yMaximum);
        if (m_grid.axes) {
            const std::string step = axes.step > 0 ? fmt::format("{}", axes.step) : "autofreq";
            m_job->script += fmt::format("set border\nset xtics {0}\nset ytics {0}\n"
                                         "set xlabel {1}\nset ylabel {2}\n",
                                         step, gnuplotText(axes.xLabel), gnuplotText(axes.yLabel));
        } else {
            m_job->script += "unset border\nunset tics\n";
        }
        m_job->script += "plot " + image(p.pixels, p.width, p.height, axes) + "\nunset label\n";
    }

    // Beside the first row, its marks on the right.
    void colorBar(const ColorBar& bar) {
        PictureAxes axes;
        axes.yMinimum = bar.minimum;
        axes.yMaximum = bar.maximum;
        std::vector<Rgb8> pixels;  // two columns, as gnuplot draws none of one
        for (auto color = bar.colors.rbegin(); color != bar.colors.rend(); ++color) {
            pixels.insert(pixels.end(), 2, *color);
        }
        const Box first = boxOf(0);
        margins({double(m_width - kBarText - kBarWidth), first.y, double(kBarWidth),
                 double(m_cellHeight)});
        m_job->script += fmt::format(
            "unset tics\nunset xlabel\nunset ylabel\nset border\nset xrange [0:1]\n"
            "set yrange [{0}:{1}]\nset y2range [{0}:{1}]\nset y2tics\nset y2label {2}\nplot {3}\n",
            bar.minimum, bar.maximum, gnuplotText(bar.label),
            image(pixels, 2, static_cast<unsigned>(bar.colors.size()), axes));
    }

    const PictureGrid& m_grid;
    GnuplotJob* m_job = nullptr;
    unsigned m_cellWidth = 0, m_cellHeight = 0, m_left = 0, m_width = 0, m_height = 0;
    std::vector<unsigned> m_rowTops;  // of the pictures, below their titles
};

}  // namespace

Rgb8 rgb8FromSrgb(const glm::vec3& srgb) {
    const glm::vec3 v = glm::clamp(srgb, 0.0f, 1.0f) * 255.0f + 0.5f;
    return {static_cast<unsigned char>(v.x), static_cast<unsigned char>(v.y),
            static_cast<unsigned char>(v.z)};
}

void drawPictureGrid(const PictureGrid& grid, const std::string& path) {
    drawWithGnuplot(Sheet(grid).job(), path);
}

}  // namespace gp::tool
