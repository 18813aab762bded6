#include "brute_force_flip.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace gp::metrics {
namespace {

constexpr double kPi = 3.14159265358979323846;
using Values = std::vector<double>;

// [IEC 61966-2-1:1999]
glm::dvec3 xyz(glm::dvec3 c) {
    return {0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z,
            0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z,
            0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z};
}

glm::dvec3 rgb(glm::dvec3 v) {
    return {3.2406255 * v.x - 1.537208 * v.y - 0.4986286 * v.z,
            -0.9689307 * v.x + 1.8757561 * v.y + 0.0415175 * v.z,
            0.0557101 * v.x - 0.2040211 * v.y + 1.0569959 * v.z};
}

const glm::dvec3 kWhite(0.9505, 1.0, 1.089);

glm::dvec3 huntLab(glm::dvec3 linear) {
    const glm::dvec3 r = xyz(linear) / kWhite;
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double l = 116 * f(r.y) - 16;
    return {l, 0.01 * l * 500 * (f(r.x) - f(r.y)), 0.01 * l * 200 * (f(r.y) - f(r.z))};
}

double distance(glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 d = huntLab(a) - huntLab(b);
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

using KernelFunction = std::function<double(double, double)>;  // of pixels from the middle

// Weights are divided by `positive` where above zero and by `negative` where below.
Values filter(const Values& in, int w, int h, int radius, const KernelFunction& kernel) {
    double positive = 0, negative = 0;
    for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            const double k = kernel(x, y);
            (k > 0 ? positive : negative) += std::abs(k);
        }
    }
    Values out(in.size(), 0.0);
    for (int py = 0; py < h; ++py) {
        for (int px = 0; px < w; ++px) {
            for (int y = -radius; y <= radius; ++y) {
                for (int x = -radius; x <= radius; ++x) {
                    const int sx = std::clamp(px + x, 0, w - 1), sy = std::clamp(py + y, 0, h - 1);
                    const double k = kernel(x, y);
                    out[static_cast<std::size_t>(py * w + px)] +=
                        k / (k > 0 ? positive : negative) *
                        in[static_cast<std::size_t>(sy * w + sx)];
                }
            }
        }
    }
    return out;
}

struct Views {
    std::vector<glm::dvec3> filtered;
    Values edges, points;
};

Values contrast(const Values& channel, int w, int h, double ppd, const double (&p)[4]) {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
    return filter(channel, w, h, radius, [&](double x, double y) {
        const double d2 = (x * x + y * y) / (ppd * ppd);
        return p[0] * std::sqrt(kPi / p[1]) * std::exp(-kPi * kPi * d2 / p[1]) +
               p[2] * std::sqrt(kPi / p[3]) * std::exp(-kPi * kPi * d2 / p[3]);
    });
}

Values feature(const Values& grey, int w, int h, double ppd, bool edge) {
    const double s = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3 * s));
    const auto kernel = [&](double along, double across) {
        const double g = std::exp(-(along * along + across * across) / (2 * s * s));
        return edge ? -along * g : (along * along / (s * s) - 1) * g;
    };
    const Values gx = filter(grey, w, h, radius, kernel);
    const Values gy = filter(grey, w, h, radius,
                             [&](double x, double y) { return kernel(y, x); });
    Values length(gx.size());
    for (std::size_t i = 0; i < length.size(); ++i) {
        length[i] = std::sqrt(gx[i] * gx[i] + gy[i] * gy[i]);
    }
    return length;
}

Views view(const Picture& picture, double ppd) {
    const double parameters[3][4] = {
        {1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
    const int w = picture.width, h = picture.height;
    Values channels[3];
    Values grey;
    for (const glm::vec3& pixel : picture.pixels) {
        const glm::dvec3 r = xyz(pixel) / kWhite;
        channels[0].push_back(116 * r.y - 16);
        channels[1].push_back(500 * (r.x - r.y));
        channels[2].push_back(200 * (r.y - r.z));
        grey.push_back(r.y);
    }
    for (int c = 0; c < 3; ++c) {
        channels[c] = contrast(channels[c], w, h, ppd, parameters[c]);
    }
    Views result;
    for (std::size_t i = 0; i < grey.size(); ++i) {
        const double y = (channels[0][i] + 16) / 116;
        const glm::dvec3 r(y + channels[1][i] / 500, y, y - channels[2][i] / 200);
        result.filtered.push_back(glm::clamp(rgb(r * kWhite), glm::dvec3(0.0), glm::dvec3(1.0)));
    }
    result.edges = feature(grey, w, h, ppd, true);
    result.points = feature(grey, w, h, ppd, false);
    return result;
}

}  // namespace

double bruteForceColorError(glm::dvec3 a, glm::dvec3 b) {
    const double largest = std::pow(distance({0, 1, 0}, {0, 0, 1}), 0.7);
    const double d = std::pow(distance(a, b), 0.7);
    return d < 0.4 * largest ? d * 0.95 / (0.4 * largest)
                             : 0.95 + (d - 0.4 * largest) / (0.6 * largest) * 0.05;
}

Values bruteForceFlip(const Picture& a, const Picture& b, double ppd) {
    const Views va = view(a, ppd), vb = view(b, ppd);
    Values errors;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double color = bruteForceColorError(va.filtered[i], vb.filtered[i]);
        const double difference = std::max(std::abs(va.edges[i] - vb.edges[i]),
                                           std::abs(va.points[i] - vb.points[i]));
        errors.push_back(std::pow(color, 1 - std::sqrt(difference / std::sqrt(2.0))));
    }
    return errors;
}

}  // namespace gp::metrics
