/// The last stages of a build: bounds of all chunks, directory pages, tables and the header.
#pragma once

#include "host_sim/terrain_builder/entries_file.hpp"

namespace tedavis::host_sim {

/// Sets bound_m of a row of entries: their own errors, those of strips of finer chunks beside them, which are there because of
/// them, and nowhere less than their children's. The level below must be whole. Any thread, different rows at once.
void set_bounds(const BuildPlan& plan, EntriesFile& entries, std::uint32_t level, std::uint32_t row);

/// Pages are counted as in the page table. Any thread, different pages at once.
void write_page(const BuildPlan& plan, const TdbLayout& layout, const EntriesFile& entries, std::uint32_t page,
                WorkFile& database);

/// Undulation, page table and header; `header` has counts and heights.
void write_frame(const BuildPlan& plan, const TdbLayout& layout, terrain::FileHeader header, WorkFile& database);

}  // namespace tedavis::host_sim
