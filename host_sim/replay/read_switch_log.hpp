/// Switch logs as files: their text, their edges by a panel, and what is wrong with them.
#pragma once

#include <string>
#include <vector>

#include "bus/switches/switch_log_source.hpp"
#include "host_sim/reports/run_findings.hpp"

namespace tedavis::host_sim {

/// The text of a switch log; throws UserError where the file is none.
[[nodiscard]] std::string read_switch_log(const std::string& path);

/// A switch log as a panel reads it.
struct PanelReading {
    std::vector<bus::SwitchEdge> edges;  ///< in order of time
    bus::SwitchStatistics statistics;
    std::vector<bus::SwitchLineReport> reports;  ///< the first lines that are no edges of the panel
};
[[nodiscard]] PanelReading read_panel(std::string_view log_text, const bus::SwitchConfig& panel);

/// Lines that the panel does not have or that are broken, and lines of the panel that the log never states. `log`, `panel_name`:
/// as the user named them.
[[nodiscard]] Findings switch_findings(const std::string& log, std::string_view log_text, const std::string& panel_name,
                                       const bus::SwitchConfig& panel, const PanelReading& reading);

/// Edges that no instant of the flight can show.
[[nodiscard]] Findings switch_time_findings(const std::string& log, const std::vector<bus::SwitchEdge>& edges, base::Time first,
                                            base::Time last);

}  // namespace tedavis::host_sim
