#include "host_sim/terrain_builder/terrain_model.hpp"

#include <cmath>
#include <functional>
#include <utility>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

// Chosen so that a chunk is used at about its own size away: tolerance / (side in metres) is the angle of a pixel there.
constexpr double kToleranceOfCell = 0.05;
constexpr float kExactTolerance_m = 0.0005f;
constexpr float kLoosen = 1.1f;
constexpr std::size_t kTargetChunkVertices = kMaxChunkVertices * 9 / 10;
constexpr float kUselessTolerance_m = 2000;

double grid_undulation(const TerrainModel& model, double latitude_deg, double longitude_deg) {
    const double x = (longitude_deg - model.undulation_west_deg) / kUndulationStep_deg;
    const double y = (model.undulation_north_deg - latitude_deg) / kUndulationStep_deg;
    const double i = std::min(std::max(std::floor(x), 0.0), model.undulation_columns - 2.0);
    const double j = std::min(std::max(std::floor(y), 0.0), model.undulation_rows - 2.0);
    const double u = std::min(std::max(x - i, 0.0), 1.0), v = std::min(std::max(y - j, 0.0), 1.0);
    const float* p =
        model.undulation_m.data() + static_cast<std::size_t>(j) * model.undulation_columns + static_cast<std::size_t>(i);
    const std::uint32_t row = model.undulation_columns;
    return (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * ((1 - u) * p[row] + u * p[row + 1]);
}

void cut_geoid(TerrainModel& model) {
    const Raster& r = model.raster;
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const double south_deg = post_latitude_deg(r, r.rows - 1), east_deg = post_longitude_deg(r, r.columns - 1);
    model.undulation_west_deg = std::floor(r.west_deg / kUndulationStep_deg) * kUndulationStep_deg;
    model.undulation_north_deg = std::ceil(r.north_deg / kUndulationStep_deg) * kUndulationStep_deg;
    model.undulation_columns =
        static_cast<std::uint32_t>(std::ceil((east_deg - model.undulation_west_deg) / kUndulationStep_deg)) + 1;
    model.undulation_rows =
        static_cast<std::uint32_t>(std::ceil((model.undulation_north_deg - south_deg) / kUndulationStep_deg)) + 1;
    model.undulation_columns = std::max(model.undulation_columns, 2u);
    model.undulation_rows = std::max(model.undulation_rows, 2u);
    for (std::uint32_t j = 0; j < model.undulation_rows; ++j)
        for (std::uint32_t i = 0; i < model.undulation_columns; ++i)
            model.undulation_m.push_back(static_cast<float>(
                geoid
                    .undulation(base::radians(std::max(-90.0, model.undulation_north_deg - kUndulationStep_deg * j)),
                                base::radians(model.undulation_west_deg + kUndulationStep_deg * i))
                    .m));
}

/// Posts beyond the raster repeat its last row and column, so that edge chunks are whole; they are never drawn.
void fill_lattice(TerrainModel& model) {
    const Raster& r = model.raster;
    Lattice& l = model.lattice;
    l.surface_m.resize(static_cast<std::size_t>(l.columns * l.rows));
    l.post_class.resize(l.surface_m.size());
    for (std::int64_t j = 0; j < l.rows; ++j) {
        for (std::int64_t i = 0; i < l.columns; ++i) {
            const std::int64_t source_i = std::min<std::int64_t>(i, r.columns - 1),
                               source_j = std::min<std::int64_t>(j, r.rows - 1);
            const std::size_t from = r.at(static_cast<std::uint32_t>(source_i), static_cast<std::uint32_t>(source_j));
            const bool outside = i != source_i || j != source_j;
            const bool is_void = r.post_class[from] == PostClass::void_;
            const double undulation = grid_undulation(model, post_latitude_deg(r, source_j), post_longitude_deg(r, source_i));
            l.surface_m[l.at(i, j)] = is_void ? 0.0f : static_cast<float>(r.height_m[from] + undulation);
            l.post_class[l.at(i, j)] = outside ? (is_void ? PostClass::void_ : PostClass::outside) : r.post_class[from];
        }
    }
}

void size_lattice(TerrainModel& model, std::uint32_t levels) {
    const Raster& r = model.raster;
    Lattice& l = model.lattice;
    const std::int64_t side = std::int64_t{kChunkCells} << (levels - 1);
    l.levels = levels;
    l.raster_columns = r.columns;
    l.raster_rows = r.rows;
    l.columns = (r.columns - 1 + side - 1) / side * side + 1;
    l.rows = (r.rows - 1 + side - 1) / side * side + 1;
    const double north_m = base::radians(r.step_lat_deg) * 6400000.0;  // above the largest radius of curvature: never too small
    const double nearest_equator =
        std::max(std::cos(base::radians(r.north_deg)), std::cos(base::radians(post_latitude_deg(r, r.rows - 1))));
    const bool spans_equator = r.north_deg > 0 && post_latitude_deg(r, r.rows - 1) < 0;
    l.cell_m = std::max(north_m, base::radians(r.step_lon_deg) * 6400000.0 * (spans_equator ? 1.0 : nearest_equator));
}

std::uint32_t useful_levels(const Raster& raster) {
    std::uint32_t levels = 1;
    const std::uint32_t longer = std::max(raster.columns, raster.rows) - 1;
    while (levels < kMaxLevels && (std::uint64_t{kChunkCells} << (levels - 1)) < longer) ++levels;
    return levels;
}

/// Vertices a chunk of the level would have.
std::uint32_t vertices_in(const TerrainModel& model, std::uint32_t level, std::int64_t ci, std::int64_t cj) {
    const Lattice& l = model.lattice;
    const std::int64_t side = std::int64_t{kChunkCells} << level;
    std::uint32_t count = 0;
    for (std::int64_t j = cj * side; j <= (cj + 1) * side; ++j)
        for (std::int64_t i = ci * side; i <= (ci + 1) * side; ++i) {
            const std::uint8_t kept = model.levels[l.at(i, j)];
            count += kept != kNeverNeeded && kept >= level ? 1 : 0;
        }
    return count;
}

bool level_fits(const TerrainModel& model, std::uint32_t level) {
    const std::int64_t side = std::int64_t{kChunkCells} << level;
    for (std::int64_t j = 0; j * side < model.lattice.raster_rows - 1; ++j)
        for (std::int64_t i = 0; i * side < model.lattice.raster_columns - 1; ++i)
            if (vertices_in(model, level, i, j) > kMaxChunkVertices) return false;
    return true;
}

/// The first level with a chunk over capacity; `levels` when all fit.
std::uint32_t first_overfull_level(const TerrainModel& model) {
    std::uint32_t level = 0;
    while (level < model.lattice.levels && level_fits(model, level)) ++level;
    return level;
}

/// The tolerance at which no chunk of the level keeps more than `target` posts by its errors alone.
float tolerance_for(const TerrainModel& model, std::uint32_t level, std::size_t target) {
    const Lattice& l = model.lattice;
    const std::int64_t side = std::int64_t{kChunkCells} << level;
    std::vector<float> errors;
    float tolerance = 0;
    for (std::int64_t cj = 0; cj * side < l.raster_rows - 1; ++cj)
        for (std::int64_t ci = 0; ci * side < l.raster_columns - 1; ++ci) {
            errors.clear();
            for (std::int64_t j = cj * side; j <= (cj + 1) * side; ++j)
                for (std::int64_t i = ci * side; i <= (ci + 1) * side; ++i)
                    if (model.errors_m[l.at(i, j)] > tolerance) errors.push_back(model.errors_m[l.at(i, j)]);
            if (errors.size() <= target) continue;
            std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(target), errors.end(),
                             std::greater<>());
            tolerance = errors[target];
        }
    return tolerance;
}

/// Tolerances that grow with the level and let every chunk fit; false when none does (borders of voids are always kept).
bool fit_tolerances(TerrainModel& model) {
    model.tolerance_m = {};
    model.tolerance_m[0] = kExactTolerance_m;
    for (std::uint32_t level = 1; level < model.lattice.levels; ++level) {
        const auto wanted = static_cast<float>(kToleranceOfCell * model.lattice.cell_m * std::exp2(level));
        model.tolerance_m[level] =
            std::max({wanted, model.tolerance_m[level - 1], tolerance_for(model, level, kTargetChunkVertices)});
        if (model.tolerance_m[level] > kUselessTolerance_m) return false;
    }
    for (;;) {
        model.levels = assign_levels(model.lattice, model.errors_m, model.tolerance_m);
        const std::uint32_t overfull = first_overfull_level(model);
        if (overfull == model.lattice.levels) return true;
        if (overfull == 0 || model.tolerance_m[overfull] > kUselessTolerance_m) return false;
        // Corners and separated borders took more than the room left for them.
        model.tolerance_m[overfull] *= kLoosen;
        for (std::uint32_t level = overfull + 1; level < model.lattice.levels; ++level)
            model.tolerance_m[level] = std::max(model.tolerance_m[level], model.tolerance_m[level - 1]);
    }
}

}  // namespace

TerrainModel make_model(Raster raster, const BuildOptions& options) {
    TerrainModel model;
    model.raster = std::move(raster);
    cut_geoid(model);
    for (std::uint32_t levels = useful_levels(model.raster);; --levels) {
        size_lattice(model, levels);
        fill_lattice(model);
        model.errors_m = measure_errors(model.lattice, [&options] {
            if (options.progress) options.progress(0, 1);
        });
        // Many voids need their borders at every level; then the coarsest levels are left away.
        if (fit_tolerances(model) || levels == 1) return model;
    }
}

}  // namespace tedavis::host_sim
