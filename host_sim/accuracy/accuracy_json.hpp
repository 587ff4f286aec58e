/// `accuracy.json`, which is also what `accuracy --json` prints, and `accuracy.csv`, one line per level.
/// host_sim/accuracy/README.md lists the keys.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host_sim/accuracy/accuracy_report.hpp"

namespace tedavis::host_sim {

inline constexpr char kAccuracySchema[] = "tedavis.accuracy/5";

[[nodiscard]] nlohmann::ordered_json accuracy_json(const AccuracyReport& report);
/// Reads what accuracy_json() wrote. Throws UserError, whose message begins with `name`, if the text is not a JSON object, has
/// another schema or lacks keys.
[[nodiscard]] AccuracyReport read_accuracy(const std::string& text, const std::string& name);
[[nodiscard]] std::string accuracy_csv(const AccuracyReport& report);

}  // namespace tedavis::host_sim
