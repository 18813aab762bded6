// The two ways in which the metrics use several threads. Both give the same bits on any number
// of threads: rows are independent, and sums are taken row by row and then in order.
#pragma once

#include <tbb/parallel_for.h>

#include <cstddef>
#include <vector>

namespace gp::metrics {

template <class Body>
void forEachRow(int rows, const Body& body) {
    tbb::parallel_for(0, rows, [&](int y) { body(y); });
}

// The sum over all rows of body(y). Doubles, since a picture has millions of pixels.
template <class Sum, class Body>
Sum sumOverRows(int rows, const Body& body) {
    std::vector<Sum> sums(static_cast<std::size_t>(rows), Sum(0));
    forEachRow(rows, [&](int y) { sums[static_cast<std::size_t>(y)] = body(y); });
    Sum total(0);
    for (const Sum& sum : sums) {
        total += sum;
    }
    return total;
}

}  // namespace gp::metrics
