/// The page of a comparison: sentences, both tracks on a map, pictures side by side, curves, tables. It is self-contained.
#pragma once

#include <string>

#include "host_sim/comparison/comparison_moments.hpp"
#include "host_sim/comparison/run_comparison.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// The begin of every page, by which a page is distinguished from other files.
inline constexpr char kComparisonPageBeginning[] = "<!DOCTYPE html>\n<html lang='en' id='tedavis-comparison'>";

/// The terrain below the tracks.
struct MapTerrain {
    const terrain::TerrainDatabase* database = nullptr;  ///< null where there is none; it must outlive the call
    std::string why_none;                                ///< a sentence, where there is none
};

/// Reads the pictures of the moments; throws UserError where one is
/// damaged.
[[nodiscard]] std::string comparison_page(const RunComparison& runs, const std::vector<ComparisonMoment>& moments,
                                          const MapTerrain& terrain);

}  // namespace tedavis::host_sim
