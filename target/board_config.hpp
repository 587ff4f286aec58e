/// The board file of `tedavis-display --config`: the device, design, bus, switches and databases of one board.
///
///     title = "..."              shown at start
///     device = "es3-mid.toml"    files that the board file names are found from the board file's own folder
///     design = "default.toml"
///     palettes = "palettes"      folder of the palettes that the design names; absent: the board file's own
///                                (designs that it names for phases, or is based on, lie beside it)
///     bus = "canaerospace.toml"
///     aircraft = "own.toml"      speeds and eye point; absent: none are known
///     light = "day"              or "night": colors of the symbology
///     symbology = "own.toml"     palette of the symbology; absent: the standard one
///     [terrain]                  absent: no terrain, the display says so
///     database = "area.tdb"
///     [scene]                    absent: no spatial data
///     database = "area.sdb"      may be missing at first; a newer revision at its place is taken over in flight
///     [costs]                    absent: none are known, and the device's deadline_ms is not held
///     file = "es2-small.costs.toml"   that --calibrate wrote on this board
///     [programs]                 absent: none; a device without a compiler then does not start
///     folder = "sc2.programs"    that `--write-shaders` wrote on this board
///     [can]
///     interface = "can0"
///     fd = false                 also receive CAN FD frames
///     filter = true              let the kernel drop identifiers that the display does not know
///     receive_buffer_bytes = 1048576
///     reopen_s = 1.0             at most one attempt in this time to open a bus that is missing
///     [switches]                 absent: no panel, the phase comes from bus and motion
///     config = "one_hot.toml"
///     [surface]
///     backend = "egl"            off-screen; "kms": on a screen that the kernel drives, without a window system;
///                                or "osmesa", where it was built
///     width_px = 1024            absent: the device file's; with "kms" it must be the size of the screen's mode
///     height_px = 768
///     [screen]                   only with "kms"
///     driver = "virtio_gpu"      of the graphics card; absent: the first card with a connected screen
///     path = "/dev/dri/by-path/platform-gpu-card"   in place of the driver
///     connector = "HDMI-A-1"     absent: the first that is connected
///     mode = "1024x768@60"       or "1024x768"; "preferred": what the screen itself prefers, also when absent
///     [records]                  absent: none are handed out
///     socket = "/run/tedavis/records"   at which local programs read the record of each frame
///     [display]
///     legend = "key"             or "none", "whole": where neither the panel nor the bus asks for another
///     [memory]
///     touch = true               take all pages at start, so that no page fault comes in flight
///
/// Memory  reading allocates (start-up only); the settings are plain data.
/// Failure  one sentence with file and line.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/socketcan/can_socket_port.hpp"
#include "bus/switches/switch_config.hpp"
#include "platform/egl_kms/screen_settings.hpp"
#include "platform/reservation/memory_reservation.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/result.hpp"
#include "render_core/design/aircraft_settings.hpp"
#include "render_core/design/phase_designs.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/flight/legend_show.hpp"

namespace tedavis::target {

using Path = base::FixedString<1023>;

struct BoardSettings {
    base::FixedString<95> title;
    effects::DeviceSettings device;
    design::DesignSettings design;
    design::PhaseDesigns phases;
    bus::BusSettings bus;
    design::AircraftSettings aircraft;  ///< none without the key
    design::SymbologyPalettes symbology = design::standard_symbology_palettes();
    design::SymbologyLight light = design::SymbologyLight::day;
    bus::SocketCanSettings can;
    bool has_switches = false;
    bus::SwitchConfig switches;
    Path terrain;   ///< empty: none
    Path scene;     ///< the same
    Path costs;     ///< the same
    Path programs;  ///< the same
    base::FixedString<15> surface;
    platform::ScreenSettings screen;  ///< of the surface "kms"
    Path records;                     ///< socket for the records of frames; empty: none
    std::uint32_t width_px = 0, height_px = 0;
    flight::LegendShow legend = flight::LegendShow::key;
    platform::Residency residency = platform::Residency::touched;
};
static_assert(std::is_trivially_copyable_v<BoardSettings>);

/// Reads the board file and all files that it names; of the terrain and scene databases it only keeps the paths.
[[nodiscard]] base::Result<BoardSettings, base::Error> load_board_settings(const char* path);

/// Returns the path of `name` relative to the folder of `board_file`; an absolute name is returned unchanged. cut() is true
/// where the path exceeds the capacity of Path.
[[nodiscard]] Path path_beside(std::string_view board_file, std::string_view name);

/// Adds filters that pass the identifiers that the decoder knows, the messages of phase and legend, and identification requests.
/// When they do not fit, no filters are set and all frames pass.
void add_bus_filters(bus::SocketCanSettings& can, const bus::BusSettings& bus);

}  // namespace tedavis::target
