#include "render_core/draw/traced_ground.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::draw {
namespace {

using terrain::ChunkVertex;
using terrain::PostClass;

constexpr std::uint64_t kPostsAlignment = 64;

/// TriangleShares of a triangle's corners.
struct TriangleShares {
    const ChunkVertex* corners[3];
    double of[3];
};

/// Of a place in a cell, from its north-west corner in parts of its sides: the triangle there.
TriangleShares shares_at(const ChunkVertex* const (&corners)[4], double u, double v) {
    if (u + v <= 1) return {{corners[0], corners[1], corners[2]}, {1 - u - v, u, v}};
    return {{corners[3], corners[2], corners[1]}, {u + v - 1, 1 - u, 1 - v}};
}

PostClass post_class_of(const TriangleShares& shares) {
    bool is_sea = true;
    for (int n = 0; n < 3; ++n) {
        if (shares.of[n] <= 0) continue;
        if (shares.corners[n]->post_class() == PostClass::void_) return PostClass::void_;
        is_sea = is_sea && shares.corners[n]->post_class() == PostClass::sea;
    }
    return is_sea ? PostClass::sea : PostClass::land;
}

float post_height_of(const TriangleShares& shares) {
    double height_m = 0;
    for (int n = 0; n < 3; ++n) height_m += shares.of[n] * double{shares.corners[n]->height_m};
    return static_cast<float>(height_m);
}

PostLook post_look_of(const TriangleShares& shares) {
    PostLook look{};
    for (int axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (int n = 0; n < 3; ++n) sum += shares.of[n] * shares.corners[n]->normal[axis];
        look.normal[axis] = static_cast<std::int8_t>(std::lround(sum));
    }
    look.post_class = post_class_of(shares);
    return look;
}

}  // namespace

std::uint64_t TracedGround::bytes_needed(const terrain::Lattice& lattice) {
    const std::uint64_t posts = std::uint64_t{lattice.columns()} * lattice.rows();
    return posts * (sizeof(float) + sizeof(PostLook)) + 2 * kPostsAlignment +
           raytrace::HeightMipmap<float>::bytes_needed(lattice.columns(), lattice.rows());
}

TracedGroundFault TracedGround::start(terrain::HeightQuery& database, base::Workers& workers, base::Arena& arena) {
    const terrain::Lattice& lattice = database.lattice();
    if (lattice.flags() != 0 || !raytrace::GroundSpace::fits(lattice, all_of(lattice))) return TracedGroundFault::round;
    const std::uint64_t posts = std::uint64_t{lattice.columns()} * lattice.rows();
    if (posts > raytrace::HeightGrid<float>::kMaxInAll || bytes_needed(lattice) > arena.use().capacity - arena.use().in_use)
        return TracedGroundFault::no_room;
    columns_ = lattice.columns();
    heights_ = arena.allocate_array<float>(posts);
    looks_ = arena.allocate_array<PostLook>(posts);
    const raytrace::HeightGrid<float> grid{heights_.data(), lattice.columns(), lattice.rows(), lattice.columns()};
    if (heights_.empty() || looks_.empty() || !grid.is_valid() || !maxima_.start(grid, arena)) return TracedGroundFault::no_room;
    std::uint64_t cells = 0;
    for (std::uint32_t level = lattice.levels(); level-- > 0;)
        if (!read_level(database, level, cells)) return TracedGroundFault::damaged;
    if (cells != std::uint64_t{lattice.columns() - 1} * (lattice.rows() - 1)) return TracedGroundFault::damaged;
    maxima_.build(workers);
    return TracedGroundFault::none;
}

/// The exact chunks of a level, and how many cells they have. A chunk that is not there has an exact one above it, or is missing:
/// then there are too few cells in the end.
bool TracedGround::read_level(terrain::HeightQuery& database, std::uint32_t level, std::uint64_t& cells) {
    const terrain::Lattice& lattice = database.lattice();
    for (std::uint32_t j = 0; j < lattice.grid_rows(level); ++j)
        for (std::uint32_t i = 0; i < lattice.grid_columns(level); ++i) {
            const terrain::ChunkEntry* const entry = database.entry_of({level, i, j});
            if (entry == nullptr || entry->children != 0) continue;
            const terrain::PostRange posts = lattice.posts_of({level, i, j});
            cells += std::uint64_t{posts.i1 - posts.i0} * (posts.j1 - posts.j0);
            if (!read_chunk(database, {level, i, j})) return false;
        }
    return true;
}

bool TracedGround::read_chunk(terrain::HeightQuery& database, const terrain::ChunkKey& key) {
    const terrain::PostRange posts = database.lattice().posts_of(key);
    const terrain::ExactChunk chunk = database.exact_chunk(posts.i0, posts.j0);
    if (chunk.entry == nullptr || terrain::key_of(*chunk.entry) != key) return false;
    const std::uint32_t level = key.level;
    const std::uint32_t across = posts.i1 - posts.i0, down = posts.j1 - posts.j0;
    const terrain::RegularGrid grid = terrain::regular_grid(across, down, level);
    for (std::uint32_t row = 0; row + 1 < grid.rows; ++row)
        for (std::uint32_t column = 0; column + 1 < grid.columns; ++column) {
            const ChunkVertex* const corners[4] = {
                &chunk.vertices[grid.index_of(column, row)], &chunk.vertices[grid.index_of(column + 1, row)],
                &chunk.vertices[grid.index_of(column, row + 1)], &chunk.vertices[grid.index_of(column + 1, row + 1)]};
            fill_cell(
                {posts.i0 + terrain::regular_post(column, across, level), posts.j0 + terrain::regular_post(row, down, level),
                 posts.i0 + terrain::regular_post(column + 1, across, level),
                 posts.j0 + terrain::regular_post(row + 1, down, level)},
                corners);
        }
    return true;
}

void TracedGround::fill_cell(const terrain::PostRange& cell, const ChunkVertex* const (&corners)[4]) {
    const double across = cell.i1 - cell.i0, down = cell.j1 - cell.j0;
    for (std::uint32_t j = cell.j0; j <= cell.j1; ++j)
        for (std::uint32_t i = cell.i0; i <= cell.i1; ++i) {
            const TriangleShares shares = shares_at(corners, (i - cell.i0) / across, (j - cell.j0) / down);
            const std::size_t at = std::size_t{j} * columns_ + i;
            heights_[at] = post_height_of(shares);
            looks_[at] = post_look_of(shares);
        }
}

}  // namespace tedavis::draw
