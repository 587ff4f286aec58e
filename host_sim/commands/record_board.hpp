/// `tedavis record --target SOCKET --board BOARD.toml [--interface can0] [--for S] -o SCRIPT.toml`: a flight test from a running
/// display, with what its bus said as a candump log beside the script.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "host_sim/commands/record_input.hpp"
#include "host_sim/console.hpp"
#include "host_sim/flight_test/board_file.hpp"
#include "host_sim/flight_test/board_port.hpp"
#include "host_sim/flight_test/recorded_facts.hpp"

namespace tedavis::host_sim {

/// Time at the begin of a recording that is skipped, since the display then still shows what was sent before, s.
inline constexpr double kBoardLeadIn_s = 5;

/// "a/b.log" of "a/b.toml".
[[nodiscard]] std::string log_beside(const std::string& script);

/// Returns the test that plays the log on a desk with the board's files. Throws UserError where options are missing or exclude
/// each other.
[[nodiscard]] FlightTest board_input(const RecordOptions& options, const BoardFile& board);

/// Records for options.for_s and writes the bus frames to `log`. Returns the number of display frames that `tracks` took. Throws
/// UserError, BoardLost and Interrupted.
[[nodiscard]] std::uint64_t record_board(BoardPort& port, const RecordOptions& options, std::ostream& log, FactTracks& tracks,
                                         Console& console);

/// The same with a display on this machine (live_board.hpp).
[[nodiscard]] std::uint64_t record_live_board(const RecordOptions& options, const BoardFile& board, std::ostream& log,
                                              FactTracks& tracks, Console& console);

}  // namespace tedavis::host_sim
