#include "bus/canaerospace/stated_messages.hpp"

#include <algorithm>
#include <cmath>

#include "bus/canaerospace/identifier_table.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::bus {
namespace {

using base::ConfigSection;
using flight::Signal;

constexpr std::int64_t kFirstIdentifier = 200, kLastIdentifier = 1999;  // neither emergency events nor node services
constexpr double kMaxFactor = 1e9;
constexpr double kMinPeriod_s = 0.001, kMaxPeriod_s = 60;
constexpr double kShortestStale_s = 0.3;  // as the standard's quickest signals: a display of 10 Hz must not flicker

struct StatedUnit {
    std::string_view name;
    BusUnit quantity;
    double factor, offset;  ///< SI = number * factor + offset
};

constexpr double kPascalsPerInchOfMercury = 3386.389;  // 25.4 mm of mercury at 0 degrees Celsius
constexpr double kZeroCelsius_k = 273.15;

/// The first of a quantity is the standard's.
constexpr StatedUnit kUnits[] = {
    {"m", BusUnit::metre, 1, 0},
    {"ft", BusUnit::metre, base::kMetresPerFoot, 0},
    {"km", BusUnit::metre, 1000, 0},
    {"NM", BusUnit::metre, base::kMetresPerNauticalMile, 0},
    {"m/s", BusUnit::metre_per_second, 1, 0},
    {"kt", BusUnit::metre_per_second, base::kMpsPerKnot, 0},
    {"km/h", BusUnit::metre_per_second, base::kMpsPerKilometreAnHour, 0},
    {"ft/min", BusUnit::metre_per_second, base::kMpsPerFootPerMinute, 0},
    {"deg", BusUnit::degree, base::kRadiansPerDegree, 0},
    {"rad", BusUnit::degree, 1, 0},
    {"deg/s", BusUnit::degree_per_second, base::kRadiansPerDegree, 0},
    {"rad/s", BusUnit::degree_per_second, 1, 0},
    {"K", BusUnit::kelvin, 1, 0},
    {"degC", BusUnit::kelvin, 1, kZeroCelsius_k},
    {"hPa", BusUnit::pressure, base::kPascalsPerHectopascal, 0},
    {"Pa", BusUnit::pressure, 1, 0},
    {"inHg", BusUnit::pressure, kPascalsPerInchOfMercury, 0},
    {"g", BusUnit::acceleration, base::kStandardGravity, 0},
    {"m/s2", BusUnit::acceleration, 1, 0},
    {"1", BusUnit::none, 1, 0},
    {"%", BusUnit::none, 0.01, 0},
};

struct NumberType {
    std::string_view name;
    DataType type;
};
constexpr NumberType kTypes[] = {
    {"FLOAT", DataType::float32}, {"SHORT2", DataType::short16x2}, {"LONG", DataType::long32}, {"ULONG", DataType::ulong32},
    {"SHORT", DataType::short16}, {"USHORT", DataType::ushort16},  {"CHAR", DataType::char8},  {"UCHAR", DataType::uchar8},
};

DataType read_type(ConfigSection& table) {
    const std::string_view name = table.text("type", kTypes[0].name);
    for (const NumberType& one : kTypes)
        if (one.name == name) return one.type;
    table.fault("type", "'type' must be one of: FLOAT, SHORT2, LONG, ULONG, SHORT, USHORT, CHAR, UCHAR");
    return DataType::float32;
}

StatedUnit read_unit(ConfigSection& table, BusUnit quantity) {
    const auto is_of_quantity = [&](const StatedUnit& unit) { return unit.quantity == quantity; };
    const StatedUnit* const standard = std::find_if(std::begin(kUnits), std::end(kUnits), is_of_quantity);
    const std::string_view name = table.text("unit", standard->name);
    base::FixedString<159> known("'unit' must be one of:");
    for (const StatedUnit& unit : kUnits) {
        if (!is_of_quantity(unit)) continue;
        if (unit.name == name) return unit;
        known.append(" ");
        known.append(unit.name);
    }
    table.fault("unit", known.view());
    return *standard;
}

/// A signal that the standard's table or guidance states, and so has a unit and a plausible range.
Signal read_signal(ConfigSection& table) {
    const Signal signal = flight::signal_from_name(table.text("signal"));
    if (signal != Signal::count_ && place_of_signal(signal) != kNotInTable) return signal;
    table.fault("signal",
                "no such signal on the bus; choose one of those listed under [freshness] in configs/buses/canaerospace.toml");
    return Signal::count_;
}

/// Ten periods, at most a second, but at least three periods and 0.3 s; lost after three times as long.
void read_period(ConfigSection& table, StatedMessage& message) {
    message.states_period = table.has("period_s");
    if (!message.states_period) return;
    const double period_s = table.number("period_s", kMinPeriod_s, kMaxPeriod_s);
    const double stale_s = std::max({3 * period_s, std::min(10 * period_s, 1.0), kShortestStale_s});
    message.limits = {base::Duration::from_seconds(stale_s), base::Duration::from_seconds(3 * stale_s)};
}

StatedMessage read_message(ConfigSection table) {
    StatedMessage message;
    message.signal = read_signal(table);
    message.identifier = static_cast<std::uint16_t>(table.integer("identifier", kFirstIdentifier, kLastIdentifier));
    message.type = read_type(table);
    const double scale = table.number("scale", -kMaxFactor, kMaxFactor, 1),
                 offset = table.number("offset", -kMaxFactor, kMaxFactor, 0);
    if (scale == 0) table.fault("scale", "'scale' must not be 0, which makes every number the same; leave it out or correct it");
    if (message.signal != Signal::count_) {
        const StatedUnit unit = read_unit(table, entry_at(place_of_signal(message.signal)).unit);
        message.factor = scale * unit.factor;
        message.offset = offset * unit.factor + unit.offset;
    }
    read_period(table, message);
    return message;
}

}  // namespace

const StatedMessage* find_message(const StatedMessages& messages, std::uint16_t identifier) noexcept {
    for (const StatedMessage& message : messages)
        if (message.identifier == identifier) return &message;
    return nullptr;
}

bool is_stated(const StatedMessages& messages, Signal signal) noexcept {
    return std::any_of(messages.begin(), messages.end(), [&](const StatedMessage& message) { return message.signal == signal; });
}

StatedMessages read_stated_messages(ConfigSection& root, std::string_view (*is_taken)(std::uint16_t, const void*),
                                    const void* context) {
    StatedMessages messages;
    for (std::size_t n = 0; n < root.table_count("message"); ++n) {
        ConfigSection table = root.table_at("message", n);
        const StatedMessage message = read_message(table);
        const std::string_view taken = is_taken(message.identifier, context);
        base::FixedString<159> fault;
        if (!taken.empty())
            for (const std::string_view part :
                 {std::string_view("this identifier states "), taken, std::string_view(" already; choose another")})
                fault.append(part);
        else if (find_message(messages, message.identifier) != nullptr)
            fault.append("another [[message]] has this identifier; give each its own");
        if (!fault.empty()) table.fault("identifier", fault.view());
        if (message.signal != Signal::count_ && is_stated(messages, message.signal))
            table.fault("signal", "another [[message]] states this signal; keep one of them");
        if (!messages.try_push_back(message)) {
            table.fault("identifier", "a bus file has at most 16 [[message]] tables; remove some");
            break;
        }
    }
    return messages;
}

}  // namespace tedavis::bus
