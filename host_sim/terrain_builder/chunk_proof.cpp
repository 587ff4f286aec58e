#include "host_sim/terrain_builder/chunk_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/user_error.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

float rounded_up(double value) {
    const auto nearest = static_cast<float>(value);
    return nearest >= value ? nearest : std::nextafter(nearest, std::numeric_limits<float>::max());
}

using Corners = std::array<std::uint16_t, 3>;

std::vector<Corners> triangles_beside(const ChunkDraft& draft, std::uint8_t coarser_sides, ChunkMeshScratch& scratch) {
    std::vector<std::uint16_t> indices(3 * kMaxChunkTriangles);
    const MeshCount count = build_chunk_indices(draft.entry, {draft.vertices.data(), draft.vertices.size()},
                                                {draft.triangles.data(), draft.triangles.size()}, coarser_sides, scratch,
                                                {indices.data(), indices.size()});
    if (!count.sound)
        throw UserError("terrain build: the mesh of chunk " + std::to_string(draft.entry.level) + "/" +
                        std::to_string(draft.entry.i) + "/" + std::to_string(draft.entry.j) +
                        " does not close; report this raster");
    std::vector<Corners> triangles(count.indices / 3);
    for (std::size_t n = 0; n < triangles.size(); ++n) triangles[n] = {indices[3 * n], indices[3 * n + 1], indices[3 * n + 2]};
    return triangles;
}

/// What a mesh has that the chunk's own has not: those that were kept come first and in the same order.
void append_new(const std::vector<Corners>& own, const std::vector<Corners>& mesh, std::vector<Corners>& fresh) {
    std::size_t next = 0;
    for (const Corners& triangle : mesh) {
        while (next < own.size() && own[next] != triangle) ++next;
        if (next == own.size()) fresh.push_back(triangle);
        if (next < own.size()) ++next;
    }
}

constexpr double kMaxRise_m = 10000;  // that heights of a raster may have
constexpr double kMaxShift = 0.1;     // of a cell: slopes of the cells beside it then cover where a place went

CurvatureBound row_bound(const Lattice& lattice, std::uint32_t j0, std::uint32_t j1, double rise_m) {
    CurvatureBound bound;
    for (std::uint32_t j = j0; j < j1; ++j) bound.include(curvature_bound(lattice, 1, j, j + 1, rise_m));
    return bound;
}

struct CellSize {
    double east_m, south_m;
};

/// Cells of a chunk and of the rows beside it are nowhere smaller.
CellSize smallest_cell(const Lattice& lattice, const PostRange& domain) {
    const std::uint32_t j0 = std::max(domain.j0, 1u) - 1, j1 = std::min(domain.j1 + 1, lattice.rows() - 1);
    const double cosine = std::min(std::cos(lattice.latitude_rad(j0)), std::cos(lattice.latitude_rad(j1)));
    return {earth::kMinCurvatureRadius_m * cosine * std::abs(lattice.longitude_rad(1) - lattice.longitude_rad(0)),
            earth::kMinCurvatureRadius_m * (lattice.latitude_rad(j0) - lattice.latitude_rad(j1)) / (j1 - j0)};
}

/// The cells of a chunk and those round it, by their north-west posts: how steep the surface is there, drawn ones with void
/// corners included.
class CellSlopes {
public:
    CellSlopes(const PostWindowView& posts, const PostRange& domain, CellSize size, double steepest)
        : posts_(posts),
          i0_(std::int64_t{domain.i0} - 1),
          j0_(std::int64_t{domain.j0} - 1),
          columns_(domain.i1 - domain.i0 + 2),
          rows_(domain.j1 - domain.j0 + 2),
          slope_(std::size_t{columns_} * rows_),
          rise_m_(rows_) {
        const bool whole = holds(i0_, j0_) && holds(i0_ + columns_, j0_ + rows_);
        for (std::uint32_t row = 0; row < rows_; ++row)
            for (std::uint32_t column = 0; column < columns_; ++column)
                if (has_cell(i0_ + column, j0_ + row)) measure(row, column, size);
        if (!whole) std::fill(slope_.begin(), slope_.end(), static_cast<float>(steepest));
    }

    [[nodiscard]] double rise_of_row_m(std::uint32_t j) const { return rise_m_[static_cast<std::size_t>(j - j0_)]; }
    /// Steepest of the cell and the eight round it.
    [[nodiscard]] double round(std::int64_t i, std::int64_t j) const {
        const float* const first =
            &slope_[static_cast<std::size_t>(j - 1 - j0_) * columns_ + static_cast<std::size_t>(i - 1 - i0_)];
        float steepest = 0;
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column) steepest = std::max(steepest, first[row * columns_ + column]);
        return double{steepest};
    }
    [[nodiscard]] bool has_cell(std::int64_t i, std::int64_t j) const {
        return holds(i, j) && holds(i + 1, j + 1) && !is_outside(i, j) && !is_outside(i + 1, j) && !is_outside(i, j + 1) &&
               !is_outside(i + 1, j + 1);
    }

private:
    [[nodiscard]] std::size_t at(std::int64_t i, std::int64_t j) const {
        return static_cast<std::size_t>(j - posts_.j0) * posts_.columns + static_cast<std::size_t>(i - posts_.i0);
    }
    [[nodiscard]] bool holds(std::int64_t i, std::int64_t j) const {
        return i >= posts_.i0 && j >= posts_.j0 && i < posts_.i0 + posts_.columns && j < posts_.j0 + posts_.rows;
    }
    [[nodiscard]] bool is_outside(std::int64_t i, std::int64_t j) const {
        return posts_.post_class[at(i, j)] == PostClass::outside;
    }

    void measure(std::uint32_t row, std::uint32_t column, CellSize size) {
        const float *north = &posts_.surface_m[at(i0_ + column, j0_ + row)], *south = north + posts_.columns;
        const float east_m = std::max(std::abs(north[1] - north[0]), std::abs(south[1] - south[0])),
                    south_m = std::max(std::abs(south[0] - north[0]), std::abs(south[1] - north[1]));
        slope_[std::size_t{row} * columns_ + column] =
            rounded_up(std::hypot(double{east_m} / size.east_m, double{south_m} / size.south_m));
        const auto [least, most] = std::minmax({north[0], north[1], south[0], south[1]});
        rise_m_[row] = std::max(rise_m_[row], double{most} - least);
    }

    const PostWindowView& posts_;
    const std::int64_t i0_, j0_;
    const std::uint32_t columns_, rows_;
    std::vector<float> slope_;
    std::vector<double> rise_m_;  // the largest of a row of cells
};

}  // namespace

std::vector<std::uint16_t> strip_triangles(const ChunkDraft& draft, std::uint8_t sides) {
    std::vector<std::uint16_t> indices;
    if (sides == 0) return indices;
    const auto scratch = std::make_unique<ChunkMeshScratch>();
    const std::vector<Corners> own = triangles_beside(draft, 0, *scratch);
    std::vector<Corners> fresh;
    for (unsigned mask = 1; mask < 16; ++mask)
        if ((mask & ~unsigned{sides}) == 0)
            append_new(own, triangles_beside(draft, static_cast<std::uint8_t>(mask), *scratch), fresh);
    std::sort(fresh.begin(), fresh.end());
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    for (const Corners& triangle : fresh) indices.insert(indices.end(), triangle.begin(), triangle.end());
    return indices;
}

void ChunkErrors::include(const ChunkErrors& other) {
    own.include(other.own);
    strips.include(other.strips);
    shift_m = std::max(shift_m, other.shift_m);
}

void ChunkErrors::state(ChunkEntry& entry) const {
    entry.above_m = rounded_up(own.above_m);
    entry.below_m = rounded_up(own.below_m);
    entry.strip_above_m = rounded_up(strips.above_m);
    entry.strip_below_m = rounded_up(strips.below_m);
    grow_box(entry, own.largest_m() + shift_m);
}

ChunkProof::ChunkProof(const BuildPlan& plan, const Steepness& slopes, const ChunkDraft& draft,
                       const std::vector<double>& surface_m, std::uint8_t sides)
    : plan_(plan), domain_(plan.lattice.posts_of(key_of(draft.entry))), rounding_m_(draft.rounding_m) {
    if ((draft.entry.flags & kChunkRegular) != 0 && !take_cells(draft)) add_regular(draft);
    add_triangles(draft, surface_m, draft.triangles.data(), draft.triangles.size(), false);
    const std::vector<std::uint16_t> strips = strip_triangles(draft, sides);
    add_triangles(draft, surface_m, strips.data(), strips.size(), true);
    include_curvature(slopes);
}

void ChunkProof::add_triangles(const ChunkDraft& draft, const std::vector<double>& surface_m, const std::uint16_t* indices,
                               std::size_t count, bool in_strip) {
    for (std::size_t n = 0; n < count; n += 3) {
        Triangle t{};
        for (std::size_t k = 0; k < 3; ++k) {
            const ChunkVertex& v = draft.vertices[indices[n + k]];
            t.corners[k] = {domain_.i0 + v.i, domain_.j0 + v.j, surface_m[indices[n + k]]};
        }
        const auto& [a, b, c] = t.corners;
        const auto at_pole = [this](const MeshCorner& corner) { return plan_.is_pole_row(static_cast<std::uint32_t>(corner.j)); };
        if (at_pole(a) + at_pole(b) + at_pole(c) > 1) continue;  // a line in space; its neighbours show what lies there
        t.i0 = std::min({a.i, b.i, c.i});
        t.i1 = std::max({a.i, b.i, c.i});
        t.j0 = std::min({a.j, b.j, c.j});
        t.j1 = std::max({a.j, b.j, c.j});
        const double rise_m =
            std::max({a.surface_m, b.surface_m, c.surface_m}) - std::min({a.surface_m, b.surface_m, c.surface_m});
        const CurvatureBound bound = curvature_bound(plan_.lattice, static_cast<std::uint32_t>(t.i1 - t.i0),
                                                     static_cast<std::uint32_t>(t.j0), static_cast<std::uint32_t>(t.j1), rise_m);
        t.more_above_m = bound.up_m;
        t.more_below_m = bound.down_m;
        t.shift_m = bound.shift_m;
        t.in_strip = in_strip;
        errors_.shift_m = std::max(errors_.shift_m, bound.shift_m);
        triangles_.push_back(t);
    }
}

/// Its triangles are the true surface's own: one stands for all.
void ChunkProof::add_regular(const ChunkDraft& draft) {
    const std::uint32_t step = 1u << draft.entry.level;
    float least = std::numeric_limits<float>::max(), most = std::numeric_limits<float>::lowest();
    for (const ChunkVertex& v : draft.vertices) {
        least = std::min(least, v.height_m);
        most = std::max(most, v.height_m);
    }
    CurvatureBound bound;
    for (std::uint32_t j = domain_.j0; j < domain_.j1; j += step)
        bound.include(curvature_bound(plan_.lattice, step, j, std::min(j + step, domain_.j1), double{most} - least));
    Triangle t{};
    t.more_above_m = bound.up_m;
    t.more_below_m = bound.down_m;
    t.shift_m = bound.shift_m;
    t.exact = true;
    errors_.shift_m = std::max(errors_.shift_m, bound.shift_m);
    triangles_.push_back(t);
}

/// What is off sideways is off by the slope in height.
void ChunkProof::include_curvature(const Steepness& slopes) {
    const double cell_m = 6335000 * std::abs(plan_.lattice.latitude_rad(domain_.j0) - plan_.lattice.latitude_rad(domain_.j1)) /
                          (domain_.j1 - domain_.j0);
    const auto margin = static_cast<std::uint32_t>(std::min(errors_.shift_m / cell_m, 1e6)) + 1;
    const double slope = slopes.steepest(domain_, margin);
    steepest_ = slope;
    const double rounding_m = rounding_m_ * (1 + slope);
    for (Triangle& t : triangles_) {
        const double sideways_m = slope * t.shift_m;
        t.more_above_m += sideways_m + rounding_m;
        t.more_below_m += sideways_m + rounding_m;
        (t.in_strip ? errors_.strips : errors_.own).include({t.more_above_m, t.more_below_m});
    }
}

/// Where every post is a vertex, but not beside a pole.
bool ChunkProof::take_cells(const ChunkDraft& draft) {
    const bool beside_pole =
        (plan_.has_north_pole() && domain_.j0 <= 1) || (plan_.has_south_pole() && domain_.j1 + 2 >= plan_.header.rows);
    if (draft.entry.level != 0 || draft.roundings.size() != draft.vertices.size() || beside_pole) return false;
    const CellSize cell = smallest_cell(plan_.lattice, domain_);
    const CurvatureBound bound = row_bound(plan_.lattice, domain_.j0, domain_.j1, kMaxRise_m);
    if (bound.shift_m > kMaxShift * std::min(cell.east_m, cell.south_m)) return false;
    const std::size_t columns = domain_.i1 - domain_.i0 + 1;
    roundings_.resize(columns * (domain_.j1 - domain_.j0 + 1));
    for (std::size_t n = 0; n < draft.vertices.size(); ++n)
        roundings_[draft.vertices[n].j * columns + draft.vertices[n].i] = draft.roundings[n];
    return true;
}

/// Its triangles are the true surface's own.
void ChunkProof::include_cells(const PostWindowView& posts) {
    const CellSlopes slopes(posts, domain_, smallest_cell(plan_.lattice, domain_), steepest_);
    const std::size_t columns = domain_.i1 - domain_.i0 + 1;
    for (std::uint32_t j = domain_.j0; j < domain_.j1; ++j) {
        const CurvatureBound bound = row_bound(plan_.lattice, j, j + 1, slopes.rise_of_row_m(j));
        errors_.shift_m = std::max(errors_.shift_m, bound.shift_m);
        for (std::uint32_t i = domain_.i0; i < domain_.i1; ++i) {
            if (!slopes.has_cell(i, j)) continue;
            const double slope = slopes.round(i, j);
            double rounding_m = 0;
            for (const auto& [di, dj] : {std::pair{0u, 0u}, {1u, 0u}, {0u, 1u}, {1u, 1u}}) {
                const VertexRounding& corner = roundings_[(j + dj - domain_.j0) * columns + i + di - domain_.i0];
                rounding_m = std::max(rounding_m, corner.up_m + slope * corner.sideways_m);
            }
            const double both_m = slope * bound.shift_m + rounding_m;
            errors_.own.include({bound.up_m + both_m, bound.down_m + both_m});
        }
    }
}

void ChunkProof::include(const PostWindowView& posts) {
    if (!roundings_.empty()) include_cells(posts);
    const std::int64_t last_i = posts.i0 + posts.columns - 1, last_j = posts.j0 + posts.rows - 1;
    for (const Triangle& t : triangles_) {
        if (t.exact || t.i0 > last_i || t.j0 > last_j || t.i1 < posts.i0 || t.j1 < posts.j0) continue;
        SignedError error = triangle_error(posts, t.corners[0], t.corners[1], t.corners[2]);
        error.above_m += t.more_above_m;
        error.below_m += t.more_below_m;
        (t.in_strip ? errors_.strips : errors_.own).include(error);
    }
}

}  // namespace tedavis::host_sim
