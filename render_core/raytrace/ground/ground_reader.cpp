#include "render_core/raytrace/ground/ground_reader.hpp"

#include <algorithm>

#include "render_core/raytrace/ground/exact_chunk.hpp"
#include "render_core/raytrace/ground/exact_posts.hpp"
#include "render_core/terrain/chunk_payload.hpp"

namespace tedavis::raytrace {
namespace {

/// Numbers [first, end) of what has a post in a window.
struct TouchedRange {
    std::uint32_t first, end;
    /// `cells` across each of `count`.
    static TouchedRange of(std::uint32_t first_post, std::uint32_t last_post, std::uint32_t cells, std::uint32_t count) {
        return {first_post == 0 ? 0 : (first_post - 1) / cells, std::min(last_post / cells + 1, count)};
    }
};

bool touches(const terrain::PostRange& a, const terrain::PostRange& b) {
    return a.i0 <= b.i1 && b.i0 <= a.i1 && a.j0 <= b.j1 && b.j0 <= a.j1;
}

void add_damage(const terrain::TdbFailure& failure, GroundReading& reading) {
    if (reading.damaged_parts == 0 || failure.offset < reading.first_damage.offset) reading.first_damage = failure;
    ++reading.damaged_parts;
}

void add_reading(const GroundReading& part, GroundReading& all) {
    all.rounding.largest_m = std::max(all.rounding.largest_m, part.rounding.largest_m);
    all.read_bytes += part.read_bytes;
    all.rounding.has_beyond = all.rounding.has_beyond || part.rounding.has_beyond;
    if (part.damaged_parts == 0) return;
    const std::uint32_t damaged_parts = all.damaged_parts + part.damaged_parts;
    if (all.damaged_parts == 0 || part.first_damage.offset < all.first_damage.offset) all.first_damage = part.first_damage;
    all.damaged_parts = damaged_parts;
}

}  // namespace

/// Pages of a level that share no post: every second one each way.
template <class Height>
struct GroundReader::Round {
    const GroundReader* reader;
    const GroundWindow<Height>* to;
    std::uint32_t level;
    TouchedRange columns, rows;  // of pages
    std::uint32_t odd_column, odd_row;

    void work(std::uint32_t desk) const {
        std::uint32_t n = 0;
        const auto desks = static_cast<std::uint32_t>(reader->desks_.size());
        for (std::uint32_t j = rows.first; j < rows.end; ++j)
            for (std::uint32_t i = columns.first; i < columns.end; ++i)
                if (i % 2 == odd_column && j % 2 == odd_row && n++ % desks == desk)
                    reader->read_page(*this, i, j, reader->desks_[desk]);
    }
};

bool GroundReader::start(const terrain::TerrainDatabase& database, std::uint32_t workers, base::Arena& arena) {
    TEDAVIS_CHECK(workers > 0);
    database_ = &database;
    desks_ = arena.allocate_array<Desk>(workers);
    return !desks_.empty();
}

template <class Height>
void GroundReader::read_page(const Round<Height>& round, std::uint32_t i, std::uint32_t j, Desk& desk) const {
    const terrain::Lattice& lattice = database_->lattice();
    const std::uint32_t index = lattice.page_index({round.level, i * terrain::kPageChunks, j * terrain::kPageChunks});
    if (!database_->has_page(index)) return;
    const terrain::TdbFailure failure = database_->read_page(index, desk.page);
    desk.reading.read_bytes += sizeof desk.page;
    if (failure.error != terrain::TdbError::none) return add_damage(failure, desk.reading);
    for (const terrain::ChunkEntry& entry : desk.page.entries)
        if (entry.vertex_count != 0 && entry.children == 0 && touches(lattice.posts_of(key_of(entry)), round.to->window))
            read_chunk(round, entry, desk);
}

template <class Height>
void GroundReader::read_chunk(const Round<Height>& round, const terrain::ChunkEntry& entry, Desk& desk) const {
    const base::Span<std::uint8_t> payload(desk.payload);
    const terrain::TdbFailure failure = read_exact_chunk(*database_, entry, payload);
    desk.reading.read_bytes += entry.payload.bytes;
    if (failure.error != terrain::TdbError::none) return add_damage(failure, desk.reading);
    put_exact_posts(database_->lattice(), entry, payload_vertices(entry, payload), *round.to, desk.reading.rounding);
}

template <class Height>
GroundReading GroundReader::read(const GroundWindow<Height>& to, base::Workers& workers) {
    const terrain::Lattice& lattice = database_->lattice();
    TEDAVIS_CHECK(to.window.i0 <= to.window.i1 && to.window.i1 < lattice.columns() && to.window.j0 <= to.window.j1 &&
                  to.window.j1 < lattice.rows() && to.posts.size() == std::size_t{to.columns()} * to.rows());
    std::fill(to.posts.begin(), to.posts.end(), HeightGrid<Height>::kVoid);
    for (Desk& desk : desks_) desk.reading = {};
    // Coarse levels first: the finer one stays.
    for (std::uint32_t level = database_->levels(); level-- > 0;) {
        const std::uint32_t cells = (terrain::kChunkCells << level) * terrain::kPageChunks;
        const auto columns = TouchedRange::of(to.window.i0, to.window.i1, cells, lattice.page_columns(level));
        const auto rows = TouchedRange::of(to.window.j0, to.window.j1, cells, lattice.page_rows(level));
        for (std::uint32_t n = 0; n < 4; ++n) {
            Round<Height> round{this, &to, level, columns, rows, n % 2, n / 2};
            workers.parallel_for(
                static_cast<std::uint32_t>(desks_.size()),
                [](void* context, std::uint32_t desk) { static_cast<const Round<Height>*>(context)->work(desk); }, &round);
        }
    }
    GroundReading all;
    for (const Desk& desk : desks_) add_reading(desk.reading, all);
    all.void_posts = static_cast<std::uint64_t>(std::count(to.posts.begin(), to.posts.end(), HeightGrid<Height>::kVoid));
    return all;
}

template GroundReading GroundReader::read(const GroundWindow<std::int16_t>&, base::Workers&);
template GroundReading GroundReader::read(const GroundWindow<float>&, base::Workers&);

}  // namespace tedavis::raytrace
