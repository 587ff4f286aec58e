/// What the file of a board (target/boards) says that a flight test can depend on.
#pragma once

#include <string>
#include <vector>

#include "bus/switches/switch_config.hpp"
#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"

namespace tedavis::host_sim {

struct BoardFile {
    std::string path;                           ///< of the configuration, also where a pack was named
    std::string design, device, bus, aircraft;  ///< paths; the last may be empty
    std::string switches, terrain, scene;       ///< paths; empty: none
    std::string interface;                      ///< of the bus
    bool can_fd = false;                        ///< whether that takes CAN FD frames
    DesignFolders design_folders;               ///< of the names in `design`
    double rate_hz = 0;                         ///< of the device
    std::vector<std::string> designs;           ///< names of the design and of those of its phases
    bus::SwitchConfig panel;                    ///< of `switches`
};

/// `named` is what tedavis-display --config reads: a file, or a pack's folder, whose files are then compared with its manifest.
/// Throws UserError with the sentence that tedavis-display would end with.
[[nodiscard]] BoardFile read_board_file(const std::string& named);

/// What a script has that says nothing else.
[[nodiscard]] ScriptDefaults script_defaults(const BoardFile& board);

/// Whether the input has edges of a panel; that of a scenario always has.
[[nodiscard]] bool throws_switches(const FlightTest& test);

/// Why a test is one of another board, such as "names the terrain 'jacksboro', and the board has area.tdb"; empty where it is one
/// of this board. A file that the test names must be the board's, or have the same content; of a panel the names of the lines and
/// the patterns count. A terrain or scene without a path must be the name of the board's file.
[[nodiscard]] std::string misfit_of(const FlightTest& test, const BoardFile& board);

}  // namespace tedavis::host_sim
