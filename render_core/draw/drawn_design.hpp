/// A design, and what the programs of the terrain write for it (terrain_program.hpp). Pure; any thread.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/draw/ground_focus_kind.hpp"

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
    bool has_focus = false;  ///< foci are drawn: one is in effect and changes the ground
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
/// With that output. `has_focus`: whether foci are to be drawn, where the design has any that change the ground.
[[nodiscard]] DrawnDesign drawn_as(const design::DesignSettings& design, bool off_screen_depth, bool has_focus) noexcept;

}  // namespace tedavis::draw
