#include "bus/candump/candump_log_source.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/bus/text_bytes.hpp"

namespace tedavis::bus::test_candump_log_source {
namespace {

constexpr base::Time kForever{std::numeric_limits<std::int64_t>::max()};

base::Span<const char> span_of(const std::string& text) { return {text.data(), text.size()}; }

std::string line(double seconds, const char* frame = "123#11", const char* interface_name = "can0") {
    char text[128];
    std::snprintf(text, sizeof text, "(%017.6f) %s %s\n", seconds, interface_name, frame);
    return text;
}

std::vector<CanFrame> read_all(CanSource& source, base::Time until = kForever) {
    std::vector<CanFrame> frames;
    CanFrame batch[7];
    while (const std::size_t count = source.read(until, batch)) frames.insert(frames.end(), batch, batch + count);
    return frames;
}

base::Time at(double seconds) { return base::Time{} + base::Duration::from_seconds(seconds); }

TEST(CandumpLogSource, HandsOutFramesUpToTheGivenTimeOnce) {
    const std::string text = line(1) + line(2) + line(3);
    CandumpLogSource source(span_of(text));
    EXPECT_EQ(read_all(source, at(0.5)).size(), 0u);
    EXPECT_EQ(source.health(), SourceHealth::running);
    EXPECT_EQ(read_all(source, at(2)).size(), 2u);
    EXPECT_EQ(read_all(source, at(2)).size(), 0u);
    EXPECT_EQ(read_all(source, at(9)).size(), 1u);
    EXPECT_EQ(source.health(), SourceHealth::ended);
    EXPECT_EQ(source.statistics().frames, 3u);
}

TEST(CandumpLogSource, CountsEveryLineByKindAndReportsBrokenOnes) {
    const std::string text = line(1) + "\n" + "garbage\n" + "(broken\n" + line(2) +
                             "DROPCOUNT: dropped 5 CAN frames on 'can0' socket (total drops 5)\n" +
                             line(3, "20000040#0000000000000000") + "(3.000000) can0 123#1\n" +
                             std::string(2 * kMaxLogLine, '(') + "\n";
    CandumpLogSource source(span_of(text));
    EXPECT_EQ(read_all(source).size(), 3u);
    EXPECT_EQ(source.line_counts().lines, 9u);
    EXPECT_EQ(source.line_counts().blank, 1u);
    EXPECT_EQ(source.line_counts().other, 1u);
    EXPECT_EQ(source.line_counts().drop_reports, 1u);
    EXPECT_EQ(source.statistics().dropped, 5u);
    EXPECT_EQ(source.statistics().error_frames, 1u);
    EXPECT_EQ(source.statistics().malformed, 3u);
    ASSERT_EQ(source.reports().size(), 3u);
    EXPECT_EQ(source.reports()[0].line, 4u);
    EXPECT_EQ(source.reports()[0].fault, LineFault::time_stamp);
    EXPECT_EQ(source.reports()[1].line, 8u);
    EXPECT_EQ(source.reports()[1].fault, LineFault::data);
    EXPECT_EQ(source.reports()[2].fault, LineFault::too_long);
}

TEST(CandumpLogSource, KeepsTheFirstReportsOfManyAndCountsAll) {
    std::string text;
    for (int i = 0; i < 100; ++i) text += "(x\n";
    CandumpLogSource source(span_of(text));
    EXPECT_EQ(read_all(source).size(), 0u);
    EXPECT_EQ(source.statistics().malformed, 100u);
    ASSERT_EQ(source.reports().size(), kMaxLineReports);
    EXPECT_EQ(source.reports()[kMaxLineReports - 1].line, kMaxLineReports);
}

TEST(CandumpLogSource, ReadingAheadOfTimeDoesNotCountTwice) {
    const std::string text = line(1) + "(broken\n" + line(5);
    CandumpLogSource source(span_of(text));
    for (int i = 0; i < 10; ++i) (void)read_all(source, at(2 + 0.1 * i));
    EXPECT_EQ(source.statistics().frames, 1u);
    EXPECT_EQ(read_all(source, at(5)).size(), 1u);
    EXPECT_EQ(source.statistics().malformed, 1u);
    EXPECT_EQ(source.reports().size(), 1u);
}

TEST(CandumpLogSource, InterfacesAreNumberedInOrderOfAppearance) {
    const std::string text = line(1, "123#", "can1") + line(2, "123#", "can0") + line(3, "123#", "can1");
    CandumpLogSource source(span_of(text));
    const std::vector<CanFrame> frames = read_all(source);
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[0].channel, 0);
    EXPECT_EQ(frames[1].channel, 1);
    EXPECT_EQ(frames[2].channel, 0);
    EXPECT_EQ(source.interface_names()[1].view(), "can0");
}

TEST(CandumpLogSource, OutOfOrderStampsKeepTheirTimeAndAreCounted) {
    const std::string text = line(1.000) + line(1.010) + line(1.005) + line(1.020);
    CandumpLogSource source(span_of(text));
    const std::vector<CanFrame> frames = read_all(source);
    ASSERT_EQ(frames.size(), 4u);
    EXPECT_EQ(frames[2].time, at(1.005));
    EXPECT_EQ(source.line_counts().out_of_order, 1u);
}

TEST(CandumpLogSource, TellsWhereTimeRunsBackAndByHowMuch) {
    const std::string text = line(10) + line(11) + "prose\n" + line(10.25) + line(10.5) + line(7) + line(8);
    CandumpLogSource source(span_of(text));
    (void)source.read(at(9), base::Span<CanFrame>());
    EXPECT_EQ(read_all(source).size(), 6u);
    const LogLineCounts& lines = source.line_counts();
    EXPECT_EQ(lines.runs_back, 2u);
    EXPECT_EQ(lines.first_back_line, 4u);
    EXPECT_EQ(lines.first_back, base::Duration::milliseconds(750));
    EXPECT_EQ(lines.longest_back, base::Duration::milliseconds(3500));
    const std::string forwards = line(10) + line(10) + line(11);
    CandumpLogSource sound(span_of(forwards));
    EXPECT_EQ(read_all(sound).size(), 3u);
    EXPECT_EQ(sound.line_counts().runs_back, 0u) << "equal stamps do not run back";
    EXPECT_EQ(sound.line_counts().first_back_line, 0u);
}

TEST(CandumpLogSource, AClockSetBackIsReanchored) {
    const std::string text = line(5000) + line(5000.1) + line(100) + line(100.1);
    CandumpLogSource source(span_of(text));
    const std::vector<CanFrame> frames = read_all(source);
    ASSERT_EQ(frames.size(), 4u);
    EXPECT_EQ(frames[2].time, at(5000.1));
    EXPECT_EQ(frames[3].time, at(5000.2));
    EXPECT_EQ(source.line_counts().clock_steps, 1u);
}

TEST(CandumpLogSource, OneLeapingStampDoesNotMoveTime) {
    const std::string text = line(10) + line(10.1) + line(16.1) + "\n(broken\n" + line(10.2) + line(10.3);
    CandumpLogSource source(span_of(text));
    const std::vector<CanFrame> frames = read_all(source);
    ASSERT_EQ(frames.size(), 5u);
    EXPECT_EQ(frames[2].time, at(10.1));
    EXPECT_EQ(frames[4].time, at(10.3));
    EXPECT_EQ(source.line_counts().leaping_stamps, 1u);
    EXPECT_EQ(source.line_counts().clock_steps, 0u);
    EXPECT_EQ(source.statistics().malformed, 1u);
}

TEST(CandumpLogSource, AClockSetBackOverAndOverStaysWithinTime) {
    std::string text;
    for (int i = 0; i < 20; ++i) text += line(8e9) + line(8e9 + 0.1) + line(0) + line(0.1);
    CandumpLogSource source(span_of(text));
    const std::vector<CanFrame> frames = read_all(source);
    ASSERT_EQ(frames.size(), 80u);
    for (const CanFrame& frame : frames) {
        EXPECT_GE(frame.time.ns, 0);
        EXPECT_LE(frame.time, kLatestStamp);
    }
}

TEST(CandumpLogSource, APauseInTheRecordingIsNoLeap) {
    const std::string text = line(10) + line(70) + line(70.1);
    CandumpLogSource source(span_of(text));
    EXPECT_EQ(read_all(source)[1].time, at(70));
    EXPECT_EQ(source.line_counts().leaping_stamps, 0u);
}

TEST(CandumpLogSource, WindowAndMemoryAgreeAndAPositionGoesOnExactly) {
    std::string text;
    for (int i = 0; i < 5000; ++i) {
        text += line(100 + 0.01 * i, i % 3 == 0 ? "12345678##1001122" : "123#1122334455667788", i % 2 == 0 ? "can0" : "can1");
        if (i % 100 == 7) text += "(broken " + std::to_string(i) + "\n";
    }
    CandumpLogSource whole(span_of(text));
    const std::vector<CanFrame> expected = read_all(whole);
    TextBytes bytes(text);
    std::vector<char> window(kMinLogWindow);
    CandumpLogSource streamed(bytes, {window.data(), window.size()});
    std::vector<CanFrame> frames = read_all(streamed, at(120));
    const LogPosition position = streamed.position();
    const std::vector<CanFrame> rest = read_all(streamed);
    frames.insert(frames.end(), rest.begin(), rest.end());
    ASSERT_EQ(frames.size(), expected.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        ASSERT_EQ(frames[i].time.ns, expected[i].time.ns);
        ASSERT_EQ(frames[i].id, expected[i].id);
        ASSERT_EQ(frames[i].channel, expected[i].channel);
    }
    streamed.seek(position);
    EXPECT_EQ(streamed.health(), SourceHealth::running);
    EXPECT_EQ(read_all(streamed).size(), rest.size());
    EXPECT_EQ(streamed.statistics().malformed, whole.statistics().malformed);
    EXPECT_EQ(streamed.statistics().frames, whole.statistics().frames);
}

TEST(CandumpLogSource, AFailingMediumIsReported) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += line(i);
    TextBytes bytes(text);
    bytes.fail_beyond(50000);
    std::vector<char> window(kMinLogWindow);
    CandumpLogSource source(bytes, {window.data(), window.size()});
    EXPECT_GT(read_all(source).size(), 1000u);
    EXPECT_EQ(source.health(), SourceHealth::failed);
}

}  // namespace
}  // namespace tedavis::bus::test_candump_log_source
