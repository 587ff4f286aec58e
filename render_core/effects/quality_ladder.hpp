/// The rungs between the picture that a design asks for and the cheapest one that still says the same: on each the terrain is
/// coarser, glyphs of fields stand wider apart, and more of what only embellishes is given up. Terrain itself, warning colours,
/// ground data, maps beside the picture, symbology, and features of the scene (no-go areas, obstacles, storm cells, traffic) are
/// on no rung: they stay as they are.
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include "render_core/effects/cost_model.hpp"

namespace tedavis::effects {

struct Rung {
    double tau_factor = 1;     ///< times the error that the design allows the terrain
    double detail_factor = 1;  ///< times the detail of glyphs of fields
};
inline constexpr std::size_t kRungs = 6;
inline constexpr std::array<Rung, kRungs> kLadder{{{1, 1}, {1.4, 0.8}, {2, 0.65}, {2.8, 0.5}, {4, 0.35}, {4, 0.2}}};

/// By EffectRow::given_up_from: what embellishes goes first, what tells forms apart last. Haze stays: it is cheap, and the
/// terrain's errors are judged by what it hides.
[[nodiscard]] EffectSet given_up_on(std::size_t rung) noexcept;

/// What the terrain may miss on a rung: never so much more than `design_px` that `coarse_px` is passed, beyond which it would be
/// degraded and lose its warning colours.
[[nodiscard]] double tau_px_on(std::size_t rung, double design_px, double coarse_px) noexcept;

/// How a frame's counters change with the terrain's error and the detail of glyphs. Errs to the dear side both ways: a finer
/// terrain is taken for as large as the error's ratio, a coarser one for larger than it is.
struct Quality {
    double tau_px = 1;
    double detail = 1;  ///< of the glyphs, 0..1
};
[[nodiscard]] FrameCounters counters_at(const FrameCounters& counters, const Quality& from, const Quality& to) noexcept;

}  // namespace tedavis::effects
