/// The result of a contract as JSON, a stable format for scripts, and as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host_sim/contract/judge_contract.hpp"

namespace tedavis::host_sim {

/// `holds`, `failures` [{`condition`, `time_s`, `value`, `limit`, `region`, ...}], `conditions` with all of them and their
/// `values` at `times_s`, null where one was not measured. In a failure
/// time, value and region are those of the first break, under `worst` those of the worst one; null where nothing was measured,
/// with the reason under `why`. An infinite rank is null.
[[nodiscard]] nlohmann::ordered_json contract_json(const JudgedContract& judged);
/// Returns the text without a line end.
[[nodiscard]] std::string contract_text(const JudgedContract& judged);
/// Returns "0.110 is the most".
[[nodiscard]] std::string bound_text(const ContractCondition& condition);
/// Returns "0.140 (whole picture)" of a value that was measured.
[[nodiscard]] std::string reading_text(const ContractCondition& condition, const ContractReading& reading);
/// Returns why a condition could not be measured, or is passed; empty where it was measured.
[[nodiscard]] std::string condition_gap(const JudgedCondition& judged);

}  // namespace tedavis::host_sim
