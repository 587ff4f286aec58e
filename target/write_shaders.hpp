/// `tedavis-display --write-shaders DIR`: makes the programs of a board whose device has no shader compiler, on the board itself,
/// since only the driver that linked a program can load it. `tedavis shaders` does the same on a desk with that driver.
///
/// Thread  one; makes and releases an off-screen surface. Failure  one sentence, and nothing is left of the folder; so it is
/// after a signal.
#pragma once

#include <cstdio>

#include "target/board_config.hpp"
#include "target/stop_signal.hpp"

namespace tedavis::target {

/// Starts the board's display with a compiler, and writes what it has linked to the new folder `path`. Prints one line, or one
/// of JSON {"programs", "count", "device"}.
[[nodiscard]] base::Error write_shaders(const BoardSettings& settings, const char* path, const StopSignal& stop, bool json,
                                        std::FILE* out);

}  // namespace tedavis::target
