/// The phase switches as keys turn them: edges for the player, and the log that replays them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bus/switches/switch_config.hpp"
#include "bus/switches/switch_edge.hpp"

namespace tedavis::host_sim {

/// What brings the panel to a pattern at `time`: an edge for each line whose level, after all of `before`, is another one or
/// not known yet. `high`: one bit a line.
[[nodiscard]] std::vector<bus::SwitchEdge> edges_to_pattern(const bus::SwitchConfig& config,
                                                            const std::vector<bus::SwitchEdge>& before, std::uint32_t high,
                                                            base::Time time);

/// A switch log of these edges (bus/switches/switch_log.hpp).
[[nodiscard]] std::string switch_log_text(const bus::SwitchConfig& config, const std::vector<bus::SwitchEdge>& edges);

}  // namespace tedavis::host_sim
