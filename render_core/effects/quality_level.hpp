/// The quality levels between the picture that a design requests and cheaper ones. At each further level the terrain is at least
/// as coarse, glyphs of fields are at least as sparse, and at least the same effects are given up. Which levels there are is
/// measured (`tedavis calibrate`) and stands in the calibration file (calibration.hpp). Terrain itself, warning colours, ground
/// data, adjacent maps, symbology, and features of the scene (no-go areas, obstacles, storm cells, traffic) are kept at every
/// level: only effects whose row says may_be_given_up can be given up.
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include "render_core/effects/cost_model.hpp"

namespace tedavis::effects {

struct QualityLevel {
    double tau_factor = 1;     ///< factor of the error that the design allows the terrain; at least 1
    double detail_factor = 1;  ///< factor of the detail of glyphs of fields, 0..1
    EffectSet given_up;
    // As measured over the pictures of the calibration:
    double ms = 0;           ///< mean time of a frame
    double error_px = 0;     ///< greatest error of the drawn terrain, pixels
    double error_color = 0;  ///< mean CIEDE2000 against the design's own picture
};

/// The largest number of levels.
inline constexpr std::size_t kQualityLevelCount = 6;

/// The richest level first. By default there is only the design's own picture, so nothing is reduced.
struct QualityLevels {
    std::array<QualityLevel, kQualityLevelCount> at{};
    std::uint8_t count = 1;
};
static_assert(std::is_trivially_copyable_v<QualityLevels>);

/// Returns whether `level` takes no longer than `other`, has no greater error, and is better in at least one of the three.
[[nodiscard]] bool dominates(const QualityLevel& level, const QualityLevel& other) noexcept;

/// Returns what is wrong with the n-th level, compared with those before it; empty: nothing. The first level must be the
/// design's own picture. Each further one must be cheaper than the one before, keep no more than it, give up only what may be
/// given up, and must not be dominated, nor dominate a level before it.
[[nodiscard]] std::string_view fault_of(const QualityLevels& levels, std::size_t n) noexcept;

/// Returns the pixel error allowed for the terrain at a level, limited to `coarse_px` where `design_px` is below it: beyond
/// that the terrain would be degraded and lose its warning colours.
[[nodiscard]] double tau_px_on(const QualityLevel& level, double design_px, double coarse_px) noexcept;

/// Estimates how a frame's counters change with the terrain's error and the glyphs' detail. Costs are overestimated in both
/// directions: a finer terrain is assumed to have more triangles than it really has, and a coarser one too.
struct Quality {
    double tau_px = 1;
    double detail = 1;  ///< detail of the glyphs, 0..1
};
[[nodiscard]] FrameCounters counters_at(const FrameCounters& counters, const Quality& from, const Quality& to) noexcept;

}  // namespace tedavis::effects
