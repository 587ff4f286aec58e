#include "bus/canaerospace/phase_report.hpp"

#include <gtest/gtest.h>

#include "tests/bus/golden_frames.hpp"

namespace tedavis::bus::test_phase_report {
namespace {

base::Time at_ms(std::int64_t ms) { return base::Time{ms * 1'000'000}; }

BusSettings settings_of(std::uint16_t identifier) {
    BusSettings settings;
    settings.phase.report_identifier = identifier;
    settings.node.node = 30;
    return settings;
}

/// Sends what is due, and returns it as a line of candump; empty: nothing is due.
std::string said(PhaseReport& report, const flight::PhaseStatus& status, base::Time now) {
    const auto message = report.due(status, now);
    if (!message) return "";
    report.sent(status, now);
    return text_of(*message);
}

TEST(PhaseReport, SaysPhaseSourceAndFaultsAsTheReadmeStatesThem) {
    PhaseReport report(settings_of(1853));
    flight::PhaseStatus status = flight::stated_phase(flight::kApproachFinal, flight::PhaseSource::can);
    EXPECT_EQ(said(report, status, at_ms(0)), "73D#1E1000002B030000");
    status.source = flight::PhaseSource::switches;
    status.switch_fault = true;
    EXPECT_EQ(said(report, status, at_ms(10)), "73D#1E1000012B040100");
    status.disagreement = true;
    EXPECT_EQ(said(report, status, at_ms(20)), "73D#1E1000022B040300");
}

/// The numbers of the sources are a contract with others on the bus.
TEST(PhaseReport, EachSourceHasItsNumber) {
    using flight::PhaseSource;
    const std::pair<PhaseSource, int> numbers[] = {{PhaseSource::none, 0},
                                                   {PhaseSource::held, 1},
                                                   {PhaseSource::motion, 2},
                                                   {PhaseSource::can, 3},
                                                   {PhaseSource::switches, 4}};
    for (const auto& [source, number] : numbers) {
        const auto message =
            PhaseReport(settings_of(1853)).due(flight::stated_phase({flight::Scenario::ground, 0}, source), at_ms(0));
        ASSERT_TRUE(message);
        EXPECT_EQ(message->data[5], number);
    }
}

TEST(PhaseReport, IsDueOnChangeAndOnceASecond) {
    PhaseReport report(settings_of(1853));
    const flight::PhaseStatus cruise = flight::stated_phase({flight::Scenario::cruise, 0}, flight::PhaseSource::motion);
    int messages = 0;
    for (std::int64_t ms = 0; ms <= 3500; ms += 100) messages += said(report, cruise, at_ms(ms)).empty() ? 0 : 1;
    EXPECT_EQ(messages, 4) << "at 0, 1, 2 and 3 s";
    flight::PhaseStatus held = cruise;
    held.source = flight::PhaseSource::held;
    EXPECT_FALSE(said(report, held, at_ms(3600)).empty());
    held.presented = flight::kApproachFinal;
    EXPECT_TRUE(said(report, held, at_ms(3700)).empty()) << "what the picture follows is not what is reported";
}

TEST(PhaseReport, AMessageThatWasNotSentStaysDueWithItsCode) {
    PhaseReport report(settings_of(1853));
    const flight::PhaseStatus ground = flight::stated_phase({flight::Scenario::ground, 0}, flight::PhaseSource::can);
    const auto first = report.due(ground, at_ms(0)), again = report.due(ground, at_ms(33));
    ASSERT_TRUE(first && again);
    EXPECT_EQ(text_of(*first), text_of(*again));
}

TEST(PhaseReport, IsSilentUnlessTheBusFileAsksForIt) {
    PhaseReport report(BusSettings{});
    EXPECT_FALSE(report.due(flight::stated_phase(flight::kApproachFinal, flight::PhaseSource::can), at_ms(0)));
}

}  // namespace
}  // namespace tedavis::bus::test_phase_report
