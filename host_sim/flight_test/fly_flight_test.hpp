/// Flies a test: its input through the replay's player, frames planned at the device's rate where an expectation asks for one,
/// and drawn only at the first failing instant.
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
    std::vector<ExpectationResult> expectations;  ///< in the order of the test's
    std::uint64_t frames = 0;                     ///< that were planned for them
    std::string picture, record;                  ///< of the first failing instant: PNG bytes, and the frame's record as JSON

    [[nodiscard]] std::size_t held() const;
    [[nodiscard]] std::size_t failed() const;
    /// Whether any of them holds or fails.
    [[nodiscard]] bool is_judged() const { return held() + failed() > 0; }
    /// Conditions that could not be judged.
    [[nodiscard]] std::size_t not_judged() const;
    [[nodiscard]] bool holds() const { return failed() == 0; }
    /// Of the expectation that failed first; null where all hold.
    [[nodiscard]] const ExpectationResult* first_failure() const;
};

/// A display that tests use one after the other, as long as they ask for the same one: a start takes longer than most tests.
class TestDisplay {
public:
    /// Throws UserError where it cannot be started.
    DisplaySession& session_for(const PictureOptions& picture, bool is_generated);

private:
    std::unique_ptr<DisplaySession> session_;
    std::string key_;
};

struct FlyTestSettings {
    std::string folder;  ///< for the logs of steps
    bool draws_failure = false;
    std::function<bool()> is_interrupted;
};

/// The test has a log, or steps. Throws UserError where the input cannot be played or an expectation lies beyond its end, and
/// Interrupted.
[[nodiscard]] FlightTestResult fly_flight_test(const FlightTest& test, TestDisplay& display, const FlyTestSettings& settings);

/// Frames to be watched, by seconds since the first of the input: all of a span, or single ones.
struct WatchedTimes {
    double from_s = 0;
    std::optional<double> to_s;  ///< nothing: the end of the input, or of a script's times
    std::vector<double> at_s;    ///< not empty: for each of these times, in their order, the first frame at or after it
};

struct FrameWatcher {
    std::function<void(const ObservedFrame&)> take;
    std::function<void(std::uint64_t done, std::uint64_t total)> told;  ///< may be empty
};

struct WatchedFlight {
    double rate_hz = 0;  ///< frames of the device a second
    std::uint64_t frames = 0;
};

/// Plans frames as fly_flight_test() does, and judges none. Throws UserError where no frame lies at such times, and Interrupted.
[[nodiscard]] WatchedFlight watch_flight(const FlightTest& test, TestDisplay& display, const FlyTestSettings& settings,
                                         const WatchedTimes& times, const FrameWatcher& watcher);

}  // namespace tedavis::host_sim
