// Makes the dictionary of glints (layout: shading/glint/dictionary.glsl).
//
// The leaves of the trees lie on all quantiles of the normal distribution, so that the mean over
// the rows of any level is normal; an Owen scramble orders them, so that the leaves below every
// node are stratified too, and uneven within their strata.
#include "scene/glint_dictionary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/glint/dictionary.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/sampling/sobol.glsl"
GP_SHADING_END

namespace gp {
namespace {

using namespace shading;

// Where lobes may lie, in standard deviations: 513 points of [0, 4], a seventh of a lobe apart.
constexpr size_t places = 513;
constexpr double placeStep = double(GLINT_REACH) / (places - 1);

// Beyond 8 what is left is below a double's last digit.
double normalCdf(double x) {
    return x < -8.0 ? 0.0 : x > 8.0 ? 1.0 : 0.5 * std::erfc(-x * M_SQRT1_2);
}

constexpr size_t copies = 4;  // but for the normal distribution, the same for all

// A row before it is rounded.
using Row = std::array<std::array<float, GLINT_BINS>, copies>;

// Averages over bins and linear reading between them add step^2 / 12 and step^2 / 6.
double lobeWidth(double total) {
    constexpr double step = double(GLINT_REACH) / GLINT_BINS;
    return std::sqrt(total * total - 0.25 * step * step);
}

// An even pair of lobes as averages over bins; what would lie beyond the end is folded back.
std::array<float, GLINT_BINS> lobes(double mean, double width) {
    constexpr double folded = 2.0 * double(GLINT_REACH);
    constexpr double step = double(GLINT_REACH) / GLINT_BINS;
    std::array<float, GLINT_BINS> bins;
    double below = 0.0;
    for (uint edge = 0; edge <= GLINT_BINS; ++edge) {
        double sum = 0.0;
        for (const double at : {mean, -mean, folded - mean, folded + mean})
            sum += normalCdf((edge * step - at) / width);
        if (edge > 0) bins[edge - 1] = float(0.5 * (sum - below) / step);
        below = sum;
    }
    return bins;
}

// As roots in units of GLINT_ROOT. What rounding took from a bin the next one has more, so that
// the sum stays.
std::array<uint, GLINT_BINS> rounded(const std::array<float, GLINT_BINS>& bins) {
    constexpr double unit = double(GLINT_ROOT) * double(GLINT_ROOT);
    std::array<uint, GLINT_BINS> roots;
    double left = 0.0;
    for (uint i = 0; i < GLINT_BINS; ++i) {
        left += double(bins[i]);
        const float root = std::sqrt(std::max(float(left), 0.0f)) * (1.0f / GLINT_ROOT);
        roots[i] = std::min(uint(root + 0.5f), 65535u);
        left -= double(roots[i]) * roots[i] * unit;
    }
    return roots;
}

class DictionaryMaker {
public:
    DictionaryMaker() : words_(GLINT_WORDS), places_(places), rows_(GLINT_LEAVES) {}

    std::vector<uint32_t> make() {
        makePlaces();
        for (uint leaf = 0; leaf < GLINT_LEAVES; ++leaf) makeLeaf(leaf);
        for (uint level = 0; level < uint(GLINT_LEVELS); ++level) {
            const uint entries = glint_entries(level);
            // Both children of a row are gone when it is written over the first.
            for (uint entry = 0; level > 0 && entry < entries; ++entry)
                rows_[entry] = mixed(rows_[entry], rows_[entry + entries], 0.5f);
            for (uint entry = 0; entry < entries; ++entry) store(level, entry);
        }
        return std::move(words_);
    }

private:
    void makePlaces() {
        normal_ = rounded(lobes(0.0, lobeWidth(1.0)));
        for (size_t width = 0; width < copies; ++width) {
            const double total = std::exp2(double(width)) / 16.0;
            const double nearer = std::sqrt(1.0 - total * total);
            for (size_t place = 0; place < places; ++place)
                places_[place][width] =
                    lobes(nearer * double(place) * placeStep, lobeWidth(total));
        }
    }

    void makeLeaf(uint leaf) {
        const uint quantile = owen_scramble(leaf << (32 - GLINT_LEVELS), 0x7a3c91e5u) >>
                              (32 - GLINT_LEVELS);
        const float p = (float(quantile) + 0.5f) / float(GLINT_LEAVES);
        // Of |x|, x normal.
        const float at =
            std::min(float(M_SQRT2 / placeStep) * erf_inverse(p), float(places) - 1.01f);
        const auto place = size_t(at);
        rows_[leaf] = mixed(places_[place], places_[place + 1], at - float(place));
    }

    static Row mixed(const Row& a, const Row& b, float t) {
        Row row;
        for (size_t width = 0; width < copies; ++width)
            for (uint i = 0; i < GLINT_BINS; ++i)
                row[width][i] = (1.0f - t) * a[width][i] + t * b[width][i];
        return row;
    }

    void store(uint level, uint entry) {
        std::array<uint, GLINT_BINS> narrow = rounded(rows_[entry][0]);
        for (uint width = 0; width < copies; ++width) {
            const std::array<uint, GLINT_BINS> wide =
                width + 1 < copies ? rounded(rows_[entry][width + 1]) : normal_;
            uint32_t* words = &words_[glint_at(glint_row(level, entry), width, 1)];
            for (uint i = 0; i < GLINT_BINS; ++i) words[i] = narrow[i] | wide[i] << 16u;
            words[-1] = words[0];
            words[GLINT_BINS] = words[GLINT_BINS - 1];
            narrow = wide;
        }
    }

    std::vector<uint32_t> words_;
    std::vector<Row> places_;  // of a lobe at each place
    std::vector<Row> rows_;    // of the level in work
    std::array<uint, GLINT_BINS> normal_;
};

}  // namespace

const std::vector<uint32_t>& glintWords() {
    static const std::vector<uint32_t> words = DictionaryMaker().make();
    return words;
}

glm::uvec2 glintDictionary() {
    const auto address = uint64_t(reinterpret_cast<uintptr_t>(glintWords().data()));
    return {uint32_t(address), uint32_t(address >> 32u)};
}

}  // namespace gp
