/// The foci of a frame for drawers of data: the region and values of each, and the look of the context.
///
/// Plain data; pure functions; any thread.
#pragma once

#include <array>

#include "render_core/design/focus_settings.hpp"
#include "render_core/scene/focus_map.hpp"
#include "render_core/scene/focus_region.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

struct FrameFoci {
    scene::FocusRegions regions;                                   ///< one per focus; for data foci the data's positions
    std::array<scene::FocusMap, scene::kMaxFoci> maps{};           ///< for valid regions
    const design::FocusList* foci = nullptr;                       ///< the design's foci; null: none
    std::array<scene::FocusValueRange, scene::kMaxFoci> ranges{};  ///< value ranges of data foci
    design::FocusData look;                                        ///< look of data in the context
    double least_degree = 0;                                       ///< least degree of the intermediate context
    glm::dvec3 own_ship{0};                                        ///< ECEF
    bool has_own_ship = false;                                     ///< its position is known

    /// False where no focus is in effect, so that nothing is context.
    [[nodiscard]] bool is_any() const noexcept;
    [[nodiscard]] bool changes_data() const noexcept { return look.is_any() && is_any(); }
};

/// The look of data at a degree of focus, as shares of their look without foci.
struct FocusLook {
    double detail = 1, brightness = 1, saturation = 1, size = 1;
    double aggregate = 1;  ///< glyphs aggregate this many by this many
    bool is_hidden = false;
};
[[nodiscard]] FocusLook look_at(const FrameFoci& foci, double degree) noexcept;
/// Returns the colour made greyer at the same lightness, then darker; the opacity is unchanged.
[[nodiscard]] design::Color shown_color(const FocusLook& look, design::Color color) noexcept;

/// Returns a key, never 0; equal keys mean equal changes of data at these times.
[[nodiscard]] std::uint64_t key_of(const FrameFoci& foci, std::int64_t time_ns, bool has_date) noexcept;

/// True where a data focus selects a layer that has the requested attribute (for wind also "speed").
[[nodiscard]] bool is_meant(const design::FocusOfData& data, const scene::Layer& layer) noexcept;

}  // namespace tedavis::draw
