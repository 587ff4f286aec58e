/// The summary of a run: `summary.json`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bus/state/traffic_table.hpp"
#include "host_sim/options/ghost_options.hpp"
#include "host_sim/reports/alert_tally.hpp"
#include "host_sim/reports/closest_json.hpp"
#include "host_sim/reports/deadline_tally.hpp"
#include "host_sim/reports/effect_tally.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "render_core/base/memory_budget.hpp"

namespace tedavis::host_sim {

/// Frames of the bus by their result in the decoder, and lines of the log that are no frames: `broken_lines` begin like one,
/// `other_lines` do not.
struct CanCounts {
    std::uint64_t frames = 0, decoded = 0, alien = 0, errors = 0, dropped = 0;
    std::uint64_t broken_lines = 0, other_lines = 0;
    bus::TrafficCounts traffic;
};

struct RunSummary {
    std::uint64_t frames = 0;
    double fps_median = 0;  ///< 1000 / median of `ms.total`
    double ms_p99 = 0;
    std::uint64_t heap_allocations_after_start = 0;
    std::uint64_t terrain_frames = 0;                     ///< that show terrain
    std::uint64_t frames_over_void = 0;                   ///< of these, without a height of the ground below
    double worst_error_px = 0, worst_start_error_px = 0;  ///< FlightTally
    TerrainAlertCounts terrain_alerts;
    ClosestReport closest;
    std::uint64_t gl_calls_outside_device = 0;
    std::string device, design, aircraft, palette, light, terrain, scene, log, switches, video;  ///< as they were named
    std::uint32_t width = 0, height = 0;
    DeadlineSummary deadline;
    std::string costs;  ///< file of measured costs, or empty
    std::string gl;     ///< surface and the driver's own name
    CanCounts can;
    std::vector<EffectCount> effects;   ///< that frames of the run requested
    std::vector<ShownGhost> ghosts;     ///< other flights that its pictures show
    bool has_accuracy_overlay = false;  ///< its pictures have the accuracy overlay
    bool interrupted = false;
    std::vector<std::string> notes;  ///< notes for the reader, such as broken lines or synthetic data
    Findings warnings;
};

/// Median (mean of the middle two) and the 99th percentile (nearest rank) of frame times; zeros for none.
struct FrameTimes {
    double median_ms = 0, p99_ms = 0;
};
[[nodiscard]] FrameTimes frame_times(std::vector<double> total_ms);

/// "worst terrain error 0.71 px", or that none was drawn.
[[nodiscard]] std::string error_text(const RunSummary& summary);
/// "; while its first chunks arrived, 35.20 px"; empty where all had arrived with the first picture.
[[nodiscard]] std::string start_error_text(const RunSummary& summary);

/// Returns the JSON with all keys in a fixed order and the budget table as `memory`.
[[nodiscard]] std::string run_summary_json(const RunSummary& summary, const base::BudgetTable& memory);

}  // namespace tedavis::host_sim
