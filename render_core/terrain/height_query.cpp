#include "render_core/terrain/height_query.hpp"

#include <cmath>

#include "render_core/terrain/chunk_payload.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::terrain {
namespace {

/// Exact chunks are regular: they hold every post of their grid and no index.
constexpr std::size_t kPayloadBytes = (kChunkCells + 1) * (kChunkCells + 1) * sizeof(ChunkVertex);
constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// Corners north-west, north-east, south-west, south-east, and the place in it: u east, v south, both 0..1.
struct Cell {
    const ChunkVertex* corner[4];
    double u = 0, v = 0;
    bool north_is_pole = false, south_is_pole = false;
};

bool has(const Cell& cell, PostClass post_class) {
    for (const ChunkVertex* corner : cell.corner)
        if (corner->post_class() == post_class) return true;
    return false;
}

/// The diagonal runs from north-east to south-west. A row at a pole is one point: meridians run straight to it.
double interpolate(const Cell& cell) {
    const double nw = double{cell.corner[0]->height_m}, ne = double{cell.corner[1]->height_m},
                 sw = double{cell.corner[2]->height_m}, se = double{cell.corner[3]->height_m};
    const double u = cell.u, v = cell.v;
    if (cell.north_is_pole) return (1 - v) * nw + v * ((1 - u) * sw + u * se);
    if (cell.south_is_pole) return v * sw + (1 - v) * ((1 - u) * nw + u * ne);
    return u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
}

/// The cell of a regular chunk round a lattice point inside the chunk.
Cell cell_round(const Lattice& lattice, const ChunkEntry& entry, base::Span<const ChunkVertex> vertices, double point_i,
                double point_j) {
    const PostRange posts = lattice.posts_of(key_of(entry));
    const std::uint32_t cells_i = posts.i1 - posts.i0, cells_j = posts.j1 - posts.j0, level = entry.level;
    const RegularGrid grid = regular_grid(cells_i, cells_j, level);
    const double i = point_i - posts.i0, j = point_j - posts.j0;
    const auto a = static_cast<std::uint32_t>(std::fmin(std::floor(i / (1u << level)), grid.columns - 2.0));
    const auto b = static_cast<std::uint32_t>(std::fmin(std::floor(j / (1u << level)), grid.rows - 2.0));
    Cell cell;
    for (std::uint32_t corner = 0; corner < 4; ++corner)
        cell.corner[corner] = &vertices[grid.index_of(a + corner % 2, b + corner / 2)];
    const double i0 = regular_post(a, cells_i, level), i1 = regular_post(a + 1, cells_i, level);
    const double j0 = regular_post(b, cells_j, level), j1 = regular_post(b + 1, cells_j, level);
    cell.u = (i - i0) / (i1 - i0);
    cell.v = (j - j0) / (j1 - j0);
    cell.north_is_pole = (lattice.flags() & kLatticeNorthPole) != 0 && posts.j0 == 0 && b == 0;
    cell.south_is_pole = (lattice.flags() & kLatticeSouthPole) != 0 && posts.j1 == lattice.rows() - 1 && b == grid.rows - 2;
    return cell;
}

/// The index of the least recently requested one.
template <class Kept>
std::uint32_t oldest_of(base::Span<Kept> kept) {
    std::uint32_t oldest = 0;
    for (std::uint32_t n = 1; n < kept.size(); ++n)
        if (kept[n].asked < kept[oldest].asked) oldest = n;
    return oldest;
}

}  // namespace

std::uint64_t HeightQuery::bytes_needed() {
    return kKeptChunks * (sizeof(KeptChunk) + kPayloadBytes) + kKeptPages * (sizeof(KeptPage) + sizeof(DirectoryPage)) + 128 +
           KeptHeights::bytes_needed();
}

bool HeightQuery::start(const TerrainDatabase& database, base::Arena& arena) {
    database_ = &database;
    chunks_ = arena.allocate_array<KeptChunk>(kKeptChunks);
    kept_pages_ = arena.allocate_array<KeptPage>(kKeptPages);
    pages_ = arena.allocate_array<DirectoryPage>(kKeptPages);
    auto* memory = static_cast<std::uint8_t*>(arena.allocate(kKeptChunks * kPayloadBytes, alignof(ChunkVertex)));
    if (chunks_.empty() || kept_pages_.empty() || pages_.empty() || memory == nullptr || !heights_.start(arena)) return false;
    payloads_ = {memory, kKeptChunks * kPayloadBytes};
    return true;
}

base::Span<std::uint8_t> HeightQuery::payload(std::uint32_t kept) const {
    return payloads_.subspan(kept * kPayloadBytes, kPayloadBytes);
}

const ChunkEntry* HeightQuery::entry_of(const ChunkKey& key) {
    const std::uint32_t page_index = database_->lattice().page_index(key);
    std::uint32_t place = 0;
    while (place < kKeptPages && (kept_pages_[place].asked == 0 || kept_pages_[place].page_index != page_index)) ++place;
    if (place == kKeptPages) {
        if (!database_->has_page(page_index)) return nullptr;
        place = oldest_of(kept_pages_);
        kept_pages_[place].asked = 0;
        if (database_->read_page(page_index, pages_[place]).error != TdbError::none) return nullptr;
        kept_pages_[place].page_index = page_index;
    }
    kept_pages_[place].asked = ++asked_;
    const ChunkEntry& entry = pages_[place].entries[Lattice::index_in_page(key)];
    return entry.vertex_count == 0 ? nullptr : &entry;
}

/// From the top level down. Null when the way there is damaged.
const ChunkEntry* HeightQuery::exact_entry(std::uint32_t i, std::uint32_t j) {
    for (std::uint32_t level = database_->levels(); level-- > 0;) {
        const std::uint32_t cells = kChunkCells << level;
        const ChunkEntry* entry = entry_of({level, i / cells, j / cells});
        if (entry == nullptr || entry->children == 0) return entry;
    }
    return nullptr;
}

/// Where the exact chunk over a lattice cell is kept; kNone when it cannot be had.
std::uint32_t HeightQuery::chunk_over(std::uint32_t i, std::uint32_t j) {
    for (std::uint32_t n = 0; n < kKeptChunks; ++n) {
        if (chunks_[n].asked == 0) continue;
        const PostRange posts = database_->lattice().posts_of(key_of(chunks_[n].entry));
        if (i < posts.i0 || i >= posts.i1 || j < posts.j0 || j >= posts.j1) continue;
        chunks_[n].asked = ++asked_;
        return n;
    }
    const ChunkEntry* entry = exact_entry(i, j);
    if (entry == nullptr) return kNone;
    const std::uint32_t place = oldest_of(chunks_);
    chunks_[place].asked = 0;
    chunks_[place].entry = *entry;
    if (database_->read_part(entry->payload, payload(place)).error != TdbError::none ||
        !payload_holds(database_->lattice(), *entry, payload(place)))
        return kNone;
    const PostRange posts = database_->lattice().posts_of(key_of(*entry));
    chunks_[place].extents = block_extents(*entry, regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, entry->level),
                                           payload_vertices(*entry, payload(place)));
    chunks_[place].asked = ++asked_;
    return place;
}

ExactChunk HeightQuery::exact_chunk(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t kept = chunk_over(i, j);
    if (kept == kNone) return {};
    const ChunkEntry& entry = chunks_[kept].entry;
    return {&entry, payload_vertices(entry, payload(kept)), &chunks_[kept].extents};
}

/// What is damaged may be read better the next time.
HeightAnswer HeightQuery::at(double latitude_rad, double longitude_rad) {
    if (!std::isfinite(latitude_rad) || !std::isfinite(longitude_rad)) return {};
    if (const HeightAnswer* const kept = heights_.find(latitude_rad, longitude_rad); kept != nullptr) return *kept;
    const HeightAnswer answer = read_height(latitude_rad, longitude_rad);
    if (answer.status != HeightStatus::damaged) heights_.keep(latitude_rad, longitude_rad, answer);
    return answer;
}

HeightAnswer HeightQuery::read_height(double latitude_rad, double longitude_rad) {
    HeightAnswer answer;
    answer.undulation = database_->undulation(latitude_rad, longitude_rad);
    const LatticePoint point = database_->lattice().point(latitude_rad, longitude_rad);
    if (!point.inside) return answer;
    const auto i = static_cast<std::uint32_t>(std::fmin(point.i, database_->lattice().columns() - 2.0));
    const auto j = static_cast<std::uint32_t>(std::fmin(point.j, database_->lattice().rows() - 2.0));
    const std::uint32_t kept = chunk_over(i, j);
    if (kept == kNone) {
        answer.status = HeightStatus::damaged;
        return answer;
    }
    const ChunkEntry& entry = chunks_[kept].entry;
    const Cell cell = cell_round(database_->lattice(), entry, payload_vertices(entry, payload(kept)), point.i, point.j);
    if (has(cell, PostClass::void_)) {
        answer.status = HeightStatus::void_;
        return answer;
    }
    answer.status = has(cell, PostClass::land) ? HeightStatus::land : HeightStatus::sea;
    answer.height.m = interpolate(cell);
    return answer;
}

}  // namespace tedavis::terrain
