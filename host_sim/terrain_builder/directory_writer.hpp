/// The last stage of a build: bounds of all chunks, directory pages, tables and the header.
#pragma once

#include <functional>

#include "host_sim/terrain_builder/entries_file.hpp"

namespace tedavis::host_sim {

/// Sets bound_m of every entry: its own errors, those of strips of finer chunks beside it, which are there because of it, and
/// nowhere less than its children's. `progress` may throw to stop.
void set_bounds(const BuildPlan& plan, EntriesFile& entries, const std::function<void(std::uint64_t, std::uint64_t)>& progress);

/// A page with its checksum.
[[nodiscard]] terrain::DirectoryPage make_page(const BuildPlan& plan, const EntriesFile& entries, std::uint32_t level,
                                               std::uint32_t i, std::uint32_t j);

/// Writes everything but the chunks' parts; `header` has counts and heights. The header goes last.
void write_directory(const BuildPlan& plan, const TdbLayout& layout, const EntriesFile& entries, terrain::FileHeader header,
                     WorkFile& database);

}  // namespace tedavis::host_sim
