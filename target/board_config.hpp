/// The board file of `tedavis-display --config`: the device, design, bus, switches and databases of one board.
/// What stands in it: platform/configuration/display_config.hpp. In its place may stand a pack, which is checked whole.
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
#include "platform/configuration/config_path.hpp"
#include "platform/configuration/pack_check.hpp"
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

using platform::Path;
using platform::path_beside;

struct BoardSettings {
    platform::CheckedPack pack;  ///< that the board file is of; is_pack() is false where it is of none
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

/// Reads the board file and all files that it names; of the terrain and scene databases it only keeps the paths. `path` may be a
/// pack (platform/configuration/pack_check.hpp), which must be as its manifest says and, where there is a file `pack_key`, signed
/// with that key. may_pass of the error: the pack changed meanwhile.
[[nodiscard]] base::Result<BoardSettings, platform::ConfigError> load_board_settings(
    const char* path, const char* pack_key = platform::kInstalledPackKey);

/// Adds filters that pass the identifiers that the decoder knows, the messages of phase and legend, and identification requests.
/// When they do not fit, no filters are set and all frames pass.
void add_bus_filters(bus::SocketCanSettings& can, const bus::BusSettings& bus);

}  // namespace tedavis::target
