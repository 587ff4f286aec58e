/// Reads the files of switch logs: their text, the edges of a panel's lines, and defects.
#pragma once

#include <string>
#include <vector>

#include "bus/switches/switch_log_source.hpp"
#include "host_sim/reports/run_findings.hpp"

namespace tedavis::host_sim {

/// Returns the text of a switch log. Throws UserError where the file is no switch log.
[[nodiscard]] std::string read_switch_log(const std::string& path);

/// A switch log read with the lines of a panel.
struct PanelReading {
    std::vector<bus::SwitchEdge> edges;  ///< in order of time
    bus::SwitchStatistics statistics;
    std::vector<bus::SwitchLineReport> reports;  ///< the first lines that are no edges of the panel
};
[[nodiscard]] PanelReading read_panel(std::string_view log_text, const bus::SwitchConfig& panel);

/// Returns findings about malformed lines, lines that the panel does not have, and lines of the panel that the log never states.
/// `log` and `panel_name` are the files as the user named them.
[[nodiscard]] Findings switch_findings(const std::string& log, std::string_view log_text, const std::string& panel_name,
                                       const bus::SwitchConfig& panel, const PanelReading& reading);

/// Returns a finding about edges outside the time of the flight.
[[nodiscard]] Findings switch_time_findings(const std::string& log, const std::vector<bus::SwitchEdge>& edges, base::Time first,
                                            base::Time last);

}  // namespace tedavis::host_sim
