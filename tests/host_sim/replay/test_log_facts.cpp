#include "host_sim/replay/log_facts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_log_facts {
namespace {

using ::testing::HasSubstr;

std::string line(double seconds, const std::string& frame, const std::string& interface_name = "can0") {
    char text[128];
    std::snprintf(text, sizeof text, "(%017.6f) %s %s\n", seconds, interface_name.c_str(), frame.c_str());
    return text;
}

constexpr char kLatitude[] = "40C#090300011C2B5590", kLongitude[] = "40D#0903000105C5D4B0", kPitch[] = "137#0102000140A00000";

/// A position and a pitch.
std::string sound() { return line(1, kLatitude) + line(1.1, kLongitude) + line(1.2, kPitch) + line(2, "137#0102000240A00000"); }

class LogFactsOf : public ::testing::Test {
protected:
    LogFacts facts(const std::string& text) { return read_log_facts(folder_.write("x.log", text), bus::BusSettings()); }
    Findings findings(const std::string& text) { return log_findings("x.log", "canaerospace", facts(text)); }
    std::string names(const std::string& text) {
        std::string all;
        for (const Finding& finding : findings(text)) all += finding.name + " ";
        return all;
    }
    test_support::TemporaryFolder folder_;
};

TEST_F(LogFactsOf, WhatConvertAssumedOfTheHeightsStandsBesideTheLog) {
    const std::string log = folder_.write("x.log", sound());
    EXPECT_FALSE(assumes_heights(log)) << "nothing beside it";
    const auto beside = [&](const std::string& json) {
        folder_.write("x.log.json", json);
        return assumes_heights(log);
    };
    EXPECT_TRUE(beside(R"({"assume_geometric": true, "derived": {"height": "pressure altitude taken for a height"}})"));
    EXPECT_TRUE(assumes_heights(log + ".gz")) << "packed since";
    EXPECT_FALSE(beside(R"({"assume_geometric": true, "derived": {"height": "GNSS height above the ellipsoid"}})"));
    EXPECT_FALSE(beside(R"({"assume_geometric": false, "derived": {"height": "pressure altitude"}})"));
    for (const char* const other : {"", "[1]", R"({"assume_geometric": "yes"})", R"({"assume_geometric": true, "derived": 3})"})
        EXPECT_FALSE(beside(other)) << other;
}

TEST_F(LogFactsOf, ASoundLogHasNoFindings) {
    const LogFacts read = facts(sound() + "prose\n");
    EXPECT_EQ(read.counters.frames, 4u);
    EXPECT_EQ(read.counters.decoded, 4u);
    EXPECT_EQ(read.lines.other, 1u);
    EXPECT_TRUE(read.has_position);
    EXPECT_EQ((read.last - read.first).to_seconds(), 1);
    ASSERT_EQ(read.interfaces.size(), 1u);
    EXPECT_EQ(read.interfaces[0].name, "can0");
    EXPECT_EQ(names(sound() + "prose\n"), "");
}

TEST_F(LogFactsOf, TimeThatRunsBackIsSaidWithItsFirstLine) {
    const Findings found = findings(sound() + line(1.5, "137#0102000340A00000") + line(3, "137#0102000440A00000"));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "log.time_runs_back");
    EXPECT_EQ(found[0].text, "x.log: time runs back at 1 line, first at line 5 by 0.500 s, at most by 0.500 s");
}

TEST_F(LogFactsOf, AReversedLogIsCalledSo) {
    std::string text = line(1, kLatitude) + line(1, kLongitude);
    for (int n = 0; n < 50; ++n) text = line(1.5 + 0.02 * n, "137#0102000240A00000") + text;
    const Findings found = findings(text);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "log.reversed");
    EXPECT_THAT(found[0].text, HasSubstr("50 of 52 frames are stamped before the one above"));
}

TEST_F(LogFactsOf, OneStampForAllIsSaid) {
    EXPECT_EQ(names(line(1, kLatitude) + line(1, kLongitude) + line(1, kPitch)), "log.no_time ");
}

TEST_F(LogFactsOf, MergedInterfacesAreNamedWithTheirFrames) {
    const Findings found = findings(sound() + line(3, "137#0102000340A00000", "can1"));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "log.interfaces");
    EXPECT_EQ(found[0].count, 2u);
    EXPECT_THAT(found[0].text, HasSubstr("frames of 2 interfaces are read as one bus: can0 (4 frames), can1 (1 frame)"));
}

TEST_F(LogFactsOf, OtherTrafficIsNoFlight) {
    const Findings found = findings(line(1, "1F5#01000020000100FE") + line(2, "271#140000007FFF1098"));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "bus.nothing_decoded");
    EXPECT_THAT(found[0].text, HasSubstr("none of 2 frames can be decoded by the bus canaerospace"));
    EXPECT_EQ(names(line(1, kPitch) + line(2, "271#140000007FFF1098")), "bus.no_position ");
}

TEST_F(LogFactsOf, CodesThatAreNoPhaseAndValuesOutOfRangeAreCounted) {
    const Findings found =
        findings(sound() + line(3, "726#01100001630002FF") + line(4, "726#01100002070002FF") + line(5, "137#0102000342B60000"));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].name, "bus.impossible_phase");
    EXPECT_EQ(found[0].text, "x.log: 2 flight phase messages with a code that is no phase, the first with code 99");
    EXPECT_EQ(found[1].name, "bus.out_of_range");
    EXPECT_EQ(found[1].count, 1u) << "a pitch of 91 degrees";
    EXPECT_EQ(names(sound() + line(3, "726#011000011E0002FF")), "") << "30: cruise";
}

TEST_F(LogFactsOf, BrokenLinesAndLostFramesAreCounted) {
    const Findings found =
        findings(sound() + "(3.0) can0 12\n" + "DROPCOUNT: dropped 5 CAN frames on 'can0' socket (total drops 5)\n");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].name, "log.broken_lines");
    EXPECT_THAT(found[0].text, HasSubstr("(the first: line 5, the time stamp is not"));
    EXPECT_EQ(found[1].name, "log.dropped");
    EXPECT_EQ(found[1].count, 5u);
}

TEST_F(LogFactsOf, WhatHasNoFrameIsRefused) {
    for (const char* text : {"", "It was a dark and stormy night.\n", "\x1f\x8b"})
        test_support::expect_user_error([&] { (void)facts(text); }, "x.log: ");
    test_support::expect_user_error([&] { (void)facts("(1.000000) can0 12\n"); },
                                    "no line of it is a frame of a candump log (the first: line 1, ");
}

}  // namespace
}  // namespace tedavis::host_sim::test_log_facts
