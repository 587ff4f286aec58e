/// Weights of aspects that stand above those of a design: `--weights terrain=0.3,data=1`.
#pragma once

#include <map>
#include <string>

#include "render_core/design/priority.hpp"

namespace tedavis::host_sim {

/// Requested weights by the aspect's name.
using AskedWeights = std::map<std::string, double>;

/// Parses weights; throws UserError where the text is not a list of names with numbers from 0 to 1.
[[nodiscard]] AskedWeights weights_from(const std::string& text);
/// Returns the text that weights_from() reads.
[[nodiscard]] std::string text_of(const AskedWeights& weights);
/// Sets the requested weights in a design; in a design without weights all others are 1. Throws UserError, which names the
/// design's aspects, where it lacks a requested one.
void put_weights(const AskedWeights& weights, const std::string& design_file, design::PrioritySettings& priority);

}  // namespace tedavis::host_sim
