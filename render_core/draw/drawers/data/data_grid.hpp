/// The surface grid on data (thesis, 4.2.4): lines of longitude and latitude above those on the ground, counted from the same
/// post, and lines of equal height above MSL, as uniforms of shaders/data_grid.frag.
///
/// Positions in a piece are floats relative to its anchor. Longitude, latitude and height are computed from them by series:
/// about the Earth's axis, then in the meridian's circle of curvature at the anchor with its change. Apart from float rounding,
/// lines are within 0.1 m of their true positions 100 km from the anchor and within 0.003 m at 30 km; lines of equal height
/// also have the change of the geoid over that distance as an error. There are no lines within a degree of a pole.
///
/// Plain data, pure functions; any thread; set_grid_place(): the GL thread. The radii of curvature are those of earth/wgs84.hpp,
/// the change of the meridian's is their derivative.
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
    const terrain::TerrainDatabase* database = nullptr;  ///< database of the ground; provides the geoid

    [[nodiscard]] bool is_shown() const { return settings != nullptr && settings->is_shown(); }
};

/// The uniforms for an anchor, with their names in the shader; strength 0 where there is no grid.
struct GridPlace {
    glm::vec4 turn{0}, look{0};
    glm::vec3 radii{0}, first{0}, rate{0}, spacing_m{0};
    glm::vec2 climb{0};
};
/// `anchor` is in ECEF. `has_heights` is false for pieces on the ground, which have no lines of equal height.
[[nodiscard]] GridPlace grid_place(const DataGrid& grid, const glm::dvec3& anchor, bool has_heights);

inline constexpr std::size_t kGridUniforms = 7;
inline constexpr const char* kGridUniformNames[kGridUniforms] = {"grid_turn",  "grid_radii", "grid_first", "grid_rate",
                                                                 "grid_climb", "grid_look",  "grid_size"};
/// Sets the uniforms of the program in use; `first` is the index of kGridUniformNames in its list.
void set_grid_place(gl::Gl& gl, const gl::Program& program, std::size_t first, const GridPlace& place, double focal_px);

}  // namespace tedavis::draw
