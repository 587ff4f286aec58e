/// Selects the search that finds the hits of rays, with its numbers of steps: exact, or one of the approximate searches of the
/// thesis's tracer (6.2.2.2). Plain data.
#pragma once

#include <cstdint>

#include "render_core/raytrace/search/uniform_search.hpp"

namespace tedavis::raytrace {

enum class SearchKind : std::uint8_t {
    exact,  ///< maximum mipmap, then the intersection with the surface of each remaining cell
    cells,  ///< the same cells; uniform steps and halvings in each
    ray,    ///< uniform steps and halvings over the whole ray
    cones,  ///< steps that cones over the posts permit, over a bilinear surface
};

struct SearchSettings {
    static constexpr std::uint32_t kMaxSteps = 65536;

    SearchKind kind = SearchKind::exact;
    /// 1..kMaxSteps; ray: over the whole ray, cells: in each cell, cones: at most as many in each straight piece of the ray
    std::uint32_t steps = 0;
    std::uint32_t halvings = 0;  ///< of the step with the hit, 0..UniformSearch::kMaxHalvings

    [[nodiscard]] constexpr bool is_exact() const { return kind == SearchKind::exact; }
    [[nodiscard]] UniformSearch uniform() const { return {steps, halvings}; }
};

/// Returns a search with its default numbers of steps and halvings; the exact one has none.
[[nodiscard]] constexpr SearchSettings usual_search(SearchKind kind) {
    constexpr std::uint32_t kHalvings = 12;
    switch (kind) {
        case SearchKind::cells: return {kind, 4, kHalvings};
        case SearchKind::ray: return {kind, 1024, kHalvings};
        case SearchKind::cones: return {kind, 96, kHalvings};
        case SearchKind::exact: break;
    }
    return {};
}

[[nodiscard]] constexpr bool operator==(const SearchSettings& a, const SearchSettings& b) {
    return a.kind == b.kind && a.steps == b.steps && a.halvings == b.halvings;
}

}  // namespace tedavis::raytrace
