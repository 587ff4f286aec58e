/// The keys of a board's configuration file (target/boards) that a flight test can depend on.
#pragma once

#include <string>
#include <vector>

#include "bus/switches/switch_config.hpp"
#include "host_sim/flight_test/flight_test.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"

namespace tedavis::host_sim {

struct BoardFile {
    std::string path;                           ///< of the configuration file; of a pack, of the file in it
    std::string design, device, bus, aircraft;  ///< paths; `aircraft` may be empty
    std::string switches, terrain, scene;       ///< paths; empty: none
    std::string interface;                      ///< of the bus
    bool can_fd = false;                        ///< whether the interface takes CAN FD frames
    DesignFolders design_folders;               ///< of the names in `design`
    double rate_hz = 0;                         ///< of the device
    std::vector<std::string> designs;           ///< names of the design and of the designs of its phases
    bus::SwitchConfig panel;                    ///< of `switches`
};

/// `named` is a configuration file, or a pack's folder, whose files are then compared with its manifest, as for tedavis-display
/// --config. Throws UserError with the message with which tedavis-display would end.
[[nodiscard]] BoardFile read_board_file(const std::string& named);

/// Defaults of a script that is flown on this board.
[[nodiscard]] ScriptDefaults script_defaults(const BoardFile& board);

/// Whether the test's input has edges of the panel's lines; the input of a scenario always has.
[[nodiscard]] bool throws_switches(const FlightTest& test);

/// Returns why a test cannot be flown on this board, such as "names the terrain 'jacksboro', and the board has area.tdb"; empty
/// where it can. A file that the test names must be the board's, or have the same content; panels are equal if the names of their
/// lines and their patterns are. A terrain or scene that is named without a path must have the name of the board's file.
[[nodiscard]] std::string misfit_of(const FlightTest& test, const BoardFile& board);

}  // namespace tedavis::host_sim
