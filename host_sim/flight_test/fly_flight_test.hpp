/// Flies a test: its input through the replay's player, frames planned at the device's rate where an expectation asks for one,
/// and drawn only at the first failing instant.
#pragma once

#include <functional>
#include <memory>
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
    [[nodiscard]] bool holds() const { return held() == expectations.size(); }
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

}  // namespace tedavis::host_sim
