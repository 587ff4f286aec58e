/// Comma-separated flights with documented column names.
///
/// First line: names, in any order. Required: `time` (seconds since 1970 UTC, or ISO 8601), `latitude_deg`,
/// `longitude_deg`. Optional: `height_ellipsoid_m` or `height_msl_m` (GNSS; not both), `pressure_altitude_m`,
/// `ground_speed_mps`, `track_deg` (true), `vertical_speed_mps`, `pitch_deg`, `roll_deg`, `heading_deg` (true),
/// `on_ground` (0 or 1), `aircraft` (where a file holds several). Empty cells are absent values. Lines that start with
/// `#` are comments. Other columns are ignored and named in a note.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/importers/recorded_flight.hpp"

namespace tedavis::host_sim {

/// Throws UserError with the line of the first cell that is no number or out of range.
[[nodiscard]] ImportedFile import_csv(std::string_view text, const std::string& name);

}  // namespace tedavis::host_sim
