// The sea: waves of a measured spectrum on a few periodic grids (cascades), by inverse FFT.
// Based on: Tessendorf 2001, "Simulating Ocean Water", SIGGRAPH course notes; Horvath 2015,
// "Empirical Directional Wave Spectra for Computer Graphics", DigiPro; Dupuy and Bruneton 2012,
// "Real-time Animation and Rendering of Ocean Whitecaps", SIGGRAPH Asia technical briefs. What is
// ours: energy of a grid's coarse waves by quadrature, slope moments weighted by area, and foam
// that is a function of time alone.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "ocean/ocean_settings.h"

namespace gp {

// Area of a displaced surface, seen from above, over that at rest; below 0 it folds over. Given:
// derivatives of the horizontal displacement, dDx/dx, dDy/dy, dDx/dy (= dDy/dx).
constexpr float oceanJacobian(float xx, float yy, float xy) {
    return (1.0f + xx) * (1.0f + yy) - xy * xy;
}

// A point of one cascade, or the sum of all. Derivatives are by undisplaced x and y.
struct OceanPoint {
    glm::vec3 displacement{0.0f};   // m: horizontal (choppiness is in it), and height
    float foam = 0.0f;              // 0..1
    glm::vec2 gradient{0.0f};       // of the height
    glm::vec3 stretch{0.0f};        // of the displacement: dDx/dx, dDy/dy, dDx/dy (= dDy/dx)

    float jacobian() const { return oceanJacobian(stretch.x, stretch.y, stretch.z); }
    // Slope of the displaced surface: s with J^T s = gradient. The Jacobian counts as at least
    // oceanLeastJacobian: beyond, the surface is vertical or folds over.
    glm::vec2 slope() const;
};

// Where the surface is squeezed to less, its slope is bounded.
constexpr float oceanLeastJacobian = 0.1f;

// Slopes of the displaced surface over a footprint, weighted by its horizontal area.
struct OceanSlopes {
    glm::vec2 mean{0.0f};
    float varX = 0.0f;  // variances about the mean, at least 0
    float varY = 0.0f;
    float cov = 0.0f;   // cov^2 <= varX varY
    float foam = 0.0f;  // mean over the footprint, 0..1
};

// Second moments of slopes, of a part of the spectrum.
struct OceanMoments {
    float xx = 0.0f;
    float yy = 0.0f;
    float xy = 0.0f;
};

// A named image of one cascade, for other programs: rows from the largest y down, x to the right.
struct OceanMap {
    std::string name;  // "displacement_0", "normal_0", "foam_0", "moments_0", … "_1" …
    uint32_t size = 0;
    uint32_t channels = 0;
    std::vector<float> texels;  // size * size * channels
};

// One sea at one time. Reading is thread-safe; setTime must not run beside reading. A moved-from
// Ocean may only be destroyed or assigned to.
class Ocean {
public:
    // Settings must be without fault. Computes the spectrum (some 10 ms) and time 0.
    explicit Ocean(const OceanSettings& settings);
    ~Ocean();
    Ocean(Ocean&&) noexcept;
    Ocean& operator=(Ocean&&) noexcept;

    // Everything below as it is at that time, -1e9..1e9: the same bits however time got there and
    // on any number of threads. Runs on TBB's threads. A step ahead is cheap; a leap also computes
    // the moments that foam remembers, up to 16 of them.
    void setTime(double seconds);
    double time() const;
    const OceanSettings& settings() const;

    // Sum of all cascades at (x, y) of the surface at rest, m; bilinear between grid points.
    OceanPoint at(glm::vec2 rest) const;
    // The displacement alone, which is cheaper.
    glm::vec3 displacement(glm::vec2 rest) const;

    // Slopes over a footprint at (x, y) of the surface at rest: a parallelogram of sides d0 and d1,
    // m, about it. Of what the grids resolve; tail() has the rest. Any footprint is allowed: a
    // point has no variance, one of kilometres that of the whole sea.
    OceanSlopes slopes(glm::vec2 rest, glm::vec2 d0, glm::vec2 d1) const;

    // Moments of all waves of wave numbers above k (rad/m), from the spectrum alone, up to
    // oceanTailEnd; any k at least 0. Displacement by choppiness is not in it.
    OceanMoments momentsAbove(float k) const;
    // Of the waves too short for the finest grid: the roughness of the water between its points.
    OceanMoments tail() const;
    // Variance of the height, m^2, of all waves of wave numbers above k.
    float varianceAbove(float k) const;
    // Four times the standard deviation of the height, m: the significant wave height.
    float significantHeight() const;

    // Wave numbers of cascade i: from first to end, rad/m; the next begins where this one ends.
    struct Band {
        float first;
        float end;
    };
    Band band(uint32_t cascade) const;
    // Point (ix, iy) of the grid of a cascade, at (ix, iy) length / size m; indices wrap around.
    OceanPoint gridPoint(uint32_t cascade, int ix, int iy) const;

    // Displacement, normal, foam and moments of every cascade, as they are now.
    std::vector<OceanMap> maps() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// Where spectra end, rad/m: waves of 6 mm, below which viscosity leaves nothing.
constexpr float oceanTailEnd = 1000.0f;

}  // namespace gp
