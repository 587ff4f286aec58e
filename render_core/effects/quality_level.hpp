/// The quality levels between the picture that a design requests and the cheapest one with the same information. At
/// each further level the terrain is coarser, glyphs of fields are sparser, and more decorative effects are given up. Terrain
/// itself, warning colours, ground data, adjacent maps, symbology, and features of the scene (no-go areas, obstacles, storm
/// cells, traffic) are kept at every level.
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include "render_core/effects/cost_model.hpp"

namespace tedavis::effects {

struct QualityLevel {
    double tau_factor = 1;     ///< factor of the error that the design allows the terrain
    double detail_factor = 1;  ///< factor of the detail of glyphs of fields
};
inline constexpr std::size_t kQualityLevelCount = 6;
inline constexpr std::array<QualityLevel, kQualityLevelCount> kQualityLevels{
    {{1, 1}, {1.4, 0.8}, {2, 0.65}, {2.8, 0.5}, {4, 0.35}, {4, 0.2}}};

/// Returns the effects given up at a level, by EffectRow::given_up_from: decorative effects first, those that show form last.
/// Haze is kept: it is cheap, and the terrain's level of detail relies on it.
[[nodiscard]] EffectSet given_up_on(std::size_t quality_level) noexcept;

/// Returns the pixel error allowed for the terrain at a level, limited to `coarse_px` where `design_px` is below it: beyond
/// that the terrain would be degraded and lose its warning colours.
[[nodiscard]] double tau_px_on(std::size_t quality_level, double design_px, double coarse_px) noexcept;

/// Estimates how a frame's counters change with the terrain's error and the glyphs' detail. Costs are overestimated in both
/// directions: a finer terrain is assumed to have more triangles than it really has, and a coarser one too.
struct Quality {
    double tau_px = 1;
    double detail = 1;  ///< detail of the glyphs, 0..1
};
[[nodiscard]] FrameCounters counters_at(const FrameCounters& counters, const Quality& from, const Quality& to) noexcept;

}  // namespace tedavis::effects
