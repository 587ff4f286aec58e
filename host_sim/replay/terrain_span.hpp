/// The parts of a flight that are over the ground of a database, by which --over-terrain cuts a replay.
#pragma once

#include <string>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/flight_outline.hpp"
#include "host_sim/replay/time_range.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// Each from the first to the last place in a row that lies inside; empty where no place lies inside the lattice. Places are
/// about a second apart: what is shorter may be missed. Voids inside the lattice count as inside.
[[nodiscard]] TimeRanges spans_over(const std::vector<OutlinePlace>& places, const terrain::Lattice& lattice);

/// Where the flight is over the ground, in the time that the options ask for; at least one. Each begins and ends with known
/// ground below; between, there may be voids. `first`: the log's first instant. Throws UserError, with what flight and database
/// cover, where the flight is never over known ground in that time, and where there is no database.
[[nodiscard]] TimeRanges terrain_spans(const ReplayOptions& options, const FlightOutline& outline, base::Time first,
                                       const terrain::TerrainDatabase* database);

/// Throws the same UserError where no fix, nor what may lie between two of them, comes near the ground: a few degrees of a sparse
/// recording may. `name`: of the database. Where it says nothing the flight may still never be over it.
void require_near_terrain(const std::vector<OutlinePlace>& fixes, const std::string& name,
                          const terrain::TerrainDatabase& database);

/// For the report: "frames are drawn where the flight is over alps.tdb: 15.6 - 65.6 s, 80.1 - 95.0 s". Of many spans some are
/// named.
[[nodiscard]] std::string words_of_spans(const TimeRanges& spans, base::Time first, const std::string& terrain);

}  // namespace tedavis::host_sim
