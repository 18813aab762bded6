// The last frame times, and what to say of them.
#pragma once

#include <cstddef>
#include <vector>

namespace gp::tool::view {

class TimeHistory {
public:
    static constexpr std::size_t kLongest = 120;

    void add(double seconds);
    // Milliseconds, oldest first: what a plot wants.
    const std::vector<float>& milliseconds() const { return m_milliseconds; }
    double mean() const;              // milliseconds; 0 without any
    double percentile(double p) const;  // of 0..100, milliseconds; 0 without any

private:
    std::vector<float> m_milliseconds;
};

}  // namespace gp::tool::view
