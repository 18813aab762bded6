// Pearson's chi-square test of a table of counts, apart from what was counted (grids.h has that).
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "chi2/random.h"

namespace gp {

struct Chi2Options {
    std::string name;              // in messages and in the name of a dumped table
    std::uint64_t seed = 1;
    std::size_t samples = 1'000'000;
    double significance = 0.01;    // of the whole family of tests …
    std::size_t testCount = 1;     // … which has so many members (Sidak's correction)
    std::filesystem::path tableFolder;  // where failed tests leave their tables; empty: nowhere
};

struct Chi2Result {
    bool passed = false;
    double pValue = 0.0;
    double statistic = 0.0;
    std::size_t degrees = 0;
    double pdfIntegral = 0.0;       // of the density over the tested region
    double acceptedFraction = 0.0;  // of the samples that lie in it
    std::string message;
};

// Q(a, x), the regularised upper incomplete gamma function: a series for small x, Lentz's continued
// fraction for the rest. [Press et al. 2007, "Numerical Recipes", section 6.2]
inline double gammaQ(double a, double x) {
    if (x <= 0.0) return 1.0;
    const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
    if (x < a + 1.0) {
        double term = 1.0 / a;
        double sum = term;
        for (double n = a + 1.0; std::abs(term) > 1e-16 * std::abs(sum); n += 1.0) {
            term *= x / n;
            sum += term;
        }
        return 1.0 - sum * front;
    }
    double b = x + 1.0 - a;
    double c = 1e300;
    double d = 1.0 / b;
    double h = d;
    for (int i = 1; i < 100'000; ++i) {
        const double an = -i * (i - a);
        b += 2.0;
        d = an * d + b;
        if (std::abs(d) < 1e-300) d = 1e-300;
        c = b + an / c;
        if (std::abs(c) < 1e-300) c = 1e-300;
        d = 1.0 / d;
        h *= c * d;
        if (std::abs(c * d - 1.0) < 1e-15) break;
    }
    return front * h;
}

struct Chi2Table {
    std::vector<double> observed;
    std::vector<double> expected;
};

// One line a cell, in the order of the grid: number, observed, expected, standard deviations apart.
inline std::string dumpTable(const Chi2Options& options, const Chi2Table& table) {
    std::string file = options.name;
    for (char& c : file) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    std::filesystem::create_directories(options.tableFolder);
    const std::filesystem::path path = options.tableFolder / (file + ".csv");
    std::ofstream out(path);
    out << "cell,observed,expected,deviation\n";
    for (std::size_t i = 0; i < table.observed.size(); ++i) {
        const double e = table.expected[i];
        const double deviation = e > 0.0 ? (table.observed[i] - e) / std::sqrt(e) : 0.0;
        out << fmt::format("{},{},{:.4f},{:.3f}\n", i, table.observed[i], e, deviation);
    }
    return path.string();
}

// Cells with fewer than five expected counts are pooled, smallest first, as the distribution of
// the statistic is only then that of chi-square.
inline Chi2Result chi2Test(const Chi2Options& options, const Chi2Table& table) {
    constexpr double minimumExpected = 5.0;
    Chi2Result result;
    std::vector<std::size_t> order(table.expected.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return table.expected[a] < table.expected[b];
    });
    double observed = 0.0, expected = 0.0;
    double impossible = 0.0;
    std::size_t groups = 0;
    for (const std::size_t i : order) {
        if (table.expected[i] <= 0.0) impossible += table.observed[i];
        observed += table.observed[i];
        expected += table.expected[i];
        if (expected < minimumExpected) continue;
        const double difference = observed - expected;
        result.statistic += difference * difference / expected;
        observed = expected = 0.0;
        ++groups;
    }
    // Sorted upwards, only a table of nothing but small cells can leave a rest over.
    result.degrees = groups > 0 ? groups - 1 : 0;
    result.pValue = result.degrees > 0
        ? gammaQ(0.5 * static_cast<double>(result.degrees), 0.5 * result.statistic) : 1.0;
    const double tests = static_cast<double>(std::max<std::size_t>(options.testCount, 1));
    const double threshold = 1.0 - std::pow(1.0 - options.significance, 1.0 / tests);
    // Rounding may move a sample over an edge of the support, but only a few in a hundred thousand.
    const bool outside = impossible > 1e-5 * static_cast<double>(options.samples) + 5.0;
    result.passed = result.degrees > 0 && result.pValue >= threshold && !outside;
    result.message = fmt::format(
        "{}: chi2 = {:.1f}, {} degrees of freedom, p = {:.3g} (needed {:.3g}), {} samples where the"
        " density is 0", options.name, result.statistic, result.degrees, result.pValue, threshold,
        impossible);
    if (!result.passed && !options.tableFolder.empty())
        result.message += "; table in " + dumpTable(options, table);
    return result;
}

}  // namespace gp
