#include "host_sim/number_list.hpp"

#include <charconv>
#include <cmath>

namespace tedavis::host_sim {

std::vector<double> parse_number_list(std::string_view text, char separator) {
    std::vector<double> numbers;
    for (bool more = true; more;) {
        const std::size_t end = text.find(separator);
        more = end != std::string_view::npos;
        const std::string_view part = text.substr(0, end);
        double number = 0;
        const auto read = std::from_chars(part.data(), part.data() + part.size(), number);
        if (read.ec != std::errc() || read.ptr != part.data() + part.size() || !std::isfinite(number)) return {};
        numbers.push_back(number);
        if (more) text.remove_prefix(end + 1);
    }
    return numbers;
}

}  // namespace tedavis::host_sim
