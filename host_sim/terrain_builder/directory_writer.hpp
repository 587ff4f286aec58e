/// The last stages of a build: bounds of all chunks, directory pages, tables and the header.
#pragma once

#include "host_sim/terrain_builder/entry_book.hpp"

namespace tedavis::host_sim {

/// The chunks of a database before its directory is written, with levels, chunks and pages numbered as in the database.
struct DirectorySources {
    const BuildPlan& plan;  ///< of the finest posts
    const InsetCoverage& coverage;
    const TdbLayout& layout;
    EntryBook& entries;
};

/// Sets bound_m of an entry: the largest of its own errors, those of the strips of finer neighbours beside it, and its children's
/// bounds; updates the summary of its posts from its children. The level below must be complete. Different chunks of a level may
/// be finished at once, on any thread.
void finish_entry(const DirectorySources& sources, const terrain::ChunkKey& key);

/// Writes the n-th page that has chunks, in the order of the page table. Different pages may be written at once, on any thread.
void write_page(const DirectorySources& sources, std::uint32_t page, WorkFile& database);

/// Writes undulation, page table and header; `header` has counts and heights.
void write_frame(const DirectorySources& sources, terrain::FileHeader header, WorkFile& database);

}  // namespace tedavis::host_sim
