/// Signals as a tester states them: name and unit in the key, "indicated_airspeed_kt = 90".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render_core/flight/signal.hpp"

namespace tedavis::host_sim {

/// A signal and the unit in which a number states it: SI = number * factor + offset.
struct StatedSignalUnit {
    flight::Signal signal = flight::Signal::count_;
    double factor = 1, offset = 0;

    [[nodiscard]] double to_si(double number) const { return number * factor + offset; }
};

/// Names of all signals that the bus can send.
[[nodiscard]] std::vector<std::string> bus_signal_names();

/// Reads a key such as "pitch_deg". Signals without a unit (flaps, navigation source) have no suffix. Returns nothing for an
/// unknown key; `message` then states the fault and the most similar names.
[[nodiscard]] std::optional<StatedSignalUnit> read_signal_key(std::string_view key, std::string& message);

/// Returns the fault of a value, "'pitch_deg' must be -90 to 90"; empty where the bus can send the value and the receiver accepts
/// it.
[[nodiscard]] std::string fault_of_value(const std::string& key, const StatedSignalUnit& unit, double number);
/// The same for a range in which no value from `low` to `high` is possible.
[[nodiscard]] std::string fault_of_range(const std::string& key, const StatedSignalUnit& unit, double low, double high);
/// Whether the signal is an angle that wraps at 360 degrees.
[[nodiscard]] bool is_direction(flight::Signal signal);

/// Returns the signals of a name: one signal, or a group such as "position", "attitude" or "all"; empty for an unknown name.
[[nodiscard]] std::vector<flight::Signal> signals_named(std::string_view name);
/// Names that signals_named() knows.
[[nodiscard]] std::vector<std::string> signal_group_names();

}  // namespace tedavis::host_sim
