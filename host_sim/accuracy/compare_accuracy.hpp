/// Compares a report with an earlier one: which levels became slower or less accurate.
#pragma once

#include <string>
#include <vector>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

/// By how much a figure may grow before it counts as worse, as a share of the earlier figure.
struct ComparisonLimits {
    double slower = 0.25;        ///< of a median time
    double less_accurate = 0.1;  ///< of a mean or greatest error
};

/// Compares the report with one that was read from `file`, level by level. Times are judged only if both were measured on the
/// same processor model with as many processors, and only if they grew by more than the noise of both. Errors below the bound of
/// the reference are not judged. Throws UserError if the heights, the flight, the displays or the extent differ, since then
/// errors are not of the same inputs.
[[nodiscard]] ComparedReport compare_accuracy(const AccuracyReport& report, const AccuracyReport& earlier,
                                              const std::string& file, const ComparisonLimits& limits);

/// True if a level is slower or less accurate beyond the limits, or if a knob of both reports lacks a level that it had.
[[nodiscard]] bool is_worse(const ComparedReport& compared);

/// Returns a text for people: how far both reports rank the levels alike, and one line for each time or error that became worse
/// and for each level that is gone, or the statement that no level is worse.
[[nodiscard]] std::string comparison_text(const ComparedReport& compared);

/// Returns HTML: one sentence on the ranking of levels for each comparison, then a table with one row per level and, for each
/// earlier report, its time, its largest error and a remark. Empty without comparisons.
[[nodiscard]] std::string comparison_table(const std::vector<ComparedReport>& comparisons);

}  // namespace tedavis::host_sim
