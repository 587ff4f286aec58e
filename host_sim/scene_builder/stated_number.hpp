/// Numbers and instants in the fields of features.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tedavis::host_sim {

/// Parses a text that is one finite number, in decimals or with an exponent, with optional spaces around it; nothing for others.
[[nodiscard]] std::optional<double> stated_number(std::string_view text);
/// ISO 8601, the form of GDAL ("2020/04/12 09:47:00+00"), or seconds since 1970 UTC.
[[nodiscard]] std::optional<std::int64_t> stated_instant_ns(std::string_view text);

}  // namespace tedavis::host_sim
