/// The part of the default identifier distribution of CANaerospace 1.7 (section 5) that a display needs: name, unit, sign,
/// accepted data types, plausible range, and the signal of the core that receives the value.
///
/// Numbers are decimal because the standard's hexadecimal column is off by one from 1095 on. The standard's rate table
/// prints 1030 for the GPS height; 1038 (section 5.7) is meant. Signs follow ISO 1151-1/-2.
#pragma once

#include <cstdint>
#include <type_traits>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/canaerospace/data_type.hpp"
#include "render_core/base/span.hpp"
#include "render_core/flight/signal.hpp"

namespace tedavis::bus {

/// The unit on the bus.
enum class BusUnit : std::uint8_t {
    none,
    acceleration,
    degree,
    degree_per_second,
    metre,
    metre_per_second,
    kelvin,
    pressure,
    bits,
    time_of_day,
    date,
};
/// Returns "deg", "m/s", ...: the unit of the standard, also where the bus file selects another dialect.
[[nodiscard]] const char* to_string(BusUnit unit) noexcept;

/// Where several identifiers state one signal, rank 0 is preferred.
inline constexpr std::uint8_t kMaxRanks = 3;

struct IdentifierEntry {
    std::uint16_t identifier;
    const char* name;
    BusUnit unit;
    std::uint32_t types;    ///< bit n: data type n is accepted
    flight::Signal signal;  ///< count_: decoded, but not a signal of the core
    std::uint8_t rank;
    bool service_code_is_index;  ///< waypoints: the service code is their number, not a status
    bool glider_profile;         ///< not in the standard; known only if the bus file says so
    double low, high;            ///< plausible range in SI, after decoding; values outside are refused
};

[[nodiscard]] base::Span<const IdentifierEntry> identifier_table() noexcept;
inline constexpr std::uint16_t kNotInTable = 0xFFFF;
/// Returns the identifier's index in the table, or kNotInTable.
[[nodiscard]] std::uint16_t identifier_index(std::uint16_t identifier) noexcept;

/// Guidance, for which the standard has no identifiers: this project's own profile in the user-defined ones, specified in
/// configs/buses/README.md. The `identifier` of a row is its distance from the bus file's first one. A message without data
/// states that nothing is selected.
[[nodiscard]] base::Span<const IdentifierEntry> guidance_table() noexcept;

/// Numbers the identifiers that a bus knows, those of the standard first and then those of guidance: 0 .. kMaxPlaces - 1, or
/// kNotInTable.
inline constexpr std::uint16_t kMaxPlaces = 126;
[[nodiscard]] std::uint16_t place_of(std::uint16_t identifier, const GuidanceSettings& guidance) noexcept;
/// The place of the preferred identifier of a signal, or kNotInTable for signals that no identifier states.
[[nodiscard]] std::uint16_t place_of_signal(flight::Signal signal) noexcept;
/// Returns the row of a place; `place` must come from place_of().
[[nodiscard]] const IdentifierEntry& entry_at(std::uint16_t place) noexcept;
[[nodiscard]] std::uint16_t place_count() noexcept;
[[nodiscard]] constexpr std::uint32_t type_bit(DataType type) { return std::uint32_t{1} << static_cast<unsigned>(type); }

enum class AngleRange : std::uint8_t { as_is, heading, longitude };

/// True for latitudes and longitudes, which may arrive as a pair of DOUBLE halves, and in one dialect as LONG in 1e-7 degrees.
[[nodiscard]] constexpr bool is_position(const IdentifierEntry& entry) {
    return (entry.types & type_bit(DataType::double_high)) != 0;
}
inline constexpr double kDegreesPerLongUnit = 1e-7;

/// How this bus's dialect turns an entry's number into the core's value: SI = number * factor + offset, then wrapped.
struct SignalBinding {
    flight::Signal signal = flight::Signal::count_;
    std::uint8_t rank = 0;
    AngleRange range = AngleRange::as_is;
    double factor = 1;
    double offset = 0;
    bool is_magnetic = false;  ///< the number is relative to magnetic north; who knows the variation adds it
};
static_assert(std::is_trivially_copyable_v<SignalBinding>);

[[nodiscard]] SignalBinding bind(const IdentifierEntry& entry, const BusDialect& dialect) noexcept;
[[nodiscard]] double to_si(const SignalBinding& binding, double number) noexcept;
/// Returns headings and directions in +-180 degrees, as the standard requires.
[[nodiscard]] double from_si(const SignalBinding& binding, double si) noexcept;

}  // namespace tedavis::bus
