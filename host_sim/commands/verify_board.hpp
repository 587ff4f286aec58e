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

/// The board of `--target`; nothing on the desk. Throws UserError where --board is missing, or options belong to a board and
/// there is none.
[[nodiscard]] std::optional<BoardFile> stated_board(const std::string& target, const std::string& board,
                                                    const std::string& others);

struct BoardTests {
    const VerifyOptions& options;
    const BoardFile& board;
    std::string folder;  ///< for logs
    std::function<bool()> is_interrupted;
};

/// One after the other. A test of another board is left out where a folder has it; one that was named itself is refused, before
/// anything is flown. Throws UserError and Interrupted.
[[nodiscard]] std::vector<FlownTest> fly_tests_on_board(std::vector<FlightTest>& tests, const BoardTests& settings,
                                                        Console& console);

}  // namespace tedavis::host_sim
