/// The last stages of a build: bounds of all chunks, directory pages, tables and the header.
#pragma once

#include "host_sim/terrain_builder/entry_book.hpp"

namespace tedavis::host_sim {

/// A database's chunks on the way into its directory: levels, chunks and pages as the database counts them.
struct DirectorySources {
    const BuildPlan& plan;  ///< of the finest posts
    const InsetCoverage& coverage;
    const TdbLayout& layout;
    EntryBook& entries;
};

/// Sets bound_m of an entry: its own errors, those of strips of finer chunks beside it, which are there because of it, and
/// nowhere less than its children's; what it says of its posts follows its children. The level below must be whole. Any
/// thread, different chunks of a level at once.
void finish_entry(const DirectorySources& sources, const terrain::ChunkKey& key);

/// Pages that have chunks are counted in the order of the page table. Any thread, different pages at once.
void write_page(const DirectorySources& sources, std::uint32_t page, WorkFile& database);

/// Undulation, page table and header; `header` has counts and heights.
void write_frame(const DirectorySources& sources, terrain::FileHeader header, WorkFile& database);

}  // namespace tedavis::host_sim
