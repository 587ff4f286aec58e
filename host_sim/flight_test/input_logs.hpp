/// What a flight test is fed with, as the logs that a replay reads.
#pragma once

#include <string>

#include "host_sim/flight_test/judge_expectation.hpp"
#include "host_sim/replay/flight_player.hpp"

namespace tedavis::host_sim {

/// What a test says that ends early.
inline constexpr const char* kTestInterrupted = "interrupted; a flight test that was not flown to its end has not passed";

/// The logs of a test with steps, which are written to `folder`, or those that it names. Throws UserError.
[[nodiscard]] PlayerFiles test_input_files(const FlightTest& test, const std::string& folder);

/// Of recorded and generated flights, whose length only the log knows. Throws UserError, a line an expectation beyond the end, or
/// in whose time a device that keeps its rate has no frame.
void require_within_input(const FlightTest& test, double end_s, const FrameTimes& times);

}  // namespace tedavis::host_sim
