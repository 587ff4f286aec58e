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

/// Names of all signals that the bus carries.
[[nodiscard]] std::vector<std::string> bus_signal_names();

/// Reads "pitch_deg". Signals without a unit (flaps, navigation source) have no suffix. Nothing for another key: `message` then
/// says what is wrong, with the nearest names.
[[nodiscard]] std::optional<StatedSignalUnit> read_signal_key(std::string_view key, std::string& message);

/// What is wrong with a value that a key states: "'pitch_deg' must be -90 to 90". Empty where the bus can carry it and its
/// receiver takes it.
[[nodiscard]] std::string fault_of_value(const std::string& key, const StatedSignalUnit& unit, double number);
/// Directions start again at 360 degrees.
[[nodiscard]] bool is_direction(flight::Signal signal);

/// Signals of a name: a signal, or a group of them such as "position", "attitude" or "all"; empty for another name.
[[nodiscard]] std::vector<flight::Signal> signals_named(std::string_view name);
/// Names that signals_named() knows.
[[nodiscard]] std::vector<std::string> signal_group_names();

}  // namespace tedavis::host_sim
