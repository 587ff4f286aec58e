#include "host_sim/terrain_builder/terrain_sources.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr double kNearlyAsDense = 0.15;  // of a doubling

/// Levels below the coarse posts'.
std::uint32_t finer_levels(const PostGrid& whole, const TerrainSources& sources) {
    if (sources.insets.empty()) return 0;
    double finest_deg = whole.step_lat_deg;
    for (const PostReaderFactory& open : sources.insets) finest_deg = std::min(finest_deg, open()->grid().step_lat_deg);
    const double doublings = std::ceil(std::log2(whole.step_lat_deg / finest_deg) - kNearlyAsDense);
    auto levels = static_cast<std::uint32_t>(std::clamp(doublings, 1.0, double{kMaxBaseLevel}));
    const std::uint64_t cells = std::max(whole.columns, whole.rows) - 1;
    while (levels > 1 && (cells << levels) >= PostSource::kMaxPostsOfASide) --levels;
    return levels;
}

void require_region(const BuildPlan& plan) {
    if (plan.header.lattice_flags != 0)
        throw UserError(
            plan.source.source +
            ": finer rasters can lie in a region only, not in a raster round the Earth or at a pole; cut it with --bounds");
}

}  // namespace

TerrainPlan::TerrainPlan(const TerrainSources& sources, const BuildOptions& options) {
    const PostGrid whole = sources.open()->grid();
    const std::uint32_t levels = finer_levels(whole, sources);
    coarse = make_build_plan(whole, options, levels);
    if (levels > 0) require_region(coarse);
    fine = make_finer_plan(coarse, levels);
    std::vector<PostRange> footprints;
    for (const PostReaderFactory& open : sources.insets) {
        insets.push_back(std::make_unique<InsetSampler>(fine, open));
        footprints.push_back(insets.back()->footprint());
        if (footprints.back().i1 < footprints.back().i0)
            throw UserError(open()->grid().source + ": lies outside " + whole.source + "; leave it out or name a larger raster");
    }
    if (levels > 0) coverage = InsetCoverage(fine.lattice, levels, footprints);
}

}  // namespace tedavis::host_sim
