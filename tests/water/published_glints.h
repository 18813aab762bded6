// The published glints as their OpenGL program has them, with what the audit found (docs/water.md):
// tables of nodes read at the centres of texels, no filter where the dictionary ends in the
// Gaussian, a hash that repeats along lines, unequal weights of a finite dictionary. Only here, to
// compare with.
// Based on: Chermain et al. 2020, "Procedural Physically based BRDF for Real-Time Rendering of
// Glints"; 2021, "Real-Time Geometric Glint Anti-Aliasing with Normal Map Filtering".
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "statistics/random.h"

// Its types hold shading's, which each translation unit has its own of.
namespace gp::test {
namespace {

class PublishedGlints {
public:
    // jitter: of the density, in levels; the program has 2 built in.
    explicit PublishedGlints(float jitter) : jitter_(jitter) {
        Random random(192);
        for (int i = 0; i < rows; ++i) addRow(random);
    }

    float p22(const shading::Glint& g, glm::vec2 s) const {
        glm::vec2 d0 = g.d0, d1 = g.d1;
        if (glm::length(d0) < glm::length(d1)) std::swap(d0, d1);
        if (glm::length(d0) > 4 * glm::length(d1)) d1 *= glm::length(d0) / (4 * glm::length(d1));
        const float level = std::max(0.0f, float(levels - 1) + std::log2(glm::length(d1)));
        const float low = std::floor(level);
        if (std::round(levelOfDensity(g, low, 0.5f)) >= levels && g.area > 0.99f)
            return shading::slopes_p22(g.slopes, s);
        return glm::mix(ofLevel(g, s, d0, d1, int(low)), ofLevel(g, s, d0, d1, int(low) + 1),
                        level - low);
    }

private:
    static constexpr int levels = 16, rows = 192, nodes = 64;
    static constexpr float deviation = 0.353553391f, lobe = 0.02f;

    // One distribution: level l has 2^l lobes and their mirror images.
    void addRow(Random& random) {
        const float step = 4 * deviation / nodes;
        std::vector<double> sum(nodes, 0.0);
        uint32_t means = 0;
        for (int level = 0; level < levels; ++level) {
            for (; means < 1u << level; ++means) {
                const float r = std::sqrt(-2 * std::log(1 - random.uniform()));
                const float mu = std::abs(deviation * r * std::cos(6.2831853f * random.uniform()));
                const int first = std::max(0, int((mu - 5 * lobe) / step));
                for (int k = first; k < nodes && float(k) * step < mu + 5 * lobe; ++k)
                    sum[size_t(k)] += density(float(k) * step - mu);
                for (int k = 0; k < nodes && float(k) * step + mu < 5 * lobe; ++k)
                    sum[size_t(k)] += density(float(k) * step + mu);
            }
            // To an integral of 1 of the linear interpolant over both halves.
            double area = 0;
            for (int k = 0; k < nodes; ++k)
                area += sum[size_t(k)] * double(step) * (k == 0 ? 1 : 2);
            std::vector<float> chain;
            for (int k = 0; k < nodes; ++k) chain.push_back(float(sum[size_t(k)] / area));
            for (size_t n = nodes, from = 0; n > 1; from += n, n /= 2)
                for (size_t k = 0; k < n; k += 2)
                    chain.push_back(0.5f * (chain[from + k] + chain[from + k + 1]));
            tables_.push_back(chain);
        }
    }
    // Of a lobe, from a table: there are six million of them.
    static double density(float x) {
        static const std::vector<double> table = [] {
            std::vector<double> t;
            for (int i = 0; i <= 1024; ++i) t.push_back(std::exp(-0.5 * std::pow(i / 200.0, 2)));
            return t;
        }();
        return table[std::min(size_t(std::abs(x) / lobe * 200 + 0.5f), size_t(1024))];
    }

    // textureGrad of one row: texel centres, mirrored, trilinear. x, width: in units of the table.
    float read(int row, int level, float x, float width) const {
        const std::vector<float>& chain = tables_[size_t(row * levels + level)];
        const float lod = std::clamp(std::log2(std::max(width * nodes, 1e-6f)), 0.0f, 6.0f);
        const int fine = std::min(int(lod), 5);
        return glm::mix(linear(chain, fine, x), linear(chain, fine + 1, x), lod - float(fine));
    }
    static float linear(const std::vector<float>& chain, int mip, float x) {
        const int n = nodes >> mip, first = 2 * nodes - 2 * n;
        const float at = x * float(n) - 0.5f;
        const int i = int(std::floor(at));
        const auto texel = [&](int k) {
            k = k < 0 ? -1 - k : k >= n ? 2 * n - 1 - k : k;
            return chain[size_t(first + std::clamp(k, 0, n - 1))];
        };
        return glm::mix(texel(i), texel(i + 1), at - float(i));
    }

    static float hash(uint32_t n) {
        n = (n << 13u) ^ n;
        n = n * (n * n * 15731u + 789221u) + 1376312589u;
        return float(n & 0x7FFFFFFFu) / float(0x7FFFFFFF);
    }

    float levelOfDensity(const shading::Glint& g, float level, float u) const {
        const float facets = g.log_density / 1.38629436f + level - float(levels - 1);
        const float z = shading::erf_inverse(std::clamp(2 * u - 1, -0.999999f, 0.999999f));
        return std::clamp(facets + jitter_ * 1.41421356f * z, 0.0f, float(levels));
    }

    float cell(const shading::Glint& g, glm::vec2 s, int level, int x, int y) const {
        const uint32_t id = (uint32_t(x) << level) + 1549u * (uint32_t(y) << level);
        if (hash(id * 13u) > g.area) return 0;
        const float dictionaryLevel =
            std::round(levelOfDensity(g, float(level), hash(id * 2171u)));
        if (dictionaryLevel >= levels) return shading::slopes_p22(g.slopes, s);
        const float turn = -6.2831853f * hash(id), c = std::cos(turn), n = std::sin(turn);
        const shading::Slopes& d = g.slopes;
        const float sx = std::sqrt(d.var_x), sy = std::sqrt(d.var_y), rho = d.cov / (sx * sy);
        const float q = std::sqrt(1 - rho * rho);
        // The same map for slopes and for the pixel's kernel, into units of the table.
        const auto mapped = [&](glm::vec2 v) {
            const glm::vec2 w(v.x / (sx * q) - rho * v.y / (sy * q), v.y / sy);
            return glm::vec2(c * w.x - n * w.y, n * w.x + c * w.y) * 0.25f;
        };
        const glm::vec2 at = glm::abs(mapped(s - d.mean));
        if (at.x >= 1 || at.y >= 1) return 0;
        const glm::vec2 width =
            0.5f * glm::max(glm::abs(mapped(g.k0)), glm::abs(mapped(g.k1)));
        const int i = std::min(int(hash(id * 16807u) * rows), rows - 1);
        const int j = std::min(int(hash(id * 48271u) * rows), rows - 1);
        const int l = int(dictionaryLevel);
        return read(i, l, at.x, width.x) * read(j, l, at.y, width.y) * deviation * deviation /
               (sx * sy * q);
    }

    float ofLevel(const shading::Glint& g, glm::vec2 s, glm::vec2 d0, glm::vec2 d1,
                  int level) const {
        const float scale = std::exp2(float(levels - 1 - level));
        const glm::vec2 st = g.uv * scale - 0.5f;
        d0 *= scale, d1 *= scale;
        float a = d0.y * d0.y + d1.y * d1.y + 1, c = d0.x * d0.x + d1.x * d1.x + 1;
        float b = -2 * (d0.x * d0.y + d1.x * d1.y);
        const float f = a * c - b * b / 4;
        a /= f, b /= f, c /= f;
        const float det = a * c - b * b / 4;
        const float w = std::sqrt(c / det), h = std::sqrt(a / det);
        float sum = 0, weights = 0;
        for (int y = int(std::ceil(st.y - h)); float(y) <= st.y + h; ++y)
            for (int x = int(std::ceil(st.x - w)); float(x) <= st.x + w; ++x) {
                const float ss = float(x) - st.x, tt = float(y) - st.y;
                const float r2 = a * ss * ss + b * ss * tt + c * tt * tt;
                if (r2 >= 1) continue;
                const float weight = std::exp(-2 * r2) - std::exp(-2.0f);
                sum += weight * cell(g, s, level, x, y);
                weights += weight;
            }
        return weights > 0 ? sum / weights : 0;
    }

    float jitter_;
    std::vector<std::vector<float>> tables_;  // [row][level]: MIP chain
};

}  // namespace
}  // namespace gp::test
