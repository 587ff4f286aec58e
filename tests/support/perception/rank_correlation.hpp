/// Spearman's: the correlation of two lists' ranks, equal values sharing their mean rank.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace tedavis::test_support {

template <class Values>
std::vector<double> ranks_of(const Values& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> ranks(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && !(values[order[first]] < values[order[end]])) ++end;
        for (std::size_t n = first; n < end; ++n) ranks[order[n]] = 0.5 * static_cast<double>(first + end - 1);
        first = end;
    }
    return ranks;
}

/// -1..1; 0 where one of them is constant.
template <class One, class Other>
double rank_correlation(const One& one, const Other& other) {
    const std::vector<double> a = ranks_of(one), b = ranks_of(other);
    const double mean = 0.5 * static_cast<double>(a.size() - 1);
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        ab += (a[n] - mean) * (b[n] - mean);
        aa += (a[n] - mean) * (a[n] - mean);
        bb += (b[n] - mean) * (b[n] - mean);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

}  // namespace tedavis::test_support
