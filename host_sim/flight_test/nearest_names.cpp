#include "host_sim/flight_test/nearest_names.hpp"

#include <algorithm>
#include <numeric>

namespace tedavis::host_sim {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), row;
    std::iota(before.begin(), before.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        row.assign(1, i + 1);
        for (std::size_t j = 0; j < b.size(); ++j)
            row.push_back(std::min({before[j] + (a[i] == b[j] ? 0 : 1), row[j] + 1, before[j + 1] + 1}));
        before.swap(row);
    }
    return before.back();
}

namespace {

/// Also to one of the words that a name is made of, as "airsped" to "indicated_airspeed".
std::size_t distance_to_name(std::string_view name, const std::string& other) {
    std::size_t nearest = edit_distance(name, other);
    for (std::size_t begin = 0; begin < other.size();) {
        const std::size_t end = std::min(other.find_first_of("_.", begin), other.size());
        nearest = std::min(nearest, 1 + edit_distance(name, std::string_view(other).substr(begin, end - begin)));
        begin = end + 1;
    }
    return nearest;
}

}  // namespace

std::string nearest_names(std::string_view name, const std::vector<std::string>& names) {
    constexpr std::size_t kShown = 3;
    std::vector<std::string> sorted = names;
    const auto far = [name](const std::string& other) { return distance_to_name(name, other); };
    std::stable_sort(sorted.begin(), sorted.end(), [far](const std::string& a, const std::string& b) { return far(a) < far(b); });
    sorted.resize(std::min(sorted.size(), kShown));
    std::string list;
    for (std::size_t n = 0; n < sorted.size(); ++n) list += (n == 0 ? "" : n + 1 == sorted.size() ? " or " : ", ") + sorted[n];
    return list;
}

}  // namespace tedavis::host_sim
