/// The input of a flight test as the logs that a replay reads.
#pragma once

#include <string>

#include "host_sim/flight_test/judge_expectation.hpp"
#include "host_sim/replay/flight_player.hpp"

namespace tedavis::host_sim {

/// The message of an interrupted test.
inline constexpr const char* kTestInterrupted = "interrupted; a flight test that was not flown to its end has not passed";

/// Returns the logs that the test names, or writes those of its steps to `folder`. Throws UserError.
[[nodiscard]] PlayerFiles test_input_files(const FlightTest& test, const std::string& folder);

/// Checks the expectations against the end of the input, which for recorded and generated flights only the log states. Throws
/// UserError with one line for each expectation that is beyond the end or, where the device has a fixed rate, has no frame in its
/// window.
void require_within_input(const FlightTest& test, double end_s, const FrameTimes& times);

}  // namespace tedavis::host_sim
