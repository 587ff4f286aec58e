/// The one configuration file of desk and board: what `tedavis replay --config` and `tedavis-display --config` read.
/// "both": desk and board use it. "board": the desk reads it, so that its faults are found, and does not use it.
///
///     title = "..."              both, as all keys up to [terrain]; shown at start
///     device = "es3-mid.toml"    files that the file names are found from its own folder
///     design = "default.toml"
///     designs = "designs"        folder of the designs that a design names by a short name, for phases or as its base; absent:
///                                they lie beside the design that names them
///     palettes = "palettes"      folder of the palettes that designs name by short names; absent: this file's own
///     bus = "canaerospace.toml"
///     aircraft = "own.toml"      speeds and eye point; absent: none are known
///     light = "day"              or "night": colors of the symbology
///     symbology = "own.toml"     palette of the symbology; absent: the standard one
///     [terrain]                  both; absent: no terrain, the display says so
///     database = "area.tdb"
///     [scene]                    both; absent: no spatial data
///     database = "area.sdb"      on a board it may be missing at first; a newer revision at its place is taken over in flight
///     [costs]                    both; absent: none are known, and the device's deadline_ms is not held
///     file = "es2-small.costs.toml"   that --calibrate wrote on this board
///     [programs]                 board; absent: none; a device without a compiler then does not start
///     folder = "sc2.programs"    that `--write-shaders` wrote on this board
///     [parameters]               both; above the designs
///     tau_px = 1.0               terrain error in pixels; absent: the design's
///     deadline_ms = 25.0         that a frame may take by [costs]; absent: the device's on a board, none on the desk
///     foci = ["shape = ..."]     before the design's: the keys of [[focus]] within one line each
///     [parameters.weights]       both
///     terrain = 0.3              0 to 1, of any aspect; absent: the design's
///     [can]                      board, which does not start without it
///     interface = "can0"
///     fd = false                 also receive CAN FD frames
///     filter = true              let the kernel drop identifiers that the display does not know
///     receive_buffer_bytes = 1048576
///     reopen_s = 1.0             at most one attempt in this time to open a bus that is missing
///     [switches]                 both; absent: no panel, the phase comes from bus and motion
///     config = "one_hot.toml"
///     [surface]                  board; its size: both
///     backend = "egl"            off-screen; "kms": on a screen that the kernel drives, without a window system;
///                                or "osmesa", where it was built
///     width_px = 1024            both of them or none; absent: the device file's; with "kms" it must be the size of the screen's
///                                mode
///     height_px = 768
///     [screen]                   board; only with "kms"
///     driver = "virtio_gpu"      of the graphics card; absent: the first card with a connected screen
///     path = "/dev/dri/by-path/platform-gpu-card"   in place of the driver
///     connector = "HDMI-A-1"     absent: the first that is connected
///     mode = "1024x768@60"       or "1024x768"; "preferred": what the screen itself prefers, also when absent
///     [records]                  board; absent: none are handed out
///     socket = "/run/tedavis/records"   at which local programs read the record of each frame
///     [display]                  both
///     legend = "key"             or "none", "whole": where neither the panel nor the bus asks for another
///     [memory]                   board
///     touch = true               take all pages at start, so that no page fault comes in flight
///     [replay]                   desk (host_sim/options/replay_config.hpp); a board leaves it alone
///
/// Memory  plain data. Failure  kept by the reader, as one sentence with file and line.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "bus/socketcan/can_socket_port.hpp"
#include "platform/configuration/config_path.hpp"
#include "platform/configuration/design_parameters.hpp"
#include "platform/egl_kms/screen_settings.hpp"
#include "platform/reservation/memory_reservation.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/flight/legend_show.hpp"

namespace tedavis::platform {

/// Paths are those behind the names: from the folder of the file. An empty one: the file names none.
struct DisplayConfig {
    base::FixedString<95> title;
    Path device, design, bus, aircraft, symbology;
    Path palettes;  ///< ends in a slash, or is empty: the working folder
    Path designs;   ///< ends in a slash; empty: none is named
    design::SymbologyLight light = design::SymbologyLight::day;
    Path terrain, scene, costs;
    Path programs;  ///< folder
    DesignParameters parameters;
    std::optional<double> deadline_ms;
    bool has_can = false;
    bus::SocketCanSettings can;  ///< without filters
    bool filters_can = true;
    Path switches;
    base::FixedString<15> surface;
    std::uint32_t width_px = 0, height_px = 0;  ///< 0: the device's
    ScreenSettings screen;
    Path records;
    flight::LegendShow legend = flight::LegendShow::key;
    Residency residency = Residency::touched;
};
static_assert(std::is_trivially_copyable_v<DisplayConfig>);

enum class ConfigUse : std::uint8_t {
    board,  ///< needs [can] and leaves [replay] alone
    desk    ///< needs no [can]; whoever called reads [replay]
};

/// Reads all keys of the file, named as the reader is; faults are the reader's. Does not call finish(): the caller may have
/// further faults to report at the keys.
void read_display_config(base::ConfigReader& reader, ConfigUse use, DisplayConfig& config);

}  // namespace tedavis::platform
