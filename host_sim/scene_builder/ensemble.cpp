#include "host_sim/scene_builder/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tedavis::host_sim {
namespace {

bool all_have(const Members& members, std::size_t post) {
    return std::none_of(members.begin(), members.end(), [post](const std::vector<float>& m) { return std::isnan(m[post]); });
}

}  // namespace

EnsembleMean mean_of(const Members& members) {
    EnsembleMean joined;
    const std::size_t posts = members.front().size();
    joined.mean.resize(posts);
    joined.spread.resize(posts);
    for (std::size_t n = 0; n < posts; ++n) {
        double sum = 0, squares = 0;
        for (const std::vector<float>& member : members) sum += double{member[n]};
        const auto count = static_cast<double>(members.size()), mean = sum / count;
        for (const std::vector<float>& member : members) squares += (double{member[n]} - mean) * (double{member[n]} - mean);
        joined.mean[n] = static_cast<float>(mean);
        joined.spread[n] = static_cast<float>(std::sqrt(squares / (count - 1)));  // of one: 0 / 0
    }
    return joined;
}

void add_to_sums(const Members& members, std::vector<double>& sums) {
    sums.resize(members.size());
    for (std::size_t post = 0; post < members.front().size(); ++post) {
        if (!all_have(members, post)) continue;
        for (std::size_t n = 0; n < members.size(); ++n) sums[n] += double{members[n][post]};
    }
}

std::vector<std::size_t> evenly_by_rank(const std::vector<double>& sums, std::size_t most) {
    std::vector<std::size_t> order(sums.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sums[a] < sums[b]; });
    if (order.size() <= most) return order;
    std::vector<std::size_t> kept;
    for (std::size_t n = 0; n < most; ++n) kept.push_back(order[(2 * n * (order.size() - 1) + most - 1) / (2 * (most - 1))]);
    return kept;
}

}  // namespace tedavis::host_sim
