/// The tracer's contact sheet as one picture, as a page and as JSON.
#pragma once

#include <string>

#include "host_sim/reports/drawn_sheet.hpp"
#include "host_sim/tracing/trace_sheet.hpp"

namespace tedavis::host_sim {

/// Converts the sheet for draw_contact_sheet().
[[nodiscard]] DrawnSheet labelled_sheet(const TraceSheet& sheet, const TracedGround& ground);
/// Returns a self-contained page: a table of times, bytes and errors, then the pictures.
[[nodiscard]] std::string trace_sheet_page(const TraceSheet& sheet, const TracedGround& ground);
/// Keys that scripts may rely on: `sheet`, `terrain`, `pose`, `picture`, `page`, and `pictures` [{`group`, `title`, `file`,
/// `error` {`mean`, `largest`, `edges`}}], each with the keys of shot_json().
[[nodiscard]] std::string trace_sheet_json(const TraceSheet& sheet, const TracedGround& ground);

}  // namespace tedavis::host_sim
