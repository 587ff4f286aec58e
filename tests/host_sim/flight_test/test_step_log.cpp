#include "host_sim/flight_test/step_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "bus/switches/switch_log.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_step_log {
namespace {

using base::SignalState;
using flight::Signal;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kEnd = "[[expect]]\nat_s = 10\nphase = \"cruise\"\n";

FlightTest test_of(const std::string& steps) {
    const test_support::TemporaryFolder place;
    ScriptFaults faults;
    FlightTest test = read_flight_test(place.write("a.toml", steps + kEnd), {}, faults);
    EXPECT_THAT(faults.sentences(), ::testing::IsEmpty());
    return test;
}

/// The bus as its receiver has it, at a time.
class Received {
public:
    explicit Received(const std::string& steps) : test_(test_of(steps)) {
        std::ostringstream stream;
        write_step_log(test_, stream, "log");
        const std::string text = stream.str();
        bus::CandumpLogSource source({text.data(), text.size()});
        frames_.resize(100'000);
        frames_.resize(source.read(base::Time{INT64_MAX}, {frames_.data(), frames_.size()}));
        EXPECT_EQ(source.statistics().malformed, 0u);
    }
    bus::BusSnapshot at(double seconds) const {
        const base::Time now = test_.start.time + base::Duration::from_seconds(seconds);
        std::size_t count = 0;
        while (count < frames_.size() && frames_[count].time <= now) ++count;
        const auto assembler = std::make_unique<bus::StateAssembler>(test_.bus);
        assembler->feed({frames_.data(), count});
        return assembler->snapshot(now);
    }
    SignalState state(Signal signal, double seconds) const {
        const auto snapshot = at(seconds);
        return snapshot.state.state_of(signal, test_.start.time + base::Duration::from_seconds(seconds));
    }
    double length_s() const { return (frames_.back().time - frames_.front().time).to_seconds(); }
    const std::vector<bus::CanFrame>& frames() const { return frames_; }

private:
    FlightTest test_;
    std::vector<bus::CanFrame> frames_;
};

TEST(StepLog, TheReceiverGetsWhatTheStepsHold) {
    const Received bus("[[step]]\nat_s = 3\nhold = { pitch_deg = 5, indicated_airspeed_kt = 90 }\n");
    EXPECT_NEAR(bus.at(2.9).state[Signal::pitch].value_or(9), 0, 1e-9);
    EXPECT_NEAR(bus.at(4).state[Signal::pitch].value_or(9), 5 * 3.14159265 / 180, 1e-7);
    EXPECT_NEAR(bus.at(4).state[Signal::indicated_airspeed].value_or(0), 46.3, 1e-5);
}

TEST(StepLog, ASignalThatIsStoppedGrowsOldAndOneThatIsSentAgainReturns) {
    const Received bus("[[step]]\nat_s = 3\nstop = [\"pitch\"]\n[[step]]\nat_s = 7\nsend = [\"pitch\"]\n");
    EXPECT_EQ(bus.state(Signal::pitch, 3.2), SignalState::valid);
    EXPECT_EQ(bus.state(Signal::pitch, 3.5), SignalState::stale);
    EXPECT_EQ(bus.state(Signal::pitch, 4.5), SignalState::lost);
    EXPECT_EQ(bus.state(Signal::pitch, 7.1), SignalState::valid);
    EXPECT_EQ(bus.state(Signal::roll, 4.5), SignalState::valid) << "control";
}

TEST(StepLog, AnInvalidSignalSaysSo) {
    EXPECT_EQ(Received("[[step]]\nat_s = 3\ninvalid = [\"roll\"]\n").state(Signal::roll, 3.5), SignalState::invalid);
}

TEST(StepLog, APhaseIsStatedOnChangeAndEachSecond) {
    const Received bus("[[step]]\nat_s = 3.3\nphase = \"approach.final\"\n[[step]]\nat_s = 6.5\nstop = [\"phase\"]\n");
    std::vector<double> sent;
    for (const bus::CanFrame& frame : bus.frames())
        if (frame.id == 1830) sent.push_back((frame.time - bus.frames().front().time).to_seconds());
    ASSERT_EQ(sent.size(), 4u) << "3.3, 4, 5 and 6 s";
    EXPECT_NEAR(sent[0], 3.3, 0.01);
    EXPECT_NEAR(sent[3], 6.0, 0.01);
    EXPECT_EQ(bus.at(4).phase_status.phase.value_or({}), flight::kApproachFinal);
}

TEST(StepLog, FramesGoOutAsTheyAre) {
    const Received bus("[[step]]\nat_s = 2\nframe = [\"125#0102\", \"12345678#AA\"]\n");
    std::size_t found = 0;
    for (const bus::CanFrame& frame : bus.frames()) found += frame.id == 0x125 || frame.id == 0x12345678 ? 1 : 0;
    EXPECT_EQ(found, 2u);
}

TEST(StepLog, ASilentBusLastsToTheEnd) {
    const Received bus("[[step]]\nat_s = 1\nstop = [\"all\"]\n");
    EXPECT_NEAR(bus.length_s(), 10.5, 0.01) << "half a second beyond the expectation";
    EXPECT_EQ(bus.state(Signal::roll, 9), SignalState::lost);
}

/// Expectations count from the first frame.
TEST(StepLog, ABusThatIsSilentFromTheStartBeginsAtZero) {
    const Received bus("[[step]]\nat_s = 0\nstop = [\"all\"]\n[[step]]\nat_s = 5\nsend = [\"all\"]\n");
    EXPECT_NEAR(bus.length_s(), 10.5, 0.01);
    EXPECT_EQ(bus.state(Signal::pitch, 1), SignalState::missing);
    EXPECT_EQ(bus.state(Signal::pitch, 6), SignalState::valid);
}

TEST(StepLog, AHoldSendsAgain) {
    const Received bus("[[step]]\nat_s = 1\nstop = [\"pitch\", \"roll\"]\n[[step]]\nat_s = 5\nhold = { pitch_deg = 4 }\n");
    EXPECT_EQ(bus.state(Signal::pitch, 4), SignalState::lost);
    EXPECT_EQ(bus.state(Signal::pitch, 6), SignalState::valid);
    EXPECT_EQ(bus.state(Signal::roll, 6), SignalState::lost) << "control";
}

TEST(StepLog, AValueThatTheBusCannotCarryNamesItsStep) {
    FlightTest test = test_of("[[step]]\nat_s = 2\nhold = { navigation_source = 1 }\n");
    test.steps[0].hold[0].si = 999;
    std::ostringstream stream;
    test_support::expect_user_error([&] { write_step_log(test, stream, "log"); }, ":1: the value of 'navigation_source'");
}

std::size_t lines_of(const std::string& text) { return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')); }

TEST(StepSwitchLog, BeginsWithAllLevels) {
    const std::string log = step_switch_log(test_of("[[step]]\nat_s = 2\nswitch = \"CRUISE\"\n"));
    EXPECT_THAT(log, StartsWith("# tedavis switch log 1\n"));
    EXPECT_THAT(log, HasSubstr("00.000000) panel.AUTO 1\n")) << "at rest the panel leaves the phase to the others";
    EXPECT_THAT(log, HasSubstr("02.000000) panel.CRUISE 1\n"));
    EXPECT_EQ(lines_of(log), 1u + 7 + 7);
}

TEST(StepSwitchLog, ABounceAlternates) {
    const std::string log =
        step_switch_log(test_of("[[step]]\nat_s = 2\nbounce = { line = \"CRUISE\", times = 3, gap_ms = 5 }\n"));
    EXPECT_THAT(log, HasSubstr("02.000000) panel.CRUISE 1\n"));
    EXPECT_THAT(log, HasSubstr("02.005000) panel.CRUISE 0\n"));
    EXPECT_THAT(log, HasSubstr("02.010000) panel.CRUISE 1\n"));
}

TEST(StepSwitchLog, WithoutSwitchesThereIsNone) {
    EXPECT_EQ(step_switch_log(test_of("[[step]]\nat_s = 2\nphase = \"cruise\"\n")), "");
}

}  // namespace
}  // namespace tedavis::host_sim::test_step_log
