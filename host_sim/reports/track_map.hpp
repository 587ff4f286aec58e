/// The track of a run on a map, as inline SVG: shaded terrain below, each phase in its color, marks of time, a scale. North is
/// up.
#pragma once

#include <string>
#include <vector>

#include "host_sim/reports/run_story.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// A numbered place of the map.
struct MapMark {
    double latitude_deg = 0, longitude_deg = 0;
    std::string label, description;
};

/// Of the samples with a valid position; empty where there are fewer than two. `terrain`: null where the run had none.
[[nodiscard]] std::string track_map_svg(const RunStory& story, const terrain::TerrainDatabase* terrain,
                                        const std::vector<MapMark>& marks = {});

}  // namespace tedavis::host_sim
