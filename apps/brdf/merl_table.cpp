#include "brdf/merl_table.h"

#include <cmath>

namespace gp::tool {
namespace {

constexpr std::size_t kBatch = std::size_t{1} << 16;
// A prime number of cells apart, so that the probes have all angles.
constexpr std::size_t kProbeStep = 997;
// Rounding gives a narrow lobe differences of a thousandth.
constexpr double kSame = 0.01;

DirectionPair reversed(const DirectionPair& pair) { return {pair.wo, pair.wi}; }

}  // namespace

MerlTable::MerlTable(GpDevice device, const Bsdf& bsdf) : m_device(device), m_bsdf(bsdf) {
    Pairs at, turned, back;
    for (std::size_t cell = 0; cell < merl::cellCount; cell += kProbeStep) {
        const DirectionPair pair = merl::directionsOf(cell, 0.0);
        if (!pair.aboveHorizon()) {
            continue;
        }
        at.push_back(pair);
        turned.push_back(merl::directionsOf(cell, static_cast<double>(1 + cell % 5)));
        back.push_back(reversed(pair));
    }
    m_anisotropic = difference(at, turned) > kSame;
    m_reciprocal = difference(at, back) <= kSame;
}

std::vector<GpBsdfValue> MerlTable::evaluate(const Pairs& pairs) const {
    std::vector<glm::vec3> wi, wo;
    for (const DirectionPair& pair : pairs) {
        wi.emplace_back(pair.wi);
        wo.emplace_back(pair.wo);
    }
    return tool::evaluate(m_device, m_bsdf, wi, wo);
}

double MerlTable::difference(const Pairs& a, const Pairs& b) const {
    const std::vector<GpBsdfValue> first = evaluate(a), second = evaluate(b);
    double differences = 0, sum = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = first[i].f[c], y = second[i].f[c];
            differences += std::abs(x - y);
            sum += 0.5 * (x + y);
        }
    }
    return sum > 0 ? differences / sum : 0;
}

// What a cell is the mean of: nothing where it is below the horizon.
void MerlTable::appendPairs(std::size_t cell, Pairs& pairs) const {
    if (!merl::directionsOf(cell, 0.0).aboveHorizon()) {
        return;
    }
    const std::size_t count = m_anisotropic ? azimuths : 1;
    for (std::size_t k = 0; k < count; ++k) {
        const double turns = static_cast<double>(k) / static_cast<double>(count);
        const DirectionPair pair = merl::directionsOf(cell, 2.0 * M_PI * turns);
        pairs.push_back(pair);
        if (!m_reciprocal) {
            pairs.push_back(reversed(pair));
        }
    }
}

std::string MerlTable::file(const std::function<void(double)>& progress) const {
    std::vector<float> cells(3 * merl::cellCount, -1.0f);
    for (std::size_t begin = 0; begin < merl::cellCount;) {
        Pairs pairs;
        std::vector<std::size_t> ends;  // behind each cell's pairs
        while (begin + ends.size() < merl::cellCount && pairs.size() < kBatch) {
            appendPairs(begin + ends.size(), pairs);
            ends.push_back(pairs.size());
        }
        const std::vector<GpBsdfValue> values = evaluate(pairs);
        for (std::size_t i = 0, k = 0; i < ends.size(); k = ends[i++]) {
            if (k == ends[i]) {
                continue;
            }
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (std::size_t j = k; j < ends[i]; ++j) {
                    sum += values[j].f[c];
                }
                cells[3 * (begin + i) + c] =
                    static_cast<float>(sum / static_cast<double>(ends[i] - k));
            }
        }
        begin += ends.size();
        progress(static_cast<double>(begin) / static_cast<double>(merl::cellCount));
    }
    return merl::fileOf(cells);
}

}  // namespace gp::tool
