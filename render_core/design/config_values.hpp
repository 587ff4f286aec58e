/// What the readers of design files share: colours, and faults that name their key.
#pragma once

#include <array>
#include <cstddef>
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

/// The key "technique", one of the names of an enumeration's values; absent it stays.
template <class Enum, std::size_t N>
void read_technique(base::ConfigSection& section, const std::array<std::string_view, N>& names, Enum& value) {
    const base::Span<const std::string_view> choices(names.data(), names.size());
    value = static_cast<Enum>(section.choice("technique", choices, static_cast<std::size_t>(value)));
}

}  // namespace tedavis::design
