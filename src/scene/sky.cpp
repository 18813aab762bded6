// Based on:
//   A. J. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999:
//     how luminance and colour are distributed over a clear sky (fits of appendix 2).
//   M. S. Rea (ed.), The IESNA Lighting Handbook, 9th edition, 2000, chapter 8: how bright a clear
//     sky and its sun are altogether.
//   F. Kasten, A. T. Young, "Revised optical air mass tables and approximation formula", Applied
//     Optics 28(22), 1989: how much air the sun's light passes.
// Our deviations: Preetham's absolute scale, too bright around noon, is replaced by the handbook's
// illuminance; colours outside of Rec. 709 are clipped. Below the horizon lies grey ground.
#include "scene/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

#include "scene/environment_table.h"

namespace gp {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double lumensPerWatt = 683;
constexpr uint32_t skyWidth = 512, skyHeight = 256;
constexpr double turbidity = 3;            // clear; below 2 the fits turn negative
constexpr float sunAngularRadius = 0.00465f;
constexpr double groundAlbedo = 0.25;      // between dry soil and grass

// The five coefficients of F(theta, gamma) for one of Y, x, y.
struct Perez {
    double a, b, c, d, e;

    // [Perez, Seals, Michalsky 1993, as Preetham 1999 uses it]
    double at(double cosTheta, double gamma) const {
        const double cosGamma = std::cos(gamma);
        return (1 + a * std::exp(b / cosTheta)) *
               (1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
    }
};

// [Preetham 1999, appendix 2, table of distribution coefficients]
constexpr double T = turbidity;
constexpr Perez perezY = {0.1787 * T - 1.4630, -0.3554 * T + 0.4275, -0.0227 * T + 5.3251,
                          0.1206 * T - 2.5771, -0.0670 * T + 0.3703};
constexpr Perez perezx = {-0.0193 * T - 0.2592, -0.0665 * T + 0.0008, -0.0004 * T + 0.2125,
                          -0.0641 * T - 0.8989, -0.0033 * T + 0.0452};
constexpr Perez perezy = {-0.0167 * T - 0.2608, -0.0950 * T + 0.0092, -0.0079 * T + 0.2102,
                          -0.0441 * T - 1.6537, -0.0109 * T + 0.0529};

double cubic(double t, double c3, double c2, double c1, double c0) {
    return ((c3 * t + c2) * t + c1) * t + c0;
}

// [Preetham 1999, appendix 2, zenith chromaticity x]; t: the sun's angle from the zenith
double zenithx(double t) {
    return T * T * cubic(t, 0.00166, -0.00375, 0.00209, 0) +
           T * cubic(t, -0.02903, 0.06377, -0.03202, 0.00394) +
           cubic(t, 0.11693, -0.21196, 0.06052, 0.25886);
}

// [Preetham 1999, appendix 2, zenith chromaticity y]
double zenithy(double t) {
    return T * T * cubic(t, 0.00275, -0.00610, 0.00317, 0) +
           T * cubic(t, -0.04214, 0.08970, -0.04153, 0.00516) +
           cubic(t, 0.15346, -0.26756, 0.06670, 0.26688);
}

// [IEC 61966-2-1: the inverse of the primaries' matrix]
glm::dvec3 rec709FromXyz(const glm::dvec3& c) {
    return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z,
            -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
            0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

double luminance(const glm::dvec3& c) {
    return 0.2126729 * c.x + 0.7151522 * c.y + 0.0721750 * c.z;
}

glm::dvec3 rec709FromYxy(double Y, double x, double y) {
    const glm::dvec3 xyz(Y * x / y, Y, Y * (1 - x - y) / y);
    glm::dvec3 rgb = glm::max(rec709FromXyz(xyz), glm::dvec3(0));
    const double clipped = luminance(rgb);
    return clipped > 0 ? rgb * (Y / clipped) : rgb;  // clipping must not change the brightness
}

// [Kasten and Young 1989]: air masses towards the sun, 1 at the zenith, 38 at the horizon
double airMass(double elevation) {
    const double degrees = elevation * 180 / pi;
    return 1 / (std::sin(elevation) + 0.50572 * std::pow(degrees + 6.07995, -1.6364));
}

// [IESNA Lighting Handbook, 9th ed., ch. 8, clear sky]: lux on a plane facing the sun
double sunIlluminance(double elevation) { return 127500 * std::exp(-0.21 * airMass(elevation)); }

// [IESNA Lighting Handbook, 9th ed., ch. 8, clear sky]: lux on the ground from the sky alone
double skyIlluminance(double elevation) { return 800 + 15500 * std::sqrt(std::sin(elevation)); }

// What the air leaves of light at one wavelength in micrometres.
double transmittance(double micrometres, double ozonePerCm, double mass) {
    // [Preetham 1999, appendix 1: Rayleigh, Angstrom's aerosol, ozone, after Iqbal 1983]
    const double rayleigh = 0.008735 * std::pow(micrometres, -4.08);
    const double aerosol = (0.04608 * T - 0.04586) * std::pow(micrometres, -1.3);
    const double ozone = 0.35 * ozonePerCm;
    return std::exp(-(rayleigh + aerosol + ozone) * mass);
}

// The sun's colour with a luminance of 1: a black body of 5,778 K seen through the air at the
// wavelengths where the three primaries are strongest.
glm::dvec3 sunColor(double elevation) {
    const double mass = airMass(elevation);
    const glm::dvec3 aboveAir(1.110, 0.976, 0.914);
    const glm::dvec3 air(transmittance(0.610, 0.120, mass), transmittance(0.550, 0.085, mass),
                         transmittance(0.465, 0.0075, mass));
    const glm::dvec3 color = aboveAir * air;
    return color / luminance(color);
}

glm::dvec3 sunDirection(double azimuth, double elevation) {
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            -std::cos(elevation) * std::cos(azimuth)};
}

// Towards the centre of a pixel; the middle of the image looks along -Z, its right half to +X.
glm::dvec3 directionOf(uint32_t x, uint32_t y) {
    const double phi = ((x + 0.5) / skyWidth - 0.5) * 2 * pi, theta = (y + 0.5) / skyHeight * pi;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

struct Sky {
    std::vector<glm::dvec3> upper;  // radiance above the horizon, rows from the zenith down
    glm::dvec3 irradiance{0};       // of the ground, by the sky alone
};

// In proportion first; the handbook's illuminance then gives the scale.
Sky makeSky(const glm::dvec3& sun, double elevation) {
    const double sunTheta = pi / 2 - elevation;
    const double Y0 = perezY.at(1, sunTheta);
    const double xScale = zenithx(sunTheta) / perezx.at(1, sunTheta);
    const double yScale = zenithy(sunTheta) / perezy.at(1, sunTheta);
    Sky sky;
    sky.upper.resize(size_t(skyWidth) * skyHeight / 2);
    tbb::parallel_for(0u, skyHeight / 2, [&](uint32_t y) {
        for (uint32_t x = 0; x < skyWidth; ++x) {
            const glm::dvec3 direction = directionOf(x, y);
            const double gamma = std::acos(std::clamp(glm::dot(direction, sun), -1.0, 1.0));
            const double Y = perezY.at(direction.y, gamma) / Y0;
            sky.upper[size_t(y) * skyWidth + x] =
                rec709FromYxy(std::max(Y, 0.0), xScale * perezx.at(direction.y, gamma),
                              yScale * perezy.at(direction.y, gamma));
        }
    });
    // The solid angle of a pixel from the exact area of its row, so that few rows are enough.
    for (uint32_t y = 0; y < skyHeight / 2; ++y) {
        const double top = std::cos(y * pi / skyHeight);
        const double bottom = std::cos((y + 1) * pi / skyHeight);
        const double projected = (top * top - bottom * bottom) * pi / skyWidth;
        for (uint32_t x = 0; x < skyWidth; ++x)
            sky.irradiance += sky.upper[size_t(y) * skyWidth + x] * projected;
    }
    const double scale = skyIlluminance(elevation) / lumensPerWatt / luminance(sky.irradiance);
    for (glm::dvec3& radiance : sky.upper) radiance *= scale;
    sky.irradiance *= scale;
    return sky;
}

std::shared_ptr<const EnvironmentTable> tableOf(const Sky& sky, const glm::dvec3& ground) {
    std::vector<glm::vec4> pixels(size_t(skyWidth) * skyHeight);
    for (size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = glm::vec4(glm::vec3(i < sky.upper.size() ? sky.upper[i] : ground), 1);
    return makeEnvironmentTable(&pixels[0].x, skyWidth, skyHeight);
}

}  // namespace

void removeSkySun(Scene& scene) {
    for (const auto& light : scene.lights)
        if (light->ofSky) light->inScene = false;
    std::erase_if(scene.lights, [](const auto& light) { return light->ofSky; });
}

void setSky(Scene& scene, float sunAzimuth, float sunElevation, float sunLux) {
    const double elevation = sunElevation;
    const glm::dvec3 towardsSun = sunDirection(sunAzimuth, elevation);
    const double lux = sunLux > 0 ? sunLux : sunIlluminance(elevation);
    const glm::dvec3 sunIrradiance = sunColor(elevation) * (lux / lumensPerWatt);
    const Sky sky = makeSky(towardsSun, elevation);
    const glm::dvec3 onGround = sky.irradiance + sunIrradiance * std::max(towardsSun.y, 0.0);

    auto sun = std::make_shared<Light>();
    sun->name = "sun";
    sun->kind = LightKind::directional;
    sun->emission = glm::vec3(sunIrradiance);
    sun->direction = -glm::vec3(towardsSun);
    sun->angularRadius = sunAngularRadius;
    sun->ofSky = true;
    std::shared_ptr<const EnvironmentTable> table = tableOf(sky, onGround * (groundAlbedo / pi));

    scene.lights.reserve(scene.lights.size() + 1);  // the last step that can fail
    removeSkySun(scene);
    scene.lights.push_back(std::move(sun));
    scene.environment = {std::move(table), glm::vec3(1), 0};
    ++scene.revision;
}

}  // namespace gp
