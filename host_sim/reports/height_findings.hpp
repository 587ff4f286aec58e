/// Checks whether heights are plausible for ground, to warn of rasters and databases with other data.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/reports/run_findings.hpp"
#include "host_sim/terrain_builder/impossible_values.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

struct HeightCounts {
    std::uint64_t posts = 0, void_posts = 0;
    double lowest_m = 0, highest_m = 0;  ///< of the posts that are not void
    bool is_eight_bit = false;           ///< the file has no more than 256 values
};

/// Returns the counts of a terrain database.
[[nodiscard]] HeightCounts height_counts(const terrain::FileHeader& header);

[[nodiscard]] Findings height_findings(const std::string& file, const HeightCounts& counts);

/// Returns the findings of a raster that is to be used as terrain, from a sample of its posts. Throws UserError as
/// open_raster_source does.
[[nodiscard]] Findings value_findings(const std::string& file, const RasterOptions& options);

}  // namespace tedavis::host_sim
