#include "host_sim/flight_test/signal_value.hpp"

#include <cstdio>

#include "bus/canaerospace/identifier_table.hpp"
#include "host_sim/flight_test/nearest_names.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using bus::BusUnit;
using flight::Signal;

struct KeyUnit {
    BusUnit quantity;
    const char* suffix;
    double factor, offset;
};

constexpr double kFreezingPoint_k = 273.15, kPascalsPerInchOfMercury = 3386.389;

constexpr KeyUnit kKeyUnits[] = {
    {BusUnit::acceleration, "g", base::kStandardGravity, 0},
    {BusUnit::acceleration, "mps2", 1, 0},
    {BusUnit::degree, "deg", base::kRadiansPerDegree, 0},
    {BusUnit::degree, "rad", 1, 0},
    {BusUnit::degree_per_second, "dps", base::kRadiansPerDegree, 0},
    {BusUnit::degree_per_second, "radps", 1, 0},
    {BusUnit::metre, "m", 1, 0},
    {BusUnit::metre, "ft", base::kMetresPerFoot, 0},
    {BusUnit::metre, "km", 1000, 0},
    {BusUnit::metre, "nm", base::kMetresPerNauticalMile, 0},
    {BusUnit::metre_per_second, "mps", 1, 0},
    {BusUnit::metre_per_second, "kt", base::kMpsPerKnot, 0},
    {BusUnit::metre_per_second, "kmh", base::kMpsPerKilometreAnHour, 0},
    {BusUnit::metre_per_second, "fpm", base::kMpsPerFootPerMinute, 0},
    {BusUnit::kelvin, "k", 1, 0},
    {BusUnit::kelvin, "c", 1, kFreezingPoint_k},
    {BusUnit::pressure, "hpa", base::kPascalsPerHectopascal, 0},
    {BusUnit::pressure, "pa", 1, 0},
    {BusUnit::pressure, "inhg", kPascalsPerInchOfMercury, 0},
};

struct SignalGroup {
    const char* name;
    std::vector<Signal> signals;
};

const std::vector<SignalGroup>& signal_groups() {
    static const std::vector<SignalGroup> kGroups = {
        {"position", {Signal::latitude, Signal::longitude, Signal::ellipsoid_height}},
        {"motion", {Signal::ground_speed, Signal::true_track, Signal::vertical_speed}},
        {"attitude", {Signal::pitch, Signal::roll}},
        {"heading", {Signal::true_heading, Signal::magnetic_heading}},
        {"airspeed", {Signal::indicated_airspeed, Signal::true_airspeed, Signal::calibrated_airspeed}},
        {"altitude", {Signal::baro_altitude, Signal::standard_altitude, Signal::true_altitude}},
    };
    return kGroups;
}

bool is_on_bus(Signal signal) { return bus::place_of_signal(signal) != bus::kNotInTable; }

BusUnit quantity_of(Signal signal) { return bus::entry_at(bus::place_of_signal(signal)).unit; }

bool has_key_unit(BusUnit quantity) {
    for (const KeyUnit& unit : kKeyUnits)
        if (unit.quantity == quantity) return true;
    return false;
}

/// "pitch_deg or pitch_rad".
std::string keys_of(Signal signal) {
    const std::string name = flight::to_string(signal);
    std::string keys;
    for (const KeyUnit& unit : kKeyUnits)
        if (unit.quantity == quantity_of(signal)) keys += (keys.empty() ? "" : " or ") + name + "_" + unit.suffix;
    return keys.empty() ? name : keys;
}

std::string_view name_before_unit(std::string_view key) { return key.substr(0, key.rfind('_')); }

/// The signal whose name is the whole key, or all before its last underscore.
Signal signal_of_key(std::string_view key) {
    const Signal whole = flight::signal_from_name(key);
    return whole != Signal::count_ ? whole : flight::signal_from_name(name_before_unit(key));
}

}  // namespace

std::vector<std::string> bus_signal_names() {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < flight::kSignalCount; ++n)
        if (is_on_bus(static_cast<Signal>(n))) names.emplace_back(flight::to_string(static_cast<Signal>(n)));
    return names;
}

std::optional<StatedSignalUnit> read_signal_key(std::string_view key, std::string& message) {
    const Signal signal = signal_of_key(key);
    if (signal == Signal::count_ || !is_on_bus(signal)) {
        const std::string_view name = key.find('_') == std::string_view::npos ? key : name_before_unit(key);
        message = "'" + std::string(key) + "' is no signal of the bus; say " + nearest_names(name, bus_signal_names()) +
                  ", with the unit after it";
        return std::nullopt;
    }
    const std::string name = flight::to_string(signal);
    if (!has_key_unit(quantity_of(signal)) && key == name) return StatedSignalUnit{signal, 1, 0};
    for (const KeyUnit& unit : kKeyUnits)
        if (unit.quantity == quantity_of(signal) && key == name + "_" + unit.suffix)
            return StatedSignalUnit{signal, unit.factor, unit.offset};
    const bool has_unit = key.size() > name.size();
    message = has_unit ? std::string(key.substr(name.size() + 1)) + " is no unit of '" + name + "'"
                       : "'" + name + "' does not say the unit";
    message += "; say " + keys_of(signal);
    return std::nullopt;
}

std::string fault_of_value(const std::string& key, const StatedSignalUnit& unit, double number) {
    constexpr double kRounding = 1e-9;  // of the range, as degrees and radians are converted
    const bus::IdentifierEntry& entry = bus::entry_at(bus::place_of_signal(unit.signal));
    const double si = unit.to_si(number), slack = kRounding * (entry.high - entry.low);
    if (si >= entry.low - slack && si <= entry.high + slack) return {};
    char range[80];
    std::snprintf(range, sizeof range, "%.6g to %.6g", (entry.low - unit.offset) / unit.factor,
                  (entry.high - unit.offset) / unit.factor);
    return "'" + key + "' must be " + range + "; other values are refused by their receiver";
}

std::string fault_of_range(const std::string& key, const StatedSignalUnit& unit, double low, double high) {
    const bus::IdentifierEntry& entry = bus::entry_at(bus::place_of_signal(unit.signal));
    if (unit.to_si(high) < entry.low) return fault_of_value(key, unit, high);
    return unit.to_si(low) > entry.high ? fault_of_value(key, unit, low) : "";
}

bool is_direction(Signal signal) {
    constexpr double kFullTurn = 0.99 * 2 * base::kPi;  // no other angle goes so far
    return is_on_bus(signal) && quantity_of(signal) == BusUnit::degree &&
           bus::entry_at(bus::place_of_signal(signal)).high > kFullTurn;
}

std::vector<Signal> signals_named(std::string_view name) {
    for (const SignalGroup& group : signal_groups())
        if (group.name == name) return group.signals;
    const Signal one = flight::signal_from_name(name);
    if (name != "all") return one != Signal::count_ && is_on_bus(one) ? std::vector<Signal>{one} : std::vector<Signal>();
    std::vector<Signal> all;
    for (const std::string& each : bus_signal_names()) all.push_back(flight::signal_from_name(each));
    return all;
}

std::vector<std::string> signal_group_names() {
    std::vector<std::string> names = bus_signal_names();
    for (const SignalGroup& group : signal_groups()) names.emplace_back(group.name);
    names.emplace_back("all");
    return names;
}

}  // namespace tedavis::host_sim
