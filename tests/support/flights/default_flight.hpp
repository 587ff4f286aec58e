/// The default flight as `scenario build default` writes it, and a display that flies it over its terrain without a screen.
#pragma once

#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/flight_log/flight_log_writer.hpp"
#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/scenario/scenario_switches.hpp"
#include "platform/runtime/display_host.hpp"
#include "platform/surface_factory.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/kept_reservation.hpp"
#include "tests/support/files/memory_bytes.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/flights/sent_traffic.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::test_support {

struct RecordedFlight {
    std::string log;
    std::string switch_log;
    bus::SwitchConfig panel;
};

inline bus::SwitchConfig shipped_panel(const std::string& name) {
    const std::string path = "configs/switches/" + name + ".toml";
    return bus::load_switch_config(source_file(path), path).value();
}

inline RecordedFlight default_flight() {
    const std::string path = "configs/scenarios/default.toml";
    const host_sim::Scenario scenario = host_sim::parse_scenario(source_file(path), path);
    const host_sim::GeoidEgm96 geoid = host_sim::GeoidEgm96::installed();
    const host_sim::ScenarioFlight flight(scenario, scenario.seed, geoid);
    std::ostringstream log;
    host_sim::FlightLogSettings settings;
    settings.bus = traffic_bus();
    host_sim::write_flight_log(flight, settings, log, [](double) { return true; });
    const bus::SwitchConfig panel = shipped_panel(scenario.switch_config);
    return {log.str(), host_sim::scenario_switch_log(scenario, flight, panel), panel};
}

/// A candump or switch log again, `seconds` later. Stamps of ten digits before the point, as until the year 2286.
inline std::string seconds_later(std::string log, std::int64_t seconds) {
    constexpr std::size_t kDigits = 10;
    for (std::size_t at = 0; at < log.size(); at = log.find('\n', at) + 1) {
        if (log[at] == '(') {
            const std::int64_t stamp = std::stoll(log.substr(at + 1, kDigits)) + seconds;
            log.replace(at + 1, kDigits, std::to_string(stamp));
        }
        if (log.find('\n', at) == std::string::npos) break;
    }
    return log;
}

/// The database of the default flight's terrain, in memory.
struct DefaultTerrain {
    std::vector<std::uint8_t> image = build();
    MemoryBytes bytes{image};

    DefaultTerrain() = default;
    DefaultTerrain(const DefaultTerrain&) = delete;
    DefaultTerrain& operator=(const DefaultTerrain&) = delete;

private:
    static std::vector<std::uint8_t> build() {
        const std::string raster = test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif";
        host_sim::BuildOptions options;
        options.le90_m = 16;
        return build_image_of_file(raster, options);
    }
};

using SurfaceWrapper = std::unique_ptr<base::Surface> (*)(std::unique_ptr<base::Surface>);
inline std::unique_ptr<base::Surface> as_it_is(std::unique_ptr<base::Surface> surface) { return surface; }

/// A started display; throws what start() says. `terrain` must outlive it and may be null; so may `scene`, which is read at once.
class HeadlessDisplay {
public:
    HeadlessDisplay(const std::string& backend, const std::string& device, std::uint32_t width, std::uint32_t height,
                    base::ByteSource* terrain)
        : HeadlessDisplay(backend, device, width, height, terrain, shipped_design("default")) {}
    HeadlessDisplay(const std::string& backend, const std::string& device, std::uint32_t width, std::uint32_t height,
                    base::ByteSource* terrain, const design::DesignSettings& design, SurfaceWrapper wrap = as_it_is,
                    base::ByteSource* scene = nullptr)
        : HeadlessDisplay(backend, shipped_device(device), width, height, terrain, design, wrap, scene) {}
    HeadlessDisplay(const std::string& backend, const effects::DeviceSettings& device, std::uint32_t width, std::uint32_t height,
                    base::ByteSource* terrain, const design::DesignSettings& design, SurfaceWrapper wrap = as_it_is,
                    base::ByteSource* scene = nullptr, const design::PhaseDesigns* phases = nullptr,
                    base::Workers* workers = nullptr)
        : backend_(backend), wrap_(wrap), memory_(display::DisplayMemory::bytes_needed(device.budget)) {
        platform::DisplayHostSettings settings;
        settings.display.device = device;
        settings.display.design = design;
        settings.display.phases = phases;
        settings.display.width_px = width;
        settings.display.height_px = height;
        settings.display.generated_flight = true;
        settings.display.legend = flight::LegendShow::whole;
        settings.surface = {backend, &HeadlessDisplay::make_surface, this};
        settings.terrain.bytes = terrain;
        settings.scene.bytes = scene;
        settings.workers = workers != nullptr ? workers : &serial_;
        settings.memory = memory_.arena();
        if (const platform::HostFault fault = host_.start(settings)) throw std::runtime_error(fault.error.message.c_str());
    }

    [[nodiscard]] display::Display& display() { return host_.display(); }
    [[nodiscard]] base::Surface& surface() { return host_.surface(); }
    /// Displays of one thread draw in turn.
    [[nodiscard]] bool make_current() { return host_.make_current(); }

private:
    static base::Result<std::unique_ptr<base::Surface>, base::Error> make_surface(const void* self,
                                                                                  const platform::SurfaceSettings& settings) {
        const auto& display = *static_cast<const HeadlessDisplay*>(self);
        auto made = platform::make_surface(display.backend_, settings);
        if (!made.ok()) return base::fail(made.error());
        return display.wrap_(std::move(made.value()));
    }

    std::string backend_;
    SurfaceWrapper wrap_;
    KeptReservation memory_;
    base::SerialWorkers serial_;
    platform::DisplayHost host_;
};

}  // namespace tedavis::test_support
