#include "host_sim/terrain_builder/chunk_builder.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "host_sim/terrain_builder/curvature_bound.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

bool touches_passing_border(const ChunkDraft& draft, const std::uint16_t* corners) {
    return std::any_of(corners, corners + 3, [&](std::uint16_t n) {
        return n < draft.entry.border_count && !draft.vertices[n].stays_beside_coarser();
    });
}

std::uint16_t count_strips(const ChunkDraft& draft, const std::vector<std::uint16_t>& triangles) {
    std::uint16_t strips = 0;
    for (std::size_t n = 0; n < triangles.size(); n += 3)
        strips = static_cast<std::uint16_t>(strips + (touches_passing_border(draft, &triangles[n]) ? 1 : 0));
    return strips;
}

// Of the tolerance. Where all posts are candidates, what may be missed between them: tighter costs triangles. Where candidates
// are vertices of finer meshes, other posts are between them too.
constexpr double kMissOfPosts = 1.27, kMissOfVertices = 1.0;
constexpr double kUsualSlope = 0.5;  // of the steepest of a chunk, which few of its triangles have
constexpr double kLoosen = 1.25;
constexpr int kMaxAttempts = 6;

/// What the triangulation asks to know about the true surface and the curved Earth.
struct GroundOfChunk {
    const BuildPlan& plan;
    PostRange posts;
    double slope;
    PostWindowView surface;

    static double sagitta_m(const void* context, std::uint32_t posts_east, std::uint32_t posts_south, std::uint32_t row) {
        const auto& chunk = *static_cast<const GroundOfChunk*>(context);
        const std::uint32_t j = chunk.posts.j0 + row;
        const CurvatureBound bound = curvature_bound(chunk.plan.lattice, posts_east, j, j + posts_south, 0);
        return bound.down_m + kUsualSlope * chunk.slope * bound.shift_m;
    }
    static TinMiss miss(const void* context, const TinPost& a, const TinPost& b, const TinPost& c) {
        const auto& chunk = *static_cast<const GroundOfChunk*>(context);
        const auto corner = [&chunk](const TinPost& post) {
            return MeshCorner{std::int64_t{chunk.posts.i0} + post.i, std::int64_t{chunk.posts.j0} + post.j, post.height_m};
        };
        const PlacedError placed = placed_triangle_error(chunk.surface, corner(a), corner(b), corner(c));
        return {placed.error.largest_m(), placed.i - chunk.posts.i0, placed.j - chunk.posts.j0};
    }
};

/// A mesh that ends at its capacity is far off wherever it had not come to yet; a looser tolerance spreads its vertices.
Tin within_capacity(TinInput& input, double tolerance_m, double miss_of_tolerance) {
    for (int attempt = 1;; ++attempt) {
        input.tolerance_m = tolerance_m;
        input.miss_tolerance_m = miss_of_tolerance * tolerance_m;
        Tin tin = make_chunk_tin(input);
        if (tin.vertices.size() < input.max_vertices || attempt == kMaxAttempts) return tin;
        tolerance_m = kLoosen * std::max(tolerance_m, tin.candidate_error_m);
    }
}

}  // namespace

std::vector<std::uint16_t> regular_triangles(const RegularGrid& grid) {
    std::vector<std::uint16_t> triangles;
    for (std::uint32_t j = 0; j + 1 < grid.rows; ++j)
        for (std::uint32_t i = 0; i + 1 < grid.columns; ++i)
            for (const auto& [di, dj] : {std::pair{0u, 0u}, {0u, 1u}, {1u, 0u}, {1u, 0u}, {0u, 1u}, {1u, 1u}})
                triangles.push_back(static_cast<std::uint16_t>(grid.index_of(i + di, j + dj)));
    return triangles;
}

ChunkDraft make_regular_chunk(const BuildPlan& plan, const LineLevels& lines, const ChunkKey& key, const LatticeWindow& window,
                              const PostPlaces& places) {
    const PostRange posts = plan.lattice.posts_of(key);
    const std::uint32_t cells_i = posts.i1 - posts.i0, cells_j = posts.j1 - posts.j0;
    const RegularGrid grid = regular_grid(cells_i, cells_j, key.level);
    ChunkAssembly assembly(plan, key);
    assembly.reserve(grid.vertex_count());
    for (const BorderPost& post : chunk_border(plan, lines, key)) assembly.add_border(post, window, places);
    for (std::uint32_t row = 1; row + 1 < grid.rows; ++row)
        for (std::uint32_t column = 1; column + 1 < grid.columns; ++column)
            assembly.add_inner(posts.i0 + regular_post(column, cells_i, key.level),
                               posts.j0 + regular_post(row, cells_j, key.level), window, places);
    ChunkDraft draft = assembly.finish();
    draft.entry.flags |= kChunkRegular;
    draft.entry.triangle_count = static_cast<std::uint16_t>(grid.triangle_count());
    draft.entry.strip_count = count_strips(draft, regular_triangles(grid));
    return draft;
}

Tin triangulate_chunk(const BuildPlan& plan, const Steepness& slopes, const ChunkKey& key, std::vector<TinPost> border_posts,
                      std::vector<TinPost> candidates, const LatticeWindow* surface) {
    const PostRange posts = plan.lattice.posts_of(key);
    const GroundOfChunk ground{plan, posts, slopes.steepest(posts, 0), surface != nullptr ? surface->view() : PostWindowView{}};
    TinInput input;
    input.last_i = posts.i1 - posts.i0;
    input.last_j = posts.j1 - posts.j0;
    input.border = std::move(border_posts);
    input.candidates = std::move(candidates);
    input.max_vertices = kMaxChunkVertices;
    input.curvature_m = &GroundOfChunk::sagitta_m;
    if (surface != nullptr) input.miss = &GroundOfChunk::miss;
    input.context = &ground;
    const double tolerance_m = plan.tolerance_m(key.level, key.j);
    return within_capacity(input, tolerance_m, key.level <= kLevelsBelow ? kMissOfPosts : kMissOfVertices);
}

void set_triangles(ChunkDraft& draft, std::vector<std::uint16_t> triangles) {
    for (const bool wanted : {true, false})
        for (std::size_t n = 0; n < triangles.size(); n += 3)
            if (touches_passing_border(draft, &triangles[n]) == wanted)
                draft.triangles.insert(draft.triangles.end(), &triangles[n], &triangles[n] + 3);
    draft.entry.triangle_count = static_cast<std::uint16_t>(triangles.size() / 3);
    draft.entry.strip_count = count_strips(draft, triangles);
}

std::vector<std::uint8_t> payload_of(const ChunkDraft& draft, std::uint32_t lift) {
    std::vector<ChunkVertex> vertices = draft.vertices;
    for (ChunkVertex& v : vertices) {
        v.i = static_cast<std::uint16_t>(v.i << lift);
        v.j = static_cast<std::uint16_t>(v.j << lift);
    }
    const std::size_t vertex_bytes = vertices.size() * sizeof(ChunkVertex),
                      index_bytes = draft.triangles.size() * sizeof(std::uint16_t);
    std::vector<std::uint8_t> bytes(vertex_bytes + index_bytes);
    std::memcpy(bytes.data(), vertices.data(), vertex_bytes);
    if (index_bytes > 0) std::memcpy(bytes.data() + vertex_bytes, draft.triangles.data(), index_bytes);
    return bytes;
}

}  // namespace tedavis::host_sim
