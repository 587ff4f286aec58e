#include "host_sim/terrain_builder/directory_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "host_sim/terrain_builder/part_store.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

/// Quadrants of a neighbour beyond a side that lie at that side.
struct Facing {
    EdgeBit side;
    std::uint32_t quadrants[2];
};
constexpr Facing kFacing[] = {{kEdgeNorth, {2, 3}}, {kEdgeEast, {0, 2}}, {kEdgeSouth, {0, 1}}, {kEdgeWest, {1, 3}}};

float bound_of(const BuildPlan& plan, const EntriesFile& entries, const ChunkEntry& entry) {
    float bound = std::max(entry.above_m, entry.below_m);
    if (entry.children == 0) return bound;
    const ChunkKey key = key_of(entry);
    const Lattice& lattice = plan.lattice;
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant)
        if (lattice.contains(key.child(quadrant))) bound = std::max(bound, entries.read(key.child(quadrant)).bound_m);
    for (const Facing& facing : kFacing) {
        const ChunkKey neighbour = lattice.neighbour(key, facing.side);
        if (neighbour == kNoChunk) continue;
        for (const std::uint32_t quadrant : facing.quadrants) {
            if (!lattice.contains(neighbour.child(quadrant))) continue;
            const ChunkEntry finer = entries.read(neighbour.child(quadrant));
            bound = std::max({bound, finer.strip_above_m, finer.strip_below_m});
        }
    }
    return bound;
}

/// The north-west chunk of a page.
ChunkKey first_chunk(const Lattice& lattice, std::uint32_t page) {
    for (std::uint32_t level = 0;; ++level) {
        const std::uint32_t across = lattice.page_columns(level), pages = across * lattice.page_rows(level);
        if (page < pages) return {level, page % across * kPageChunks, page / across * kPageChunks};
        page -= pages;
    }
}

std::uint32_t page_crc(const DirectoryPage& page) {
    constexpr std::size_t kStart = offsetof(DirectoryPage, level);
    return checksum(&page.level, sizeof page - kStart);
}

}  // namespace

void set_bounds(const BuildPlan& plan, EntriesFile& entries, std::uint32_t level, std::uint32_t row) {
    for (std::uint32_t i = 0; i < plan.lattice.grid_columns(level); ++i) {
        ChunkEntry entry = entries.read({level, i, row});
        entry.bound_m = bound_of(plan, entries, entry);
        entries.write(entry);
    }
}

void write_page(const BuildPlan& plan, const TdbLayout& layout, const EntriesFile& entries, std::uint32_t index,
                WorkFile& database) {
    const auto page = std::make_unique<DirectoryPage>();
    const ChunkKey first = first_chunk(plan.lattice, index);
    page->level = first.level;
    page->i = first.i / kPageChunks;
    page->j = first.j / kPageChunks;
    for (std::uint32_t n = 0; n < kPageChunks * kPageChunks; ++n) {
        const ChunkKey key{first.level, first.i + n % kPageChunks, first.j + n / kPageChunks};
        if (plan.lattice.contains(key)) page->entries[n] = entries.read(key);
    }
    page->crc = page_crc(*page);
    database.write(layout.pages + std::uint64_t{index} * sizeof *page, page.get(), sizeof *page);
}

void write_frame(const BuildPlan& plan, const TdbLayout& layout, FileHeader header, WorkFile& database) {
    std::vector<std::uint64_t> table(plan.lattice.page_count());
    for (std::size_t n = 0; n < table.size(); ++n) table[n] = layout.pages + n * sizeof(DirectoryPage);
    const std::vector<float>& undulation = plan.undulation.undulation_m;
    database.write(layout.undulation, undulation.data(), undulation.size() * sizeof(float));
    database.write(layout.page_table, table.data(), table.size() * sizeof(std::uint64_t));
    header.page_count = plan.lattice.page_count();
    header.undulation_offset = layout.undulation;
    header.page_table_offset = layout.page_table;
    header.undulation_crc = checksum(undulation.data(), undulation.size() * sizeof(float));
    header.page_table_crc = checksum(table.data(), table.size() * sizeof(std::uint64_t));
    header.header_crc = checksum(&header, offsetof(FileHeader, header_crc));
    database.write(0, &header, sizeof header);
}

}  // namespace tedavis::host_sim
