// A model's values at the cells of a MERL file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "merl_format.h"
#include "reflectance.h"

namespace gp::tool {

class MerlTable {
public:
    // Of an anisotropic model. A lobe narrower than a tenth of a turn shows as steps.
    static constexpr std::size_t azimuths = 32;

    // Finds out what the model is by some thousand values. Throws RunError.
    MerlTable(GpDevice device, const Bsdf& bsdf);

    bool isAnisotropic() const { return m_anisotropic; }
    bool isReciprocal() const { return m_reciprocal; }

    // The bytes of the file; `progress` gets the part that is done. Throws RunError.
    std::string file(const std::function<void(double)>& progress) const;

private:
    using Pairs = std::vector<DirectionPair>;
    std::vector<GpBsdfValue> evaluate(const Pairs& pairs) const;
    // The sum of differences as a share of the sum.
    double difference(const Pairs& a, const Pairs& b) const;
    void appendPairs(std::size_t cell, Pairs& pairs) const;

    GpDevice m_device;
    const Bsdf& m_bsdf;
    bool m_anisotropic = false;
    bool m_reciprocal = true;
};

}  // namespace gp::tool
