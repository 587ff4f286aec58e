/// Signs at the lines of storm cells' motion (cell_motion.hpp): after how many minutes the front is at the farthest barb,
/// "15 MIN".
///
/// A sign is drawn below its barb, else above or beside it, where it covers no other sign and no symbology and the barb is
/// visible; else it is left out. Lines without a barb have no sign. Pure, apart from queries to the ground. Thread  the
/// display's. Memory none; the mesh is scratch memory. Bounded: as area_prisms.hpp.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

/// Returns the number of signs that were drawn.
std::uint32_t add_motion_times(BillboardSheet& sheet, SolidMesh& mesh, const ElementInput& input);

}  // namespace tedavis::draw
