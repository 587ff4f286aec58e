/// A report beside an earlier one: which levels became slower or less accurate.
#pragma once

#include <string>
#include <vector>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

/// What may change before it counts as worse, as shares of the earlier figure.
struct ComparisonLimits {
    double slower = 0.25;        ///< of a median time
    double less_accurate = 0.1;  ///< of a mean or greatest error
};

/// Compares the report with one that was read from `file`, level by level. Times are judged only where both were measured on the
/// same processor, and only beyond the noise of both. Throws UserError if the heights, the flight, the displays or the extent
/// differ, since then errors are not of the same inputs.
[[nodiscard]] ComparedReport compare_accuracy(const AccuracyReport& report, const AccuracyReport& earlier,
                                              const std::string& file, const ComparisonLimits& limits);

/// True if a level is slower or less accurate beyond the limits, or is no longer there.
[[nodiscard]] bool is_worse(const ComparedReport& compared);

/// For people: what is worse, a line each, or that nothing is.
[[nodiscard]] std::string comparison_text(const ComparedReport& compared);

/// HTML of one table: a row for each level, a column of times for each report; empty without comparisons.
[[nodiscard]] std::string comparison_table(const std::vector<ComparedReport>& comparisons);

}  // namespace tedavis::host_sim
