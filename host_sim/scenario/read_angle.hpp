/// Reads angles of scenario files in degrees and returns radians.
#pragma once

#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

/// The key is required. Limits are in degrees; a value outside them is a fault of the section.
[[nodiscard]] inline double read_angle(base::ConfigSection& section, std::string_view key, double low_deg, double high_deg) {
    return base::radians(section.number(key, low_deg, high_deg));
}

/// Returns `fallback_rad` if the key is absent.
[[nodiscard]] inline double read_angle(base::ConfigSection& section, std::string_view key, double low_deg, double high_deg,
                                       double fallback_rad) {
    return section.has(key) ? read_angle(section, key, low_deg, high_deg) : fallback_rad;
}

}  // namespace tedavis::host_sim
