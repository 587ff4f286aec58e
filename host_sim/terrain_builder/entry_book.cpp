#include "host_sim/terrain_builder/entry_book.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

std::uint32_t chunks_across(std::uint32_t first, std::uint32_t last, std::uint32_t level) {
    const std::uint32_t cells = kChunkCells << level;
    return (last - first + cells - 1) / cells;
}

ChunkKey coarse_key(const ChunkKey& key, std::uint32_t base_level) { return {key.level - base_level, key.i, key.j}; }

}  // namespace

RegionEntries::RegionEntries(const std::string& path, const PostRange& region, std::uint32_t base_level)
    : region_(region), base_level_(base_level), file_(path) {
    for (std::uint32_t level = 0; level < base_level; ++level)
        first_[level + 1] = first_[level] + std::uint64_t{chunks_across(region.i0, region.i1, level)} *
                                                chunks_across(region.j0, region.j1, level);
    file_.resize(first_[base_level] * sizeof(ChunkEntry));
}

bool RegionEntries::holds(const ChunkKey& key) const {
    const std::uint32_t cells = kChunkCells << key.level;
    return key.level < base_level_ && key.i * cells >= region_.i0 && key.j * cells >= region_.j0 && key.i * cells < region_.i1 &&
           key.j * cells < region_.j1;
}

std::uint64_t RegionEntries::offset(const ChunkKey& key) const {
    const std::uint32_t cells = kChunkCells << key.level;
    const std::uint64_t across = chunks_across(region_.i0, region_.i1, key.level);
    return (first_[key.level] + (key.j - region_.j0 / cells) * across + (key.i - region_.i0 / cells)) * sizeof(ChunkEntry);
}

ChunkEntry RegionEntries::read(const ChunkKey& key) const {
    ChunkEntry entry;
    file_.read(offset(key), &entry, sizeof entry);
    return entry;
}

void RegionEntries::write(const ChunkEntry& entry) { file_.write(offset(key_of(entry)), &entry, sizeof entry); }

ChunkEntry EntryBook::read(const ChunkKey& key) const {
    const std::uint32_t base = coverage_.base_level();
    if (key.level < base) {
        for (const auto& region : regions_)
            if (region->holds(key)) return region->read(key);
        return {};
    }
    ChunkEntry entry = changed_.read(coarse_key(key, base));
    if (entry.vertex_count == 0) entry = coarse_.read(coarse_key(key, base));
    entry.level = static_cast<std::uint8_t>(key.level);
    return entry;
}

void EntryBook::write(ChunkEntry entry) {
    const std::uint32_t base = coverage_.base_level();
    if (entry.level < base) {
        for (const auto& region : regions_)
            if (region->holds(key_of(entry))) return region->write(entry);
        return;
    }
    entry.level = static_cast<std::uint8_t>(entry.level - base);
    changed_.write(entry);
}

void EntryBook::sync() {
    coarse_.sync();
    changed_.sync();
    for (const auto& region : regions_) region->sync();
}

}  // namespace tedavis::host_sim
