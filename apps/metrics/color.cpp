#include "metrics/color.h"

#include <cmath>

namespace gp::metrics {
namespace {

// Column i holds the XYZ of primary i at full drive; they are scaled so that all three together
// give the white point.
glm::dmat3 makeXyzFromLinear() {
    // [ITU-R BT.709-6, table 1: chromaticities of the primaries and of D65]
    const glm::dvec3 red(0.64, 0.33, 0.03);
    const glm::dvec3 green(0.30, 0.60, 0.10);
    const glm::dvec3 blue(0.15, 0.06, 0.79);
    const glm::dvec3 white = glm::dvec3(0.3127, 0.3290, 0.3583) / 0.3290;
    const glm::dmat3 chromaticities(red, green, blue);
    const glm::dvec3 scale = glm::inverse(chromaticities) * white;
    return glm::dmat3(red * scale.x, green * scale.y, blue * scale.z);
}

// Each row divided by the white point's value in it.
glm::dmat3 makeRelativeXyzFromLinear() {
    const glm::dmat3 xyzFromLinear = makeXyzFromLinear();
    const glm::dvec3 white = xyzFromLinear * glm::dvec3(1.0);
    glm::dmat3 result = xyzFromLinear;
    for (int column = 0; column < 3; ++column) {
        result[column] /= white;
    }
    return result;
}

float labCurve(float t) {
    // [CIE 15:2004, section 8.2.1]
    const float delta = 6.0f / 29.0f;
    if (t > delta * delta * delta) {
        return std::cbrt(t);
    }
    return t / (3.0f * delta * delta) + 4.0f / 29.0f;
}

}  // namespace

float luminance(glm::vec3 linear) {
    // [ITU-R BT.709-6, item 3.2]
    return glm::dot(linear, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

// [IEC 61966-2-1:1999]
float srgbFromLinear(float linear) {
    if (linear <= 0.0031308f) {
        return 12.92f * linear;
    }
    return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linearFromSrgb(float encoded) {
    if (encoded <= 0.04045f) {
        return encoded / 12.92f;
    }
    return std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

glm::vec3 srgbFromLinear(glm::vec3 linear) {
    return {srgbFromLinear(linear.x), srgbFromLinear(linear.y), srgbFromLinear(linear.z)};
}

glm::vec3 linearFromSrgb(glm::vec3 encoded) {
    return {linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z)};
}

glm::vec3 relativeXyzFromLinear(glm::vec3 linear) {
    static const glm::mat3 matrix(makeRelativeXyzFromLinear());
    return matrix * linear;
}

glm::vec3 linearFromRelativeXyz(glm::vec3 xyz) {
    static const glm::mat3 matrix(glm::inverse(makeRelativeXyzFromLinear()));
    return matrix * xyz;
}

// [Andersson et al. 2020, FLIP, section 4.1.1: L*a*b* without its cube roots]
glm::vec3 ycxczFromLinear(glm::vec3 linear) {
    const glm::vec3 xyz = relativeXyzFromLinear(linear);
    return {116.0f * xyz.y - 16.0f, 500.0f * (xyz.x - xyz.y), 200.0f * (xyz.y - xyz.z)};
}

glm::vec3 linearFromYcxcz(glm::vec3 ycxcz) {
    const float y = (ycxcz.x + 16.0f) / 116.0f;
    return linearFromRelativeXyz({y + ycxcz.y / 500.0f, y, y - ycxcz.z / 200.0f});
}

glm::vec3 labFromLinear(glm::vec3 linear) {
    const glm::vec3 xyz = relativeXyzFromLinear(linear);
    const float fx = labCurve(xyz.x);
    const float fy = labCurve(xyz.y);
    const float fz = labCurve(xyz.z);
    return {116.0f * fy - 16.0f, 500.0f * (fx - fy), 200.0f * (fy - fz)};
}

// [Andersson et al. 2020, FLIP, section 4.1.2, after Hunt 1952]
glm::vec3 huntAdjusted(glm::vec3 lab) {
    const float scale = 0.01f * lab.x;
    return {lab.x, scale * lab.y, scale * lab.z};
}

// [Abasi et al. 2020, Distancing color differences, HyAB]
float hyabDistance(glm::vec3 labA, glm::vec3 labB) {
    const glm::vec3 d = labA - labB;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

}  // namespace gp::metrics
