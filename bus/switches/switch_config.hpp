/// Which GPIO lines select the flight phase, and which pattern of them means which phase (`configs/switches/*.toml`).
///
///     title = "..."            shown in messages
///     code = "one_hot"         what every pattern must obey: one_hot, odd_parity, even_parity or free
///     debounce_ms = 30         a level counts once it has been stable this long, 0..1000 (default 30)
///     settle_ms = 200          impossible patterns are tolerated this long while a knob turns, 0..5000 (default 200)
///     [[line]]                 1..16 of them, in order
///     chip = "panel"           label of the GPIO chip, or its name (gpiochip0)
///     name = "GROUND"          name of the line on that chip; with `offset` a name of your own
///     offset = 4               its number on that chip, where the chip gives its lines no names; absent: found by name
///     active_low = false       a closed switch pulls the line down
///     pull = "none"            bias asked of the kernel: none (leave as it is), off, up, down
///     [[pattern]]              1..32 of them
///     phase = "takeoff.start"  strings of flight/flight_phase.hpp; "unknown" leaves the phase to the other sources
///     high = ["TAKEOFF"]       lines that are active; all others are not
///     [legend]                 absent: the panel does not ask for a legend
///     chip = "panel"           one more line, with the keys of [[line]]; it is no part of the patterns. While it is
///     name = "LEGEND"          active, the whole legend is shown
///
/// Every pattern that is not listed is impossible. Start-up only.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "bus/switches/switch_edge.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/time.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMaxSwitchPatterns = 32;

enum class LinePull : std::uint8_t { none, off, up, down };

struct SwitchLine {
    base::FixedString<63> chip;
    base::FixedString<63> name;
    std::int32_t offset = -1;  ///< number on the chip; negative: the line is found by its name
    bool active_low = false;
    LinePull pull = LinePull::none;
};

struct SwitchPattern {
    std::uint32_t high = 0;  ///< one bit a line
    flight::FlightPhase phase;
};

struct SwitchConfig {
    base::FixedString<95> title;
    base::FixedVector<SwitchLine, kMaxSwitchLines> lines;  ///< the last one asks for the legend where `has_legend_line`
    bool has_legend_line = false;
    base::FixedVector<SwitchPattern, kMaxSwitchPatterns> patterns;
    base::Duration debounce = base::Duration::milliseconds(30);
    base::Duration settle = base::Duration::milliseconds(200);

    /// Bits of all lines.
    [[nodiscard]] std::uint32_t all_lines() const { return (std::uint32_t{1} << lines.size()) - 1; }
    /// Bits of the lines that state the phase.
    [[nodiscard]] std::uint32_t phase_lines() const { return has_legend_line ? all_lines() >> 1u : all_lines(); }
    /// Whether the line of the legend is known to be active.
    [[nodiscard]] bool asks_for_legend(const SwitchLevels& levels) const {
        return has_legend_line && (levels.known & levels.high & ~phase_lines()) != 0;
    }
    /// Returns the index of the line named "chip.name", or lines.size().
    [[nodiscard]] std::size_t find_line(std::string_view full_name) const;
    /// Returns the pattern with exactly these lines of the phase high, or null.
    [[nodiscard]] const SwitchPattern* find_pattern(std::uint32_t high) const;
};
static_assert(std::is_trivially_copyable_v<SwitchConfig>);

/// `name` is the file's name in error messages.
[[nodiscard]] base::Result<SwitchConfig, base::Error> load_switch_config(std::string_view text, std::string_view name);

}  // namespace tedavis::bus
