/// Cues that lead to foci that are not seen: beyond the picture an arrow at its edge, behind terrain a hollow sign where the
/// focus is, each with the name and the distance. They keep clear of the symbology and of all signs.
///
/// A focus is seen where one of its points is in the picture and no drawn terrain stands before it (terrain/line_of_sight.hpp).
/// Points stand on the ground, in volumes in their middle. Who is in a focus needs no cue. Distances are from the own ship, else
/// from the eye.
///
/// Pure but for the ground and the sight that are asked. Bounded. Thread  the sheet's.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/frame_foci.hpp"

namespace tedavis::draw {

enum class FocusSight : std::uint8_t {
    nowhere,  ///< not shown
    around,   ///< the own ship is in it
    seen,
    behind_terrain,
    out_of_view,
};
/// For records: "behind terrain".
[[nodiscard]] const char* name_of(FocusSight sight) noexcept;

struct FocusCue {
    FocusSight sight = FocusSight::nowhere;
    double distance_m = 0;  ///< to the point that the cue leads to
    bool is_drawn = false;  ///< false where none is needed, or none has room
};
using FocusCues = std::array<FocusCue, scene::kMaxFoci>;

/// In the sheet's room; distances in nautical miles, or in kilometres.
[[nodiscard]] FocusCues add_focus_cues(BillboardSheet& sheet, const FrameFoci& foci, scene::Ground& ground, bool is_metric);

}  // namespace tedavis::draw
