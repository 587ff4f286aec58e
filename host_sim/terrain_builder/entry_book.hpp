/// The entries of all chunks of a database while it is built, by their keys in the database.
///
/// A terrain without insets has one file. With insets, level 0 of the coarse chunks' file is the base level of the database; each
/// region has a file of its own for the levels below; coarse entries that its fine posts change are in a second coarse file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/entries_file.hpp"
#include "host_sim/terrain_builder/inset_coverage.hpp"

namespace tedavis::host_sim {

/// Entries of one region's chunks below the base level.
class RegionEntries {
public:
    RegionEntries(const std::string& path, const terrain::PostRange& region, std::uint32_t base_level);

    [[nodiscard]] bool holds(const terrain::ChunkKey& key) const;
    /// Zeros where nothing was written.
    [[nodiscard]] terrain::ChunkEntry read(const terrain::ChunkKey& key) const;
    void write(const terrain::ChunkEntry& entry);
    void sync() { file_.sync(); }

private:
    [[nodiscard]] std::uint64_t offset(const terrain::ChunkKey& key) const;

    terrain::PostRange region_;
    std::uint32_t base_level_;
    std::uint64_t first_[terrain::kMaxLevels + 1]{};
    WorkFile file_;
};

class EntryBook {
public:
    /// `coarse` and `changed` are for the coarse lattice. All arguments must outlive this object.
    EntryBook(const InsetCoverage& coverage, EntriesFile& coarse, EntriesFile& changed)
        : coverage_(coverage), coarse_(coarse), changed_(changed) {}

    void add(std::unique_ptr<RegionEntries> region) { regions_.push_back(std::move(region)); }

    /// The chunk must exist.
    [[nodiscard]] terrain::ChunkEntry read(const terrain::ChunkKey& key) const;
    /// Writes an entry that read() returned, or a new one. Coarse entries are written to `changed`.
    void write(terrain::ChunkEntry entry);
    void sync();

private:
    const InsetCoverage& coverage_;
    EntriesFile& coarse_;
    EntriesFile& changed_;
    std::vector<std::unique_ptr<RegionEntries>> regions_;
};

}  // namespace tedavis::host_sim
