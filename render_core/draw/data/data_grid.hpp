/// The surface grid on data (thesis, 4.2.4): lines of longitude and latitude that stand over those of the ground, counted from
/// the same post, and lines of equal height above MSL, as uniforms of shaders/data_grid.frag.
///
/// A place in a piece is a float from its anchor. Longitude, latitude and height follow from it by series: about the axis, then
/// in the meridian's circle of curvature at the anchor and what that grows by. But for the floats' own rounding lines are within
/// 0.1 m of their places 100 km from the anchor, and within 0.003 m 30 km from it; those of equal height besides within what the
/// geoid bends by on the way. None within a degree of a pole, where meridians meet.
///
/// Plain data, pure functions; any thread but where GL is given. Source of the radii: earth/wgs84.hpp; of what that along the
/// meridian grows by: their derivative.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render_core/design/terrain_style.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::draw {

struct DataGrid {
    const design::GridSettings* settings = nullptr;      ///< null: no lines
    const terrain::TerrainDatabase* database = nullptr;  ///< whose ground has them; it knows the geoid

    [[nodiscard]] bool is_shown() const { return settings != nullptr && settings->spacing_m > 0; }
};

/// What the shader is told of an anchor, under the names of its uniforms; strength 0 where there is no grid.
struct GridPlace {
    glm::vec4 turn{0}, look{0};
    glm::vec3 radii{0}, first{0}, rate{0}, spacing_m{0};
    glm::vec2 climb{0};
};
/// `anchor` in ECEF. Without lines of equal height where the piece lies on the ground.
[[nodiscard]] GridPlace grid_place(const DataGrid& grid, const glm::dvec3& anchor, bool has_heights);

inline constexpr std::size_t kGridUniforms = 7;
inline constexpr const char* kGridUniformNames[kGridUniforms] = {"grid_turn",  "grid_radii", "grid_first", "grid_rate",
                                                                 "grid_climb", "grid_look",  "grid_size"};
/// Of the program in use; `first`: where kGridUniformNames begin among its uniforms.
void set_grid_place(gl::Gl& gl, const gl::Program& program, std::size_t first, const GridPlace& place, double focal_px);

}  // namespace tedavis::draw
