/// Chooses what terrain programs write for a design, and in which pass it is shaded. Pure; any thread.
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
    color_and_distance,  ///< the distance in alpha, for silhouettes; with blur round a focus the degree of focus
    code,                ///< height, light and distance codes (terrain_code.frag)
};
/// A design, and what terrain programs write for it.
struct DrawnDesign {
    const design::DesignSettings* design = nullptr;
    TerrainOutput output = TerrainOutput::color;
    bool has_focus = false;    ///< foci are drawn: one is in effect and changes the ground
    bool is_deferred = false;  ///< ray-traced ground is shaded once per pixel, from a geometry picture
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
/// Chunks in slots from this one on have no number in a geometry picture, whose numbers have ten bits.
inline constexpr std::uint32_t kMaxGeometrySlots = 1023;
/// The texture unit of geometry pictures, which devices with fewer units do not have; bytes per pixel of the geometry picture and
/// of the texture of depths together.
inline constexpr std::uint32_t kGeometryUnit = 11, kShadedTexelBytes = 20;

/// The capabilities of a device on which the choice depends.
struct DrawAbility {
    bool off_screen_depth = true;
    bool is_es3 = true;
    bool shades_rays = false;  ///< it can shade a geometry picture of its size (drawers/geometry_picture.hpp)
};
[[nodiscard]] DrawAbility ability_of(const effects::DeviceSettings& device) noexcept;

/// Returns how a device draws a design. `has_focus`: the design's foci are in effect, if any of them change the ground. A design
/// that requests ray tracing and shows more than codes can represent has deferred shading where the device `shades_rays`; not
/// with flat ground or magnified foci, which displace the ground, nor where the terrain is not drawn off-screen for the picture
/// pass (goes_off_screen()).
[[nodiscard]] DrawnDesign drawn_as(const design::DesignSettings& design, const DrawAbility& ability, bool has_focus) noexcept;

}  // namespace tedavis::draw
