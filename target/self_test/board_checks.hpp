/// Checks a board's set-up: faults that the start would refuse, and those that the display would show as failed.
///
/// Reads every byte of the terrain and scene databases that the board file names, and starts the display as the program does,
/// on the board's own surface, without bus and panel. Each of these is one check, with one sentence for a fault:
///
///     board_terrain   every checksum, entry and vertex       board_scene     every checksum, and room for it on the device
///     board_surface   as the board file requests it          board_display   the device's budgets with design and terrain
///     board_costs     are this board's                       board_programs  the folder is there
///
/// With BoardReading::headers the databases are opened as the start opens them, and no more of them is read: that is fast.
///
/// Files that the board file does not name have no check, nor has what needs a surface or a display where that failed.
///
/// Thread  one; makes and releases a surface. Memory  the device's reservation and one page of terrain.
#pragma once

#include "target/board_config.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

enum class BoardReading : std::uint8_t { every_byte, headers };

struct BoardCheckSettings {
    BoardReading reading = BoardReading::every_byte;
    bool is_off_screen = false;  ///< draws off-screen where the board's surface is a screen
};

void check_board(const BoardSettings& settings, SelfTestReport& report, const BoardCheckSettings& how = {});

}  // namespace tedavis::target
