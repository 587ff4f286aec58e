#include "host_sim/terrain_builder/verify_database.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "host_sim/user_error.hpp"
#include "render_core/terrain/verify_page.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr std::uint64_t kMaxTableBytes = 128u << 20;  // page table and undulation of the largest database

platform::FileByteSource opened(const std::string& path) {
    auto file = platform::open_file(path.c_str());
    if (!file.ok()) throw UserError(std::string(file.error().message.view()));
    return std::move(file.value());
}

template <class Action>
void for_pages(const OpenDatabase& open, Action action) {
    const auto page = std::make_unique<DirectoryPage>();
    const std::uint32_t pages = open.database().lattice().page_count();
    for (std::uint32_t n = 0; n < pages; ++n) {
        if (!open.database().has_page(n)) continue;
        open.read_page(n, *page);
        for (const ChunkEntry& entry : page->entries)
            if (entry.vertex_count != 0) action(n, entry);
    }
}

}  // namespace

void refuse_database(const std::string& path, const TdbFailure& failure) {
    throw UserError(path + ": " + std::string(describe(failure).view()));
}

OpenDatabase::OpenDatabase(const std::string& path) : path_(path), bytes_(opened(path)) {
    const auto table_bytes = static_cast<std::size_t>(std::min(bytes_.size() + 4096, kMaxTableBytes));
    memory_.reset(new unsigned char[table_bytes]);
    base::Arena arena(memory_.get(), table_bytes);
    auto database = TerrainDatabase::open(bytes_, arena);
    if (!database.ok()) refuse(database.error());
    database_ = database.value();
}

void OpenDatabase::read_page(std::uint32_t page_index, DirectoryPage& page) const {
    const TdbFailure failure = database_.read_page(page_index, page);
    if (failure.error != TdbError::none) refuse(failure);
}

std::vector<std::uint8_t> OpenDatabase::read_part(const PartPlace& place) const {
    std::vector<std::uint8_t> bytes(place.bytes);
    const TdbFailure failure = database_.read_part(place, {bytes.data(), bytes.size()});
    if (failure.error != TdbError::none) refuse(failure);
    return bytes;
}

void OpenDatabase::refuse(const TdbFailure& failure) const { refuse_database(path_, failure); }

std::uint64_t verify_page(const OpenDatabase& open, std::uint32_t page_index) {
    const auto room = std::make_unique<VerifyRoom>();
    std::uint64_t chunks = 0;
    const TdbFailure failure = terrain::verify_page(open.database(), page_index, *room, chunks);
    if (failure.error != TdbError::none) open.refuse(failure);
    return chunks;
}

void verify_database(const OpenDatabase& open, const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
    const std::uint32_t pages = open.database().lattice().page_count();
    std::uint64_t chunks = 0;
    for (std::uint32_t page = 0; page < pages; ++page) {
        chunks += verify_page(open, page);
        progress(page + 1, pages);
    }
    if (chunks != open.database().header().chunk_count) open.refuse({TdbError::directory_damaged, 0});
}

std::vector<LevelSummary> summarise_levels(const OpenDatabase& open) {
    std::vector<LevelSummary> levels(open.database().levels());
    for_pages(open, [&levels](std::uint32_t, const ChunkEntry& entry) {
        LevelSummary& level = levels[entry.level];
        ++level.chunks;
        level.vertices += entry.vertex_count;
        level.triangles += entry.triangle_count;
        level.payload_bytes += entry.payload.bytes;
        level.drape_pages += entry.drape.bytes != 0 ? 1 : 0;
        level.worst_error_m = std::max({level.worst_error_m, entry.above_m, entry.below_m});
        level.worst_bound_m = std::max(level.worst_bound_m, entry.bound_m);
    });
    return levels;
}

}  // namespace tedavis::host_sim
