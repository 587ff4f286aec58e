/// Opens a recorded flight of any supported format and selects the aircraft.
#pragma once

#include <string>

#include "host_sim/importers/recorded_flight.hpp"

namespace tedavis::host_sim {

/// Reads the file (gzip or plain) and detects the format by its content, not its name. Throws UserError.
[[nodiscard]] ImportedFile import_flight_file(const std::string& path);
/// The format of a recorded flight, "IGC", "GPX" or "ADS-B JSON", by its beginning; empty for other formats and where the file is
/// missing. Tables (CSV) are not distinguished from other text.
[[nodiscard]] std::string recorded_format(const std::string& path);
/// Whether the file (gzip or plain) is a bus log, by the beginning of its first line. Throws UserError where the file cannot be
/// read.
[[nodiscard]] bool is_bus_log_file(const std::string& path);
/// The flight of `aircraft` (its identity or callsign, case does not matter; empty: the only one). Throws UserError that
/// lists the choices where the file holds several, or none of that name.
[[nodiscard]] RecordedFlight choose_aircraft(ImportedFile file, const std::string& aircraft, const std::string& path);

}  // namespace tedavis::host_sim
