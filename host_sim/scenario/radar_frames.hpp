/// The storm as seen by a generated radar at the strip: the layer "radar", from the start on every kRadarInterval_s, up to the
/// first time that is not before the flight's end (kMaxRadarFrames at most).
///
/// Its attribute "reflectivity" (dBZ) is the strongest echo of the cells (storm_cells.hpp), kNoEcho_dbz where there is none, and
/// missing beyond the range. The beam widens and rises with the distance d, so the quality falls from 1 at the radar to
/// 1 - kQualityLost at the range r: it is 1 - kQualityLost (d / r)^2. The uncertainty of a value is 1 minus its quality.
#pragma once

#include <vector>

#include "host_sim/scenario/scenario.hpp"
#include "host_sim/scenario/storm_cells.hpp"
#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

inline constexpr std::uint32_t kRadarPosts = 73;
inline constexpr int kRadarInterval_s = 300;
inline constexpr int kMaxRadarFrames = 24;
inline constexpr double kQualityLost = 0.7;

/// The scenario must have weather.
[[nodiscard]] LayerDraft make_radar_layer(const Scenario& scenario, const std::vector<StormCell>& cells, base::Time flight_end);

}  // namespace tedavis::host_sim
