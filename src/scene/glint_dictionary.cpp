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

double normalCdf(double x) { return 0.5 * std::erfc(-x * M_SQRT1_2); }

// The average over a bin of an even pair of lobes; what would lie beyond the end is folded back.
double binAverage(double low, double high, double mean, double width) {
    double sum = 0.0;
    constexpr double folded = 2.0 * double(GLINT_REACH);
    for (const double at : {mean, -mean, folded - mean, folded + mean})
        sum += normalCdf((high - at) / width) - normalCdf((low - at) / width);
    return 0.5 * sum / (high - low);
}

class DictionaryMaker {
public:
    DictionaryMaker() : words_(GLINT_WORDS), rows_(places) {}

    std::vector<float> make() {
        for (uint width = 0; width < 4; ++width) makeWidth(width);
        const GlintBins normal = glint_bins(0, 4);
        const double step = double(GLINT_REACH) / normal.count;
        for (uint bin = 0; bin < normal.count; ++bin) {
            words_[normal.base + bin] =
                float(binAverage(bin * step, (bin + 1) * step, 0.0, lobeWidth(1.0, step)));
        }
        for (uint leaf = 0; leaf < GLINT_LEAVES; ++leaf) makeLeaf(leaf);
        for (uint level = 1; level < uint(GLINT_LEVELS); ++level)
            for (uint entry = 0; entry < glint_entries(level); ++entry) makeParent(level, entry);
        return std::move(words_);
    }

private:
    // Averages over bins and linear reading between them add step^2 / 12 and step^2 / 6.
    static double lobeWidth(double total, double step) {
        return std::sqrt(total * total - 0.25 * step * step);
    }

    // What a lobe at each place adds to the bins of one width.
    void makeWidth(uint width) {
        const GlintBins bins = glint_bins(0, width);
        const double step = double(GLINT_REACH) / bins.count;
        const double total = std::exp2(double(width)) / 16.0;
        const double nearer = std::sqrt(1.0 - total * total);
        for (size_t place = 0; place < places; ++place) {
            for (uint bin = 0; bin < bins.count; ++bin) {
                rows_[place][bins.base + bin] =
                    float(binAverage(bin * step, (bin + 1) * step,
                                     nearer * double(place) * placeStep, lobeWidth(total, step)));
            }
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
        const float next = at - float(place);
        for (uint i = 0; i < GLINT_ROW; ++i)
            words_[glint_row(0, leaf) + i] =
                (1.0f - next) * rows_[place][i] + next * rows_[place + 1][i];
    }

    void makeParent(uint level, uint entry) {
        const uint first = glint_row(level - 1, entry);
        const uint second = glint_row(level - 1, entry + glint_entries(level));
        for (uint i = 0; i < GLINT_ROW; ++i)
            words_[glint_row(level, entry) + i] =
                0.5f * (words_[first + i] + words_[second + i]);
    }

    std::vector<float> words_;
    std::vector<std::array<float, GLINT_ROW>> rows_;  // of a lobe at each place
};

}  // namespace

const std::vector<float>& glintWords() {
    static const std::vector<float> words = DictionaryMaker().make();
    return words;
}

glm::uvec2 glintDictionary() {
    const auto address = uint64_t(reinterpret_cast<uintptr_t>(glintWords().data()));
    return {uint32_t(address), uint32_t(address >> 32u)};
}

}  // namespace gp
