/// Wind as barbs that face the eye (wind_barb.hpp), of glyphs that a view has selected: single places, and means of several.
///
/// Up on a barb is ahead over the ground, as on a map that turns with the own ship; seen from above it is the picture's up. The
/// nearest come first; what would cover another billboard, and what terrain stands before, is hidden. Colour by the mean speed;
/// `link` leads down to the ground. Pure but for the ground that is asked, once a link. Bounded.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::draw {

/// Of the text's size: a staff; and the least distance of two barbs.
inline constexpr float kStaff = 2.2f, kBarbSpacing = 4.4f;
[[nodiscard]] inline double barb_spacing_px(const BillboardSheet& sheet) {
    return static_cast<double>(kBarbSpacing * sheet.text_px());
}

/// `glyphs` of wind: their places relative to the sheet's eye. Counts their members.
[[nodiscard]] ElementCount add_wind_barbs(BillboardSheet& sheet, const ElementInput& input,
                                          base::Span<const scene::SelectedGlyph> glyphs);

}  // namespace tedavis::draw
