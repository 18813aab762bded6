// The random numbers of statistical tests: fixed seeds, so that a run can be repeated exactly.
#pragma once

#include <cstdint>

namespace gp {

// Uniform floats in [0, 1) on the grid of 2^-24, all 24 bits random.
// [O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms",
//  PCG-XSH-RR 64/32]
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 1u) { next(); }

    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005ull + 1442695040888963407ull;
        const auto mixed = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
        const auto turn = static_cast<std::uint32_t>(old >> 59u);
        return (mixed >> turn) | (mixed << ((32u - turn) & 31u));
    }

    float uniform() { return static_cast<float>(next() >> 8u) * 0x1p-24f; }

private:
    std::uint64_t state_;
};

}  // namespace gp
