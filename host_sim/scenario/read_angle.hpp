/// Reads angles of scenario files in degrees and returns radians.
#pragma once

#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

[[nodiscard]] inline double read_angle(base::ConfigSection& section, std::string_view key, double low_deg, double high_deg) {
    return base::radians(section.number(key, low_deg, high_deg));
}

}  // namespace tedavis::host_sim
