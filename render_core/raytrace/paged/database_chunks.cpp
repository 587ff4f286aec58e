#include "render_core/raytrace/paged/database_chunks.hpp"

#include <algorithm>

#include "render_core/raytrace/cell_bounds.hpp"
#include "render_core/raytrace/ground/exact_posts.hpp"
#include "render_core/terrain/chunk_payload.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kNoPage = 0xFFFFFFFFu;

/// Of a chunk of the finest level, as far as a window of a database has it.
terrain::PostRange part_within(const terrain::PostRange& posts, const terrain::PostRange& window) {
    return {posts.i0, posts.j0, std::min(posts.i1, window.i1), std::min(posts.j1, window.j1)};
}

bool has_any_cell(const HeightGrid<float>& grid) {
    const auto is_there = [&](std::uint32_t i, std::uint32_t j) { return grid.at(i, j) != HeightGrid<float>::kVoid; };
    for (std::uint32_t j = 0; j + 1 < grid.rows; ++j)
        for (std::uint32_t i = 0; i + 1 < grid.columns; ++i)
            if (is_there(i, j) && is_there(i + 1, j) && is_there(i, j + 1) && is_there(i + 1, j + 1)) return true;
    return false;
}

}  // namespace

struct DatabaseChunks::Desk {
    terrain::DirectoryPage page;
    std::uint32_t page_index;
    std::uint64_t read_bytes;
    alignas(terrain::ChunkVertex) std::uint8_t payload[kExactChunkBytes];
    float part[kPosts * kPosts];
    GroundReader reader;
};

std::uint64_t DatabaseChunks::bytes_needed(std::uint32_t desks) {
    return desks * (sizeof(Desk) + GroundReader::bytes_needed(1)) + 64;
}

bool DatabaseChunks::start(const terrain::TerrainDatabase& database, const terrain::PostRange& window, std::uint32_t desks,
                           base::Arena& arena) {
    TEDAVIS_CHECK(desks > 0 && window.i0 % kCells == 0 && window.j0 % kCells == 0 && window.i0 <= window.i1 &&
                  window.j0 <= window.j1 && window.i1 < database.lattice().columns() && window.j1 < database.lattice().rows());
    database_ = &database;
    window_ = window;
    damaged_pages_ = 0;
    constexpr std::uint32_t kMax = HeightGrid<float>::kMaxPosts;
    if (columns() < 2 || rows() < 2 || columns() > kMax || rows() > kMax) return false;
    desks_ = arena.allocate_array<Desk>(desks);
    if (desks_.empty()) return false;
    for (Desk& desk : desks_) {
        desk.page_index = kNoPage;
        if (!desk.reader.start(database, 1, arena)) return false;
    }
    return true;
}

std::uint64_t DatabaseChunks::read_bytes() const {
    std::uint64_t bytes = 0;
    for (const Desk& desk : desks_) bytes += desk.read_bytes;
    return bytes;
}

/// Those of the window that an exact chunk covers.
void DatabaseChunks::bound_chunks(const terrain::ChunkEntry& entry, base::Span<float> lowest, base::Span<float> highest) const {
    if ((entry.flags & (terrain::kChunkHasSea | terrain::kChunkHasLand)) == 0) return;
    const terrain::PostRange posts = database_->lattice().posts_of(key_of(entry));
    if (posts.i0 >= window_.i1 || posts.j0 >= window_.j1 || posts.i1 <= window_.i0 || posts.j1 <= window_.j0) return;
    const std::uint32_t first_i = (std::max(posts.i0, window_.i0) - window_.i0) / kCells;
    const std::uint32_t first_j = (std::max(posts.j0, window_.j0) - window_.j0) / kCells;
    const std::uint32_t last_i = (std::min(posts.i1, window_.i1) - 1 - window_.i0) / kCells;
    const std::uint32_t last_j = (std::min(posts.j1, window_.j1) - 1 - window_.j0) / kCells;
    for (std::uint32_t j = first_j; j <= last_j; ++j)
        for (std::uint32_t i = first_i; i <= last_i; ++i) {
            const std::size_t chunk = std::size_t{j} * chunk_columns() + i;
            lowest[chunk] = entry.min_height_m;
            highest[chunk] = entry.max_height_m;
        }
}

bool DatabaseChunks::read_bounds(base::Span<float> lowest, base::Span<float> highest) {
    const terrain::Lattice& lattice = database_->lattice();
    std::fill(lowest.begin(), lowest.end(), no_surface<float>(HeightBound::minimum));
    std::fill(highest.begin(), highest.end(), no_surface<float>(HeightBound::maximum));
    damaged_pages_ = 0;
    terrain::DirectoryPage& page = desks_[0].page;
    desks_[0].page_index = kNoPage;
    for (std::uint32_t level = 0; level < database_->levels(); ++level) {
        const std::uint32_t cells = (kCells << level) * terrain::kPageChunks;
        const std::uint32_t last_i = std::min(window_.i1 / cells, lattice.page_columns(level) - 1);
        const std::uint32_t last_j = std::min(window_.j1 / cells, lattice.page_rows(level) - 1);
        for (std::uint32_t j = window_.j0 / cells; j <= last_j; ++j)
            for (std::uint32_t i = window_.i0 / cells; i <= last_i; ++i) {
                const std::uint32_t index = lattice.page_index({level, i * terrain::kPageChunks, j * terrain::kPageChunks});
                if (!database_->has_page(index)) continue;
                if (database_->read_page(index, page).error != terrain::TdbError::none) {
                    ++damaged_pages_;
                    continue;
                }
                for (const terrain::ChunkEntry& entry : page.entries)
                    if (entry.vertex_count != 0 && entry.children == 0) bound_chunks(entry, lowest, highest);
            }
    }
    return true;
}

/// Null where the finest level has none there, or its page is damaged.
const terrain::ChunkEntry* DatabaseChunks::finest_entry(const terrain::ChunkKey& key, Desk& desk) const {
    const std::uint32_t index = database_->lattice().page_index(key);
    if (!database_->has_page(index)) return nullptr;
    if (desk.page_index != index) {
        desk.page_index = kNoPage;
        if (database_->read_page(index, desk.page).error != terrain::TdbError::none) return nullptr;
        desk.page_index = index;
        desk.read_bytes += sizeof desk.page;
    }
    const terrain::ChunkEntry& entry = desk.page.entries[terrain::Lattice::index_in_page(key)];
    return entry.vertex_count == 0 ? nullptr : &entry;
}

bool DatabaseChunks::load(std::uint32_t column, std::uint32_t row, std::uint32_t desk, base::Span<float> posts) {
    Desk& own = desks_[desk];
    std::fill(posts.begin(), posts.end(), HeightGrid<float>::kVoid);
    const terrain::ChunkKey key{0, window_.i0 / kCells + column, window_.j0 / kCells + row};
    GroundWindow<float> part{part_within(database_->lattice().posts_of(key), window_), {}, 1};
    part.posts = {own.part, std::size_t{part.columns()} * part.rows()};
    if (const terrain::ChunkEntry* const entry = finest_entry(key, own); entry != nullptr) {
        const base::Span<std::uint8_t> payload(own.payload);
        if (read_exact_chunk(*database_, *entry, payload).error != terrain::TdbError::none) return false;
        GroundRounding rounding;
        put_exact_posts(database_->lattice(), *entry, payload_vertices(*entry, payload), part, rounding);
        own.read_bytes += entry->payload.bytes;
    } else if (!load_coarse(part, own)) {
        return false;
    }
    for (std::uint32_t n = 0; n < part.rows(); ++n)
        std::copy_n(part.grid().row(n), part.columns(), posts.data() + std::size_t{n} * kPosts);
    return true;
}

/// With the posts that finer chunks beside it have. Whether it is damaged shows where no cell is left: its neighbours' posts
/// alone make none.
bool DatabaseChunks::load_coarse(const GroundWindow<float>& to, Desk& desk) const {
    base::SerialWorkers alone;
    const GroundReading reading = desk.reader.read(to, alone);
    desk.read_bytes += reading.read_bytes;
    return reading.damaged_parts == 0 || has_any_cell(to.grid());
}

}  // namespace tedavis::raytrace
