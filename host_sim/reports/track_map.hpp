/// Tracks on a map, as inline SVG: shaded terrain below, marks, a scale. North is up. The track of one run has each phase in its
/// color; several tracks have a color each. A label without room beside its place is left out, but its tooltip stays.
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
        bool joins_next = true;  ///< false: the track has a gap behind it
    };
    std::string name, color;
    double width = 2.5;         ///< of the line; 1.5 to 6
    std::vector<Place> places;  ///< in the order of time
    /// False: there is also a gap between places that are much farther apart in time than usual.
    bool states_gaps = false;
};

/// The part of another flight's track that the map of a run shows.
struct MapTrackView {
    bool is_shown = false;  ///< a part of it lies on the map
    bool is_cut = false;    ///< a part of it lies beyond the map
    bool has_gaps = false;  ///< one of its gaps begins or ends on the map
};

/// Returns the map of the samples with a valid position; empty where there are fewer than two. `terrain` is null where the run
/// had none. `beside` are other flights' tracks, drawn below that of the run; those of less than two places are left out. For
/// them the map is extended by up to a quarter of its size at each side; they are clipped at its border.
[[nodiscard]] std::string track_map_svg(const RunStory& story, const terrain::TerrainDatabase* terrain,
                                        const std::vector<MapMark>& marks = {}, const std::vector<MapTrack>& beside = {});
[[nodiscard]] MapTrackView view_of_track(const RunStory& story, const std::vector<MapTrack>& beside, std::size_t number);
/// Returns a map of several tracks, later ones above earlier ones. Tracks of less than two places are left out; empty where none
/// is left.
[[nodiscard]] std::string tracks_map_svg(const std::vector<MapTrack>& tracks, const terrain::TerrainDatabase* terrain,
                                         const std::vector<MapMark>& marks = {});

}  // namespace tedavis::host_sim
