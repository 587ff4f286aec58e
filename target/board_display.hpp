/// The display of a board, started from the board's settings. The program and its self-test start it by the same functions.
///
/// Terrain that cannot be opened (no file, not readable, damaged) does not prevent the start: the display runs without it and
/// shows TERRAIN FAIL, and the host's terrain_fault() gives the reason.
#pragma once

#include "platform/runtime/display_host.hpp"
#include "target/board_config.hpp"

namespace tedavis::target {

/// Whether the board's surface is a screen, and not memory.
[[nodiscard]] inline bool is_on_screen(const BoardSettings& settings) { return settings.surface.view() == "kms"; }

/// What a host is started with as the board file asks for it. The board's settings must outlive it. `utc` of the board's clock:
/// whether a pack is out of date is judged by it until the bus states UTC; by default the clock was never set.
[[nodiscard]] platform::DisplayHostSettings board_host_settings(const BoardSettings& settings, base::Time utc = {});
/// The same, drawn into headless EGL where the board's surface is a screen: several such hosts may be open at a time, and no
/// frame waits for the screen.
[[nodiscard]] platform::DisplayHostSettings off_screen_host_settings(const BoardSettings& settings);
/// Starts a host with these settings, or changed ones. The error names the part of the board file.
[[nodiscard]] platform::HostFault start_board_host(const BoardSettings& settings, const platform::DisplayHostSettings& of_host,
                                                   platform::DisplayHost& host);
/// Starts a host with what the board file asks for; `utc` as above. The error names the part of the board file.
[[nodiscard]] platform::HostFault start_board_display(const BoardSettings& settings, platform::DisplayHost& host,
                                                      base::Time utc = {});

/// Applies the costs that the board file names, if any, so that the device's deadline is held.
[[nodiscard]] base::Error hold_board_deadline(const BoardSettings& settings, platform::DisplayHost& host);

}  // namespace tedavis::target
