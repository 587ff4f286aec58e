/// What a frame costs, as numbers: ms = fixed + a megapixel's * megapixels + a thousand things' * things / 1000, summed over what
/// runs. The coefficients belong to one device on one machine, and come from its calibration; without them a cost is not known.
///
/// Pure. Thread  any. Memory  none; the table is of fixed size.
#pragma once

#include <type_traits>

#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {

/// Milliseconds, from 0 on.
struct CostLine {
    double fixed_ms = 0;
    double ms_per_megapixel = 0;
    double ms_per_thousand = 0;
};

/// What a frame costs beside the effects of the table.
enum class Overhead : std::uint8_t {
    frame,     ///< sky, symbology and everything that no other line has
    elements,  ///< data over the terrain, a thousand features
    glyphs,    ///< of fields, a thousand glyphs
    count_
};
inline constexpr std::size_t kOverheads = static_cast<std::size_t>(Overhead::count_);
inline constexpr std::array<std::string_view, kOverheads> kOverheadNames{"frame", "elements", "glyphs"};

struct CostTable {
    bool is_known = false;
    std::array<CostLine, kEffectCount> effects{};
    std::array<CostLine, kOverheads> overheads{};

    [[nodiscard]] CostLine& operator[](Effect effect) { return effects[static_cast<std::size_t>(effect)]; }
    [[nodiscard]] CostLine& operator[](Overhead overhead) { return overheads[static_cast<std::size_t>(overhead)]; }
};
static_assert(std::is_trivially_copyable_v<CostTable>);

/// How much of everything a frame has.
struct FrameCounters {
    double megapixels = 0;  ///< of the picture
    double triangles = 0;   ///< of the terrain
    double maps = 0;        ///< beside the picture
    double elements = 0;    ///< features that are drawn over the terrain, but for glyphs of fields
    double glyphs = 0;
};

/// What an effect's cost grows with beside pixels.
enum class CostThing : std::uint8_t { none, triangles, maps };
inline constexpr std::array<std::string_view, 3> kCostThingNames{"", "triangles", "maps"};
[[nodiscard]] CostThing thing_of(Effect effect) noexcept;

[[nodiscard]] double modelled_ms(const CostLine& line, double megapixels, double things) noexcept;
/// Of a frame with everything that the plan runs.
[[nodiscard]] double modelled_ms(const CostTable& table, const FramePlan& plan, const FrameCounters& counters) noexcept;

}  // namespace tedavis::effects
