/// ADS-B tables as the Python libraries write them: a list of records, or a table of columns each keyed by row.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/importers/recorded_flight.hpp"

namespace tedavis::host_sim {

/// Columns used: `timestamp` (ms since 1970 UTC, or seconds, or ISO 8601), `last_position` (when the position was
/// received; repeated positions are skipped by it), `icao24`, `callsign`, `latitude`, `longitude` (deg), `altitude`
/// (ft, pressure), `geoaltitude` (ft, GNSS above the ellipsoid as Mode S transmits it), `groundspeed` (kt), `track`,
/// `heading`, `pitch`, `roll` (deg), `vertical_rate` (ft/min), `onground`. Rows without a position are counted and
/// skipped. Throws UserError when the text is no JSON, no such table, or holds no position.
[[nodiscard]] ImportedFile import_adsb_json(std::string_view text, const std::string& name);

}  // namespace tedavis::host_sim
