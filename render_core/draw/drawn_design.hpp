/// A design, and what the programs of the terrain write for it (terrain_program.hpp). Pure; any thread.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/draw/ground_focus_kind.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {

/// What a terrain program writes. All except `color` are drawn off-screen, for the picture pass.
enum class TerrainOutput : std::uint8_t {
    color,               ///< the picture
    color_and_distance,  ///< the distance in alpha: silhouettes are found in it; with blur round a focus how sharp it is
    code,                ///< heights, light and distance of terrain_code.frag
};
/// A design, and what terrain programs write for it.
struct DrawnDesign {
    const design::DesignSettings* design = nullptr;
    TerrainOutput output = TerrainOutput::color;
    bool has_focus = false;    ///< foci are drawn: one is in effect and changes the ground
    bool is_deferred = false;  ///< ground that rays meet is shaded once a pixel, from a geometry picture
    bool on_es3 = true;        ///< the device's lane
};
using DrawnDesigns = base::Span<const DrawnDesign>;

/// True where the distances in the picture are only used for volumetric light. Warning colours are then written as near, so that
/// no shaft darkens them, and the picture needs no separate pass before the others.
[[nodiscard]] bool has_shafts_only(const design::DesignSettings& design) noexcept;
/// True where there is blur round a focus; degrees of focus are then written instead of distances.
[[nodiscard]] bool blurs_context(const DrawnDesign& design) noexcept;
/// True where terrain is drawn off-screen for the picture pass; where its alpha serves light shafts or blur round foci alone it
/// needs no pass of its own.
[[nodiscard]] bool goes_off_screen(const DrawnDesign& design) noexcept;
/// True where the picture pass draws the air before the ground, once a pixel, by distances of fine_distance.frag; else the
/// programs of the terrain draw it.
[[nodiscard]] bool has_air_in_picture(const DrawnDesign& design) noexcept;
/// Returns the cheapest output that shows the style and the data on a device with or without off-screen depth; `focus` is the
/// variant of foci that is drawn.
[[nodiscard]] TerrainOutput output_of(const design::DesignSettings& design, bool off_screen_depth,
                                      const GroundFocusKind& focus = {}) noexcept;
/// Slots of chunks from this one on have no number in a geometry picture, which has ten bits for it.
inline constexpr std::uint32_t kMaxGeometrySlots = 1023;
/// The texture unit of geometry pictures, beyond those of smaller devices; bytes a pixel of their texture and that of depths.
inline constexpr std::uint32_t kGeometryUnit = 11, kShadedTexelBytes = 20;

/// What a device can draw of a design, besides what designs ask for.
struct DrawAbility {
    bool off_screen_depth = true;
    bool is_es3 = true;
    bool shades_rays = false;  ///< it has room for a geometry picture of its own size (drawers/geometry_picture.hpp)
};
[[nodiscard]] DrawAbility ability_of(const effects::DeviceSettings& device) noexcept;

/// With that output, as such a device draws it. `has_focus`: whether foci are to be drawn, where the design has any that change
/// the ground. A design that asks for rays and has more than codes can say is drawn off screen, with deferred shading, where the
/// device shades rays; not on a flat ground or with magnified foci, which show the ground elsewhere than it is, and not where its
/// picture needs no pass of its own.
[[nodiscard]] DrawnDesign drawn_as(const design::DesignSettings& design, const DrawAbility& ability, bool has_focus) noexcept;

}  // namespace tedavis::draw
