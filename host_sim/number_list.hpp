/// Numbers in one word of the command line: "9.6,46.5,10.2,47.1", "1024x768".
#pragma once

#include <string_view>
#include <vector>

namespace tedavis::host_sim {

/// Decimal numbers between separators, independent of the locale. Empty when any part is not exactly one finite number.
[[nodiscard]] std::vector<double> parse_number_list(std::string_view text, char separator);

}  // namespace tedavis::host_sim
