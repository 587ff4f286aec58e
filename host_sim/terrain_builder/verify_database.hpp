/// Reads a database from end to end as the display would: every checksum, every entry, every vertex.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "platform/files/file_byte_source.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// Throws UserError with the fault of the database, its offset, and what to do.
[[noreturn]] void refuse_database(const std::string& path, const terrain::TdbFailure& failure);

/// An opened database on disk. Its functions throw UserError with the fault and its offset.
class OpenDatabase {
public:
    explicit OpenDatabase(const std::string& path);

    [[nodiscard]] const terrain::TerrainDatabase& database() const { return database_; }
    /// Reads the page of an entry of the page table. Throws UserError where it is damaged.
    void read_page(std::uint32_t page_index, terrain::DirectoryPage& page) const;
    /// Returns the bytes of a part, whose checksum is verified. Throws UserError.
    [[nodiscard]] std::vector<std::uint8_t> read_part(const terrain::PartPlace& place) const;
    [[noreturn]] void refuse(const terrain::TdbFailure& failure) const;

private:
    std::string path_;
    platform::FileByteSource bytes_;
    std::unique_ptr<unsigned char[]> memory_;  // allocated without initialization, so that unused pages take no memory
    terrain::TerrainDatabase database_;
};

/// Verifies every part that a page of the directory names and returns the number of chunks. Different pages may be verified at
/// once, on any thread. Throws UserError.
std::uint64_t verify_page(const OpenDatabase& open, std::uint32_t page_index);

/// Verifies the whole file; `progress` is called with the pages read and in all, and may throw to stop. Throws UserError.
void verify_database(const OpenDatabase& open, const std::function<void(std::uint64_t, std::uint64_t)>& progress);

/// Sums and maxima over the chunks of one level.
struct LevelSummary {
    std::uint64_t chunks = 0, vertices = 0, triangles = 0, payload_bytes = 0, drape_pages = 0;
    float worst_error_m = 0, worst_bound_m = 0;
};
/// Returns the summaries of all levels from the directory, finest level first. Throws UserError.
[[nodiscard]] std::vector<LevelSummary> summarise_levels(const OpenDatabase& open);

}  // namespace tedavis::host_sim
