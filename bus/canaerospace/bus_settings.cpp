#include "bus/canaerospace/bus_settings.hpp"

#include <utility>

#include "bus/canaerospace/identifier_table.hpp"

namespace tedavis::bus {
namespace {

using base::ConfigSection;
using base::Duration;

constexpr double kMaxSeconds = 3600;

void read_duration(ConfigSection& section, std::string_view key, double low_s, double high_s, Duration& value) {
    value = Duration::from_seconds(section.number(key, low_s, high_s, value.to_seconds()));
}

void read_byte(ConfigSection& section, std::string_view key, std::int64_t low, std::int64_t high, std::uint8_t& value) {
    value = static_cast<std::uint8_t>(section.integer(key, low, high, value));
}

void read_dialect(ConfigSection section, BusDialect& dialect) {
    static constexpr std::string_view kAccelerations[] = {"g", "m/s2"};
    static constexpr std::string_view kPressures[] = {"hPa", "Pa"};
    static constexpr std::string_view kHeadings[] = {"true", "magnetic"};
    static constexpr std::string_view kWinds[] = {"from", "to"};
    static constexpr std::string_view kVariations[] = {"east", "west"};
    static constexpr std::string_view kDeviations[] = {"own_ship", "path"};
    static constexpr std::string_view kServiceCodes[] = {"invalid", "ignored"};
    dialect.accept_long_position = section.boolean("accept_long_position", dialect.accept_long_position);
    section.choose("acceleration_unit", kAccelerations, dialect.acceleration);
    section.choose("pressure_unit", kPressures, dialect.pressure);
    section.choose("heading_321_reference", kHeadings, dialect.heading);
    section.choose("wind_direction", kWinds, dialect.wind);
    section.choose("variation_positive", kVariations, dialect.variation);
    section.choose("deviation_states", kDeviations, dialect.deviation);
    section.choose("direction_reference", kHeadings, dialect.directions);
    section.choose("service_code_not_zero", kServiceCodes, dialect.service_code);
    dialect.month_from_zero = section.boolean("month_from_zero", dialect.month_from_zero);
    dialect.glider_identifiers = section.boolean("glider_identifiers", dialect.glider_identifiers);
    read_byte(section, "redundancy_channels", 1, kMaxRedundancyChannels, dialect.redundancy_channels);
    read_duration(section, "pair_window_s", 0.001, 1.0, dialect.pair_window);
    read_duration(section, "sender_timeout_s", 0.1, 60.0, dialect.sender_timeout);
}

void read_phase(ConfigSection section, PhaseMessageSettings& phase) {
    phase.status_identifier =
        static_cast<std::uint16_t>(section.integer("status_identifier", 200, 1999, phase.status_identifier));
    phase.request_identifier =
        static_cast<std::uint16_t>(section.integer("request_identifier", 200, 1999, phase.request_identifier));
    if (phase.request_identifier == phase.status_identifier)
        section.fault("request_identifier", "'request_identifier' equals 'status_identifier'; give each its own");
    if (section.has("report_identifier"))
        phase.report_identifier = static_cast<std::uint16_t>(section.integer("report_identifier", 200, 1999));
    if (phase.report_identifier == phase.status_identifier || phase.report_identifier == phase.request_identifier)
        section.fault("report_identifier", "'report_identifier' is that of another message of the phase; give it its own");
    const std::pair<std::string_view, std::uint16_t> stated[] = {{"status_identifier", phase.status_identifier},
                                                                 {"request_identifier", phase.request_identifier},
                                                                 {"report_identifier", phase.report_identifier}};
    for (const auto& [key, identifier] : stated)
        if (identifier != 0 && identifier_index(identifier) != kNotInTable)
            section.fault(key, "this identifier has a meaning in the standard; choose another");
    read_duration(section, "timeout_s", 0.1, 60.0, phase.timeout);
}

/// What else a bus file gives identifiers to: the phase, and the profiles that were read before.
struct TakenIdentifiers {
    const PhaseMessageSettings& phase;
    const TrafficSettings& traffic;
    const GuidanceSettings& guidance;
};

/// Without its section a profile is not received: its identifiers are free for others.
std::uint16_t read_first_identifier(ConfigSection section, std::uint16_t count, std::string_view count_in_words,
                                    const TakenIdentifiers& taken) {
    if (!section.present()) return 0;
    constexpr std::string_view kKey = "first_identifier";
    const auto first = static_cast<std::uint16_t>(section.integer(kKey, 200, 2000 - count));
    const auto fault = [&](std::string_view meaning) {
        base::FixedString<159> message("one of the ");
        for (const std::string_view part :
             {count_in_words, std::string_view(" identifiers from here on "), meaning, std::string_view("; choose others")})
            message.append(part);
        section.fault(kKey, message.view());
    };
    for (std::uint16_t n = 0; n < count; ++n) {
        const auto identifier = static_cast<std::uint16_t>(first + n);
        if (identifier_index(identifier) != kNotInTable) return fault("has a meaning in the standard"), first;
        if (taken.phase.has(identifier)) return fault("belongs to the phase of flight"), first;
        if (taken.traffic.has(identifier)) return fault("reports other aircraft"), first;
    }
    return first;
}

/// Without its section no request is received.
void read_display(ConfigSection section, const TakenIdentifiers& taken, DisplayRequestSettings& display) {
    if (!section.present()) return;
    constexpr std::string_view kKey = "legend_identifier";
    display.legend_identifier = static_cast<std::uint16_t>(section.integer(kKey, 200, 1999));
    const std::uint16_t identifier = display.legend_identifier;
    const bool is_taken = identifier_index(identifier) != kNotInTable || taken.phase.has(identifier) ||
                          taken.traffic.has(identifier) || taken.guidance.has(identifier);
    if (is_taken) section.fault(kKey, "this identifier has a meaning already; choose another");
}

/// What the sections of a bus file give an identifier to; empty: nothing.
std::string_view meaning_of(std::uint16_t identifier, const void* context) {
    const BusSettings& settings = *static_cast<const BusSettings*>(context);
    if (settings.phase.has(identifier)) return "the phase of flight";
    if (settings.traffic.has(identifier)) return "other aircraft";
    if (settings.guidance.has(identifier)) return "what is selected ([guidance])";
    return settings.display.has(identifier) ? "which legend is shown" : "";
}

void read_node(ConfigSection section, NodeSettings& node) {
    node.answer_identification = section.boolean("answer_identification", node.answer_identification);
    read_byte(section, "id", 1, 199, node.node);
    read_byte(section, "hardware_revision", 0, 255, node.hardware_revision);
    read_byte(section, "software_revision", 0, 255, node.software_revision);
}

void read_own_ship(ConfigSection section, OwnShipSettings& own_ship) {
    read_duration(section, "extrapolation_limit_s", 0.0, 10.0, own_ship.extrapolation_limit);
    read_duration(section, "lost_after_s", 0.0, kMaxSeconds, own_ship.lost_after);
    if (own_ship.lost_after < own_ship.extrapolation_limit)
        section.fault("lost_after_s", "'lost_after_s' must not be below 'extrapolation_limit_s'");
    own_ship.position_noise_m = section.number("position_noise_m", 0.001, 1000.0, own_ship.position_noise_m);
    own_ship.height_noise_m = section.number("height_noise_m", 0.001, 1000.0, own_ship.height_noise_m);
    own_ship.velocity_noise_mps = section.number("velocity_noise_mps", 0.001, 100.0, own_ship.velocity_noise_mps);
    own_ship.acceleration_mps2 = section.number("acceleration_mps2", 0.01, 100.0, own_ship.acceleration_mps2);
}

void read_clock(ConfigSection section, base::Duration& utc_timeout) {
    read_duration(section, "timeout_s", 0.1, kMaxSeconds, utc_timeout);
}

/// Each key names a signal, its value is [stale, lost] in seconds.
void read_freshness(ConfigSection section, BusSettings& settings) {
    for (std::size_t i = 0; i < section.key_count(); ++i) {
        const std::string_view key = section.key_at(i);
        const flight::Signal signal = flight::signal_from_name(key);
        if (signal == flight::Signal::count_ || is_computed(signal)) {
            section.fault(key, "no such signal on the bus; the names are those of render_core/flight/signal.hpp");
            return;
        }
        base::FreshnessLimits& limits = settings.limits[static_cast<std::size_t>(signal)];
        double seconds[2] = {limits.stale.to_seconds(), limits.lost.to_seconds()};
        section.numbers(key, 0.001, kMaxSeconds, base::Span<double>(seconds));
        if (seconds[1] < seconds[0]) section.fault(key, "the lost limit must not be below the stale limit");
        limits = {Duration::from_seconds(seconds[0]), Duration::from_seconds(seconds[1])};
    }
}

}  // namespace

base::FreshnessLimits default_limits(flight::Signal signal) noexcept {
    using flight::Signal;
    switch (signal) {
        case Signal::pitch:
        case Signal::roll:
        case Signal::true_heading:
        case Signal::magnetic_heading:
        case Signal::pitch_rate:
        case Signal::roll_rate:
        case Signal::yaw_rate:
        case Signal::sideslip:
        case Signal::longitudinal_acceleration:
        case Signal::lateral_acceleration:
        case Signal::normal_acceleration: return {Duration::milliseconds(300), Duration::seconds(1)};
        case Signal::horizontal_accuracy:
        case Signal::vertical_accuracy:
        case Signal::wind_speed:
        case Signal::wind_direction:
        case Signal::outside_temperature:
        case Signal::baro_setting: return {Duration::seconds(10), Duration::seconds(30)};
        case Signal::flaps_lever:
        case Signal::flaps_position:
        case Signal::navigation_source:
        case Signal::selected_course:
        case Signal::selected_glidepath:
        case Signal::selected_altitude:
        case Signal::selected_heading:
        case Signal::selected_airspeed:
        case Signal::selected_vertical_speed:
        case Signal::decision_height:
        case Signal::minimum_altitude: return {Duration::seconds(3), Duration::seconds(10)};
        case Signal::magnetic_variation: return {Duration::seconds(60), Duration::seconds(600)};
        default: return {Duration::seconds(1), Duration::seconds(3)};
    }
}

BusSettings::BusSettings() {
    for (std::size_t i = 0; i < flight::kSignalCount; ++i) limits[i] = default_limits(static_cast<flight::Signal>(i));
}

base::Result<BusSettings, base::Error> load_bus_settings(std::string_view text, std::string_view name) {
    base::ConfigReader reader(text, name);
    BusSettings settings;
    ConfigSection root = reader.root();
    static constexpr std::string_view kProtocols[] = {"canaerospace"};
    std::size_t protocol = 0;  // there is one so far
    root.choose("protocol", kProtocols, protocol);
    read_dialect(root.section("dialect"), settings.dialect);
    read_phase(root.section("phase"), settings.phase);
    const TakenIdentifiers taken{settings.phase, settings.traffic, settings.guidance};
    settings.traffic.first_identifier = read_first_identifier(root.section("traffic"), kTrafficIdentifiers, "twelve", taken);
    settings.guidance.first_identifier = read_first_identifier(root.section("guidance"), kGuidanceIdentifiers, "eight", taken);
    read_display(root.section("display"), taken, settings.display);
    settings.messages = read_stated_messages(root, meaning_of, &settings);
    read_node(root.section("node"), settings.node);
    read_own_ship(root.section("own_ship"), settings.own_ship);
    read_clock(root.section("clock"), settings.utc_timeout);
    read_freshness(root.section("freshness"), settings);
    for (const StatedMessage& message : settings.messages)
        if (message.states_period && message.signal != flight::Signal::count_)
            settings.limits[static_cast<std::size_t>(message.signal)] = message.limits;
    if (!reader.finish()) return base::fail(reader.error());
    return settings;
}

}  // namespace tedavis::bus
