/// Writes a flight as a candump log of CANaerospace frames.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

#include "bus/canaerospace/bus_settings.hpp"
#include "host_sim/flight_log/flight_source.hpp"

namespace tedavis::host_sim {

struct FlightLogSettings {
    std::string name = "the log";  ///< its name in messages to the user
    std::string interface_name = "can0";
    std::uint8_t node = 9;  ///< sender of all messages: the GPS of the standard's example system
    bus::BusSettings bus;   ///< dialect in which values are written
};

struct FlightLogCounts {
    std::uint64_t frames = 0;
    std::uint64_t phase_messages = 0;
    std::uint64_t silent_ms = 0;  ///< time within the flight in which the source had nothing (gaps)
    bool interrupted = false;
};

/// Called now and then with the share done, 0..1; returns false to end the log there (Ctrl-C), which leaves it valid.
using LogProgress = std::function<bool(double share)>;

/// Frames lie on a grid of 1 ms; those of one millisecond follow each other at the pace of a 1 Mbit/s bus (125 us), so stamps
/// rise strictly and survive a log with six digits. Also sends UTC (1200) and date (1206) each second, and the stated phase
/// (1830) each second and on change. Where the bus carries other aircraft, each received one is reported once a second, one
/// message per millisecond. Throws UserError when the stream fails.
FlightLogCounts write_flight_log(const FlightSource& flight, const FlightLogSettings& settings, std::ostream& stream,
                                 const LogProgress& progress);

}  // namespace tedavis::host_sim
