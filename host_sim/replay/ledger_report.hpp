/// The ledger of a run as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "host_sim/replay/effect_ledger.hpp"

namespace tedavis::host_sim {

/// Returns the content of ledger.json.
[[nodiscard]] std::string ledger_json(const std::vector<LedgerPrice>& prices, const std::vector<LedgerSample>& samples,
                                      const std::string& device);
/// Returns one line per effect.
[[nodiscard]] std::string ledger_text(const std::vector<LedgerPrice>& prices);
/// Writes ledger.json into the run's folder and, into its subfolder ledger, the pictures "EFFECT_intended.png" and
/// "EFFECT_shown.png" of the frame that differs most; removes the pictures of an earlier run. Throws UserError.
void write_ledger(const std::string& folder, const std::string& json, const std::vector<LedgerPrice>& prices);

}  // namespace tedavis::host_sim
