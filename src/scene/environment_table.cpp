#include "scene/environment_table.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "shading/shading.h"

namespace gp {
namespace {

std::vector<float> luminanceOf(const Image& image) {
    std::vector<float> luminance(size_t(image.width) * image.height);
    const float* p = image.floats();
    for (size_t i = 0; i < luminance.size(); ++i, p += 4)
        luminance[i] = std::max(0.0f, shading::luminance(glm::vec3(p[0], p[1], p[2])));
    return luminance;
}

// Turns weights into a cumulative distribution of n + 1 values; returns their sum.
double makeCdf(const double* weights, uint32_t n, float* cdf) {
    double sum = 0;
    for (uint32_t i = 0; i < n; ++i) sum += weights[i];
    double running = 0;
    cdf[0] = 0;
    for (uint32_t i = 0; i < n; ++i) {
        running += weights[i];
        cdf[i + 1] = sum > 0 ? float(running / sum) : float(i + 1) / float(n);
    }
    cdf[n] = 1;
    return sum;
}

// guide[i] is the last cell whose cumulative value is not above i / n.
void makeGuide(const float* cdf, uint32_t n, uint16_t* guide) {
    uint32_t cell = 0;
    for (uint32_t i = 0; i < n; ++i) {
        while (cell + 1 < n && cdf[cell + 1] <= float(i) / float(n)) ++cell;
        guide[i] = uint16_t(cell);
    }
}

}  // namespace

EnvironmentTable makeEnvironmentTable(const Image& image) {
    const uint32_t w = image.width, h = image.height;
    const std::vector<float> luminance = luminanceOf(image);
    EnvironmentTable table;
    table.rowCdf.resize(h + 1);
    table.columnCdf.resize(size_t(h) * (w + 1));
    table.rowGuide.resize(h);
    table.columnGuide.resize(size_t(h) * w);
    std::vector<double> rowWeights(h), rowLuminance(h);
    tbb::parallel_for(0u, h, [&](uint32_t y) {
        std::vector<double> weights(w);
        double sum = 0;
        for (uint32_t x = 0; x < w; ++x) {
            float largest = 0;
            for (uint32_t dy = 0; dy < 3; ++dy) {
                const uint32_t ny = uint32_t(std::clamp(int(y + dy) - 1, 0, int(h) - 1));
                for (uint32_t dx = 0; dx < 3; ++dx)
                    largest = std::max(largest, luminance[size_t(ny) * w + (x + w + dx - 1) % w]);
            }
            weights[x] = largest;
            sum += luminance[size_t(y) * w + x];
        }
        // The solid angle of a row's cells: the difference of cosines at its edges.
        const double solidAngle = std::cos(M_PI * y / h) - std::cos(M_PI * (y + 1) / h);
        float* cdf = &table.columnCdf[size_t(y) * (w + 1)];
        rowWeights[y] = makeCdf(weights.data(), w, cdf) * solidAngle;
        rowLuminance[y] = sum / w * solidAngle / 2;
        makeGuide(cdf, w, &table.columnGuide[size_t(y) * w]);
    });
    const double sum = makeCdf(rowWeights.data(), h, table.rowCdf.data());
    makeGuide(table.rowCdf.data(), h, table.rowGuide.data());
    if (!(sum > 0)) return {};
    for (double l : rowLuminance) table.meanLuminance += l;
    table.width = w;
    table.height = h;
    return table;
}

}  // namespace gp
