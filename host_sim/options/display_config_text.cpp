#include "host_sim/options/display_config_text.hpp"

#include "host_sim/options/toml_writer.hpp"

namespace tedavis::host_sim {
namespace {

/// A section of one key; none where the text is empty.
void put_named(TomlWriter& toml, const char* section, const char* key, std::string_view name) {
    if (name.empty()) return;
    toml.section(section);
    toml.word(key, name);
}

void put_parameters_text(TomlWriter& toml, const platform::DisplayConfig& config) {
    const platform::DesignParameters& above = config.parameters;
    if (above.tau_px || config.deadline_ms || !above.foci.empty()) toml.section("parameters");
    toml.number("tau_px", above.tau_px);
    toml.number("deadline_ms", config.deadline_ms);
    std::vector<std::string> foci;
    for (const auto& line : above.foci) foci.emplace_back(line.view());
    toml.words("foci", foci);
    if (!above.weights.empty()) toml.section("parameters.weights");
    for (const platform::AspectWeight& weight : above.weights)
        toml.number(toml_string(std::string(weight.aspect.view())), weight.weight);
}

void put_can(TomlWriter& toml, const platform::DisplayConfig& config) {
    if (!config.has_can) return;
    toml.section("can");
    toml.word("interface", config.can.interface_name.view());
    toml.truth("fd", config.can.can_fd);
    toml.truth("filter", config.filters_can);
    toml.integer("receive_buffer_bytes", config.can.receive_buffer_bytes);
    toml.number("reopen_s", config.can.reopen_interval.to_seconds());
}

void put_screen(TomlWriter& toml, const platform::DisplayConfig& config) {
    toml.section("surface");
    toml.word("backend", config.surface.view());
    if (config.width_px > 0) toml.integer("width_px", config.width_px);
    if (config.height_px > 0) toml.integer("height_px", config.height_px);
    if (config.surface.view() != "kms") return;
    const platform::ScreenSettings& screen = config.screen;
    toml.section("screen");
    toml.word("driver", screen.driver.view());
    toml.word("path", screen.path.view());
    toml.word("connector", screen.connector.view());
    const auto mode = platform::mode_text(screen.mode.width_px, screen.mode.height_px, screen.mode.refresh_mhz);
    toml.word("mode", screen.mode.is_preferred() ? "preferred" : mode.view());
}

}  // namespace

std::string display_config_text(const platform::DisplayConfig& config) {
    TomlWriter toml;
    toml.word("title", config.title.view());
    toml.word("device", config.device.view());
    toml.word("design", config.design.view());
    toml.word("designs", config.designs.view());
    toml.word("palettes", config.palettes.view());
    toml.word("bus", config.bus.view());
    toml.word("aircraft", config.aircraft.view());
    toml.word("light", design::kSymbologyLightNames[static_cast<std::size_t>(config.light)]);
    toml.word("symbology", config.symbology.view());
    put_named(toml, "terrain", "database", config.terrain.view());
    put_named(toml, "scene", "database", config.scene.view());
    put_named(toml, "costs", "file", config.costs.view());
    put_named(toml, "programs", "folder", config.programs.view());
    put_parameters_text(toml, config);
    put_can(toml, config);
    put_named(toml, "switches", "config", config.switches.view());
    put_screen(toml, config);
    put_named(toml, "records", "socket", config.records.view());
    put_named(toml, "display", "legend", flight::kLegendShowNames[static_cast<std::size_t>(config.legend)]);
    toml.section("memory");
    toml.truth("touch", config.residency == platform::Residency::touched);
    return toml.text();
}

}  // namespace tedavis::host_sim
