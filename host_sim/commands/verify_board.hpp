/// `tedavis verify … --target SOCKET`: flies flight tests against a running display on this machine.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/commands/verify.hpp"
#include "host_sim/flight_test/board_file.hpp"
#include "host_sim/flight_test/flight_test_report.hpp"

namespace tedavis::host_sim {

/// Returns the board of `--target`; nothing on the desk. Throws UserError where --board is missing, or where options for a board
/// (`others`) are given without one.
[[nodiscard]] std::optional<BoardFile> stated_board(const std::string& target, const std::string& board,
                                                    const std::string& others);

struct BoardTests {
    const VerifyOptions& options;
    const BoardFile& board;
    std::string folder;  ///< for logs
    std::function<bool()> is_interrupted;
};

/// Flies the tests one after the other. A test for another board is left out if it was found in a folder; if it was named itself,
/// UserError is thrown before any test is flown. What Ctrl-C ended has the fault kTestInterrupted. Throws UserError, also where
/// no test is for this board.
[[nodiscard]] std::vector<FlownTest> fly_tests_on_board(std::vector<FlightTest>& tests, const BoardTests& settings,
                                                        Console& console);

}  // namespace tedavis::host_sim
