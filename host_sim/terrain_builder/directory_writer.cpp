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

std::uint32_t page_crc(const DirectoryPage& page) {
    constexpr std::size_t kStart = offsetof(DirectoryPage, level);
    return checksum(&page.level, sizeof page - kStart);
}

}  // namespace

void set_bounds(const BuildPlan& plan, EntriesFile& entries, const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
    std::uint64_t done = 0;
    for (std::uint32_t level = 0; level < plan.levels(); ++level)
        for (std::uint32_t j = 0; j < plan.lattice.grid_rows(level); ++j) {
            for (std::uint32_t i = 0; i < plan.lattice.grid_columns(level); ++i) {
                ChunkEntry entry = entries.read({level, i, j});
                entry.bound_m = bound_of(plan, entries, entry);
                entries.write(entry);
            }
            progress(done += plan.lattice.grid_columns(level), entries.count());
        }
}

DirectoryPage make_page(const BuildPlan& plan, const EntriesFile& entries, std::uint32_t level, std::uint32_t i,
                        std::uint32_t j) {
    DirectoryPage page{};
    page.level = level;
    page.i = i;
    page.j = j;
    for (std::uint32_t n = 0; n < kPageChunks * kPageChunks; ++n) {
        const ChunkKey key{level, i * kPageChunks + n % kPageChunks, j * kPageChunks + n / kPageChunks};
        if (plan.lattice.contains(key)) page.entries[n] = entries.read(key);
    }
    page.crc = page_crc(page);
    return page;
}

void write_directory(const BuildPlan& plan, const TdbLayout& layout, const EntriesFile& entries, FileHeader header,
                     WorkFile& database) {
    const Lattice& lattice = plan.lattice;
    std::vector<std::uint64_t> table(lattice.page_count());
    std::uint64_t offset = layout.pages;
    for (std::uint32_t level = 0; level < plan.levels(); ++level)
        for (std::uint32_t j = 0; j < lattice.page_rows(level); ++j)
            for (std::uint32_t i = 0; i < lattice.page_columns(level); ++i) {
                const auto page = std::make_unique<DirectoryPage>(make_page(plan, entries, level, i, j));
                table[lattice.page_index({level, i * kPageChunks, j * kPageChunks})] = offset;
                database.write(offset, page.get(), sizeof *page);
                offset += sizeof *page;
            }
    const std::vector<float>& undulation = plan.undulation.undulation_m;
    database.write(layout.undulation, undulation.data(), undulation.size() * sizeof(float));
    database.write(layout.page_table, table.data(), table.size() * sizeof(std::uint64_t));
    header.page_count = lattice.page_count();
    header.undulation_offset = layout.undulation;
    header.page_table_offset = layout.page_table;
    header.undulation_crc = checksum(undulation.data(), undulation.size() * sizeof(float));
    header.page_table_crc = checksum(table.data(), table.size() * sizeof(std::uint64_t));
    header.header_crc = checksum(&header, offsetof(FileHeader, header_crc));
    database.write(0, &header, sizeof header);
}

}  // namespace tedavis::host_sim
