/// Where a storm cell goes: an arrow from its front on, as long as it comes in kMotionAhead_s, so that its tip is where the front
/// will be then. It has the cell's colour, opaque, with a dark rim, and is a body, so that it is seen from every side.
///
/// Pure. Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kMotionAhead_s = 300;
inline constexpr double kMinMotion_mps = 0.5;  ///< below, a cell stands: an arrow would have no length

/// Where the arrow begins.
struct CellFront {
    glm::dvec3 place{0};    ///< ECEF, m
    double toward_rad = 0;  ///< clockwise from true north
    bool is_known = false;
};

/// Whether a feature's "speed" (m/s) and "toward" (rad) say that it moves.
[[nodiscard]] bool has_motion(const ElementInput& input, std::uint32_t feature);
/// Nothing where the front is not known or the batch has no room.
void add_motion_arrow(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, std::uint32_t feature,
                      const CellFront& from);

}  // namespace tedavis::draw
