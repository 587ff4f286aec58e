/// The sources of a terrain: a raster over all of it, finer ones over parts of it, and an image for its drape.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/image_source.hpp"
#include "host_sim/terrain_builder/inset_coverage.hpp"
#include "host_sim/terrain_builder/inset_import.hpp"

namespace tedavis::host_sim {

struct TerrainSources {
    PostReaderFactory open;
    std::vector<PostReaderFactory> insets;  ///< later ones override earlier ones
    std::optional<DrapeOptions> drape;      ///< nothing: no drape

    TerrainSources(PostReaderFactory whole) : open(std::move(whole)) {}  // a raster alone is a terrain. NOLINT(*-explicit-*)
    TerrainSources(PostReaderFactory whole, std::vector<PostReaderFactory> parts)
        : open(std::move(whole)), insets(std::move(parts)) {}
};

/// Plans of the coarse posts and of the finest ones, and the coverage of the finer chunks. Without insets both plans are the
/// same.
struct TerrainPlan {
    BuildPlan coarse, fine;
    InsetCoverage coverage;
    std::vector<std::unique_ptr<InsetSampler>> insets;

    /// There are 2, 4 ... 32 fine posts to a coarse one: as dense as the finest inset, or nearly so. Throws UserError where
    /// insets do not fit into the raster.
    TerrainPlan(const TerrainSources& sources, const BuildOptions& options);
    TerrainPlan(const TerrainPlan&) = delete;
    TerrainPlan& operator=(const TerrainPlan&) = delete;
};

}  // namespace tedavis::host_sim
