/// Whether a board's set-up holds: what the start would refuse, and what it would show as failed.
///
/// Reads every byte of the terrain and scene databases that the board file names, and starts the display as the program does, on
/// the board's own surface, without bus and panel. Each thing is a check of its own, with one sentence for a fault:
///
///     board_terrain   every checksum, entry and vertex       board_scene     every checksum, and room for it on the device
///     board_surface   as the board file asks for it          board_display   the device's budgets with design and terrain
///     board_costs     are this board's                       board_programs  the folder is there
///
/// Files that the board file does not name have no check; what needs a surface or a display has none where there is none.
///
/// Thread  one; makes and releases a surface. Memory  the reservation of the device, and a page of terrain.
#pragma once

#include "target/board_config.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

void check_board(const BoardSettings& settings, SelfTestReport& report);

}  // namespace tedavis::target
