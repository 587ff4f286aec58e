/// What a bus file states (configs/buses/*.toml): which dialect of CANaerospace is spoken where the standard leaves room
/// or real devices differ, how old values may get, and how the own ship is filtered.
///
/// The defaults follow the standard. Loading is start-up only and allocates.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "bus/canaerospace/stated_messages.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/stamped.hpp"
#include "render_core/flight/signal.hpp"

namespace tedavis::bus {

inline constexpr std::uint8_t kMaxRedundancyChannels = 4;

enum class AccelerationUnit : std::uint8_t { g, mps2 };
enum class PressureUnit : std::uint8_t { hpa, pa };
enum class HeadingReference : std::uint8_t { true_north, magnetic };
enum class WindDirection : std::uint8_t { from, to };
enum class VariationSign : std::uint8_t { east_positive, west_positive };
/// What a positive deviation says: where the own ship is, or where the course or path is as seen from it.
enum class DeviationSign : std::uint8_t { own_ship, path };
/// What a service code other than 0 on normal data means.
enum class ServiceCodeMeaning : std::uint8_t { invalid, ignored };

struct BusDialect {
    bool accept_long_position = true;                            ///< LONG on 1036/1037 is 1e-7 degrees
    AccelerationUnit acceleration = AccelerationUnit::g;         ///< messages 300..302
    PressureUnit pressure = PressureUnit::hpa;                   ///< messages 319, 325, 326
    HeadingReference heading = HeadingReference::true_north;     ///< message 321
    WindDirection wind = WindDirection::from;                    ///< message 334
    VariationSign variation = VariationSign::east_positive;      ///< message 1121
    DeviationSign deviation = DeviationSign::own_ship;           ///< messages 1042, 1044, 1087..1092
    HeadingReference directions = HeadingReference::true_north;  ///< messages 1120, 1125, and the directions of guidance
    ServiceCodeMeaning service_code = ServiceCodeMeaning::invalid;
    bool month_from_zero = false;          ///< message 1206 counts January as 0
    bool glider_identifiers = false;       ///< also decode 340..350, 354, 1134, ... of a common glider profile
    std::uint8_t redundancy_channels = 2;  ///< 1..kMaxRedundancyChannels; higher channels are other traffic
    base::Duration pair_window = base::Duration::milliseconds(20);  ///< longest time between the halves of a DOUBLE
    base::Duration sender_timeout = base::Duration::seconds(2);     ///< after this silence any message code is accepted
};

struct PhaseMessageSettings {
    std::uint16_t status_identifier = 1830;
    std::uint16_t request_identifier = 1831;
    std::uint16_t report_identifier = 0;  ///< of the phase that a display has (phase_report.hpp); 0: it sends none
    base::Duration timeout = base::Duration::seconds(3);

    [[nodiscard]] bool has(std::uint16_t identifier) const {
        return identifier == status_identifier || identifier == request_identifier ||
               (report_identifier != 0 && identifier == report_identifier);
    }
};

/// Reports of other aircraft (traffic_profile.hpp) use this many consecutive identifiers.
inline constexpr std::uint16_t kTrafficIdentifiers = 12;
struct TrafficSettings {
    std::uint16_t first_identifier = 0;  ///< 0: the bus carries no traffic

    [[nodiscard]] bool is_carried() const { return first_identifier != 0; }
    [[nodiscard]] bool has(std::uint16_t identifier) const {
        return is_carried() && identifier >= first_identifier && identifier - first_identifier < kTrafficIdentifiers;
    }
};

/// What pilot and autopilot have selected (guidance_table()) uses this many consecutive identifiers.
inline constexpr std::uint16_t kGuidanceIdentifiers = 8;
struct GuidanceSettings {
    std::uint16_t first_identifier = 0;  ///< 0: the bus carries none

    [[nodiscard]] bool is_carried() const { return first_identifier != 0; }
    [[nodiscard]] bool has(std::uint16_t identifier) const {
        return is_carried() && identifier >= first_identifier && identifier - first_identifier < kGuidanceIdentifiers;
    }
};

/// What the pilot asks of the display by the bus.
struct DisplayRequestSettings {
    std::uint16_t legend_identifier = 0;  ///< 0: the bus carries no request

    [[nodiscard]] bool has(std::uint16_t identifier) const { return legend_identifier != 0 && identifier == legend_identifier; }
};

/// The answer to an identification request (section 4, IDS).
struct NodeSettings {
    bool answer_identification = false;  ///< off: requests are not answered
    std::uint8_t node = 30;              ///< 1..199
    std::uint8_t hardware_revision = 1;
    std::uint8_t software_revision = 1;
};

struct OwnShipSettings {
    base::Duration extrapolation_limit = base::Duration::milliseconds(250);
    base::Duration lost_after = base::Duration::seconds(2);
    double position_noise_m = 1.0;  ///< standard deviation, used where no figure of merit is received
    double height_noise_m = 2.0;
    double velocity_noise_mps = 0.1;
    double acceleration_mps2 = 8.0;  ///< standard deviation of the acceleration that the constant-velocity model neglects
};

struct BusSettings {
    BusDialect dialect;
    PhaseMessageSettings phase;
    TrafficSettings traffic;
    GuidanceSettings guidance;
    DisplayRequestSettings display;
    StatedMessages messages;
    NodeSettings node;
    OwnShipSettings own_ship;
    base::Duration utc_timeout = base::Duration::seconds(10);  ///< without message 1200 for this long, UTC is lost
    std::array<base::FreshnessLimits, flight::kSignalCount> limits{};

    BusSettings();  ///< every limit at its default (see default_limits)
};
static_assert(std::is_trivially_copyable_v<BusSettings>);

/// Limits for signals that the standard sends every 12.5 ms (section 6.2): stale after 0.3 s, lost after 1 s. For those sent
/// every 100 ms: 1 s and 3 s. Signals that change slowly or are set by hand have longer limits: what is selected is repeated
/// every second (3 s and 10 s).
[[nodiscard]] base::FreshnessLimits default_limits(flight::Signal signal) noexcept;

/// `name` is the file's name in error messages.
[[nodiscard]] base::Result<BusSettings, base::Error> load_bus_settings(std::string_view text, std::string_view name);

}  // namespace tedavis::bus
