/// `tedavis trace`: draws one picture of the terrain by the ray tracer and reports times and memory.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/tracing/chosen_shot.hpp"

namespace tedavis::host_sim {

/// The terrain to trace; where neither is named, the shipped raster.
struct TraceTerrain {
    std::string database;  ///< .tdb
    std::string heights;   ///< a raster, which is built into a database of its own first
};

struct TraceOptions {
    TraceTerrain terrain;
    std::string scene;                 ///< .sdb, scene database, a quantity of which colours the ground; empty: none
    std::string data;                  ///< the quantity: layer, or layer.attribute; empty: the first
    std::optional<AircraftPose> pose;  ///< nothing: over the south of the terrain, northwards
    TracePreset preset = TracePreset::time;
    raytrace::SearchSettings search;   ///< of the preset's rays
    std::optional<ChoicePlan> choice;  ///< instead of a preset: settings are chosen by region
    /// Limit for heights and the data prepared from them, which are paged where they need more; nothing: no limit.
    std::optional<double> memory_mb;
    TracedShotPlan plan;        ///< without its pose
    std::uint32_t workers = 0;  ///< 0: as many as there are processors
    std::string output;         ///< X.png; X.json beside it has times and memory
};

/// Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_trace(const TraceOptions& options, Console& console);

/// Returns the database's path. One that has to be built first is written to `folder`.
[[nodiscard]] std::string database_of(const TraceTerrain& terrain, const std::string& folder, Console& console);
/// Returns the default pose: over the middle of the southern part of the terrain, above its highest post, looking north and 12
/// degrees down.
[[nodiscard]] AircraftPose usual_pose(const TracedGround& ground);
/// Returns `count` worker threads; 0: as many as there are processors. Throws UserError where so many cannot be started.
[[nodiscard]] std::unique_ptr<base::Workers> trace_workers(std::uint32_t count);

}  // namespace tedavis::host_sim
