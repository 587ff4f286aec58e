/// Describes the compared runs and their differences in sentences.
#pragma once

#include <string>
#include <vector>

#include "host_sim/comparison/run_comparison.hpp"

namespace tedavis::host_sim {

/// "The same flight with two designs: A default, B cruise" or "Two flights: A a.log, B b.log".
[[nodiscard]] std::string comparison_title(const RunComparison& runs);
/// Which run is A and which is B, and by what they are aligned.
[[nodiscard]] std::vector<std::string> run_introductions(const RunComparison& runs);
/// The main differences, one sentence each; a single sentence where nothing differs.
[[nodiscard]] std::vector<std::string> difference_sentences(const RunComparison& runs);
/// Warnings about what makes numbers hard to compare: different sizes, missing pictures or terrain alerts. May be empty.
[[nodiscard]] std::vector<std::string> comparison_warnings(const RunComparison& runs);
/// The times of an instant in both runs: "12:46:05 UTC" or "A 12:46:05 UTC, B 14:02:11 UTC".
[[nodiscard]] std::string instant_words(const RunComparison& runs, std::size_t instant);

}  // namespace tedavis::host_sim
