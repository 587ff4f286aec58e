/// Names of files in the folder of a run.
#pragma once

#include <cstdint>
#include <string>

namespace tedavis::host_sim {

inline constexpr char kFrameRecordsName[] = "frames.jsonl";
inline constexpr char kSummaryName[] = "summary.json";
inline constexpr char kReportName[] = "report.html";
inline constexpr char kLedgerName[] = "ledger.json";
inline constexpr char kLedgerFolder[] = "ledger";
inline constexpr char kFramesFolder[] = "frames";
inline constexpr char kWindowSwitchesName[] = "window.switches";

/// "<folder>/frames/000123.png".
[[nodiscard]] std::string frame_picture_path(const std::string& folder, std::uint64_t frame);

/// Throws UserError if the folder of -o is that of a run, whose report would be overwritten.
void require_no_run(const std::string& output);

}  // namespace tedavis::host_sim
