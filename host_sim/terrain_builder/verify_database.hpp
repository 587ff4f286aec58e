/// Reads a database from end to end as the display would: every checksum, every entry, every vertex.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "platform/files/file_byte_source.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// Throws UserError: what is wrong with the database, at which offset, and what to do.
[[noreturn]] void refuse_database(const std::string& path, const terrain::TdbFailure& failure);

/// A database on disk, opened. Throws UserError: what is wrong, and at which offset.
class OpenDatabase {
public:
    explicit OpenDatabase(const std::string& path);

    [[nodiscard]] const terrain::TerrainDatabase& database() const { return database_; }
    /// The page at a place of the page table. Throws UserError where it is damaged.
    void read_page(std::uint32_t page_index, terrain::DirectoryPage& page) const;
    /// A part's bytes, their checksum verified. Throws UserError.
    [[nodiscard]] std::vector<std::uint8_t> read_part(const terrain::PartPlace& place) const;
    [[noreturn]] void refuse(const terrain::TdbFailure& failure) const;

private:
    std::string path_;
    platform::FileByteSource bytes_;
    std::unique_ptr<unsigned char[]> memory_;  // not touched where it is not needed
    terrain::TerrainDatabase database_;
};

/// Every part that a page of the directory names. Any thread, different pages at once. Throws UserError.
/// Returns the number of chunks.
std::uint64_t verify_page(const OpenDatabase& open, std::uint32_t page_index);

/// The whole file; `progress` gets pages read and their number, and may throw to stop. Throws UserError.
void verify_database(const OpenDatabase& open, const std::function<void(std::uint64_t, std::uint64_t)>& progress);

/// Chunks of one level together.
struct LevelSummary {
    std::uint64_t chunks = 0, vertices = 0, triangles = 0, payload_bytes = 0, drape_pages = 0;
    float worst_error_m = 0, worst_bound_m = 0;
};
/// From the directory, finest level first. Throws UserError.
[[nodiscard]] std::vector<LevelSummary> summarise_levels(const OpenDatabase& open);

}  // namespace tedavis::host_sim
