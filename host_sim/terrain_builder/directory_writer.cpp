#include "host_sim/terrain_builder/directory_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "host_sim/terrain_builder/chunk_summary.hpp"
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

void include_children(const DirectorySources& s, const ChunkKey& key, ChunkEntry& entry) {
    entry.children = 0;
    entry.flags &= kChunkRegular;
    entry.min_height_m = entry.max_height_m = 0;
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
        if (!s.plan.lattice.contains(key.child(quadrant))) continue;
        const ChunkEntry child = s.entries.read(key.child(quadrant));
        summarise_child(child, entry);
        entry.bound_m = std::max(entry.bound_m, child.bound_m);
    }
}

float worst_facing_strip(const DirectorySources& s, const ChunkKey& key) {
    float worst = 0;
    for (const Facing& facing : kFacing) {
        const ChunkKey neighbour = s.plan.lattice.neighbour(key, facing.side);
        if (neighbour == kNoChunk || !s.coverage.exists(neighbour) || !s.coverage.has_children(neighbour)) continue;
        for (const std::uint32_t quadrant : facing.quadrants) {
            if (!s.plan.lattice.contains(neighbour.child(quadrant))) continue;
            const ChunkEntry finer = s.entries.read(neighbour.child(quadrant));
            worst = std::max({worst, finer.strip_above_m, finer.strip_below_m});
        }
    }
    return worst;
}

/// The north-west chunk of a page.
ChunkKey first_chunk(const Lattice& lattice, std::uint32_t page) {
    for (std::uint32_t level = 0;; ++level) {
        const std::uint32_t across = lattice.page_columns(level), pages = across * lattice.page_rows(level);
        if (page < pages) return {level, page % across * kPageChunks, page / across * kPageChunks};
        page -= pages;
    }
}

}  // namespace

void finish_entry(const DirectorySources& s, const ChunkKey& key) {
    ChunkEntry entry = s.entries.read(key);
    entry.bound_m = std::max({entry.above_m, entry.below_m, worst_facing_strip(s, key)});
    if (s.coverage.has_children(key)) include_children(s, key, entry);
    s.entries.write(entry);
}

void write_page(const DirectorySources& s, std::uint32_t n, WorkFile& database) {
    const TdbLayout::Page place = s.layout.existing_pages()[n];
    const auto page = std::make_unique<DirectoryPage>();
    const ChunkKey first = first_chunk(s.plan.lattice, place.index);
    page->level = first.level;
    page->i = first.i / kPageChunks;
    page->j = first.j / kPageChunks;
    for (std::uint32_t e = 0; e < kPageChunks * kPageChunks; ++e) {
        const ChunkKey key{first.level, first.i + e % kPageChunks, first.j + e / kPageChunks};
        if (s.plan.lattice.contains(key) && s.coverage.exists(key)) page->entries[e] = s.entries.read(key);
    }
    constexpr std::size_t kStart = offsetof(DirectoryPage, level);
    page->crc = checksum(&page->level, sizeof *page - kStart);
    database.write(place.offset, page.get(), sizeof *page);
}

void write_frame(const DirectorySources& s, FileHeader header, WorkFile& database) {
    std::vector<std::uint64_t> table(s.plan.lattice.page_count());
    for (const TdbLayout::Page& page : s.layout.existing_pages()) table[page.index] = page.offset;
    const std::vector<float>& undulation = s.plan.undulation.undulation_m;
    database.write(s.layout.undulation, undulation.data(), undulation.size() * sizeof(float));
    database.write(s.layout.page_table, table.data(), table.size() * sizeof(std::uint64_t));
    header.page_count = s.plan.lattice.page_count();
    header.undulation_offset = s.layout.undulation;
    header.page_table_offset = s.layout.page_table;
    header.undulation_crc = checksum(undulation.data(), undulation.size() * sizeof(float));
    header.page_table_crc = checksum(table.data(), table.size() * sizeof(std::uint64_t));
    header.header_crc = checksum(&header, offsetof(FileHeader, header_crc));
    database.write(0, &header, sizeof header);
}

}  // namespace tedavis::host_sim
