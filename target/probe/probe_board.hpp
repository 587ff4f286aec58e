/// `tedavis-display --probe --config BOARD.toml`: why a board does not work on this machine, each fault in one sentence with the
/// remedy, in the words of the start.
///
///     screen      of backend "kms": the card, its driver, the connector and the mode are there, and no other program has them
///     card, connector   what was found there, for reading only
///     can         the interface is there, up, and takes part in the bus
///     switches    each line of the panel is there and free; one check a fault, and one that says how many lines serve
///     board_*     as --self-test checks them (self_test/board_checks.hpp), but of the databases only what the start reads
///
/// May be run beside the display that it asks about: what that one holds is said to be held, and the display is then tried
/// off-screen.
///
/// Thread  one; makes and releases a surface. Memory  the device's reservation. Failure  a check in the report.
#pragma once

#include "target/board_config.hpp"
#include "target/probe/probe_ports.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

void probe_board(const BoardSettings& settings, const ProbePorts& ports, SelfTestReport& report);

/// The parts of it that ask the machine and draw nothing. True where the screen serves.
[[nodiscard]] bool probe_screen(const BoardSettings& settings, const ProbePorts& ports, SelfTestReport& report);
void probe_can(const BoardSettings& settings, const ProbePorts& ports, SelfTestReport& report);
void probe_switches(const BoardSettings& settings, const ProbePorts& ports, SelfTestReport& report);

}  // namespace tedavis::target
