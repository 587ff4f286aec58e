/// The motion of a storm cell: an arrow from its front to where the front will be after kMotionAhead_s. The arrow is a solid in
/// the cell's opaque colour with a dark rim, so that it is visible from all sides.
///
/// Pure. Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kMotionAhead_s = 300;
inline constexpr double kMinMotion_mps = 0.5;  ///< below this speed a cell has no arrow

/// The beginning of the arrow.
struct CellFront {
    glm::dvec3 place{0};    ///< ECEF, m
    double toward_rad = 0;  ///< clockwise from true north
    bool is_known = false;
};

/// True where a feature's "speed" (m/s) and "toward" (rad) state a motion.
[[nodiscard]] bool has_motion(const ElementInput& input, std::uint32_t feature);
/// Adds the arrow; nothing where the front is unknown or the batch has no room.
void add_motion_arrow(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, std::uint32_t feature,
                      const CellFront& from);

}  // namespace tedavis::draw
