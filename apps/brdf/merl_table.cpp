#include "brdf/merl_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "tool_error.h"

namespace gp::tool {
namespace {

constexpr std::size_t kBatch = std::size_t{1} << 16;
// A prime number of cells apart, so that the probes have all angles.
constexpr std::size_t kProbeStep = 997;
// Rounding gives a narrow lobe differences of a thousandth.
constexpr double kSame = 0.01;

bool isAbove(const merl::DirectionPair& pair) { return pair.wi.z > 0.0 && pair.wo.z > 0.0; }

merl::DirectionPair reversed(const merl::DirectionPair& pair) { return {pair.wo, pair.wi}; }

void append(std::vector<float>& list, const glm::dvec3& d) {
    for (int i = 0; i < 3; ++i) {
        list.push_back(static_cast<float>(d[i]));
    }
}

}  // namespace

MerlTable::MerlTable(GpDevice device, const Bsdf& bsdf) : m_device(device), m_bsdf(bsdf) {
    Pairs at, turned, back;
    for (std::size_t cell = 0; cell < merl::cellCount; cell += kProbeStep) {
        const merl::DirectionPair pair = merl::directionsOf(cell, 0.0);
        if (!isAbove(pair)) {
            continue;
        }
        at.push_back(pair);
        turned.push_back(merl::directionsOf(cell, static_cast<double>(1 + cell % 5)));
        back.push_back(reversed(pair));
    }
    m_anisotropic = difference(at, turned) > kSame;
    m_reciprocal = difference(at, back) <= kSame;
}

std::vector<glm::dvec3> MerlTable::evaluate(const Pairs& pairs) const {
    std::vector<float> wi, wo;
    for (const merl::DirectionPair& pair : pairs) {
        append(wi, pair.wi);
        append(wo, pair.wo);
    }
    std::vector<GpBsdfValue> values(pairs.size());
    check(m_device,
          gpEvaluateBsdf(m_bsdf.get(), pairs.size(), wi.data(), wo.data(), values.data()));
    std::vector<glm::dvec3> f;
    for (const GpBsdfValue& value : values) {
        f.emplace_back(value.f[0], value.f[1], value.f[2]);
    }
    return f;
}

double MerlTable::difference(const Pairs& a, const Pairs& b) const {
    const std::vector<glm::dvec3> first = evaluate(a), second = evaluate(b);
    double differences = 0, sum = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        const glm::dvec3 apart = glm::abs(first[i] - second[i]);
        const glm::dvec3 both = 0.5 * (first[i] + second[i]);
        differences += apart.x + apart.y + apart.z;
        sum += both.x + both.y + both.z;
    }
    return sum > 0 ? differences / sum : 0;
}

// What a cell is the mean of: nothing where it is below the horizon.
void MerlTable::appendPairs(std::size_t cell, Pairs& pairs) const {
    if (!isAbove(merl::directionsOf(cell, 0.0))) {
        return;
    }
    const std::size_t count = m_anisotropic ? azimuths : 1;
    for (std::size_t k = 0; k < count; ++k) {
        const double turns = static_cast<double>(k) / static_cast<double>(count);
        const merl::DirectionPair pair = merl::directionsOf(cell, 2.0 * M_PI * turns);
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
        const std::vector<glm::dvec3> f = evaluate(pairs);
        for (std::size_t i = 0, k = 0; i < ends.size(); k = ends[i++]) {
            if (k == ends[i]) {
                continue;
            }
            glm::dvec3 sum(0);
            for (std::size_t j = k; j < ends[i]; ++j) {
                sum += f[j];
            }
            for (std::size_t c = 0; c < 3; ++c) {
                const double mean = sum[static_cast<int>(c)] / static_cast<double>(ends[i] - k);
                cells[3 * (begin + i) + c] = static_cast<float>(mean);
            }
        }
        begin += ends.size();
        progress(static_cast<double>(begin) / static_cast<double>(merl::cellCount));
    }
    return merl::fileOf(cells);
}

}  // namespace gp::tool
