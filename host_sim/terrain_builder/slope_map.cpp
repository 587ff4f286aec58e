#include "host_sim/terrain_builder/slope_map.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr double kGeoidSlope = 5e-4;  // of the undulation that surfaces have on top of heights; EGM96's steepest is less

/// The largest steps between valid neighbours, in the row of cells below row j of posts.
struct LargestSteps {
    float east_m = 0, south_m = 0;
};

LargestSteps largest_steps(const LatticeWindow& w, const PostRange& posts, std::int64_t j) {
    LargestSteps steps;
    const auto is_valid = [&](std::size_t n) { return w.post_class[n] <= PostClass::sea; };
    const auto include = [&](float& largest, std::size_t a, std::size_t b) {
        if (is_valid(a) && is_valid(b)) largest = std::max(largest, std::abs(w.height_m[a] - w.height_m[b]));
    };
    for (std::int64_t i = posts.i0; i <= posts.i1; ++i) {
        const std::size_t north = w.at(i, j), south = north + w.columns;
        include(steps.south_m, north, south);
        if (i == posts.i1) continue;
        include(steps.east_m, north, north + 1);
        include(steps.east_m, south, south + 1);
    }
    return steps;
}

}  // namespace

/// Cells are nowhere smaller than taken here.
float steepest_slope(const BuildPlan& plan, const LatticeWindow& window, const PostRange& posts) {
    // At a pole itself there is no east; the first ring says how far its posts are apart.
    const auto cosine = [&](std::uint32_t j) {
        const std::uint32_t row = plan.is_pole_row(j) ? (j == 0 ? 1 : j - 1) : j;
        return std::cos(plan.lattice.latitude_rad(row));
    };
    double steepest = 0;
    for (std::uint32_t j = posts.j0; j < posts.j1; ++j) {
        const LargestSteps steps = largest_steps(window, posts, j);
        const double east_m =
            base::radians(plan.header.step_lon_deg) * earth::kMinCurvatureRadius_m * std::min(cosine(j), cosine(j + 1));
        const double north_m = earth::kMinCurvatureRadius_m * (plan.lattice.latitude_rad(j) - plan.lattice.latitude_rad(j + 1));
        steepest = std::max(steepest, std::hypot(double{steps.east_m} / east_m, double{steps.south_m} / north_m));
    }
    return static_cast<float>(steepest + kGeoidSlope);
}

SlopeMap::SlopeMap(const BuildPlan& plan, const std::string& path)
    : plan_(plan),
      columns_(plan.lattice.grid_columns(0)),
      rows_(plan.lattice.grid_rows(0)),
      closed_(plan.lattice.is_closed()),
      slope_(std::size_t{columns_} * rows_),
      file_(path) {
    file_.resize(slope_.size() * sizeof(float));
    file_.read(0, slope_.data(), slope_.size() * sizeof(float));
}

void SlopeMap::measure(const PostsFile& posts, std::uint32_t unit) {
    const std::uint32_t u = unit % plan_.unit_columns(), v = unit / plan_.unit_columns();
    LatticeWindow window;
    window.i0 = u * kUnitCells;
    window.j0 = v * kUnitCells;
    window.columns = std::min(kUnitCells + 1, plan_.header.columns - u * kUnitCells);
    window.rows = std::min(kUnitCells + 1, plan_.header.rows - v * kUnitCells);
    posts.read(window);
    constexpr std::uint32_t kSide = kUnitCells / kChunkCells;
    const std::uint32_t first = u * kSide, end = std::min((u + 1) * kSide, columns_);
    for (std::uint32_t j = v * kSide; j < std::min((v + 1) * kSide, rows_); ++j) {
        float* const row = &slope_[std::size_t{j} * columns_];
        for (std::uint32_t i = first; i < end; ++i) row[i] = steepest_slope(plan_, window, plan_.lattice.posts_of({0, i, j}));
        file_.write((std::uint64_t{j} * columns_ + first) * sizeof(float), &row[first], (end - first) * sizeof(float));
    }
}

double SlopeMap::steepest(const PostRange& posts, std::uint32_t margin_posts) const {
    const auto margin = static_cast<std::int64_t>((margin_posts + kChunkCells - 1) / kChunkCells);
    const std::int64_t first_j = std::max<std::int64_t>(posts.j0 / kChunkCells - margin, 0),
                       last_j = std::min<std::int64_t>((posts.j1 - 1) / kChunkCells + margin, rows_ - 1);
    std::int64_t first_i = posts.i0 / kChunkCells - margin, last_i = (posts.i1 - 1) / kChunkCells + margin;
    if (last_i - first_i >= columns_) first_i = 0, last_i = columns_ - 1;
    float steepest = 0;
    for (std::int64_t j = first_j; j <= last_j; ++j)
        for (std::int64_t i = first_i; i <= last_i; ++i) {
            const bool inside = i >= 0 && i < columns_;
            if (!inside && !closed_) continue;
            steepest = std::max(steepest, slope_[static_cast<std::size_t>(j * columns_ + (i + columns_) % columns_)]);
        }
    return steepest;
}

}  // namespace tedavis::host_sim
