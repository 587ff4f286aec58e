/// What the readers of design files share: colours, and faults that name their key.
#pragma once

#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/design/color.hpp"

namespace tedavis::design {

/// Reports the fault "'key' what" at this key's line.
void fault_of(base::ConfigSection& section, std::string_view key, std::string_view what);
/// Black after a fault.
[[nodiscard]] Color required_color(base::ConfigSection& section, std::string_view key);

/// Absent it stays.
void read_color(base::ConfigSection& section, std::string_view key, Color& color);

}  // namespace tedavis::design
