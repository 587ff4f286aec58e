/// Helpers of the readers of design files: colours, and faults that name their key.
#pragma once

#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/design/color.hpp"

namespace tedavis::design {

/// Reports the fault "'key' what" at this key's line.
void fault_of(base::ConfigSection& section, std::string_view key, std::string_view what);
/// Reads a colour that must be there; returns black after a fault.
[[nodiscard]] Color required_color(base::ConfigSection& section, std::string_view key);

/// Reads a colour; if the key is absent, `color` is unchanged.
void read_color(base::ConfigSection& section, std::string_view key, Color& color);

}  // namespace tedavis::design
