// Makes the dictionary of glints (layout: shading/glint/dictionary.glsl).
//
// Every entry draws its own lobes, but the j-th lobes of all entries together lie on all quantiles
// of the normal distribution, in an order shuffled anew for each j. So an entry is as uneven as
// independent draws are, while the mean over entries is normal at every level: with independent
// draws across entries too, that mean is off by 23 % at level 0.
#include "scene/glint_dictionary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>

#include "shading/lang.h"

GP_SHADING_BEGIN
#include "shading/glint/dictionary.glsl"
#include "shading/microfacet/beckmann.glsl"
#include "shading/sampling/hash.glsl"
GP_SHADING_END

namespace gp {
namespace {

using namespace shading;

// Where lobes may lie, in standard deviations: 513 points of [0, 4], a seventh of a lobe apart.
constexpr size_t places = 513;
constexpr double placeStep = double(GLINT_REACH) / (places - 1);
// Quantiles that a lobe may take within its share of 1 / GLINT_ENTRIES.
constexpr uint shifts = 64;

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
    DictionaryMaker() : words_(GLINT_WORDS), lobes_(GLINT_ENTRIES), rows_(places) {}

    std::vector<float> make() {
        makeQuantiles();
        for (uint width = 0; width < 4; ++width) makeWidth(width);
        const GlintBins normal = glint_bins(0, 4);
        const double step = double(GLINT_REACH) / normal.count;
        for (uint bin = 0; bin < normal.count; ++bin) {
            words_[normal.base + bin] =
                float(binAverage(bin * step, (bin + 1) * step, 0.0, lobeWidth(1.0, step)));
        }
        uint lobe = 0;
        for (uint level = 0; level < uint(GLINT_LEVELS); ++level) {
            for (; lobe < (1u << level); ++lobe) addLobe(lobe);
            tbb::parallel_for(0u, GLINT_ENTRIES, [&](uint entry) { makeRow(level, entry); });
        }
        return std::move(words_);
    }

private:
    // Averages over bins and linear reading between them add step^2 / 12 and step^2 / 6.
    static double lobeWidth(double total, double step) {
        return std::sqrt(total * total - 0.25 * step * step);
    }

    // Of |x|, x normal, as places and the share of the next place.
    void makeQuantiles() {
        quantiles_.resize(size_t(GLINT_ENTRIES) * shifts);
        for (size_t i = 0; i < quantiles_.size(); ++i) {
            const double p = (double(i) + 0.5) / double(quantiles_.size());
            quantiles_[i] =
                std::min(float(M_SQRT2 / placeStep) * erf_inverse(float(p)), float(places) - 1.01f);
        }
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

    // The lobe of this number in all entries: one quantile each. [Fisher and Yates]
    void addLobe(uint lobe) {
        std::array<uint, GLINT_ENTRIES> order;
        std::iota(order.begin(), order.end(), 0u);
        for (uint i = GLINT_ENTRIES - 1; i > 0; --i)
            std::swap(order[i], order[hash_u32(lobe * GLINT_ENTRIES + i) % (i + 1)]);
        // The lobes that a level adds to the one before take all shifts alike.
        const uint block = std::max(std::bit_floor(lobe), 1u);
        const uint shift = (2 * (lobe % block) + 1) * (shifts / 2) / block % shifts;
        for (uint entry = 0; entry < GLINT_ENTRIES; ++entry) {
            const float at = quantiles_[order[entry] * shifts + shift];
            const auto place = size_t(at);
            lobes_[entry][place] += 1.0f - (at - float(place));
            lobes_[entry][place + 1] += at - float(place);
        }
    }

    void makeRow(uint level, uint entry) {
        std::array<float, GLINT_ROW> row{};
        const float share = std::ldexp(1.0f, -int(level));
        for (size_t place = 0; place < places; ++place) {
            const float weight = share * lobes_[entry][place];
            if (weight == 0.0f) continue;
            for (size_t i = 0; i < GLINT_ROW; ++i) row[i] += weight * rows_[place][i];
        }
        std::copy(row.begin(), row.end(),
                  words_.begin() + (level * GLINT_ENTRIES + entry) * GLINT_ROW);
    }

    std::vector<float> words_;
    std::vector<float> quantiles_;
    std::vector<std::array<float, places>> lobes_;     // of each entry so far, by place
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
