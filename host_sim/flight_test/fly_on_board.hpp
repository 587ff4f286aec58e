/// Flies a test against a running display: its input goes onto the bus and the panel in real time, and what the display says of
/// each frame is judged as on the desk.
///
/// A test begins with a silent bus and a panel at rest, until the display knows of nothing any more: kSilence, which is the three
/// seconds after which a phase on the bus is out of date, the ten for which the last phase is held, and one more. Signals that
/// stay known for longer, such as the wind (30 s), are waited for where the test asks for them. One that is known even then, such
/// as the magnetic variation (600 s), may be of an earlier test: what asks for it is not judged.
///
/// Time 0 is the instant of the first frame of the input. Frames and edges go out in the order of their times, each within 5 ms
/// after its own on a machine that has time for it; one that is kLongestDelay late ends the test. A frame of the display has the
/// time for which it was planned. Behind the test the panel is put to rest, also where the test does not get to its end.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host_sim/flight_test/board_port.hpp"
#include "host_sim/flight_test/fly_flight_test.hpp"

namespace tedavis::host_sim {

inline constexpr base::Duration kSilence = base::Duration::seconds(14);
/// The state must be neutral so much later at the latest.
inline constexpr base::Duration kLongestUnrest = base::Duration::seconds(18);
/// An input that is sent later than this is another one than the test states.
inline constexpr base::Duration kLongestDelay = base::Duration::milliseconds(250);

struct BoardFlightSettings {
    std::string display;               ///< its socket, for sentences
    std::string folder;                ///< for the logs of steps
    double rate_hz = 0;                ///< of the board's device, in whose frames latencies are counted
    std::vector<std::string> designs;  ///< names of the board's; empty: not known
    std::function<bool()> is_interrupted;
    std::function<void(double done_s, double total_s)> told;  ///< may be empty
};

/// Conditions that the display's record cannot answer are not judged, and counted (ExpectationResult), and neither is what must
/// be reached where one of its conditions is such. Throws UserError where the input cannot be sent as it is, records are missing,
/// or a frame is not on the screen; BoardLost where the display is gone; and Interrupted.
[[nodiscard]] FlightTestResult fly_on_board(const FlightTest& test, BoardPort& port, const BoardFlightSettings& settings);

}  // namespace tedavis::host_sim
