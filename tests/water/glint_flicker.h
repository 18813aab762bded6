// A plane of glints under a moving camera: every pixel's footprint, half vectors and their changes
// are known exactly, so that methods are compared without a renderer. Flicker is that of
// `glitterpath evaluate` (docs/manual.md): how the error against the reference, of the picture as
// it is shown, changes along the motion. The reference of a method is the mean of 32 x 32 points of
// the pixel, each with a footprint and half vectors of its own.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "scene/mipmap.h"

// Its types hold shading's, which each translation unit has its own of.
namespace gp::test {
namespace {

using GlintMethod = std::function<float(const shading::Glint&, glm::vec2)>;

struct GlintPlane {
    int width = 24, height = 14, frames = 4, side = 32;  // side: of the reference's points
    float logDensity = 14;                               // facets per square metre
    float deviation = 0.15f;                             // of their slopes
    glm::uvec2 dictionary{0};
    float cameraHeight = 1.2f, fieldOfView = 0.8f, pitch = -0.35f;  // metres, radians
    glm::vec3 sun = glm::normalize(glm::vec3(0.1f, 0.9f, 0.45f));
    glm::vec2 step{0.004f, 0.009f};                      // metres a frame

    glm::vec2 camera(int frame) const { return step * float(frame) + glm::vec2(3.7f, 1.9f); }

    glm::vec3 ray(glm::vec2 pixel) const {
        const float scale = 2 * std::tan(0.5f * fieldOfView) / float(width);
        const glm::vec2 at = (pixel - 0.5f * glm::vec2(width, height)) * scale;
        const float c = std::cos(pitch), s = std::sin(pitch);
        return glm::normalize(glm::vec3(at.x, c + s * at.y, s - c * at.y));
    }
    glm::vec2 position(int frame, glm::vec2 pixel) const {
        const glm::vec3 d = ray(pixel);
        return camera(frame) + glm::vec2(d) * (-cameraHeight / d.z);
    }
    glm::vec2 pixelOf(int frame, glm::vec2 position) const {
        const glm::vec3 d(position - camera(frame), -cameraHeight);
        const float c = std::cos(pitch), s = std::sin(pitch);
        const float forward = c * d.y + s * d.z, up = c * d.z - s * d.y;
        const float scale = 2 * std::tan(0.5f * fieldOfView) / float(width);
        return glm::vec2(d.x, -up) / (forward * scale) + 0.5f * glm::vec2(width, height);
    }
    glm::vec2 slope(glm::vec2 pixel) const { return shading::slope_of(sun - ray(pixel)); }

    // What one sample of this many pixels' width shows at a place of the picture; before exposure.
    float radiance(const GlintMethod& method, int frame, glm::vec2 pixel, float pixels) const {
        const glm::vec2 x(0.5f * pixels, 0), y(0, 0.5f * pixels);
        shading::Glint g{};
        g.slopes.var_x = g.slopes.var_y = deviation * deviation;
        g.area = 1, g.log_density = logDensity, g.dictionary = dictionary, g.seed = 1;
        g.uv = position(frame, pixel);
        g.d0 = position(frame, pixel + x) - position(frame, pixel - x);
        g.d1 = position(frame, pixel + y) - position(frame, pixel - y);
        g.k0 = slope(pixel + x) - slope(pixel - x);
        g.k1 = slope(pixel + y) - slope(pixel - y);
        const glm::vec3 wo = -ray(pixel), h = glm::normalize(sun + wo);
        // [Dupuy et al. 2013, equation 9] without masking and Fresnel's term.
        return method(g, shading::slope_of(h)) / (4 * h.z * h.z * h.z * h.z * wo.z);
    }

    template <class F>
    std::vector<float> image(F&& pixelValue) const {
        std::vector<float> values;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                values.push_back(pixelValue(glm::vec2(x, y) + 0.5f));
        return values;
    }

    float exposure() const {
        double sum = 0;
        const GlintMethod smooth = [](const shading::Glint& g, glm::vec2 s) {
            return shading::slopes_p22(g.slopes, s);
        };
        for (const float v : image([&](glm::vec2 p) { return radiance(smooth, 0, p, 1); }))
            sum += double(v);
        return float(0.18 * width * height / sum);
    }
};

float shown(float linear) { return srgbFromLinear(std::min(linear, 1.0f)); }

// Of the image at `pixel` before, linearly; false outside.
bool readImage(const GlintPlane& plane, const std::vector<float>& image, glm::vec2 pixel,
                      float& value) {
    const glm::vec2 at = pixel - 0.5f, corner = glm::floor(at), f = at - corner;
    if (corner.x < 0 || corner.y < 0 || corner.x + 1 >= float(plane.width) ||
        corner.y + 1 >= float(plane.height))
        return false;
    const float* p = &image[size_t(corner.y) * size_t(plane.width) + size_t(corner.x)];
    value = glm::mix(glm::mix(p[0], p[1], f.x),
                     glm::mix(p[plane.width], p[plane.width + 1], f.x), f.y);
    return true;
}

struct GlintFlicker {
    double flicker = 0;    // of the error against the reference
    double reference = 0;  // of the reference itself: what glints do by nature
    double error = 0;      // root mean square of the error
    double brightness = 0; // mean radiance over the reference's
};

GlintFlicker glintFlicker(const GlintPlane& plane, const GlintMethod& method) {
    const float exposure = plane.exposure();
    std::vector<float> errorBefore, referenceBefore;
    double flicker = 0, reference = 0, squares = 0, sum = 0, referenceSum = 0;
    size_t count = 0, compared = 0;
    for (int frame = 0; frame < plane.frames; ++frame) {
        std::vector<float> errors, references;
        const auto pixel = [&](glm::vec2 p) {
            double mean = 0;
            const float part = 1 / float(plane.side);
            for (int j = 0; j < plane.side; ++j)
                for (int i = 0; i < plane.side; ++i)
                    mean += double(plane.radiance(
                        method, frame, p - 0.5f + (glm::vec2(i, j) + 0.5f) * part, part));
            mean /= plane.side * plane.side;
            const float one = plane.radiance(method, frame, p, 1);
            references.push_back(shown(float(mean) * exposure));
            sum += double(one), referenceSum += mean, ++count;
            return shown(one * exposure) - references.back();
        };
        errors = plane.image(pixel);
        for (size_t i = 0; i < errors.size(); ++i) {
            squares += double(errors[i]) * errors[i];
            if (frame == 0) continue;
            const glm::vec2 p = glm::vec2(i % size_t(plane.width), i / size_t(plane.width)) + 0.5f;
            const glm::vec2 before = plane.pixelOf(frame - 1, plane.position(frame, p));
            float e, r;
            if (!readImage(plane, errorBefore, before, e)) continue;
            readImage(plane, referenceBefore, before, r);
            flicker += double(errors[i] - e) * (errors[i] - e);
            reference += double(references[i] - r) * (references[i] - r);
            ++compared;
        }
        errorBefore = errors, referenceBefore = references;
    }
    return {std::sqrt(flicker / double(compared)), std::sqrt(reference / double(compared)),
            std::sqrt(squares / double(count)), sum / referenceSum};
}

}  // namespace
}  // namespace gp::test
