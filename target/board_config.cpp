#include "target/board_config.hpp"

#include "bus/canaerospace/identifier_table.hpp"
#include "platform/surface_settings.hpp"
#include "render_core/base/config_reader.hpp"
#include "target/design_files.hpp"
#include "target/file_text.hpp"

namespace tedavis::target {
namespace {

constexpr std::uint16_t kIdentificationRequest = 128;
constexpr std::string_view kCardNumber = "/dev/dri/card";
constexpr std::string_view kBackends[] = {"egl", "kms", "osmesa"};

/// Reads one board file; the first fault of a file that it names is kept with that file's own place.
class BoardFile {
public:
    BoardFile(std::string_view text, const char* path) : path_(path), reader_(text, path) {}

    base::Result<BoardSettings, base::Error> read() {
        base::ConfigSection root = reader_.root();
        settings_.title.append(root.text("title", "board"));
        take(root, "device", settings_.device, &effects::read_device_settings);
        read_design(root);
        take(root, "bus", settings_.bus, &bus::load_bus_settings);
        if (root.has("aircraft")) take(root, "aircraft", settings_.aircraft, &design::load_aircraft);
        if (root.has("symbology")) take(root, "symbology", settings_.symbology, &design::load_symbology_palettes);
        root.choose("light", design::kSymbologyLightNames, settings_.light);
        read_switches(root.section("switches"));
        read_database(root.section("terrain"), settings_.terrain);
        read_database(root.section("scene"), settings_.scene);
        if (base::ConfigSection costs = root.section("costs"); costs.present()) settings_.costs = path_at(costs, "file");
        if (base::ConfigSection made = root.section("programs"); made.present()) settings_.programs = path_at(made, "folder");
        read_can(root.section("can"));
        read_surface(root.section("surface"));
        read_screen(root);
        if (base::ConfigSection records = root.section("records"); records.present())
            settings_.records = path_at(records, "socket");
        root.section("display").choose("legend", flight::kLegendShowNames, settings_.legend);
        const bool touch = root.section("memory").boolean("touch", true);
        settings_.residency = touch ? platform::Residency::touched : platform::Residency::lazy;
        if (!reader_.finish()) return base::fail(base::make_error(reader_.error().message.view()));
        if (named_file_fault_) return base::fail(named_file_fault_);
        return settings_;
    }

private:
    /// The path behind `key`; empty after a fault.
    Path path_at(base::ConfigSection& section, std::string_view key) {
        const std::string_view name = section.text(key);
        if (name.empty()) {
            section.fault(key, "no file is named here; write its path");
            return {};
        }
        const Path path = path_beside(path_, name);
        if (!path.cut()) return path;
        section.fault(key, "the path is longer than 1023 bytes; use a shorter one");
        return {};
    }

    template <class Settings, class Load>
    void take(base::ConfigSection& section, std::string_view key, Settings& settings, Load load) {
        const Path path = path_at(section, key);
        if (path.empty()) return;
        const auto text = read_file_text(path.c_str());
        if (!text.ok()) return section.fault(key, text.error().message.view());
        auto loaded = load(text.value().view(), path.view());
        if (loaded.ok())
            settings = loaded.value();
        else if (!named_file_fault_)
            named_file_fault_ = base::make_error(loaded.error().message.view());
    }

    /// The palettes that a design names lie in one folder: the board file's own, or another that it names.
    void read_design(base::ConfigSection& root) {
        Path folder = path_beside(path_, root.text("palettes", ""));
        if (!folder.empty() && folder.view().back() != '/') folder.append("/");
        if (folder.cut()) return root.fault("palettes", "the path is longer than 1023 bytes; use a shorter one");
        Path design;
        design::NamedPhases phases;
        take(root, "design", settings_.design, [&](std::string_view text, std::string_view path) {
            DesignFiles files(folder.view());
            design = Path(path);
            return design::read_design_settings(text, path, files, &phases);
        });
        for (const design::NamedPhase& named : phases) read_phase_design(root, named, design.view(), folder.view());
    }

    void read_phase_design(base::ConfigSection& root, const design::NamedPhase& named, std::string_view design,
                           std::string_view palette_folder) {
        if (const design::DesignSettings* const known = settings_.phases.find(named.design); known != nullptr)
            return static_cast<void>(settings_.phases.add(named, *known));
        const Path path = path_of_design({named.design.view(), design});
        const auto text = read_file_text(path.c_str());
        if (path.cut() || !text.ok())
            return root.fault("design",
                              path.cut() ? "a phase's design has a path that is too long" : text.error().message.view());
        DesignFiles files(palette_folder);
        design::NamedPhases nested;
        const auto loaded = design::read_design_settings(text.value().view(), path.view(), files, &nested);
        if (!loaded.ok() && !named_file_fault_) named_file_fault_ = base::make_error(loaded.error().message.view());
        if (!loaded.ok()) return;
        if (!nested.empty())
            return root.fault("design", "names a design for a phase that has a table [phases] itself; remove that");
        if (!settings_.phases.add(named, loaded.value()))
            root.fault("design", "names more than six different designs for phases; remove some");
    }

    void read_switches(base::ConfigSection section) {
        settings_.has_switches = section.present();
        if (section.present()) take(section, "config", settings_.switches, &bus::load_switch_config);
    }

    void read_database(base::ConfigSection section, Path& path) {
        if (section.present()) path = path_at(section, "database");
    }

    void read_can(base::ConfigSection section) {
        bus::SocketCanSettings& can = settings_.can;
        const std::string_view name = section.text("interface");
        can.interface_name = base::FixedString<15>(name);
        if (name.empty() || can.interface_name.cut())
            section.fault("interface", "an interface name has 1 to 15 bytes; write it as `ip link` shows it");
        can.can_fd = section.boolean("fd", false);
        can.receive_buffer_bytes =
            static_cast<std::uint32_t>(section.integer("receive_buffer_bytes", 4096, 1 << 28, can.receive_buffer_bytes));
        can.reopen_interval = base::Duration::from_seconds(section.number("reopen_s", 0.1, 60, can.reopen_interval.to_seconds()));
        if (section.boolean("filter", true)) add_bus_filters(can, settings_.bus);
    }

    void read_surface(base::ConfigSection section) {
        std::size_t backend = 0;
        section.choose("backend", kBackends, backend);
        settings_.surface.append(kBackends[backend]);
        const auto size = [&section](std::string_view key, std::uint32_t of_device) {
            // A device that could not be read has said so already.
            const std::int64_t fallback = of_device == 0 ? platform::kMinSurfacePx : of_device;
            return static_cast<std::uint32_t>(section.integer(key, platform::kMinSurfacePx, platform::kMaxSurfacePx, fallback));
        };
        settings_.width_px = size("width_px", settings_.device.width_px);
        settings_.height_px = size("height_px", settings_.device.height_px);
    }

    void read_screen(base::ConfigSection& root) {
        base::ConfigSection section = root.section("screen");
        if (!section.present()) return;
        if (settings_.surface.view() != "kms")
            return root.fault("screen", "is for backend = \"kms\" of [surface]; set that, or remove this section");
        platform::ScreenSettings& screen = settings_.screen;
        take_text(section, "driver", screen.driver);
        take_text(section, "path", screen.path);
        take_text(section, "connector", screen.connector);
        if (!screen.driver.empty() && !screen.path.empty())
            section.fault("path", "the card is named by its driver as well; remove one of the two");
        if (screen.path.view().substr(0, kCardNumber.size()) == kCardNumber)
            section.fault("path",
                          "the numbers of cards change from start to start; name the card by driver, or by /dev/dri/by-path");
        if (!platform::parse_screen_mode(section.text("mode", "preferred"), screen.mode))
            section.fault("mode", "is no mode; write \"1024x768@60\", \"1024x768\" or \"preferred\"");
    }

    template <std::size_t N>
    static void take_text(base::ConfigSection& section, std::string_view key, base::FixedString<N>& text) {
        text.append(section.text(key, ""));
        if (text.cut()) section.fault(key, "the text is too long; use a shorter one");
    }

    std::string_view path_;
    base::ConfigReader reader_;
    BoardSettings settings_;
    base::Error named_file_fault_;
};

}  // namespace

Path path_beside(std::string_view board_file, std::string_view name) {
    Path path;
    const std::size_t slash = board_file.rfind('/');
    if (name.substr(0, 1) != "/" && slash != std::string_view::npos) path.append(board_file.substr(0, slash + 1));
    path.append(name);
    return path;
}

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

base::Result<BoardSettings, base::Error> load_board_settings(const char* path) {
    const auto text = read_file_text(path);
    if (!text.ok()) return base::fail(text.error());
    BoardFile file(text.value().view(), path);
    return file.read();
}

}  // namespace tedavis::target
