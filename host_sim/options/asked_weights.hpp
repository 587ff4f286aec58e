/// Weights of aspects that stand above those of a design: `--weights terrain=0.3,data=1`.
#pragma once

#include <map>
#include <string>

#include "render_core/design/priority.hpp"

namespace tedavis::host_sim {

/// By the aspect's name.
using AskedWeights = std::map<std::string, double>;

/// Throws UserError: no list of names with numbers from 0 to 1.
[[nodiscard]] AskedWeights weights_from(const std::string& text);
/// What weights_from() reads.
[[nodiscard]] std::string text_of(const AskedWeights& weights);
/// A design that states no weights has 1 of all others. Throws UserError where it has no such aspect, and names those that it
/// has.
void put_weights(const AskedWeights& weights, const std::string& design_file, design::PrioritySettings& priority);

}  // namespace tedavis::host_sim
