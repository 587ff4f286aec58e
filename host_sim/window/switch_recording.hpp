/// Converts the keys for phase switches to edges for the player, and to a switch log.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bus/switches/switch_config.hpp"
#include "bus/switches/switch_edge.hpp"

namespace tedavis::host_sim {

/// Returns the edges that bring the panel to a pattern at `time`: one for each line whose level after the edges `before` is
/// different or not known. `high` has one bit per line.
[[nodiscard]] std::vector<bus::SwitchEdge> edges_to_pattern(const bus::SwitchConfig& config,
                                                            const std::vector<bus::SwitchEdge>& before, std::uint32_t high,
                                                            base::Time time);

/// A switch log of these edges (bus/switches/switch_log.hpp).
[[nodiscard]] std::string switch_log_text(const bus::SwitchConfig& config, const std::vector<bus::SwitchEdge>& edges);

}  // namespace tedavis::host_sim
