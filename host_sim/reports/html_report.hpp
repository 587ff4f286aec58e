/// `report.html`: a run on one self-contained page: pictures as data URIs, charts as inline SVG, no scripts, no network;
/// readable on a phone and printable.
#pragma once

#include <string>

#include "host_sim/reports/run_story.hpp"
#include "host_sim/reports/run_summary.hpp"
#include "render_core/base/memory_budget.hpp"

namespace tedavis::host_sim {

[[nodiscard]] std::string html_report(const RunSummary& summary, const RunStory& story, const base::BudgetTable& memory);

/// Writes summary.json and report.html into the folder, each whole or not at all.
void write_run_reports(const std::string& folder, const RunSummary& summary, const RunStory& story,
                       const base::BudgetTable& memory);

}  // namespace tedavis::host_sim
