#include "view/time_history.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gp::tool::view {

void TimeHistory::add(double seconds) {
    if (m_milliseconds.size() == kLongest) {
        m_milliseconds.erase(m_milliseconds.begin());
    }
    m_milliseconds.push_back(static_cast<float>(1000.0 * seconds));
}

double TimeHistory::mean() const {
    if (m_milliseconds.empty()) {
        return 0;
    }
    return std::accumulate(m_milliseconds.begin(), m_milliseconds.end(), 0.0) /
           static_cast<double>(m_milliseconds.size());
}

double TimeHistory::percentile(double p) const {
    if (m_milliseconds.empty()) {
        return 0;
    }
    std::vector<float> sorted = m_milliseconds;
    std::sort(sorted.begin(), sorted.end());
    // The nearest rank: a time that there was, not one between two.
    const double rank = std::ceil(p / 100.0 * static_cast<double>(sorted.size()));
    const auto index = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
    return sorted[std::min(index, sorted.size() - 1)];
}

}  // namespace gp::tool::view
