/// Flies a test on the desk: the replay's player plays its input, frames at the device's rate are planned where an expectation
/// needs them, and only the frame of the first failure is drawn.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/flight_test/judge_expectation.hpp"
#include "host_sim/replay/display_session.hpp"

namespace tedavis::host_sim {

struct FlightTestResult {
    std::vector<ExpectationResult> expectations;  ///< in the order of FlightTest::expectations
    std::uint64_t frames = 0;                     ///< number of frames that were planned
    std::string picture, record;                  ///< of the frame of the first failure: PNG bytes, and its record as JSON
    double shown_s = 0;                           ///< time of that frame
    std::size_t shown = 0;                        ///< index of the expectation that fails in it

    [[nodiscard]] std::size_t held() const;
    [[nodiscard]] std::size_t failed() const;
    /// Whether at least one expectation was judged.
    [[nodiscard]] bool is_judged() const { return held() + failed() > 0; }
    /// Number of conditions that could not be judged.
    [[nodiscard]] std::size_t not_judged() const;
    [[nodiscard]] bool holds() const { return failed() == 0; }
    /// Result of the expectation that failed first in time; null where all hold.
    [[nodiscard]] const ExpectationResult* first_failure() const;
};

/// Keeps a display for the next test that needs the same one, since a start takes longer than most tests.
class TestDisplay {
public:
    /// Returns a display that was started with these options. It is valid until the next call. Throws UserError where it cannot
    /// be started.
    DisplaySession& session_for(const PictureOptions& picture, bool is_generated);

private:
    std::unique_ptr<DisplaySession> session_;
    std::string key_;
};

struct FlyTestSettings {
    std::string folder;  ///< where the logs of steps are written
    bool draws_failure = false;
    std::function<bool()> is_interrupted;
};

/// Flies a test, which has a log or steps. Throws UserError where the input cannot be played or an expectation lies beyond its
/// end, and Interrupted.
[[nodiscard]] FlightTestResult fly_flight_test(const FlightTest& test, TestDisplay& display, const FlyTestSettings& settings);

/// The frames to watch, all of a span or single ones; seconds since the first frame of the input.
struct WatchedTimes {
    double from_s = 0;
    std::optional<double> to_s;  ///< nothing: the end of the input, or the latest time of the script
    std::vector<double> at_s;    ///< not empty: only the first frame at or after each of these times, in the given order
};

struct FrameWatcher {
    std::function<void(const ObservedFrame&)> take;
    std::function<void(std::uint64_t done, std::uint64_t total)> told;  ///< may be empty
};

struct WatchedFlight {
    double rate_hz = 0;  ///< frame rate of the device
    std::uint64_t frames = 0;
};

/// Plans frames as fly_flight_test() does, without judging them. Throws UserError where no frame has such a time, and
/// Interrupted.
[[nodiscard]] WatchedFlight watch_flight(const FlightTest& test, TestDisplay& display, const FlyTestSettings& settings,
                                         const WatchedTimes& times, const FrameWatcher& watcher);

}  // namespace tedavis::host_sim
