#include "render_core/draw/drawers/data/data_grid.hpp"

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/drawers/terrain_uniforms.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kFarthestNorth_rad = base::radians(89);
constexpr double kClimbOver_rad = 0.002;  // 13 km, on both sides

double past_line(double lines) { return lines - std::floor(lines); }

/// Half of what the radius along the meridian grows by, a share a radian.
double half_growth(double latitude_rad) {
    const double s = std::sin(latitude_rad), c = std::cos(latitude_rad), e2 = earth::kEccentricitySquared;
    return 1.5 * e2 * s * c / (1 - e2 * s * s);
}

glm::dvec2 climb_of_sea(const terrain::TerrainDatabase& database, const earth::Geodetic& at) {
    const auto level_m = [&](double east_rad, double north_rad) {
        return database.undulation(at.latitude_rad + north_rad, at.longitude_rad + east_rad).m;
    };
    return {(level_m(kClimbOver_rad, 0) - level_m(-kClimbOver_rad, 0)) / (2 * kClimbOver_rad),
            (level_m(0, kClimbOver_rad) - level_m(0, -kClimbOver_rad)) / (2 * kClimbOver_rad)};
}

}  // namespace

GridPlace grid_place(const DataGrid& grid, const glm::dvec3& anchor, bool has_heights) {
    const earth::Geodetic at = earth::from_ecef(anchor);
    if (!grid.is_shown() || std::fabs(at.latitude_rad) > kFarthestNorth_rad) return {};
    const design::GridSettings& settings = *grid.settings;
    const terrain::Lattice& lattice = grid.database->lattice();
    const double meridian_m = earth::meridian_radius_m(at.latitude_rad), height_m = at.height.m;
    const double lines_a_metre = has_heights && settings.height_spacing_m > 0 ? 1 / settings.height_spacing_m : 0;
    const double msl_m = height_m - grid.database->undulation(at.latitude_rad, at.longitude_rad).m;
    const GridStep step = grid_step(lattice, settings);
    const terrain::LatticePoint post = lattice.point(at.latitude_rad, at.longitude_rad);
    constexpr double kFull = 255;
    GridPlace place;
    place.turn =
        glm::dvec4(std::cos(at.longitude_rad), std::sin(at.longitude_rad), std::cos(at.latitude_rad), std::sin(at.latitude_rad));
    place.look =
        glm::dvec4(settings.line.red / kFull, settings.line.green / kFull, settings.line.blue / kFull, settings.strength);
    place.radii = glm::dvec3((earth::prime_vertical_radius_m(at.latitude_rad) + height_m) * std::cos(at.latitude_rad),
                             meridian_m + height_m, half_growth(at.latitude_rad) * meridian_m / (meridian_m + height_m));
    place.first = glm::dvec3(past_line(step.first_east + post.i * step.lines_east),
                             past_line(step.first_south + post.j * step.lines_south), past_line(msl_m * lines_a_metre));
    place.rate = glm::dvec3(step.lines_east / step.east_rad, -step.lines_south / step.south_rad, lines_a_metre);
    place.climb = climb_of_sea(*grid.database, at);
    place.spacing_m = glm::vec3(place.radii.x / place.rate.x, -place.radii.y / place.rate.y,
                                lines_a_metre > 0 ? static_cast<float>(settings.height_spacing_m) : 0.0f);
    return place;
}

void set_grid_place(gl::Gl& gl, const gl::Program& program, std::size_t first, const GridPlace& place, double focal_px) {
    const glm::vec4 &turn = place.turn, &look = place.look;
    gl->Uniform4f(program.uniform(first), turn.x, turn.y, turn.z, turn.w);
    gl->Uniform3f(program.uniform(first + 1), place.radii.x, place.radii.y, place.radii.z);
    gl->Uniform3f(program.uniform(first + 2), place.first.x, place.first.y, place.first.z);
    gl->Uniform3f(program.uniform(first + 3), place.rate.x, place.rate.y, place.rate.z);
    gl->Uniform2f(program.uniform(first + 4), place.climb.x, place.climb.y);
    gl->Uniform4f(program.uniform(first + 5), look.x, look.y, look.z, look.w);
    gl->Uniform4f(program.uniform(first + 6), place.spacing_m.x, place.spacing_m.y, place.spacing_m.z,
                  static_cast<float>(1 / focal_px));
}

}  // namespace tedavis::draw
