// What tests of clear and calm water share: descriptions, Fresnel's term, the mean of a known
// function over a picture, and the sun on a floor below.
#pragma once

#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include "glitterpath/glitterpath.h"
#include "render/closed_forms.h"
#include "render/stage.h"

namespace gp::test {

constexpr double eta = 1.333;

inline GpOceanDesc calm() {
    GpOceanDesc desc{};
    // No light comes back from below.
    desc.given = GP_GIVEN_WIND | GP_GIVEN_ABSORPTION | GP_GIVEN_SCATTERING | GP_GIVEN_FOAM;
    desc.resolution = 64;
    return desc;
}

inline GpOceanDesc windy(float wind) {
    GpOceanDesc desc = calm();
    desc.wind = wind;
    return desc;
}

inline GpCameraDesc looking(double pitch, float height = 3, float fov = 0.25f) {
    GpCameraDesc camera{};
    camera.position[1] = height;
    camera.target[1] = height + float(std::sin(pitch));
    camera.target[2] = -float(std::cos(pitch));
    camera.verticalFov = fov;
    return camera;
}

// The cosine behind calm water's surface, seen from outside.
inline double refractedCosine(double cosine) {
    return std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
}

// [Born and Wolf 1999, section 1.5.2], unpolarised, from outside
inline double fresnel(double cosine) {
    const double inner = refractedCosine(cosine);
    const double s = (cosine - eta * inner) / (cosine + eta * inner);
    const double p = (eta * cosine - inner) / (eta * cosine + inner);
    return (s * s + p * p) / 2;
}

// From below: the same with the cosine outside, and 1 from the critical angle on.
inline double fresnelFromBelow(double cosine) {
    const double square = 1 - (1 - cosine * cosine) * eta * eta;
    return square > 0 ? fresnel(std::sqrt(square)) : 1;
}

// The mean of f(direction of the view) over the picture of looking(pitch, ..., fov).
template <class F>
double meanOverPicture(uint32_t width, uint32_t height, double fov, double pitch, const F& f) {
    double sum = 0;
    constexpr uint32_t fine = 4;  // points along each side of a pixel
    const double step = std::tan(fov / 2) / (height * fine / 2.0);
    for (uint32_t y = 0; y < height * fine; ++y)
        for (uint32_t x = 0; x < width * fine; ++x) {
            const double u = (x + 0.5 - width * fine / 2.0) * step;
            const double v = (height * fine / 2.0 - y - 0.5) * step;
            const glm::dvec3 w(u, std::sin(pitch) + v * std::cos(pitch),
                               v * std::sin(pitch) - std::cos(pitch));
            sum += f(glm::normalize(w));
        }
    return sum / (width * height * fine * fine);
}

inline GpOceanDesc clear(GpOceanDesc desc, glm::vec3 absorption, glm::vec3 scattering) {
    desc.transparent = 1;
    put(desc.absorption, absorption), put(desc.scattering, scattering);
    return desc;
}

inline void addFloor(Stage& stage, float depth, float albedo) {
    Triangles floor;
    floor.quad({-300, -depth, 300}, {600, 0, 0}, {0, 0, -600});
    stage.add(floor, stage.lambert(glm::vec3(albedo)));
}

inline void addSun(Stage& stage, double zenith, float irradiance, float radius) {
    GpLightDesc sun{};
    sun.kind = GP_LIGHT_DIRECTIONAL, sun.intensity = irradiance, sun.angularRadius = radius;
    put(sun.direction, {float(std::sin(zenith)), -float(std::cos(zenith)), 0});
    stage.light(sun);
}

// The share of light from all sides that enters calm water, and the mean of one over its cosine
// below; by numbers.
struct SkyBelow {
    double through = 0, stretch = 0;
};

inline SkyBelow whiteSkyBelow() {
    constexpr int steps = 20000;
    SkyBelow sky;
    for (int i = 0; i < steps; ++i) {
        const double c = (i + 0.5) / steps, share = 2 * c * (1 - fresnel(c)) / steps;
        sky.through += share, sky.stretch += share / refractedCosine(c);
    }
    sky.stretch /= sky.through;
    return sky;
}

// What calm water scatters along a ray that goes down by the cosine `down`, from some depth on; by
// Simpson's rule.
struct WaterColumn {
    double loss, radiance, stretch;

    double gathered(double depth, double down, double length) const {
        constexpr int steps = 200;
        double sum = 0;
        for (int i = 0; i <= steps; ++i) {
            const double s = length * i / steps;
            const double source = loss * (1 + stretch * std::max(down, 0.0));
            sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * source *
                   std::exp(-stretch * loss * (depth + down * s) - loss * s);
        }
        return radiance * sum * length / (3 * steps);
    }
};

// Of what enters deep water, the share that leaves: of the irradiance that goes up, which is
// 0.33 b / (a + b) of what goes down, the surface sends a part back, again and again.
inline double leavingShare(double absorption, double scattering) {
    const double ratio = 0.33 * scattering / (absorption + scattering);
    const double out = whiteSkyBelow().through / (eta * eta);
    double sum = 0, down = 1;
    for (int i = 0; i < 60; ++i) {
        sum += down * ratio * out;
        down *= ratio * (1 - out);
    }
    return sum;
}

// `entering`: irradiance below the surface, of what came through it.
inline WaterColumn waterColumn(double absorption, double scattering, double entering,
                               double stretch) {
    const double returned = leavingShare(absorption, scattering) * entering;
    return {absorption + scattering, returned * eta * eta / (pi * whiteSkyBelow().through),
            stretch};
}

inline WaterColumn underWhiteSky(double absorption, double scattering) {
    const SkyBelow sky = whiteSkyBelow();
    return waterColumn(absorption, scattering, pi * sky.through, sky.stretch);
}

inline WaterColumn underSun(double absorption, double scattering, double zenith,
                            double irradiance) {
    const double c = std::cos(zenith);
    return waterColumn(absorption, scattering, irradiance * c * (1 - fresnel(c)),
                       1 / refractedCosine(c));
}

// Of a matte floor that calm water covers: what arrives is what the surface lets through, less
// what the water takes on its way; of what the floor sends up the surface returns a part.
struct CalmFloor {
    double depth, albedo, zenith, irradiance;

    // The share of what leaves the floor that comes back to it.
    double returned(double loss) const {
        constexpr int steps = 20000;
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
            const double c = (i + 0.5) / steps;
            sum += 2 * c * fresnelFromBelow(c) * std::exp(-2 * loss * depth / c) / steps;
        }
        return sum;
    }
    // The irradiance of the floor.
    double arrives(double loss) const {
        const double sun = std::cos(zenith), down = refractedCosine(sun);
        const double first =
            irradiance * sun * (1 - fresnel(sun)) * std::exp(-loss * depth / down);
        return first / (1 - albedo * returned(loss));
    }
    // Seen from above the water under a cosine.
    double radiance(double cosine, double loss) const {
        return albedo / pi * arrives(loss) *
               std::exp(-loss * depth / refractedCosine(cosine)) * (1 - fresnel(cosine)) /
               (eta * eta);
    }
};

}  // namespace gp::test
