#include "target/board_config.hpp"

#include "bus/canaerospace/identifier_table.hpp"
#include "platform/configuration/display_config.hpp"
#include "platform/files/file_text.hpp"
#include "render_core/base/config_reader.hpp"
#include "target/design_files.hpp"

namespace tedavis::target {
namespace {

constexpr std::uint16_t kIdentificationRequest = 128;

/// Reads one board file; the first fault of a file that it names is kept with that file's own place.
class BoardFile {
public:
    BoardFile(std::string_view text, const char* path) : reader_(text, path) {}

    base::Result<BoardSettings, base::Error> read() {
        platform::read_display_config(reader_, platform::ConfigUse::board, config_);
        settings_.title = config_.title;
        base::ConfigSection root = reader_.root();
        take(root, "device", config_.device, settings_.device, &effects::read_device_settings);
        read_design(root);
        take(root, "bus", config_.bus, settings_.bus, &bus::load_bus_settings);
        take(root, "aircraft", config_.aircraft, settings_.aircraft, &design::load_aircraft);
        take(root, "symbology", config_.symbology, settings_.symbology, &design::load_symbology_palettes);
        base::ConfigSection switches = root.section("switches");
        take(switches, "config", config_.switches, settings_.switches, &bus::load_switch_config);
        settings_.has_switches = !config_.switches.empty();
        take_plain_settings();
        if (!reader_.finish()) return base::fail(base::make_error(reader_.error().message.view()));
        if (named_file_fault_) return base::fail(named_file_fault_);
        return settings_;
    }

private:
    void take_plain_settings() {
        settings_.light = config_.light;
        settings_.can = config_.can;
        if (config_.filters_can) add_bus_filters(settings_.can, settings_.bus);
        settings_.terrain = config_.terrain;
        settings_.scene = config_.scene;
        settings_.costs = config_.costs;
        settings_.programs = config_.programs;
        settings_.surface = config_.surface;
        settings_.screen = config_.screen;
        settings_.records = config_.records;
        settings_.width_px = config_.width_px > 0 ? config_.width_px : settings_.device.width_px;
        settings_.height_px = config_.height_px > 0 ? config_.height_px : settings_.device.height_px;
        settings_.legend = config_.legend;
        settings_.residency = config_.residency;
        if (config_.deadline_ms) settings_.device.deadline_ms = *config_.deadline_ms;
    }

    template <class Settings, class Load>
    void take(base::ConfigSection& section, std::string_view key, const Path& path, Settings& settings, Load load) {
        if (path.empty()) return;
        const auto text = platform::read_file_text(path.c_str());
        if (!text.ok()) return section.fault(key, text.error().message.view());
        auto loaded = load(text.value().view(), path.view());
        if (loaded.ok())
            settings = loaded.value();
        else if (!named_file_fault_)
            named_file_fault_ = base::make_error(loaded.error().message.view());
    }

    void read_design(base::ConfigSection& root) {
        design::NamedPhases phases;
        take(root, "design", config_.design, settings_.design, [&](std::string_view text, std::string_view path) {
            DesignFiles files(folders());
            return design::read_design_settings(text, path, files, &phases);
        });
        put_above(config_.design.view(), settings_.design);
        for (const design::NamedPhase& named : phases) read_phase_design(root, named);
    }

    [[nodiscard]] DesignFolders folders() const { return {config_.palettes.view(), config_.designs.view()}; }

    void put_above(std::string_view design_name, design::DesignSettings& design) {
        if (named_file_fault_ || !reader_.ok()) return;
        named_file_fault_ = platform::put_parameters(config_.parameters, design_name, design);
    }

    void read_phase_design(base::ConfigSection& root, const design::NamedPhase& named) {
        if (const design::DesignSettings* const known = settings_.phases.find(named.design); known != nullptr)
            return static_cast<void>(settings_.phases.add(named, *known));
        const Path path = path_of_design({named.design.view(), config_.design.view()}, folders());
        const auto text = platform::read_file_text(path.c_str());
        if (path.cut() || !text.ok())
            return root.fault("design",
                              path.cut() ? "a phase's design has a path that is too long" : text.error().message.view());
        DesignFiles files(folders());
        design::NamedPhases nested;
        auto loaded = design::read_design_settings(text.value().view(), path.view(), files, &nested);
        if (!loaded.ok() && !named_file_fault_) named_file_fault_ = base::make_error(loaded.error().message.view());
        if (!loaded.ok()) return;
        if (!nested.empty())
            return root.fault("design", "names a design for a phase that has a table [phases] itself; remove that");
        put_above(path.view(), loaded.value());
        if (!settings_.phases.add(named, loaded.value()))
            root.fault("design", "names more than six different designs for phases; remove some");
    }

    base::ConfigReader reader_;
    platform::DisplayConfig config_;
    BoardSettings settings_;
    base::Error named_file_fault_;
};

base::Result<BoardSettings, base::Error> read_board_file(const char* path) {
    const auto text = platform::read_file_text(path);
    if (!text.ok()) return base::fail(text.error());
    return BoardFile(text.value().view(), path).read();
}

}  // namespace

void add_bus_filters(bus::SocketCanSettings& can, const bus::BusSettings& bus) {
    bool fits = add_identifier_filters(can, bus.phase.status_identifier) &&
                add_identifier_filters(can, bus.phase.request_identifier) && add_identifier_filters(can, kIdentificationRequest);
    for (const bus::IdentifierEntry& entry : bus::identifier_table())
        if (!entry.glider_profile || bus.dialect.glider_identifiers) fits = fits && add_identifier_filters(can, entry.identifier);
    for (std::uint16_t n = 0; bus.traffic.is_carried() && n < bus::kTrafficIdentifiers; ++n)
        fits = fits && add_identifier_filters(can, static_cast<std::uint16_t>(bus.traffic.first_identifier + n));
    for (std::uint16_t n = 0; bus.guidance.is_carried() && n < bus::kGuidanceIdentifiers; ++n)
        fits = fits && add_identifier_filters(can, static_cast<std::uint16_t>(bus.guidance.first_identifier + n));
    for (const bus::StatedMessage& message : bus.messages) fits = fits && add_identifier_filters(can, message.identifier);
    if (bus.display.legend_identifier != 0) fits = fits && add_identifier_filters(can, bus.display.legend_identifier);
    if (!fits) can.filters.clear();
}

base::Result<BoardSettings, platform::ConfigError> load_board_settings(const char* path, const char* pack_key) {
    const auto found = platform::find_config(path, pack_key);
    if (!found.ok()) return base::fail(found.error());
    auto settings = read_board_file(found.value().file.c_str());
    if (!settings.ok()) return base::fail(platform::fault_of_start(found.value().pack, settings.error()));
    settings.value().pack = found.value().pack;
    return settings.value();
}

}  // namespace tedavis::target
