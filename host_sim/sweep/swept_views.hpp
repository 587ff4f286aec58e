/// The results of a sweep of viewpoints.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/evaluation/picture_measures.hpp"
#include "host_sim/sweep/place_in_picture.hpp"
#include "host_sim/sweep/viewpoints_round.hpp"

namespace tedavis::host_sim {

enum class PlaceSight : std::uint8_t { seen, behind_terrain, outside_picture };
/// "seen", "behind terrain", "outside the picture"
[[nodiscard]] const char* sight_name(PlaceSight sight);

struct SweptView {
    Viewpoint viewpoint;
    std::string file;  ///< of the picture, in the sweep's folder
    std::uint64_t hash = 0;
    PictureMeasures measures;
    PlaceSight sight = PlaceSight::seen;
    PlaceInPicture place;
    PlaceSaliency saliency;  ///< if the place lies in the picture, also behind terrain; measured without symbology
    std::string small_png;   ///< of the picture, for the report
};

struct SkippedViewpoint {
    Viewpoint viewpoint;
    std::string reason;  ///< "below the ground"
};

/// A view that stands out, as the evaluation shows moments.
struct StandingOut {
    std::string title;  ///< "most clutter", "the place draws the eye most"
    std::size_t index = 0;
    ClutterOpinions opinions;
    std::string picture_png, heat_png, edges_png;
};

struct Sweep {
    std::string terrain, scene, design, device, gl;  ///< as they were named
    earth::Geodetic place;
    double place_msl_m = 0, radius_m = 0;
    SweepRings rings;
    std::vector<SweptView> views;
    std::vector<SkippedViewpoint> skipped;
    std::vector<StandingOut> standing_out;  ///< in the order of views, each once
    bool interrupted = false;               ///< later viewpoints are missing
};

/// Return the index of the first view with the least or greatest clutter; there must be at least one view.
[[nodiscard]] std::size_t least_cluttered(const std::vector<SweptView>& views);
[[nodiscard]] std::size_t most_cluttered(const std::vector<SweptView>& views);
/// Returns the index of the first view with the greatest PlaceSaliency::times_mean() among those from which the place is seen;
/// nothing where there is none.
[[nodiscard]] std::optional<std::size_t> strongest_place(const std::vector<SweptView>& views);

}  // namespace tedavis::host_sim
