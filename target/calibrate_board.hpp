/// `tedavis-display --calibrate -o C.toml`: measures on the board what its display costs, and writes the file for [costs] in the
/// board file.
///
/// The same bench and the same writer as those of `tedavis calibrate` measure and write. Bus, panel and costs of the board file
/// are not used.
#pragma once

#include <cstdint>
#include <cstdio>

#include "target/board_clocks.hpp"
#include "target/board_config.hpp"
#include "target/event_log.hpp"
#include "target/stop_signal.hpp"

namespace tedavis::target {

struct CalibrateRequest {
    const char* output = "";   ///< the file to write
    std::uint32_t rounds = 0;  ///< frames with and without each effect
    bool json = false;         ///< the result as one line of JSON
};

/// What it uses of the machine; tests substitute their own.
struct CalibratePorts {
    BoardClocks clocks;
    EventLog log;
};

/// Writes the file, or nothing, and says on `out` what was measured: {"costs", "not_measured" [{"name", "why"}], "measured",
/// "levels" [{"ms", "error_px", "error_color"}]} as JSON. The error is one sentence, also where `stop` was requested.
[[nodiscard]] base::Error calibrate_board(const BoardSettings& settings, const CalibrateRequest& request,
                                          const CalibratePorts& ports, const StopSignal& stop, std::FILE* out);

}  // namespace tedavis::target
