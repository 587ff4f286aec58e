/// `report.html`: a run on one self-contained page: pictures as data URIs, charts as inline SVG, no scripts, no network;
/// readable on a phone. Printed, it leaves out what is folded away: legends, files, memory.
#pragma once

#include <string>

#include "host_sim/reports/run_story.hpp"
#include "host_sim/reports/run_summary.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// `terrain`, below the track on the map: null where the run had none.
[[nodiscard]] std::string html_report(const RunSummary& summary, const RunStory& story, const base::BudgetTable& memory,
                                      const terrain::TerrainDatabase* terrain = nullptr);

/// Writes summary.json and report.html into the folder, each whole or not at all.
void write_run_reports(const std::string& folder, const RunSummary& summary, const RunStory& story,
                       const base::BudgetTable& memory, const terrain::TerrainDatabase* terrain = nullptr);

}  // namespace tedavis::host_sim
