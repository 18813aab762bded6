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
    glm::vec2 start{3.7f, 1.9f};

    glm::vec2 camera(int frame) const { return step * float(frame) + start; }

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

// Sums over pixels, frames and places.
class FlickerSums {
public:
    FlickerSums(const GlintPlane& plane, const GlintMethod& method)
        : plane_(plane), method_(method), exposure_(plane.exposure()) {}

    void addPlace(glm::vec2 start) {
        plane_.start = start;
        Frame before;
        for (int frame = 0; frame < plane_.frames; ++frame) {
            Frame now = render(frame);
            for (const float e : now.errors) squares_ += double(e) * e;
            count_ += now.errors.size();
            if (frame > 0) compare(frame, before, now);
            before = std::move(now);
        }
    }
    GlintFlicker result() const {
        return {std::sqrt(flicker_ / double(compared_)), std::sqrt(reference_ / double(compared_)),
                std::sqrt(squares_ / double(count_)), sum_ / referenceSum_};
    }

private:
    struct Frame {
        std::vector<float> errors, references;  // as shown
    };

    Frame render(int frame) {
        Frame f;
        f.errors = plane_.image([&](glm::vec2 p) {
            double mean = 0;
            const float part = 1 / float(plane_.side);
            for (int j = 0; j < plane_.side; ++j)
                for (int i = 0; i < plane_.side; ++i)
                    mean += double(plane_.radiance(
                        method_, frame, p - 0.5f + (glm::vec2(i, j) + 0.5f) * part, part));
            mean /= plane_.side * plane_.side;
            const float one = plane_.radiance(method_, frame, p, 1);
            f.references.push_back(shown(float(mean) * exposure_));
            sum_ += double(one), referenceSum_ += mean;
            return shown(one * exposure_) - f.references.back();
        });
        return f;
    }
    void compare(int frame, const Frame& before, const Frame& now) {
        for (size_t i = 0; i < now.errors.size(); ++i) {
            const glm::vec2 p =
                glm::vec2(i % size_t(plane_.width), i / size_t(plane_.width)) + 0.5f;
            const glm::vec2 then = plane_.pixelOf(frame - 1, plane_.position(frame, p));
            float e, r;
            if (!readImage(plane_, before.errors, then, e)) continue;
            readImage(plane_, before.references, then, r);
            flicker_ += double(now.errors[i] - e) * (now.errors[i] - e);
            reference_ += double(now.references[i] - r) * (now.references[i] - r);
            ++compared_;
        }
    }

    GlintPlane plane_;
    GlintMethod method_;
    float exposure_;
    double flicker_ = 0, reference_ = 0, squares_ = 0, sum_ = 0, referenceSum_ = 0;
    size_t count_ = 0, compared_ = 0;
};

// Over this many places of the plane.
GlintFlicker glintFlicker(const GlintPlane& plane, const GlintMethod& method, int places) {
    FlickerSums sums(plane, method);
    for (int k = 0; k < places; ++k)
        sums.addPlace(glm::vec2(3.7f, 1.9f) + float(k) * glm::vec2(7.31f, 3.77f));
    return sums.result();
}

}  // namespace
}  // namespace gp::test
