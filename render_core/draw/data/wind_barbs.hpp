/// Draws wind as barbs that face the viewer (wind_barb.hpp), for the glyphs that a view has selected: single sites, and means
/// of several.
///
/// Up on a barb is the view's direction over the ground, as on a track-up map; in a view from above it is the picture's up. The
/// nearest are drawn first; barbs that would cover another billboard, or are behind terrain, are hidden. The colour is that of
/// the mean speed; `link` draws a line to the ground. Pure, apart from one query to the ground per link. Bounded.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::draw {

/// Length of a staff and least distance of two barbs, in text sizes.
inline constexpr float kStaff = 2.2f, kBarbSpacing = 6.0f;
[[nodiscard]] inline double barb_spacing_px(const BillboardSheet& sheet) {
    return static_cast<double>(kBarbSpacing * sheet.text_px());
}

/// `glyphs` of wind: their places relative to the sheet's eye. Counts their members.
[[nodiscard]] ElementCount add_wind_barbs(BillboardSheet& sheet, const ElementInput& input,
                                          base::Span<const scene::SelectedGlyph> glyphs);

}  // namespace tedavis::draw
