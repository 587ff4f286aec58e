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
    std::string scene;                 ///< .sdb, of which a quantity colours the ground; empty: none
    std::string data;                  ///< which: layer, or layer.attribute; empty: the first
    std::optional<AircraftPose> pose;  ///< nothing: over the south of the terrain, northwards
    TracePreset preset = TracePreset::time;
    raytrace::SearchSettings search;   ///< of the preset's rays
    std::optional<ChoicePlan> choice;  ///< in place of a preset: settings are chosen by region
    std::optional<double> memory_mb;   ///< that heights and what is prepared from them may take; where it is less, they are paged
    TracedShotPlan plan;               ///< but for its pose
    std::uint32_t workers = 0;         ///< 0: as many as there are processors
    std::string output;                ///< X.png; X.json beside it says what it took
};

/// Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_trace(const TraceOptions& options, Console& console);

/// The database's path; one that has to be built first is put into `folder`.
[[nodiscard]] std::string database_of(const TraceTerrain& terrain, const std::string& folder, Console& console);
/// Over the southern third, above the highest summit's lower part, looking north and a little down.
[[nodiscard]] AircraftPose usual_pose(const TracedGround& ground);
/// Throws UserError where there cannot be so many.
[[nodiscard]] std::unique_ptr<base::Workers> trace_workers(std::uint32_t count);

}  // namespace tedavis::host_sim
