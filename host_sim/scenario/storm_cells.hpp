/// Generated thunderstorm cells: blobs of echo that move straight on, each with a speed and a direction of its own.
///
/// At the bearing b from its middle a cell's outline is r (1 + 0.18 cos 2(b - b2) + 0.08 cos 3(b - b3)) away. The echo falls
/// with the square of the distance, by kOutlineDrop_db at the outline, where a smooth texture of kTexture_db (a standard
/// deviation that is nothing in the middle) makes it ragged; texture and outline move with the cell.
/// Units    metres east and north of the strip; dBZ. Pure after the draw.
#pragma once

#include <vector>

#include "host_sim/scenario/local_plane.hpp"
#include "host_sim/scenario/seeded_waves.hpp"
#include "host_sim/scenario/weather_settings.hpp"
#include "host_sim/scene_builder/scene_draft.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

inline constexpr double kStormBaseSpread_m = 200, kStormTopSpread_m = 1000;
inline constexpr double kOutlineDrop_db = 12;
inline constexpr double kTexture_db = 1;
inline constexpr double kNoEcho_dbz = -10;  ///< where a radar looks and there is none

class StormCell {
public:
    StormCell(const StormSettings& settings, SeededRandom& random);

    double east_m, north_m;  ///< of the middle at the start
    double intensity_dbz, sigma_dbz;
    double speed_mps, toward_rad;
    double base_msl_m, top_msl_m;

    /// Of the outline from the middle.
    [[nodiscard]] double outline_m(double bearing_rad) const;
    /// At a place, so long after the start. Not below kNoEcho_dbz.
    [[nodiscard]] double echo_dbz(double east_m, double north_m, double time_s) const;

private:
    double radius_m_, second_rad_, third_rad_;
    SeededWaves texture_;
};

[[nodiscard]] std::vector<StormCell> draw_storm_cells(const StormSettings& settings, SeededRandom& random);

/// The layer "storm": an area a cell, at its place at the start, with "intensity" (dBZ; standard deviation), "speed" (m/s;
/// standard deviation), "toward" (rad), "floor" and "ceiling" (m, MSL), which state none. Valid for an hour.
[[nodiscard]] LayerDraft make_storm_layer(const std::vector<StormCell>& cells, const LocalPlane& plane, base::Time start);

}  // namespace tedavis::host_sim
