/// What a terrain is built from: a raster over all of it, finer ones over parts of it, and an image to drape it with.
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
    std::vector<PostReaderFactory> insets;  ///< later ones lie over earlier ones
    std::optional<DrapeOptions> drape;      ///< the image over it

    TerrainSources(PostReaderFactory whole) : open(std::move(whole)) {}  // a raster alone is a terrain. NOLINT(*-explicit-*)
    TerrainSources(PostReaderFactory whole, std::vector<PostReaderFactory> parts)
        : open(std::move(whole)), insets(std::move(parts)) {}
};

/// Plans of the coarse posts and of the finest ones, and where chunks of the latter are. Without insets both are the same.
struct TerrainPlan {
    BuildPlan coarse, fine;
    InsetCoverage coverage;
    std::vector<std::unique_ptr<InsetSampler>> insets;

    /// The fine posts lie 2, 4 ... 32 to a coarse one: as dense as the finest inset, or nearly so. Throws UserError where insets
    /// cannot lie in the raster.
    TerrainPlan(const TerrainSources& sources, const BuildOptions& options);
    TerrainPlan(const TerrainPlan&) = delete;
    TerrainPlan& operator=(const TerrainPlan&) = delete;
};

}  // namespace tedavis::host_sim
