/// The motion of a storm cell: a thin line from the foot of its front to where the front will be after at most kMotionAhead_s,
/// with a barb for every kBarbEvery_s, whose arms point back. It is at the height of the cell's base, but at least
/// kMotionOverGround_m above the ground.
///
/// The line is kMotionLine_px wide on the screen at any distance, in the cell's opaque colour over a dark rim. Its length on the
/// screen is at most the cell's width; it is cut there, also between two barbs.
///
/// Pure, apart from queries to the ground. Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

inline constexpr double kBarbEvery_s = 300, kMotionAhead_s = 1800;
inline constexpr double kMinMotion_mps = 0.5;  ///< below this speed a cell has no line
inline constexpr double kMotionOverGround_m = 60;
inline constexpr double kBarbShare = 0.07;  ///< of the cell's width: how far a barb's end is beside the line and behind its tip
inline constexpr float kMotionLine_px = 2.4f, kMotionRim_px = 1.3f;  ///< the rim on either side

/// The beginning of the line.
struct CellFront {
    double latitude_rad = 0, longitude_rad = 0;
    double base_m = 0;      ///< of the cell, above the ellipsoid
    double toward_rad = 0;  ///< clockwise from true north
    double width_m = 0;     ///< of the cell, as the eye sees it
    double seen_rad = 0;    ///< angle at which the eye sees this width
    bool is_known = false;
};

/// True where a feature's "speed" (m/s) and "toward" (rad) state a motion.
[[nodiscard]] bool has_motion(const ElementInput& input, std::uint32_t feature);
/// Returns the length of the line, m, of a cell with this speed.
[[nodiscard]] double motion_line_m(const ElementInput& input, const CellFront& from, double speed_mps);
/// The farthest barb of a line: its place in ECEF, and the time after which the front is there; 0: the line has no barb.
struct LastBarb {
    glm::dvec3 place{0};
    double after_s = 0;
};
[[nodiscard]] LastBarb last_barb(const ElementInput& input, std::uint32_t feature, const CellFront& from);
/// Adds the line; nothing where the front is unknown or the batch has no room.
void add_motion_line(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, std::uint32_t feature, const CellFront& from);

}  // namespace tedavis::draw
