#include "target/self_test/known_flight.hpp"

#include <limits>

#include "bus/candump/candump_log_source.hpp"
#include "bus/tracker/flight_tracker.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::target {
namespace {

using flight::Signal;

constexpr std::size_t kMaxFrames = 1 << 20;  // more than any log that fits the program
constexpr int kMaxSteps = 1000;              // a damaged stamp far ahead is not stepped to
constexpr base::Time kEnd{std::numeric_limits<std::int64_t>::max()};
constexpr std::uint64_t kFrames = 1829;

/// A signal in the unit in which its message carries it.
struct KnownValue {
    const char* name;
    Signal signal;
    double factor;  ///< SI to unit
    double expected, tolerance;
    const char* unit;
};

constexpr KnownValue kValues[] = {
    {"heading", Signal::true_heading, base::kDegreesPerRadian, 20.295503616, 1e-4, "deg"},
    {"pitch", Signal::pitch, base::kDegreesPerRadian, 1.550300598, 1e-4, "deg"},
    {"roll", Signal::roll, base::kDegreesPerRadian, -0.122181125, 1e-4, "deg"},
    {"baro_altitude", Signal::baro_altitude, 1, 617.049133, 0.001, "m"},
    {"baro_setting", Signal::baro_setting, 1 / base::kPascalsPerHectopascal, 1016, 0.01, "hPa"},
    {"indicated_airspeed", Signal::indicated_airspeed, 1, 92.778107, 0.001, "m/s"},
    {"ground_speed", Signal::ground_speed, 1, 99.689041, 0.001, "m/s"},
    {"vertical_speed", Signal::vertical_speed, 1, -0.000300683, 1e-6, "m/s"},
    {"wind_speed", Signal::wind_speed, 1, 4.804860, 0.001, "m/s"},
    {"outside_temperature", Signal::outside_temperature, 1, 287.376984, 0.001, "K"},
    {"height_above_terrain", Signal::height_above_terrain, 1, 237.26, 0.3, "m"},
};

struct Extent {
    base::Time first, last;
};

/// Stamps of the first and last frame.
Extent extent_of(base::Span<const char> log) {
    bus::CandumpLogSource source(log);
    bus::CanFrame frame;
    Extent extent;
    for (std::size_t n = 0; n < kMaxFrames && source.read(kEnd, base::Span<bus::CanFrame>(&frame, 1)) == 1; ++n) {
        if (n == 0) extent.first = frame.time;
        extent.last = frame.time;
    }
    return extent;
}

void check_position(const KnownFlight& flight, SelfTestReport& report) {
    const flight::OwnShipEstimate& own_ship = flight.aircraft.own_ship;
    report.add("own_ship", own_ship.state == base::SignalState::valid && own_ship.height_is_geometric,
               base::to_string(own_ship.state));
    // 3e-6 degrees are a third of a metre.
    report.add_number("latitude", base::degrees(own_ship.position.latitude_rad), 36.576585818, 3e-6, "deg");
    report.add_number("longitude", base::degrees(own_ship.position.longitude_rad), -84.189623420, 3e-6, "deg");
    report.add_number("ellipsoid_height", own_ship.position.height.m, 589.253, 0.3, "m");
}

}  // namespace

KnownFlight play_known_flight(base::Span<const char> log, const bus::BusSettings& settings, flight::TerrainHeights& heights) {
    const Extent extent = extent_of(log);
    bus::CandumpLogSource source(log);
    bus::TrackerMemory memory(settings, nullptr, extent.first);
    bus::FlightTracker tracker(memory, {source});
    for (int n = 0; n < kMaxSteps && tracker.next_step() < extent.last; ++n) tracker.step(heights);
    const flight::FrameInput input = tracker.input_at(extent.last, heights);
    KnownFlight flight;
    flight.now = input.time;
    flight.aircraft = input.state;
    flight.phase = input.phase;
    flight.counters = memory.assembler.snapshot(extent.last).counters;
    flight.broken_lines = source.statistics().malformed;
    return flight;
}

void check_known_flight(const KnownFlight& flight, SelfTestReport& report, bool has_terrain) {
    report.add_count("log_frames", flight.counters.frames, kFrames, kFrames);
    report.add_count("log_decoded", flight.counters.decoded, kFrames, kFrames);
    report.add_count("log_broken_lines", flight.broken_lines, 0, 0);
    check_position(flight, report);
    for (const KnownValue& known : kValues) {
        if (known.signal == Signal::height_above_terrain && !has_terrain) continue;
        const bool valid = flight.aircraft.is_valid(known.signal, flight.now);
        const double found = flight.aircraft[known.signal].value_or(0) * known.factor;
        if (valid)
            report.add_number(known.name, found, known.expected, known.tolerance, known.unit);
        else
            report.add(known.name, false, base::to_string(flight.aircraft.state_of(known.signal, flight.now)));
    }
    report.add("phase", flight.phase.phase == flight::kApproachDescent, flight::sub_phase_name(flight.phase.phase));
    report.add("phase_source", flight.phase.source == flight::PhaseSource::can, flight::to_string(flight.phase.source));
}

}  // namespace tedavis::target
