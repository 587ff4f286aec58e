/// Checks of numbers on the command line, in place of those of CLI11.
#pragma once

#include <CLI/CLI.hpp>

namespace tedavis::host_sim {

/// Refuses numbers that are not above 0; CLI11's check accepts NaN.
[[nodiscard]] CLI::Validator above_zero();
/// Refuses negative numbers; the message of CLI11's check contains a number of 309 digits.
[[nodiscard]] CLI::Validator from_zero();

}  // namespace tedavis::host_sim
