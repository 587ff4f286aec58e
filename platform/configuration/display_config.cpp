#include "platform/configuration/display_config.hpp"

#include <array>

#include "platform/surface_settings.hpp"

namespace tedavis::platform {
namespace {

constexpr std::string_view kCardNumber = "/dev/dri/card";
constexpr std::string_view kBackends[] = {"egl", "kms", "osmesa"};
constexpr const char* kPathTooLong = "the path is longer than 1023 bytes; use a shorter one";

class DisplayConfigReader {
public:
    DisplayConfigReader(base::ConfigReader& reader, DisplayConfig& config) : reader_(reader), config_(config) {}

    void read(ConfigUse use) {
        base::ConfigSection root = reader_.root();
        config_.title.append(root.text("title", "board"));
        read_files(root);
        root.choose("light", design::kSymbologyLightNames, config_.light);
        read_parameters(root.section("parameters"));
        config_.has_can = root.section("can").present();
        if (config_.has_can || use == ConfigUse::board) read_can(root.section("can"));
        read_surface(root.section("surface"));
        read_screen(root);
        root.section("display").choose("legend", flight::kLegendShowNames, config_.legend);
        const bool touch = root.section("memory").boolean("touch", true);
        config_.residency = touch ? Residency::touched : Residency::lazy;
        if (use == ConfigUse::board) root.remove("replay");
    }

private:
    void read_files(base::ConfigSection& root) {
        take_path(root, "device", config_.device);
        take_path(root, "design", config_.design);
        take_path(root, "bus", config_.bus);
        if (root.has("aircraft")) take_path(root, "aircraft", config_.aircraft);
        if (root.has("symbology")) take_path(root, "symbology", config_.symbology);
        config_.palettes = folder_at(root, "palettes", "");
        if (root.has("designs")) config_.designs = folder_at(root, "designs", ".");
        take_named(root.section("switches"), "config", config_.switches);
        take_named(root.section("terrain"), "database", config_.terrain);
        take_named(root.section("scene"), "database", config_.scene);
        take_named(root.section("costs"), "file", config_.costs);
        take_named(root.section("programs"), "folder", config_.programs);
        take_named(root.section("records"), "socket", config_.records);
    }

    /// With its last slash.
    Path folder_at(base::ConfigSection& root, std::string_view key, std::string_view fallback) {
        Path folder = path_beside(reader_.name(), root.text(key, fallback));
        if (!folder.empty() && folder.view().back() != '/') folder.append("/");
        if (folder.cut()) root.fault(key, kPathTooLong);
        return folder;
    }

    /// The path stays empty after a fault.
    void take_path(base::ConfigSection& section, std::string_view key, Path& path) {
        const std::string_view name = section.text(key);
        if (name.empty()) return section.fault(key, "no file is named here; write its path");
        const Path whole = path_beside(reader_.name(), name);
        if (whole.cut()) return section.fault(key, kPathTooLong);
        path = whole;
    }

    void take_named(base::ConfigSection section, std::string_view key, Path& path) {
        if (section.present()) take_path(section, key, path);
    }

    void read_parameters(base::ConfigSection section) {
        if (section.has("tau_px")) config_.parameters.tau_px = section.number("tau_px", 0.001, 1000);
        if (section.has("deadline_ms")) config_.deadline_ms = section.number("deadline_ms", 0.001, 10'000);
        std::array<std::string_view, scene::kMaxFoci> lines;
        const std::size_t count = section.texts("foci", lines);
        for (std::size_t n = 0; n < count && n < lines.size(); ++n) {
            const base::FixedString<1000> line(lines[n]);
            if (line.cut()) section.fault("foci", "a focus is longer than a thousand bytes; leave something out");
            static_cast<void>(config_.parameters.foci.try_push_back(line));
        }
        read_weights(section);
    }

    void read_weights(base::ConfigSection& parameters) {
        base::ConfigSection section = parameters.section("weights");
        for (std::size_t n = 0; section.present() && n < section.key_count(); ++n) {
            const AspectWeight weight{section.key_at(n), section.number(section.key_at(n), 0, 1)};
            if (weight.aspect.cut() || !config_.parameters.weights.try_push_back(weight))
                section.fault(section.key_at(n), "is no aspect of a design, or one of more than 8; remove it");
        }
    }

    void read_can(base::ConfigSection section) {
        bus::SocketCanSettings& can = config_.can;
        const std::string_view name = section.text("interface");
        can.interface_name = base::FixedString<15>(name);
        if (name.empty() || can.interface_name.cut())
            section.fault("interface", "an interface name has 1 to 15 bytes; write it as `ip link` shows it");
        can.can_fd = section.boolean("fd", false);
        can.receive_buffer_bytes =
            static_cast<std::uint32_t>(section.integer("receive_buffer_bytes", 4096, 1 << 28, can.receive_buffer_bytes));
        can.reopen_interval = base::Duration::from_seconds(section.number("reopen_s", 0.1, 60, can.reopen_interval.to_seconds()));
        config_.filters_can = section.boolean("filter", true);
    }

    void read_surface(base::ConfigSection section) {
        std::size_t backend = 0;
        section.choose("backend", kBackends, backend);
        config_.surface.append(kBackends[backend]);
        const auto size = [&section](std::string_view key) {
            return section.has(key) ? static_cast<std::uint32_t>(section.integer(key, kMinSurfacePx, kMaxSurfacePx)) : 0;
        };
        config_.width_px = size("width_px");
        config_.height_px = size("height_px");
        if (section.has("width_px") != section.has("height_px"))
            reader_.root().fault("surface", "has one of width_px and height_px; write both, or none");
    }

    void read_screen(base::ConfigSection& root) {
        base::ConfigSection section = root.section("screen");
        if (!section.present()) return;
        if (config_.surface.view() != "kms")
            return root.fault("screen", "is for backend = \"kms\" of [surface]; set that, or remove this section");
        ScreenSettings& screen = config_.screen;
        take_text(section, "driver", screen.driver);
        take_text(section, "path", screen.path);
        take_text(section, "connector", screen.connector);
        if (!screen.driver.empty() && !screen.path.empty())
            section.fault("path", "the card is named by its driver as well; remove one of the two");
        if (screen.path.view().substr(0, kCardNumber.size()) == kCardNumber)
            section.fault("path",
                          "the numbers of cards change from start to start; name the card by driver, or by /dev/dri/by-path");
        if (!parse_screen_mode(section.text("mode", "preferred"), screen.mode))
            section.fault("mode", "is no mode; write \"1024x768@60\", \"1024x768\" or \"preferred\"");
    }

    template <std::size_t N>
    static void take_text(base::ConfigSection& section, std::string_view key, base::FixedString<N>& text) {
        text.append(section.text(key, ""));
        if (text.cut()) section.fault(key, "the text is too long; use a shorter one");
    }

    base::ConfigReader& reader_;
    DisplayConfig& config_;
};

}  // namespace

void read_display_config(base::ConfigReader& reader, ConfigUse use, DisplayConfig& config) {
    DisplayConfigReader(reader, config).read(use);
}

}  // namespace tedavis::platform
