#include "host_sim/commands/check_switch_log.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/read_switch_log.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

struct ReadPanel {
    std::string name;
    bus::SwitchConfig config;
    PanelReading reading;
};

ReadPanel read_by(const std::string& name, const std::string& config_path, std::string_view log_text) {
    const auto config = bus::load_switch_config(read_file(config_path), config_path);
    if (!config.ok()) throw UserError(std::string(config.error().message.view()));
    return {name, config.value(), read_panel(log_text, config.value())};
}

/// In the order of their names.
std::vector<std::string> shipped_panels() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(shipped_root() + "/configs/switches"))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

ReadPanel nearest_panel(std::string_view log_text) {
    std::optional<ReadPanel> nearest;
    for (const std::string& name : shipped_panels()) {
        ReadPanel panel = read_by(name, resolve_config(name, "switches"), log_text);
        if (!nearest || panel.reading.edges.size() > nearest->reading.edges.size()) nearest = std::move(panel);
    }
    if (!nearest) throw UserError(shipped_root() + "/configs/switches: holds no panel; name one with --switch-config");
    return std::move(*nearest);
}

void require_whole_lines(const std::string& path, const PanelReading& reading) {
    for (const bus::SwitchLineReport& report : reading.reports)
        if (report.fault != bus::SwitchLineFault::line_name)
            throw UserError(path + ":" + std::to_string(report.line) + ": " + bus::describe(report.fault) + "; correct the line");
}

}  // namespace

CheckedFile check_switch_log(const std::string& path, const std::string& panel) {
    const std::string text = read_switch_log(path);
    const ReadPanel read = panel.empty() ? nearest_panel(text) : read_by(panel, resolve_config(panel, "switches"), text);
    require_whole_lines(path, read.reading);
    Findings findings = switch_findings(path, text, read.name, read.config, read.reading);
    if (read.reading.edges.empty()) return {"a switch log", findings};
    return {"a switch log of the panel " + read.name + ", " + counted(read.reading.edges.size(), "edge"), findings};
}

}  // namespace tedavis::host_sim
