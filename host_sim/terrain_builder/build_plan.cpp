#include "host_sim/terrain_builder/build_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "host_sim/terrain_builder/attributes/attribute_tile.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr double kFinestQuantum_m = 1.0 / 16384;
constexpr double kSlackOfHeights_m = 10;              // filled voids, rounding of centres
constexpr double kStraightBelow_deg = 80, kBend = 4;  // eight times what the chord is below the arc
constexpr double kPartOfStep = 1e-3;                  // places that agree this well are the same
// Ground is rougher the closer one looks: what posts 90 m apart leave out is less than three times that of posts 30 m apart.
constexpr double kFirstTolerance_m = 3.75, kFirstCell_m = 30, kFirstGrowth = 0.6;  // at level 1, with the cell's side
constexpr double kToleranceGrowth = 2.5;                                           // from level to level

/// Round the Earth the last column meets the first: one is appended where the source has no column for it.
void close_round_the_earth(BuildPlan& plan) {
    FileHeader& h = plan.header;
    const PostGrid& g = plan.source;
    const auto turns_once = [&g](double cells) { return std::abs(cells * g.step_lon_deg - 360) < kPartOfStep * g.step_lon_deg; };
    h.columns = plan.source_columns = g.columns;
    h.step_lon_deg = g.step_lon_deg;
    if (turns_once(g.columns)) {
        h.columns = g.columns + 1;
    } else if (turns_once(g.columns - 1.0)) {
        plan.source_columns = g.columns - 1;
    } else {
        return;
    }
    h.lattice_flags |= kLatticeClosed;
    h.step_lon_deg = 360.0 / (h.columns - 1);
}

/// A row at a pole is one point; a closed lattice that ends less than a step before the pole gets such a row.
void place_poles(BuildPlan& plan) {
    FileHeader& h = plan.header;
    const PostGrid& g = plan.source;
    h.rows = g.rows;
    h.north_deg = g.north_deg;
    h.step_lat_deg = g.step_lat_deg;
    const double edge_deg = kPartOfStep * g.step_lat_deg;
    const auto add = [&](double gap_deg, std::uint32_t flag) {
        if (gap_deg < -edge_deg) throw UserError(g.source + ": reaches beyond a pole; give it other coordinates");
        const bool at_pole = gap_deg <= edge_deg;
        if (!at_pole && ((h.lattice_flags & kLatticeClosed) == 0 || gap_deg > g.step_lat_deg + edge_deg)) return;
        h.lattice_flags |= flag;
        if (flag == kLatticeNorthPole) (at_pole ? h.north_deg -= g.step_lat_deg : plan.first_source_row = 1);
        if (!at_pole) ++h.rows;
    };
    add(90 - g.north_deg, kLatticeNorthPole);
    add(g.north_deg - g.step_lat_deg * (g.rows - 1) + 90, kLatticeSouthPole);
}

std::uint32_t levels_for(const FileHeader& h, std::uint32_t most) {
    std::uint32_t levels = 1;
    const std::uint32_t cells = std::max(h.columns, h.rows) - 1;
    while (levels < most && (kChunkCells << (levels - 1)) < cells) ++levels;
    return levels;
}

/// Of angles.
struct Range {
    double least, most;
};

/// Absolute values.
double greatest_cosine(const Range& angles) {
    const bool has_peak = std::floor(angles.most / base::kPi) * base::kPi >= angles.least;
    return has_peak ? 1.0 : std::max(std::abs(std::cos(angles.least)), std::abs(std::cos(angles.most)));
}
double greatest_sine(const Range& angles) {
    return greatest_cosine({angles.least - 0.5 * base::kPi, angles.most - 0.5 * base::kPi});
}

/// Of the row nearest to the equator.
double largest_cosine(const Lattice& lattice) {
    const double north = lattice.latitude_rad(0), south = lattice.latitude_rad(lattice.rows() - 1);
    return north > 0 && south < 0 ? 1.0 : std::max(std::cos(north), std::cos(south));
}

void choose_tolerances(BuildPlan& plan) {
    FileHeader& h = plan.header;
    const double north_m = base::radians(h.step_lat_deg) * earth::kGreatestCurvatureRadius_m;
    const double east_m = base::radians(h.step_lon_deg) * earth::kGreatestCurvatureRadius_m * largest_cosine(plan.lattice);
    plan.cell_m = std::max(north_m, east_m);
    double tolerance_m = kFirstTolerance_m * std::pow(std::sqrt(north_m * east_m) / kFirstCell_m, kFirstGrowth);
    for (std::uint32_t level = 1; level < h.levels; ++level, tolerance_m *= kToleranceGrowth)
        h.tolerance_m[level] = static_cast<float>(tolerance_m);
}

void name_sources(BuildPlan& plan, const BuildOptions& options) {
    FileHeader& h = plan.header;
    std::memcpy(h.magic, kTdbMagic, sizeof kTdbMagic);
    h.version = kTdbVersion;
    h.header_bytes = sizeof h;
    h.le90_m = static_cast<float>(options.le90_m.value_or(0));
    h.light_azimuth_deg = static_cast<float>(base::degrees(FixedLight().azimuth_rad));
    h.light_elevation_deg = static_cast<float>(base::degrees(FixedLight().elevation_rad));
    std::strncpy(h.source, plan.source.source.c_str(), sizeof h.source - 1);
    const bool egm96 = plan.source.vertical_datum == VerticalDatum::egm96;
    std::strncpy(h.vertical_datum, egm96 ? "egm96" : "ellipsoid", sizeof h.vertical_datum - 1);
}

void cut_geoid(BuildPlan& plan) {
    FileHeader& h = plan.header;
    const double north_deg = base::degrees(plan.lattice.latitude_rad(0)),
                 south_deg = base::degrees(plan.lattice.latitude_rad(h.rows - 1));
    const double east_deg = h.west_deg + h.step_lon_deg * (h.columns - 1);
    plan.undulation = UndulationGrid::covering(h.west_deg, south_deg, east_deg, north_deg, GeoidEgm96::installed());
    h.undulation_west_deg = plan.undulation.west_deg;
    h.undulation_north_deg = plan.undulation.north_deg;
    h.undulation_step_deg = kUndulationStep_deg;
    h.undulation_columns = plan.undulation.columns;
    h.undulation_rows = plan.undulation.rows;
}

std::uint32_t units_across(std::uint32_t posts) { return (posts - 1 + kUnitCells - 1) / kUnitCells; }

}  // namespace

std::uint32_t BuildPlan::unit_columns() const { return units_across(header.columns); }
std::uint32_t BuildPlan::unit_rows() const { return units_across(header.rows); }

double BuildPlan::tolerance_m(std::uint32_t level, std::uint32_t chunk_row) const {
    const PostRange posts = lattice.posts_of({level, 0, chunk_row});
    const double north = lattice.latitude_rad(posts.j0), south = lattice.latitude_rad(posts.j1);
    const double mean_cosine = (std::sin(north) - std::sin(south)) / (north - south);
    return header.tolerance_m[level] * std::sqrt(std::min(1.0, mean_cosine / largest_cosine(lattice)));
}

void BuildPlan::know_heights(double lowest_msl_m, double highest_msl_m) {
    const auto [least, most] = std::minmax_element(undulation.undulation_m.begin(), undulation.undulation_m.end());
    half_relief_m = 0.5 * (highest_msl_m - lowest_msl_m + double{*most} - double{*least}) + kSlackOfHeights_m;
}

/// From half the extents of a chunk's box, north, east and down, turned to the Earth's axes. Where meridians run together fast,
/// none of its sides is straight enough.
double BuildPlan::farthest_vertex_m(std::uint32_t level) const {
    const std::uint32_t cells = kChunkCells << level;
    const double anywhere_m = std::min(half_relief_m + 0.75 * cell_m * cells, 2 * earth::kGreatestCurvatureRadius_m);
    const Range latitude{lattice.latitude_rad(header.rows - 1), lattice.latitude_rad(0)};
    if (header.lattice_flags != 0 || base::degrees(std::max(-latitude.least, latitude.most)) > kStraightBelow_deg)
        return anywhere_m;
    const double first = base::radians(header.west_deg), step = base::radians(header.step_lon_deg);
    const Range longitude{first, first + step * (header.columns - 1)};
    double east_m =
        0.5 * step * std::min(cells, header.columns - 1) * earth::kGreatestCurvatureRadius_m * largest_cosine(lattice);
    double north_m =
        0.5 * base::radians(header.step_lat_deg) * std::min(cells, header.rows - 1) * earth::kGreatestCurvatureRadius_m;
    const double bent_m = kBend * (east_m * east_m + north_m * north_m) / earth::kGreatestCurvatureRadius_m,
                 up_m = half_relief_m + bent_m;
    east_m += bent_m;
    north_m += bent_m;
    const double to_axis_m = north_m * greatest_sine(latitude) + up_m * greatest_cosine(latitude),
                 along_axis_m = north_m * greatest_cosine(latitude) + up_m * greatest_sine(latitude);
    const double x_m = to_axis_m * greatest_cosine(longitude) + east_m * greatest_sine(longitude),
                 y_m = to_axis_m * greatest_sine(longitude) + east_m * greatest_cosine(longitude);
    return std::min({anywhere_m, std::max({x_m, y_m, along_axis_m}), std::hypot(east_m, north_m, up_m)});
}

double BuildPlan::quantum_m(std::uint32_t level) const {
    return std::max(kFinestQuantum_m, std::exp2(std::ceil(std::log2(farthest_vertex_m(level) / 16777216.0))));
}

BuildPlan make_build_plan(const PostGrid& grid, const BuildOptions& options, std::uint32_t finer_levels) {
    if (grid.columns < 2 || grid.rows < 2)
        throw UserError(grid.source + ": has " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
                        " posts; a terrain needs two by two or more");
    BuildPlan plan;
    plan.source = grid;
    name_sources(plan, options);
    plan.header.west_deg = grid.west_deg;
    close_round_the_earth(plan);
    place_poles(plan);
    plan.header.levels = levels_for(plan.header, kMaxLevels - finer_levels);
    plan.lattice = Lattice(plan.header);
    choose_tolerances(plan);
    cut_geoid(plan);
    return plan;
}

BuildPlan make_finer_plan(const BuildPlan& plan, std::uint32_t finer_levels) {
    BuildPlan finer = plan;
    FileHeader& h = finer.header;
    h.columns = ((h.columns - 1) << finer_levels) + 1;
    h.rows = ((h.rows - 1) << finer_levels) + 1;
    h.step_lon_deg = std::ldexp(h.step_lon_deg, -static_cast<int>(finer_levels));
    h.step_lat_deg = std::ldexp(h.step_lat_deg, -static_cast<int>(finer_levels));
    h.levels += finer_levels;
    finer.lattice = Lattice(h);
    choose_tolerances(finer);
    for (std::uint32_t level = 0; finer_levels > 0 && level < plan.levels(); ++level)
        h.tolerance_m[level + finer_levels] = plan.header.tolerance_m[level];
    return finer;
}

}  // namespace tedavis::host_sim
