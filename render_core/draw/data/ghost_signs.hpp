/// Draws other flights that are shown beside this one for comparison: layers of lines of the role `ghost`.
///
/// Each has an aeroplane at the place of the frame's time (between its points, in proportion of time), its name beside it, and
/// its path as a thin line: solid for kGhostFlown_s behind it, and faint for kGhostComes_s ahead of it. Seen from above the
/// aeroplane points along the path. `link` draws a line down to the ground. A ghost states nothing about the own flight: it has
/// no relative height, no arrow, no age, and the colour of its element. Before its first point, after its last one, and where its
/// points have no times, it is hidden.
///
/// Terrain hides the line pixel by pixel, and the aeroplane where it is behind it. Signs that were placed before, those of
/// traffic and of obstacles among them, are never covered by an aeroplane; a name without room is left out.
///
/// Pure, apart from queries to the ground. Bounded: kGhostLine_s divides the line.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

/// Colour of ghosts in a design without an element for them; nothing else in the shipped designs has it.
inline constexpr design::Color kGhostColor{0xE0, 0x8C, 0xFF};
inline constexpr int kGhostFlown_s = 120, kGhostComes_s = 120, kGhostLine_s = 4;

/// True for a layer whose features are ghosts.
[[nodiscard]] bool shows_ghosts(const scene::Layer& layer);

/// The place of a feature at a time, in the layer's datum.
struct GhostPlace {
    scene::ScenePoint point{};
    bool is_known = false;  ///< false: the ghost has no position at that time
};
[[nodiscard]] GhostPlace ghost_place(const scene::Layer& layer, std::uint32_t feature, std::int64_t time_ns);

[[nodiscard]] ElementCount add_ghost_signs(BillboardSheet& sheet, const ElementInput& input);

}  // namespace tedavis::draw
