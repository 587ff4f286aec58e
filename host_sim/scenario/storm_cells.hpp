/// Generated thunderstorm cells: areas of radar echo that move straight on, each with a speed and a direction of its own.
///
/// At the bearing b from a cell's centre, its outline is at the distance r (1 + 0.18 cos 2(b - b2) + 0.08 cos 3(b - b3)). The
/// echo falls with the square of the distance, by kOutlineDrop_db at the outline, where a smooth random texture of standard
/// deviation kTexture_db, which is 0 at the centre, makes it irregular; texture and outline move with the cell.
/// Units    metres east and north of the strip; dBZ. Pure after the random values are drawn.
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
inline constexpr double kNoEcho_dbz = -10;  ///< value within a radar's range without an echo

class StormCell {
public:
    StormCell(const StormSettings& settings, SeededRandom& random);

    double east_m, north_m;  ///< of the middle at the start
    double intensity_dbz, sigma_dbz;
    double speed_mps, toward_rad;
    double base_msl_m, top_msl_m;

    /// Distance of the outline from the centre.
    [[nodiscard]] double outline_m(double bearing_rad) const;
    /// Echo at a place and a time after the start; at least kNoEcho_dbz.
    [[nodiscard]] double echo_dbz(double east_m, double north_m, double time_s) const;

private:
    double radius_m_, second_rad_, third_rad_;
    SeededWaves texture_;
};

[[nodiscard]] std::vector<StormCell> draw_storm_cells(const StormSettings& settings, SeededRandom& random);

/// Returns the layer "storm": an area for each cell, at its position at the start, with "intensity" (dBZ; standard deviation),
/// "speed" (m/s; standard deviation), "toward" (rad), "floor" and "ceiling" (m, MSL), which have no uncertainty. It is valid for
/// an hour.
[[nodiscard]] LayerDraft make_storm_layer(const std::vector<StormCell>& cells, const LocalPlane& plane, base::Time start);

}  // namespace tedavis::host_sim
