// Is a sampling routine what its density says? Generic chi-square tests with one adapter a domain.
//
//   chi2Rectangle(options, lo, hi, sample, pdf)   sample(Random&) -> glm::vec2, pdf(glm::vec2)
//   chi2Sphere(options, domain, sample, pdf)      sample(Random&) -> glm::vec3, pdf(glm::vec3)
//
// pdf is per unit area or per steradian. A sample may fail: a 2D point then is NaN, a direction is
// the zero vector; the density integrates to the share of the others (result.pdfIntegral against
// result.acceptedFraction). EXPECT_TRUE(result.passed) << result.message is the whole assertion.
//
// The sphere's grid suits itself to the lobe, else a lobe of 1e-4 rad would fill one cell and the
// test could not fail: its pole is the densest of a few thousand pilot samples, its rings are their
// quantiles. In s = 1 - cos(angle to the pole) and phi the area is ds dphi.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "chi2/pearson.h"
#include "chi2/quadrature.h"

namespace gp {

constexpr int chi2Rings = 25;    // odd numbers: no cell edge lies on an axis of symmetry
constexpr int chi2Sectors = 37;
constexpr int chi2Columns = 31;  // of the rectangle, both ways

// For each x the values of y at which the density jumps, as on the edge of a disk.
using RectangleBreaks = std::function<std::vector<double>(double x)>;

template <class Sample, class Pdf>
Chi2Result chi2Rectangle(const Chi2Options& options, glm::dvec2 lo, glm::dvec2 hi, Sample sample,
                         Pdf pdf, const RectangleBreaks& breaks = {}) {
    Chi2Table table;
    table.observed.assign(chi2Columns * chi2Columns + 1, 0.0);
    table.expected.assign(table.observed.size(), 0.0);
    const glm::dvec2 step = (hi - lo) / static_cast<double>(chi2Columns);
    Random random(options.seed);
    std::size_t accepted = 0;
    for (std::size_t i = 0; i < options.samples; ++i) {
        const glm::dvec2 cell = (glm::dvec2(sample(random)) - lo) / step;
        // The comparison is false for the NaN of a failed sample as well as outside.
        const bool inside = cell.x >= 0.0 && cell.y >= 0.0 && cell.x <= chi2Columns
                         && cell.y <= chi2Columns;
        const auto index = [](double v) { return std::min(static_cast<int>(v), chi2Columns - 1); };
        const int where = inside ? index(cell.x) * chi2Columns + index(cell.y)
                                 : chi2Columns * chi2Columns;
        table.observed[static_cast<std::size_t>(where)] += 1.0;
        accepted += inside ? 1u : 0u;
    }
    double total = 0.0;
    const double n = static_cast<double>(options.samples);
    const QuadratureTolerance tolerance{3e-4, 1e-9};
    for (int i = 0; i < chi2Columns * chi2Columns; ++i) {
        const glm::dvec2 from = lo + step * glm::dvec2(i / chi2Columns, i % chi2Columns);
        const double probability = integrate([&](double x) {
            const auto column = [&](double y) { return double(pdf(glm::vec2(glm::dvec2(x, y)))); };
            return integratePieces(column, from.y, from.y + step.y,
                                   breaks ? breaks(x) : std::vector<double>(), tolerance, 8);
        }, from.x, from.x + step.x, tolerance, 8);
        table.expected[static_cast<std::size_t>(i)] = n * probability;
        total += probability;
    }
    table.expected.back() = n * std::max(0.0, 1.0 - total);
    Chi2Result result = chi2Test(options, table);
    result.pdfIntegral = total;
    result.acceptedFraction = static_cast<double>(accepted) / n;
    return result;
}

struct SphereDomain {
    // 0: all directions; +1 or -1: those with z of that sign, the others are one more cell. Two
    // lobes on two sides are tested one at a time, as the grid can follow only one.
    int hemisphere = 0;
    // Normals of planes through the origin on which the density jumps (z = 0 is always one).
    std::vector<glm::dvec3> edges;
};

class SphereGrid {
public:
    // `pole` is unit length; `distances` are 1 - cos of the pilot samples' angles to it.
    SphereGrid(glm::dvec3 pole, std::vector<double> distances, const SphereDomain& domain)
        : pole_(pole), hemisphere_(domain.hemisphere) {
        const bool alongX = std::abs(pole.x) > 0.6;
        const glm::dvec3 helper(alongX ? 0 : 1, alongX ? 1 : 0, 0);
        tangent_ = glm::normalize(glm::cross(helper, pole));
        bitangent_ = glm::cross(pole, tangent_);
        edges_.insert(edges_.end(), domain.edges.begin(), domain.edges.end());
        std::sort(distances.begin(), distances.end());
        rings_.push_back(0.0);
        for (int i = 1; i < chi2Rings; ++i) {
            const double at = distances[distances.size() * static_cast<std::size_t>(i) / chi2Rings];
            // Pilot samples that coincide would make a ring without area.
            if (at > rings_.back() * (1.0 + 1e-6) + 1e-14) rings_.push_back(at);
        }
        rings_.push_back(2.0);
    }

    std::size_t cellCount() const { return (rings_.size() - 1) * chi2Sectors; }

    // From the difference of the unit vectors, as 1 - dot has no digits left near the pole.
    static double distance(glm::dvec3 a, glm::dvec3 b) { return 0.5 * glm::dot(a - b, a - b); }

    std::size_t cellOf(glm::dvec3 w) const {
        const double s = distance(w, pole_);
        const auto above = std::upper_bound(rings_.begin() + 1, rings_.end() - 1, s);
        const auto ring = above - rings_.begin();
        const double phi = std::atan2(glm::dot(w, bitangent_), glm::dot(w, tangent_));
        const double turn = (phi < 0.0 ? phi + 2.0 * M_PI : phi) / (2.0 * M_PI);
        const int sector = std::min(static_cast<int>(turn * chi2Sectors), chi2Sectors - 1);
        return static_cast<std::size_t>(ring - 1) * chi2Sectors + static_cast<std::size_t>(sector);
    }

    template <class Pdf>
    double cellProbability(std::size_t cell, const Pdf& pdf) const {
        const std::size_t ring = cell / chi2Sectors;
        const double phi0 = 2.0 * M_PI * static_cast<double>(cell % chi2Sectors) / chi2Sectors;
        const double phi1 = phi0 + 2.0 * M_PI / chi2Sectors;
        const double s0 = rings_[ring], s1 = rings_[ring + 1];
        const QuadratureTolerance outer{3e-4, 1e-9};
        const QuadratureTolerance inner{1e-4, 1e-9 / (s1 - s0)};
        return integratePieces([&](double s) {
            const double r = std::sqrt(s * (2.0 - s));
            return integratePieces([&](double phi) {
                const glm::dvec3 w = pole_ * (1.0 - s)
                    + (tangent_ * std::cos(phi) + bitangent_ * std::sin(phi)) * r;
                return contains(w) ? static_cast<double>(pdf(glm::vec3(w))) : 0.0;
            }, phi0, phi1, sectorBreaks(s), inner, 8);
        }, s0, s1, ringBreaks(s0, s1), outer, 8);
    }

    bool contains(glm::dvec3 w) const {
        return hemisphere_ == 0 || (hemisphere_ > 0) == (w.z > 0.0);
    }

private:
    // Where the circle at s crosses the planes: n.w = a + r cos(phi - phi1) = 0.
    std::vector<double> sectorBreaks(double s) const {
        std::vector<double> breaks;
        for (const glm::dvec3& n : edges_) {
            const double x = glm::dot(n, tangent_), y = glm::dot(n, bitangent_);
            const double a = glm::dot(n, pole_) * (1.0 - s);
            const double r = std::hypot(x, y) * std::sqrt(s * (2.0 - s));
            if (std::abs(a) >= r) continue;
            for (const double side : {-1.0, 1.0}) {
                const double phi = std::atan2(y, x) + side * std::acos(-a / r);
                breaks.push_back(phi - 2.0 * M_PI * std::floor(phi / (2.0 * M_PI)));
            }
        }
        return breaks;
    }

    // Where the circles begin and cease to cross them: the inner integral has a kink there.
    // The last ring reaches from the lobe's edge to the far side of the sphere; in steps of a
    // factor the tail that starts at its near end cannot fall between the points of the rule.
    std::vector<double> ringBreaks(double s0, double s1) const {
        std::vector<double> breaks;
        for (double s = 4.0 * s0; s0 > 0.0 && s < s1; s *= 4.0) breaks.push_back(s);
        for (const glm::dvec3& n : edges_) {
            const double angle = std::asin(std::min(1.0, std::abs(glm::dot(n, pole_))));
            breaks.push_back(1.0 - std::cos(angle));
            breaks.push_back(1.0 + std::cos(angle));
        }
        return breaks;
    }

    glm::dvec3 pole_, tangent_, bitangent_;
    int hemisphere_;
    std::vector<glm::dvec3> edges_{glm::dvec3(0, 0, 1)};
    std::vector<double> rings_;
};

template <class Sample, class Pdf>
SphereGrid pilotGrid(const Chi2Options& options, const SphereDomain& domain, Sample& sample,
                     Pdf& pdf) {
    Random random(options.seed + 0x5EEDull);
    std::vector<glm::dvec3> pilot;
    glm::dvec3 pole(0, 0, domain.hemisphere < 0 ? -1 : 1);
    double densest = -1.0;
    for (int i = 0; i < 40'000 && pilot.size() < 8'000; ++i) {
        const glm::dvec3 w(sample(random));
        if (!(glm::dot(w, w) > 0.5)) continue;
        if (domain.hemisphere != 0 && (domain.hemisphere > 0) != (w.z > 0.0)) continue;
        pilot.push_back(w);
        const double density = static_cast<double>(pdf(glm::vec3(w)));
        if (density > densest) {
            densest = density;
            pole = glm::normalize(w);
        }
    }
    std::vector<double> distances;
    for (const glm::dvec3& w : pilot) distances.push_back(SphereGrid::distance(w, pole));
    // A lobe that is never sampled still gets a grid: uniform in area.
    for (int i = 0; pilot.size() < 100 && i < 1000; ++i) distances.push_back(i / 500.0);
    return SphereGrid(pole, distances, domain);
}

template <class Sample, class Pdf>
Chi2Result chi2Sphere(const Chi2Options& options, const SphereDomain& domain, Sample sample,
                      Pdf pdf) {
    const SphereGrid grid = pilotGrid(options, domain, sample, pdf);
    Chi2Table table;
    table.observed.assign(grid.cellCount() + 1, 0.0);
    table.expected.assign(grid.cellCount() + 1, 0.0);
    Random random(options.seed);
    for (std::size_t i = 0; i < options.samples; ++i) {
        const glm::dvec3 w(sample(random));
        const bool inside = glm::dot(w, w) > 0.5 && grid.contains(w);
        table.observed[inside ? grid.cellOf(w) : grid.cellCount()] += 1.0;
    }
    const double n = static_cast<double>(options.samples);
    double total = 0.0;
    for (std::size_t i = 0; i < grid.cellCount(); ++i) {
        const double probability = grid.cellProbability(i, pdf);
        table.expected[i] = n * probability;
        total += probability;
    }
    table.expected.back() = n * std::max(0.0, 1.0 - total);
    Chi2Result result = chi2Test(options, table);
    result.pdfIntegral = total;
    result.acceptedFraction = 1.0 - table.observed.back() / n;
    return result;
}

}  // namespace gp
