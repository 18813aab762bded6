// Repeated measurements and what the process's clocks say.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

#include <nlohmann/json.hpp>

namespace gp::bench {

inline double median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v.size() % 2 ? v[v.size() / 2] : 0.5 * (v[v.size() / 2 - 1] + v[v.size() / 2]);
}

struct Spread {
    std::vector<double> values;

    void add(double value) { values.push_back(value); }
    double last() const { return values.back(); }
    nlohmann::ordered_json json() const {
        const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
        return {{"median", median(values)}, {"least", *lo}, {"most", *hi}, {"runs", values.size()}};
    }
};

// Seconds on the wall, and seconds that the process's threads computed: the latter hardly notice
// what else the machine does.
class Stopwatch {
public:
    double wall() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    double core() const { return cpuSeconds() - cpuStart_; }

private:
    static double cpuSeconds() {
        timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
    }
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double cpuStart_ = cpuSeconds();
};

}  // namespace gp::bench
