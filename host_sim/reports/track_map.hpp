/// Tracks on a map, as inline SVG: shaded terrain below, marks, a scale. North is up. The track of one run has each phase in its
/// color; several tracks have a color each. A label that has no room beside its place is left out; its title stays.
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
    std::string color = "#c22";
};

/// One of several tracks.
struct MapTrack {
    struct Place {
        double time_s = 0, latitude_deg = 0, longitude_deg = 0;
    };
    std::string name, color;
    double width = 2.5;         ///< of the line; 1.5 to 6
    std::vector<Place> places;  ///< in the order of time
};

/// Of the samples with a valid position; empty where there are fewer than two. `terrain`: null where the run had none. `beside`:
/// other flights' tracks, below that of the run; those of less than two places are left out.
[[nodiscard]] std::string track_map_svg(const RunStory& story, const terrain::TerrainDatabase* terrain,
                                        const std::vector<MapMark>& marks = {}, const std::vector<MapTrack>& beside = {});
/// Tracks of less than two places are left out; empty where none is left. A later one is drawn over an earlier one.
[[nodiscard]] std::string tracks_map_svg(const std::vector<MapTrack>& tracks, const terrain::TerrainDatabase* terrain,
                                         const std::vector<MapMark>& marks = {});

}  // namespace tedavis::host_sim
