/// The self-test's flight: three seconds of a bus log whose values are known, read as the board reads a bus.
///
/// The expected values were computed from the bytes of the log, without this program's decoder: see
/// target/self_test_data/ORIGIN.md.
#pragma once

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/state/state_assembler.hpp"
#include "render_core/base/span.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/terrain_heights.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

struct KnownFlight {
    bus::BusCounters counters;
    std::uint64_t broken_lines = 0;
    base::Time now;                  ///< stamp of the last frame
    flight::AircraftState aircraft;  ///< at `now`, with height_above_terrain
    flight::PhaseStatus phase;
};

/// Replays the whole log.
[[nodiscard]] KnownFlight play_known_flight(base::Span<const char> log, const bus::BusSettings& settings,
                                            flight::TerrainHeights& heights);

/// Adds a check for each known value; that of the height above terrain only where the flight had the known terrain.
void check_known_flight(const KnownFlight& flight, SelfTestReport& report, bool has_terrain = true);

}  // namespace tedavis::target
