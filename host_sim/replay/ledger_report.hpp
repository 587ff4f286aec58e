/// The ledger of a run as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "host_sim/replay/effect_ledger.hpp"

namespace tedavis::host_sim {

/// ledger.json in the run's folder, and beside it, in ledger/, "EFFECT_intended.png" and "EFFECT_shown.png" of the frame that
/// differs most.
[[nodiscard]] std::string ledger_json(const std::vector<LedgerPrice>& prices, const std::vector<LedgerSample>& samples,
                                      const std::string& device);
/// A line an effect.
[[nodiscard]] std::string ledger_text(const std::vector<LedgerPrice>& prices);
/// Writes both, the pictures of an earlier run removed. Throws UserError.
void write_ledger(const std::string& folder, const std::string& json, const std::vector<LedgerPrice>& prices);

}  // namespace tedavis::host_sim
