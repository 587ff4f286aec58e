#include "target/board_display.hpp"

#include <memory>

#include "platform/egl_kms/egl_kms_surface.hpp"
#include "platform/files/file_text.hpp"

namespace tedavis::target {
namespace {

base::Error message_of(const platform::HostFault& fault, const BoardSettings& settings) {
    const std::string_view message = fault.error.message.view();
    switch (fault.part) {
        case platform::HostPart::surface:
        case platform::HostPart::context: return base::make_error("[surface]: ", message);
        case platform::HostPart::display: return base::make_error("device '", settings.device.name.view(), "': ", message);
        default: return fault.error;
    }
}

base::Result<std::unique_ptr<base::Surface>, base::Error> make_screen(const void* screen,
                                                                      const platform::SurfaceSettings& settings) {
    return platform::make_egl_kms_surface(settings, *static_cast<const platform::ScreenSettings*>(screen));
}

}  // namespace

platform::DisplayHostSettings board_host_settings(const BoardSettings& settings, base::Time utc) {
    platform::DisplayHostSettings of_host;
    of_host.display.device = settings.device;
    of_host.display.design = settings.design;
    of_host.display.phases = &settings.phases;
    of_host.display.aircraft = settings.aircraft;
    of_host.display.symbology = settings.symbology;
    of_host.display.light = settings.light;
    of_host.display.legend = settings.legend;
    of_host.display.database_dates = policy::dates_at_start(platform::valid_period(settings.pack), utc);
    of_host.display.width_px = settings.width_px;
    of_host.display.height_px = settings.height_px;
    of_host.display.expects_scene = !settings.scene.empty();
    of_host.surface.backend = settings.surface.view();
    if (is_on_screen(settings)) {
        of_host.surface.make = &make_screen;
        of_host.surface.self = &settings.screen;
    }
    of_host.terrain.path = settings.terrain.c_str();
    of_host.terrain_fault = platform::TerrainFaultPolicy::run_without;
    of_host.arrival = terrain::ArrivalMode::live;
    of_host.programs = settings.programs.view();
    of_host.residency = settings.residency;
    return of_host;
}

platform::DisplayHostSettings off_screen_host_settings(const BoardSettings& settings) {
    platform::DisplayHostSettings of_host = board_host_settings(settings);
    if (is_on_screen(settings)) of_host.surface = {};
    return of_host;
}

platform::HostFault start_board_host(const BoardSettings& settings, const platform::DisplayHostSettings& of_host,
                                     platform::DisplayHost& host) {
    const platform::HostFault fault = host.start(of_host);
    return {fault.part, message_of(fault, settings)};
}

platform::HostFault start_board_display(const BoardSettings& settings, platform::DisplayHost& host, base::Time utc) {
    return start_board_host(settings, board_host_settings(settings, utc), host);
}

base::Error hold_board_deadline(const BoardSettings& settings, platform::DisplayHost& host) {
    if (settings.costs.empty()) return host.hold_deadline(settings.device.deadline_ms, {});
    const auto text = platform::read_file_text(settings.costs.c_str());
    if (!text.ok()) return text.error();
    return host.hold_deadline(settings.device.deadline_ms, {settings.costs.view(), text.value().view()});
}

}  // namespace tedavis::target
