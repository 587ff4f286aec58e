/// Weights of aspects that override those of a design: `--weights terrain=0.3,data=1`.
#pragma once

#include <map>
#include <string>

namespace tedavis::host_sim {

/// Requested weights, 0 to 1, by the aspect's name.
using AskedWeights = std::map<std::string, double>;

/// Parses weights; throws UserError where the text is not a list of names with numbers from 0 to 1.
[[nodiscard]] AskedWeights weights_from(const std::string& text);
/// Returns the text that weights_from() reads.
[[nodiscard]] std::string text_of(const AskedWeights& weights);

}  // namespace tedavis::host_sim
