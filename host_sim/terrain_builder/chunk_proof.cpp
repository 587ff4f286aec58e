#include "host_sim/terrain_builder/chunk_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/user_error.hpp"

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
    if ((draft.entry.flags & kChunkRegular) != 0) add_regular(draft);
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
    const double rounding_m = rounding_m_ * (1 + slope);
    for (Triangle& t : triangles_) {
        const double sideways_m = slope * t.shift_m;
        t.more_above_m += sideways_m + rounding_m;
        t.more_below_m += sideways_m + rounding_m;
        (t.in_strip ? errors_.strips : errors_.own).include({t.more_above_m, t.more_below_m});
    }
}

void ChunkProof::include(const PostWindowView& posts) {
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
