/// Recorded flights as lines in space and time: IGC, GPX, ADS-B JSON and CSV, as `tedavis convert` reads them.
///
/// Fixes that cannot have been flown are removed (fix_cleaner.hpp); a gap ends a line, and the next one begins after it. Heights
/// are above mean sea level (EGM96): GNSS heights, or the pressure altitude of a flight without them; both smoothed as for
/// replays. The notes state all of this. Of each point: ground_speed, vertical_speed (m/s) and track (rad, true). Fields: name
/// (the callsign, else the identity), aircraft, callsign, and of a line's last point last_time (s since 1970 UTC),
/// last_latitude_deg, last_longitude_deg, last_height (m), last_ground_speed, last_vertical_speed and last_track; is_latest is 1
/// on the last line of an aircraft.
#pragma once

#include <string>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// `aircraft` is the identity or callsign of the only aircraft to read; empty: all. Throws UserError where the file is no flight
/// or has no aircraft of that name.
[[nodiscard]] SourceFeatures read_flight_file(const std::string& path, const std::string& aircraft);

/// Attributes of a layer of flights whose recipe states none: the values of points.
[[nodiscard]] std::vector<AttributeRecipe> usual_attributes_of_flights();

}  // namespace tedavis::host_sim
