/// The foci of a frame, as those who draw data see them: where each is, which values it means, and what becomes of the rest.
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
    scene::FocusRegions regions;                          ///< as many as the design has foci; of data where those data are
    std::array<scene::FocusMap, scene::kMaxFoci> maps{};  ///< of the valid ones
    const design::FocusList* foci = nullptr;              ///< the design's; null: there are none
    std::array<scene::FocusValueRange, scene::kMaxFoci> ranges{};  ///< of data foci
    design::FocusData look;                                        ///< of the data of the context
    double least_degree = 0;                                       ///< of the intermediate context
    glm::dvec3 own_ship{0};                                        ///< ECEF
    bool has_own_ship = false;                                     ///< its position is known

    /// False: there is no focus, or none is anywhere, and nothing steps back.
    [[nodiscard]] bool is_any() const noexcept;
    [[nodiscard]] bool changes_data() const noexcept { return look.is_any() && is_any(); }
};

/// What data of a degree look like: shares of what they are without a focus.
struct FocusLook {
    double detail = 1, brightness = 1, saturation = 1, size = 1;
    double aggregate = 1;  ///< glyphs stand for so many by so many
    bool is_hidden = false;
};
[[nodiscard]] FocusLook look_at(const FrameFoci& foci, double degree) noexcept;
/// Greyer at the same lightness, then darker towards black; as opaque as it was.
[[nodiscard]] design::Color shown_color(const FocusLook& look, design::Color color) noexcept;

/// Never 0. Equal where both change data alike at these times.
[[nodiscard]] std::uint64_t key_of(const FrameFoci& foci, std::int64_t time_ns, bool has_date) noexcept;

/// Whether a data focus means a layer, and it has what the focus asks for: an attribute of that name, of wind also "speed".
[[nodiscard]] bool is_meant(const design::FocusOfData& data, const scene::Layer& layer) noexcept;

}  // namespace tedavis::draw
