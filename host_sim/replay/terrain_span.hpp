/// The part of a flight that is over the ground of a database, by which --over-terrain cuts a replay.
#pragma once

#include <string>
#include <vector>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/flight_outline.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// From the first to the last place in a row that lies inside, both included.
struct TerrainSpan {
    base::Time first, last;
};

/// In order of time; empty where no place lies inside the lattice. Places are about a second apart: what is shorter may be
/// missed. Voids inside the lattice count as inside.
[[nodiscard]] std::vector<TerrainSpan> spans_over(const std::vector<OutlinePlace>& places, const terrain::Lattice& lattice);

/// The options with `from_s` and `to_s` narrowed to where the flight is over the ground: from the first time that it comes over
/// it to the last time that it leaves it. `first`: the log's first instant. Throws UserError, with what flight and database
/// cover, where the flight is never over it in the time that the options ask for, and where there is no database.
[[nodiscard]] ReplayOptions over_terrain(const ReplayOptions& options, const FlightOutline& outline, base::Time first,
                                         const terrain::TerrainDatabase* database);

}  // namespace tedavis::host_sim
