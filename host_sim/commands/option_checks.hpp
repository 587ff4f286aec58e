/// Checks of numbers on the command line that CLI11 does not make as well.
#pragma once

#include <CLI/CLI.hpp>

namespace tedavis::host_sim {

/// CLI11's own check lets NaN pass.
[[nodiscard]] CLI::Validator above_zero();
/// CLI11's own check names a largest number of 309 digits.
[[nodiscard]] CLI::Validator from_zero();

}  // namespace tedavis::host_sim
