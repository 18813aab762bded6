#include "shading/shading.h"

#include "scene/water_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gp {
namespace {

constexpr double pi = std::numbers::pi;

// Below the surface, of light that came down through it.
class Downwelling {
public:
    explicit Downwelling(float ior) : ior_(ior) {}

    // Irradiance on a level surface above, from directions of this cosine with the vertical.
    void add(float cosine, glm::dvec3 irradiance) {
        const float below = shading::fresnel_g(cosine, ior_) / ior_;
        const glm::dvec3 through =
            irradiance * double(shading::fresnel_transmittance(cosine, below, ior_));
        const double weight = double(shading::luminance(glm::vec3(through)));
        irradiance_ += through;
        weights_ += weight, ways_ += weight / double(below);
    }

    glm::dvec3 irradiance() const { return irradiance_; }
    // The mean of one over the cosine below.
    double stretch() const { return weights_ > 0 ? ways_ / weights_ : 1; }

private:
    float ior_;
    glm::dvec3 irradiance_{0};
    double weights_ = 0, ways_ = 0;
};

// Rows of few pixels are cut finer, as the surface lets through less the lower the light is.
void addSky(Downwelling& light, const SkyRows& sky) {
    constexpr uint32_t fine = 256;
    const uint32_t rows = sky.means ? sky.count : 1;
    const uint32_t parts = (fine + rows - 1) / rows;
    const uint32_t count = rows * parts;
    for (uint32_t i = 0; 2 * i < count; ++i) {
        // Down to the horizon, which may be amid a row.
        const double upper = std::cos(pi * i / count);
        const double lower = std::max(std::cos(pi * (i + 1) / count), 0.0);
        const glm::dvec3 radiance(sky.color * (sky.means ? sky.means[i / parts] : glm::vec3(1)));
        light.add(float((upper + lower) / 2), radiance * (pi * (upper * upper - lower * lower)));
    }
}

// Of light from all sides above.
double surfaceTransmittance(float ior) {
    Downwelling furnace(ior);
    addSky(furnace, {});
    return furnace.irradiance().y / pi;
}

}  // namespace

// Below the surface the irradiance upwards is `ratio` times that downwards, for a high sun. [Morel
// and Prieur 1977, "Analysis of variations in ocean color", Limnology and Oceanography 22(4),
// equation 2] Of what goes up the share `out` leaves, and the rest comes down again beside what
// enters. [Austin 1974, "The Remote Sensing of Spectral Radiance from below the Ocean Surface"]
glm::vec3 seaReflectance(const SeaSettings& sea) {
    const double out = surfaceTransmittance(sea.ior) / (double(sea.ior) * double(sea.ior));
    glm::vec3 share(0);
    for (int c = 0; c < 3; ++c) {
        const double all = double(sea.absorption[c]) + double(sea.backscattering[c]);
        // With next to no absorption b over a has no bound; over the sum it stays below 1.
        const double ratio = all > 0 ? 0.33 * double(sea.backscattering[c]) / all : 0;
        share[c] = float(ratio * out / (1 - ratio * (1 - out)));
    }
    return share;
}

// Of what enters deep water the share seaReflectance comes out of it again, as the deep sea's matte
// base has it. A radiance B from all directions below lets pi B t / n^2 out, where t is the mean
// transmittance of the surface for light from all sides above. [The reciprocity of Fresnel's terms:
// Born and Wolf 1999, section 1.5.2, with the n^2 law of radiance]
WaterLight waterLight(const SeaSettings& sea, const shared::LightRecord* suns, uint32_t count,
                      const SkyRows& sky) {
    Downwelling light(sea.ior);
    for (uint32_t i = 0; i < count; ++i)
        if (suns[i].direction.y < 0)
            light.add(-suns[i].direction.y,
                      glm::dvec3(suns[i].emission) * double(-suns[i].direction.y));
    addSky(light, sky);
    const double squared = double(sea.ior) * double(sea.ior);
    WaterLight result;
    result.radiance = glm::vec3(glm::dvec3(seaReflectance(sea)) * light.irradiance() *
                                (squared / (pi * surfaceTransmittance(sea.ior))));
    // The source along a ray is at most (1 + stretch) times 0.33 of what light from all sides would
    // have in balance: so no more than that comes back, whatever the index. Water has 1 to 1.52.
    constexpr double most = 2;
    result.stretch = float(std::min(light.stretch(), most));
    return result;
}

}  // namespace gp
