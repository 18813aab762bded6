#include "scene/environment_table.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/gtc/packing.hpp>
#include <tbb/parallel_for.h>

#include "shading/shading.h"

namespace gp {
namespace {

// 512 x 512 cells are 2 MB. Of an image twice as wide as high, a cell is then half as wide as high
// on the sphere's equator.
constexpr uint32_t maxSide = 512;
constexpr uint32_t maxSkySide = 128;  // rebuilt between frames: 1 ms
constexpr double skyFloor = 0.25;     // light that may appear anywhere is found soon enough
constexpr double mostLight = 4;       // of a cell, over what its density says

// As the caller handed it in.
struct Pixels {
    const float* rgba;
    uint32_t width, height;
    size_t count() const { return size_t(width) * height; }
};

std::vector<float> luminanceOf(const Pixels& image) {
    std::vector<float> luminance(image.count());
    const float* p = image.rgba;
    for (size_t i = 0; i < luminance.size(); ++i, p += 4)
        luminance[i] = std::max(0.0f, shading::luminance(glm::vec3(p[0], p[1], p[2])));
    return luminance;
}

// [EXT_texture_shared_exponent, section 3.8.1, with glm's packing]
void packTexels(const Pixels& image, EnvironmentTable& table) {
    const float* p = image.rgba;
    const size_t n = image.count();
    float largest = 0;
    for (size_t i = 0; i < n; ++i)
        for (size_t c = 0; c < 3; ++c) largest = std::max(largest, p[4 * i + c]);
    constexpr float largestPacked = 65408;
    table.texelScale = largest > largestPacked ? largest / largestPacked : 1.0f;
    table.texels.resize(n);
    tbb::parallel_for(0u, image.height, [&](uint32_t y) {
        for (size_t i = size_t(y) * image.width, end = i + image.width; i < end; ++i)
            table.texels[i] = glm::packF3x9_E1x5(
                glm::max(glm::vec3(p[4 * i], p[4 * i + 1], p[4 * i + 2]), 0.0f) / table.texelScale);
    });
}

// Which pixels, out of n, bilinear reading brings into cell `c` of `side`; may run over both ends.
struct Span { int first, last; };
Span pixelsOf(uint32_t c, uint32_t side, uint32_t n) {
    const double lo = double(c) * n / side - 0.5, hi = double(c + 1) * n / side - 0.5;
    return {int(std::floor(lo)), int(std::ceil(hi))};
}

// The mean luminance of a cell's pixels times its share of the sphere.
std::vector<double> cellWeights(const Pixels& image, const std::vector<float>& luminance,
                                uint32_t side) {
    std::vector<double> weights(size_t(side) * side);
    const int w = int(image.width), h = int(image.height);
    tbb::parallel_for(0u, side, [&](uint32_t y) {
        const Span rows = pixelsOf(y, side, image.height);
        const double solidAngle = std::cos(M_PI * y / side) - std::cos(M_PI * (y + 1) / side);
        for (uint32_t x = 0; x < side; ++x) {
            const Span columns = pixelsOf(x, side, image.width);
            double sum = 0;
            for (int py = rows.first; py <= rows.last; ++py)
                for (int px = columns.first; px <= columns.last; ++px)
                    sum += double(luminance[size_t(std::clamp(py, 0, h - 1)) * size_t(w) +
                                            size_t((px + w) % w)]);
            const int count = (rows.last - rows.first + 1) * (columns.last - columns.first + 1);
            weights[shading::morton_from_cell({x, y})] = sum / count * solidAngle;
        }
    });
    return weights;
}

// To the nearest number with eight bits of mantissa; light never becomes none.
uint16_t upperHalf(float v) {
    return uint16_t((std::bit_cast<uint32_t>(v) + 0x8000u) >> 16);
}

// Rounds the weights to what `densities` can hold; returns their sum.
double roundWeights(std::vector<double>& weights, EnvironmentTable& table) {
    double largest = 0, sum = 0;
    for (double w : weights) largest = std::max(largest, w);
    table.densities.resize(weights.size());
    for (size_t i = 0; i < weights.size(); ++i) {
        table.densities[i] = upperHalf(float(weights[i] / largest));
        sum += weights[i] = double(wideFloat(table.densities[i]));
    }
    table.densityScale = float(double(weights.size()) / sum);
    return sum;
}

// [Vose 1991, "A Linear Algorithm for Generating Random Numbers with a Given Distribution"]
void makeAliases(const std::vector<double>& weights, double sum, EnvironmentTable& table) {
    const size_t n = weights.size();
    std::vector<double> scaled(n);
    std::vector<uint32_t> small, large;
    table.cells.resize(n);
    for (size_t i = 0; i < n; ++i) {
        scaled[i] = weights[i] / sum * double(n);
        table.cells[i] = {1.0f, uint32_t(i)};
        (scaled[i] < 1 ? small : large).push_back(uint32_t(i));
    }
    while (!small.empty() && !large.empty()) {
        const uint32_t s = small.back(), l = large.back();
        small.pop_back();
        table.cells[s].keep = float(scaled[s]);
        table.cells[s].alias = l;
        scaled[l] -= 1 - scaled[s];
        if (scaled[l] < 1) {
            large.pop_back();
            small.push_back(l);
        }
    }
}

// Means over the sphere.
void measure(const Pixels& image, const std::vector<float>& luminance, EnvironmentTable& table) {
    table.meanLuminance = 0, table.mean = glm::dvec3(0);
    table.rowMeans.resize(image.height);
    for (uint32_t y = 0; y < image.height; ++y) {
        double row = 0;
        glm::dvec3 rowColor(0);
        for (size_t i = size_t(y) * image.width, end = i + image.width; i < end; ++i) {
            const float* p = image.rgba + 4 * i;
            row += double(luminance[i]);
            rowColor += glm::dvec3(p[0], p[1], p[2]);
        }
        // The share of the sphere that a row of pixels covers.
        const double share =
            0.5 * (std::cos(M_PI * y / image.height) - std::cos(M_PI * (y + 1) / image.height));
        table.meanLuminance += row / image.width * share;
        table.mean += rowColor * (share / image.width);
        table.rowMeans[y] = glm::vec3(rowColor / double(image.width));
    }
}

// Adds `floor` times what each cell would weigh if the light came evenly from everywhere.
void raise(std::vector<double>& weights, uint32_t side, double floor) {
    double sum = 0;
    for (double w : weights) sum += w;
    for (uint32_t y = 0; y < side; ++y) {
        const double share =
            0.5 * (std::cos(M_PI * y / side) - std::cos(M_PI * (y + 1) / side)) / side;
        for (uint32_t x = 0; x < side; ++x)
            weights[shading::morton_from_cell({x, y})] += floor * sum * share;
    }
}

std::shared_ptr<EnvironmentTable> makeTable(const Pixels& image, uint32_t mostSide, double floor) {
    const std::vector<float> luminance = luminanceOf(image);
    auto table = std::make_shared<EnvironmentTable>();
    table->width = image.width, table->height = image.height;
    measure(image, luminance, *table);
    if (!(table->meanLuminance > 0)) return table;
    table->side = std::min(mostSide, std::bit_ceil(std::max(image.width, image.height)));
    std::vector<double> weights = cellWeights(image, luminance, table->side);
    if (floor > 0) raise(weights, table->side, floor);
    const double sum = roundWeights(weights, *table);
    makeAliases(weights, sum, *table);
    packTexels(image, *table);
    return table;
}

}  // namespace

glm::vec3 EnvironmentTable::radiance(uint32_t x, uint32_t y) const {
    if (black()) return glm::vec3(0);
    return glm::unpackF3x9_E1x5(texels[size_t(y) * width + x]) * texelScale;
}

std::shared_ptr<const EnvironmentTable> makeEnvironmentTable(const float* rgba, uint32_t width,
                                                             uint32_t height) {
    return makeTable({rgba, width, height}, maxSide, 0);
}

std::shared_ptr<EnvironmentTable> makeSkyTable(const float* rgba, uint32_t width,
                                               uint32_t height) {
    return makeTable({rgba, width, height}, maxSkySide, skyFloor);
}

bool refreshSkyTable(EnvironmentTable& table, const float* rgba) {
    if (table.black()) return false;
    const Pixels image{rgba, table.width, table.height};
    const std::vector<float> luminance = luminanceOf(image);
    std::vector<double> weights = cellWeights(image, luminance, table.side);
    double sum = 0;
    for (double w : weights) sum += w;
    for (size_t i = 0; i < weights.size(); ++i) {
        const double share = double(table.density(uint32_t(i))) / double(weights.size());
        if (!(weights[i] <= mostLight * share * sum)) return false;
    }
    if (!(sum > 0)) return false;
    measure(image, luminance, table);
    packTexels(image, table);
    return true;
}

}  // namespace gp
