/// The cost model of a frame: ms = fixed + ms_per_megapixel * megapixels + ms_per_thousand * things / 1000, summed over what is
/// computed. The coefficients belong to one device on one machine and come from its calibration; without them costs are
/// unknown.
///
/// Pure. Thread  any. Memory  none; the table is of fixed size.
#pragma once

#include <type_traits>

#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {

/// Milliseconds, not negative.
struct CostLine {
    double fixed_ms = 0;
    double ms_per_megapixel = 0;
    double ms_per_thousand = 0;
};

/// Costs of a frame that are not effects of the table.
enum class Overhead : std::uint8_t {
    frame,     ///< sky, symbology and everything that has no other line
    elements,  ///< data over the terrain, per thousand features
    glyphs,    ///< glyphs of fields, per thousand glyphs
    rays,      ///< terrain by rays, in place of the cost of `terrain`; all 0: it was not measured
    count_
};
inline constexpr std::size_t kOverheads = static_cast<std::size_t>(Overhead::count_);
inline constexpr std::array<std::string_view, kOverheads> kOverheadNames{"frame", "elements", "glyphs", "rays"};

struct CostTable {
    bool is_known = false;
    std::array<CostLine, kEffectCount> effects{};
    std::array<CostLine, kOverheads> overheads{};

    [[nodiscard]] CostLine& operator[](Effect effect) { return effects[static_cast<std::size_t>(effect)]; }
    [[nodiscard]] CostLine& operator[](Overhead overhead) { return overheads[static_cast<std::size_t>(overhead)]; }
    [[nodiscard]] const CostLine& operator[](Effect effect) const { return effects[static_cast<std::size_t>(effect)]; }
    [[nodiscard]] const CostLine& operator[](Overhead overhead) const { return overheads[static_cast<std::size_t>(overhead)]; }
    /// Whether it is known what terrain by rays costs.
    [[nodiscard]] bool knows_rays() const { return is_known && (*this)[Overhead::rays].ms_per_megapixel > 0; }
};
static_assert(std::is_trivially_copyable_v<CostTable>);

/// The counts of a frame that costs depend on.
struct FrameCounters {
    double megapixels = 0;  ///< of the picture
    double triangles = 0;   ///< of the terrain
    double maps = 0;        ///< adjacent maps
    double elements = 0;    ///< features drawn over the terrain, without glyphs of fields
    double glyphs = 0;
    bool is_traced = false;  ///< the terrain, by rays
};

/// The count, besides pixels, that an effect's cost depends on.
enum class CostThing : std::uint8_t { none, triangles, maps };
inline constexpr std::array<std::string_view, 3> kCostThingNames{"", "triangles", "maps"};
[[nodiscard]] CostThing thing_of(Effect effect) noexcept;

[[nodiscard]] double modelled_ms(const CostLine& line, double megapixels, double things) noexcept;
/// Returns the cost of terrain by triangles or by rays, as the counters state; of triangles where that of rays is unknown.
[[nodiscard]] double terrain_ms(const CostTable& table, const FrameCounters& counters) noexcept;
/// Returns the cost of a frame with the effects that the plan runs, ms.
[[nodiscard]] double modelled_ms(const CostTable& table, const FramePlan& plan, const FrameCounters& counters) noexcept;

}  // namespace tedavis::effects
