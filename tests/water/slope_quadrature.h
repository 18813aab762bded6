// Integrals over slopes, for tests of what is written over distributions of them.
//
//   overSlopes(about, f)        int f(s) ds over the plane, about a Gaussian's ellipse
//   meanOverSlopes(d, f)        int f(s) P22(s) ds of a Gaussian d
//
// The plane is a grid of the ellipse's own axes with equal weights, which is as good as exact for
// what falls off as a Gaussian (or is zero outside). It is turned against the axes, as kinks along
// a row would cost the square of the step, and shifted, so that a slope and its pair about the mean
// are never both on it: what holds by pairs has to hold by integration.
#pragma once

#include <cmath>

#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/slope/slopes.glsl"
GP_SHADING_END

namespace gp::test {

struct SlopeGrid {
    int steps = 500;        // along each axis
    double extent = 7.0;    // standard deviations to each side
};

template <class F>
double overSlopes(const gp::shading::Slopes& about, const F& f, SlopeGrid grid = {}) {
    const double lxx = std::sqrt(double(about.var_x));
    const double lxy = double(about.cov) / lxx;
    const double lyy = std::sqrt(double(about.var_y) - lxy * lxy);
    const double step = 2.0 * grid.extent / grid.steps;
    double sum = 0.0;
    for (int i = 0; i < grid.steps; ++i) {
        const double u = (i + 0.37) * step - grid.extent;
        for (int j = 0; j < grid.steps; ++j) {
            const double v = (j + 0.59) * step - grid.extent;
            const double x = 0.8253356 * u - 0.5646425 * v;  // 0.6 radians
            const double y = 0.5646425 * u + 0.8253356 * v;
            sum += double(f(glm::vec2(glm::dvec2(double(about.mean.x) + lxx * x,
                                                 double(about.mean.y) + lxy * x + lyy * y))));
        }
    }
    return sum * step * step * lxx * lyy;
}

template <class F>
double meanOverSlopes(const gp::shading::Slopes& d, const F& f, SlopeGrid grid = {}) {
    return overSlopes(d, [&](glm::vec2 s) {
        return double(gp::shading::slopes_p22(d, s)) * double(f(s));
    }, grid);
}

inline gp::shading::Slopes slopesOf(float meanX, float meanY, float sigmaX, float sigmaY,
                                    float rho) {
    gp::shading::Slopes d;
    d.mean = glm::vec2(meanX, meanY);
    d.var_x = sigmaX * sigmaX;
    d.var_y = sigmaY * sigmaY;
    d.cov = rho * sigmaX * sigmaY;
    return d;
}

// Degrees: from the geometry's normal, and the azimuth from +X.
inline glm::vec3 directionAt(double theta, double phi) {
    const double t = theta * M_PI / 180.0, p = phi * M_PI / 180.0;
    return glm::vec3(glm::dvec3(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p),
                                std::cos(t)));
}

}  // namespace gp::test
