/// Finds the parts of a flight that are over the terrain of a database, to which --over-terrain restricts a replay.
#pragma once

#include <string>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/flight_outline.hpp"
#include "host_sim/replay/time_range.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// Returns for each run of consecutive places inside the lattice the time from the first to the last of them. Places are about a
/// second apart, so shorter parts may be missed. Voids of the lattice count as inside.
[[nodiscard]] TimeRanges spans_over(const std::vector<OutlinePlace>& places, const terrain::Lattice& lattice);

/// Returns the parts of the flight over the terrain, within the time that the options state; at least one. Each begins and ends
/// over known ground; between there may be voids. `first` is the log's first time. Throws UserError, with the extents of flight
/// and database, where the flight is never over known ground in that time, and where there is no database.
[[nodiscard]] TimeRanges terrain_spans(const ReplayOptions& options, const FlightOutline& outline, base::Time first,
                                       const terrain::TerrainDatabase* database);

/// Throws the same UserError where neither a fix nor any possible position between two fixes is near the terrain; in a sparse
/// recording two fixes may be degrees apart. `name` is the database's. A flight that passes this check may still never be over
/// the terrain.
void require_near_terrain(const std::vector<OutlinePlace>& fixes, const std::string& name,
                          const terrain::TerrainDatabase& database);

/// For the report: "frames are drawn where the flight is over alps.tdb: 15.6 - 65.6 s, 80.1 - 95.0 s". Only the first few spans
/// are listed.
[[nodiscard]] std::string words_of_spans(const TimeRanges& spans, base::Time first, const std::string& terrain);

}  // namespace tedavis::host_sim
