/// Everything that a played instant holds as text, every number exactly: two instants are equal bit for bit where their texts
/// are.
#pragma once

#include <cinttypes>
#include <cstdio>
#include <string>

#include "host_sim/replay/flight_player.hpp"

namespace tedavis::host_sim {

inline std::string exact(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%a ", value);
    return text;
}

inline std::string exact(std::int64_t value) { return std::to_string(value) + " "; }

inline std::string text_of(const flight::AircraftState& aircraft) {
    std::string text;
    for (const base::Stamped<double>& signal : aircraft.signals)
        text += exact(signal.value_or(0)) + exact(signal.source_time().ns) + exact(static_cast<std::int64_t>(signal.quality())) +
                (signal.received() ? "got\n" : "none\n");
    const flight::OwnShipEstimate& own = aircraft.own_ship;
    return text + exact(own.position.latitude_rad) + exact(own.position.longitude_rad) + exact(own.position.height.m) +
           exact(own.velocity_north_mps) + exact(own.velocity_east_mps) + exact(own.velocity_up_mps) + exact(own.at.ns) +
           exact(static_cast<std::int64_t>(own.state)) + exact(std::int64_t{own.height_is_geometric}) + "\n";
}

inline std::string text_of(const bus::BusCounters& c) {
    return std::to_string(c.frames) + " frames " + std::to_string(c.decoded) + " decoded " + std::to_string(c.alien) + " alien " +
           std::to_string(c.errors) + " errors " + std::to_string(c.dropped) + " dropped\n";
}

inline std::string text_of(const flight::PhaseStatus& phase) {
    return std::string(flight::scenario_name(phase.phase)) + "." + flight::sub_phase_name(phase.phase) + " by " +
           flight::to_string(phase.source) + (phase.switch_fault ? " fault" : "") + (phase.disagreement ? " disagreement" : "") +
           "\n";
}

/// What a player knows at an instant.
inline std::string text_at(FlightPlayer& player, base::Time time) {
    const flight::FrameInput input = player.at(time);
    const bus::BusSnapshot bus = player.assembler().snapshot(input.time);
    const bus::PhaseMessage& said = bus.phase_status;
    const bus::DecoderCounts& d = bus.decoder;
    return text_of(input.state) + text_of(bus.counters) + text_of(input.phase) + exact(said.phase.source_time().ns) +
           exact(std::int64_t{said.phase.value_or({}).code()}) +
           exact(static_cast<std::int64_t>(d.repeated + 1000 * d.lost + 1000000 * d.restarts)) + exact(player.newest_frame().ns);
}

}  // namespace tedavis::host_sim
