/// Cues to foci that are not visible: an arrow at the picture's edge for a focus outside it, a hollow sign at the position of a
/// focus behind terrain, each with name and distance. They do not cover the symbology or other signs.
///
/// A focus is visible where one of its points is in the picture and not hidden by drawn terrain (terrain/line_of_sight.hpp).
/// Points are on the ground, for volumes in their middle. There is no cue while the own ship is in the focus. Distances are
/// from the own ship, else from the eye point.
///
/// Pure, apart from queries to the ground and the line of sight. Bounded. Thread  the sheet's.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/frame_foci.hpp"

namespace tedavis::draw {

enum class FocusSight : std::uint8_t {
    nowhere,  ///< the focus is not shown
    around,   ///< the own ship is in it
    seen,
    behind_terrain,
    out_of_view,
};
/// Returns the text for records: "behind terrain".
[[nodiscard]] const char* name_of(FocusSight sight) noexcept;

struct FocusCue {
    FocusSight sight = FocusSight::nowhere;
    double distance_m = 0;  ///< to the point that the cue leads to
    bool is_drawn = false;  ///< false where no cue is needed or there is no room
};
using FocusCues = std::array<FocusCue, scene::kMaxFoci>;

/// Adds the cues to the sheet; distances are in nautical miles or kilometres.
[[nodiscard]] FocusCues add_focus_cues(BillboardSheet& sheet, const FrameFoci& foci, scene::Ground& ground,
                                       base::DisplayUnits units);

}  // namespace tedavis::draw
