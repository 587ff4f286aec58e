/// `report.html`: a run on one self-contained page: pictures as data URIs, charts as inline SVG, no scripts, no network; readable
/// on a phone. In print, folded parts (legends, files, memory) and all but eight pictures of the film strip are left out.
#pragma once

#include <string>

#include "host_sim/reports/run_story.hpp"
#include "host_sim/reports/run_summary.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

/// `terrain`: its relief is drawn under the track on the map; null: the run had none.
[[nodiscard]] std::string html_report(const RunSummary& summary, const RunStory& story, const base::BudgetTable& memory,
                                      const terrain::TerrainDatabase* terrain = nullptr);

/// Writes summary.json and report.html into the folder, each whole or not at all.
void write_run_reports(const std::string& folder, const RunSummary& summary, const RunStory& story,
                       const base::BudgetTable& memory, const terrain::TerrainDatabase* terrain = nullptr);

}  // namespace tedavis::host_sim
