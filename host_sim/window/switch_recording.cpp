#include "host_sim/window/switch_recording.hpp"

#include <array>

#include "bus/switches/switch_log.hpp"

namespace tedavis::host_sim {

std::vector<bus::SwitchEdge> edges_to_pattern(const bus::SwitchConfig& config, const std::vector<bus::SwitchEdge>& before,
                                              std::uint32_t high, base::Time time) {
    bus::SwitchLevels levels;
    for (const bus::SwitchEdge& edge : before) {
        const std::uint32_t bit = std::uint32_t{1} << edge.line;
        levels.known |= bit;
        levels.high = edge.level ? levels.high | bit : levels.high & ~bit;
    }
    // The line of the legend stays as it is.
    const std::uint32_t phase = config.phase_lines();
    const std::uint32_t changed = ((levels.high ^ high) & phase) | (config.all_lines() & ~levels.known);
    std::vector<bus::SwitchEdge> edges;
    for (std::size_t line = 0; line < config.lines.size(); ++line) {
        const std::uint32_t bit = std::uint32_t{1} << line;
        if ((changed & bit) != 0) edges.push_back({time, static_cast<std::uint8_t>(line), (high & bit) != 0});
    }
    return edges;
}

std::string switch_log_text(const bus::SwitchConfig& config, const std::vector<bus::SwitchEdge>& edges) {
    std::string text(bus::kSwitchLogHeader);
    std::array<char, bus::kMaxSwitchLogLine> line;
    for (const bus::SwitchEdge& edge : edges)
        text.append(line.data(), bus::format_switch_log_line(edge, config, {line.data(), line.size()}));
    return text;
}

}  // namespace tedavis::host_sim
