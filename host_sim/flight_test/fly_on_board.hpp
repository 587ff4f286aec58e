/// Flies a test against a running display: its input is sent to the bus and the panel in real time, and the display's record of
/// each frame is judged as on the desk.
///
/// A test begins with a silent bus and a panel at rest until the display has no valid input left. This takes kSilence: three
/// seconds until a phase on the bus is lost, ten for which the last phase is held, and one more. Signals that stay valid for
/// longer, such as the wind (30 s), are waited for if the test expects them. A signal that is valid even then, such as the
/// magnetic variation (600 s), may come from an earlier test, so conditions on it are not judged.
///
/// Time 0 is the time of the first frame of the input. Frames and edges are sent in the order of their times, each within 5 ms
/// after its time on a machine that is not overloaded; a delay above kLongestDelay ends the test. A frame of the display has the
/// time for which it was planned. The panel is put to rest after the test, also after an error.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host_sim/flight_test/board_port.hpp"
#include "host_sim/flight_test/fly_flight_test.hpp"

namespace tedavis::host_sim {

inline constexpr base::Duration kSilence = base::Duration::seconds(14);
/// Longest wait after kSilence for a display without valid input; then the test ends with an error.
inline constexpr base::Duration kLongestUnrest = base::Duration::seconds(18);
/// Longest delay of a sent frame or edge; an input that is later is not the one that the test states.
inline constexpr base::Duration kLongestDelay = base::Duration::milliseconds(250);

struct BoardFlightSettings {
    std::string display;               ///< its socket, for sentences
    std::string folder;                ///< for the logs of steps
    double rate_hz = 0;                ///< frame rate of the board's device, in whose periods latencies are counted
    std::vector<std::string> designs;  ///< names of the board's designs; empty: not known
    std::function<bool()> is_interrupted;
    std::function<void(double done_s, double total_s)> told;  ///< may be empty
};

/// Flies a test. Conditions that the display's records cannot answer are not judged but counted (ExpectationResult); an
/// expectation of WindowKind::within with such a condition is not judged at all. Throws UserError where the input cannot be sent
/// as it is, records are missing, or a frame is not on the screen; BoardLost where the display is gone; and Interrupted.
[[nodiscard]] FlightTestResult fly_on_board(const FlightTest& test, BoardPort& port, const BoardFlightSettings& settings);

}  // namespace tedavis::host_sim
