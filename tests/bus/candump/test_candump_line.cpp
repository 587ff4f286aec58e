#include "bus/candump/candump_line.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace tedavis::bus::test_candump_line {
namespace {

struct Parsed {
    CandumpLine line;
    CanFrame frame;
};

Parsed parse(std::string_view text) {
    Parsed result;
    result.line = parse_candump_line(text, result.frame);
    return result;
}

std::string format(const CanFrame& frame, StampDigits digits = StampDigits::nano, bool direction = false) {
    char out[kMaxCandumpLine];
    return std::string(out, format_candump_line(frame, "can0", digits, direction, out));
}

TEST(CandumpLine, MicrosecondStampAndStandardIdentifier) {
    const Parsed parsed = parse("(1436509052.249713) vcan0 137#0102002A40A00000");
    ASSERT_EQ(parsed.line.kind, LineKind::frame);
    EXPECT_EQ(parsed.frame.time.ns, 1436509052249713000);
    EXPECT_EQ(parsed.line.interface_name, "vcan0");
    EXPECT_EQ(parsed.frame.id, 0x137u);
    EXPECT_FALSE(parsed.frame.extended);
    EXPECT_EQ(parsed.frame.length, 8);
    EXPECT_EQ(parsed.frame.data[3], 0x2A);
    EXPECT_EQ(parsed.frame.data[4], 0x40);
    EXPECT_FALSE(parsed.frame.transmitted);
}

TEST(CandumpLine, NanosecondStamp) {
    EXPECT_EQ(parse("(1436509052.249713123) can0 123#").frame.time.ns, 1436509052249713123);
    EXPECT_EQ(parse("(0000000000.000000) can0 123#").frame.time.ns, 0);
}

TEST(CandumpLine, RightAlignedInterfaceNames) {
    const Parsed parsed = parse("(1436509052.249713)    can0 00010138#02020005C1480000");
    ASSERT_EQ(parsed.line.kind, LineKind::frame);
    EXPECT_EQ(parsed.line.interface_name, "can0");
    EXPECT_TRUE(parsed.frame.extended);
    EXPECT_EQ(parsed.frame.id, 0x10138u);
}

TEST(CandumpLine, DirectionSuffix) {
    EXPECT_FALSE(parse("(1.000000) can0 123#11 R").frame.transmitted);
    EXPECT_TRUE(parse("(1.000000) can0 123#11 T").frame.transmitted);
    EXPECT_EQ(parse("(1.000000) can0 123#11 T\r").line.kind, LineKind::frame);
    EXPECT_EQ(parse("(1.000000) can0 123#11 X").line.fault, LineFault::trailing_text);
    EXPECT_EQ(parse("(1.000000) can0 123#11 T T").line.fault, LineFault::trailing_text);
}

TEST(CandumpLine, RemoteFrames) {
    const Parsed plain = parse("(1.000000) can0 123#R");
    EXPECT_EQ(plain.frame.kind, FrameKind::remote);
    EXPECT_EQ(plain.frame.length, 0);
    EXPECT_EQ(parse("(1.000000) can0 123#R4").frame.length, 4);
    EXPECT_EQ(parse("(1.000000) can0 123#R8_D").frame.raw_dlc, 0xD);
    EXPECT_EQ(parse("(1.000000) can0 123#R9").line.fault, LineFault::length);
    EXPECT_EQ(parse("(1.000000) can0 123#R R").frame.kind, FrameKind::remote);
}

TEST(CandumpLine, RawLengthCodeBehindEightBytes) {
    EXPECT_EQ(parse("(1.000000) can0 123#0011223344556677_E").frame.raw_dlc, 0xE);
    EXPECT_EQ(parse("(1.000000) can0 123#0011223344556677_8").line.fault, LineFault::raw_length_code);
    EXPECT_EQ(parse("(1.000000) can0 123#00112233_E").line.fault, LineFault::raw_length_code);
}

TEST(CandumpLine, FdFrames) {
    const Parsed parsed = parse("(1.000000) can0 123##50011223344556677AABBCCDD");
    ASSERT_EQ(parsed.line.kind, LineKind::frame);
    EXPECT_EQ(parsed.frame.kind, FrameKind::fd);
    EXPECT_EQ(parsed.frame.fd_flags, 5);
    EXPECT_EQ(parsed.frame.length, 12);
    EXPECT_EQ(parsed.frame.data[11], 0xDD);
    EXPECT_EQ(parse("(1.000000) can0 123##0").frame.length, 0);
    EXPECT_EQ(parse("(1.000000) can0 123##1001122334455667788").line.fault, LineFault::length)
        << "nine bytes do not exist in CAN FD";
    EXPECT_EQ(parse("(1.000000) can0 123##").line.fault, LineFault::fd_flags);
    EXPECT_EQ(parse("(1.000000) can0 1234567F##1" + std::string(128, 'A')).frame.length, 64);
    EXPECT_EQ(parse("(1.000000) can0 123##1" + std::string(130, 'A')).line.fault, LineFault::length);
}

TEST(CandumpLine, ErrorFrames) {
    const Parsed parsed = parse("(1.000000) can0 20000044#0001000000000000");
    ASSERT_EQ(parsed.line.kind, LineKind::frame);
    EXPECT_EQ(parsed.frame.kind, FrameKind::error);
    EXPECT_EQ(parsed.frame.id, 0x44u);
    EXPECT_FALSE(parsed.frame.extended);
    EXPECT_EQ(parse("(1.000000) can0 20000044#R").line.fault, LineFault::data);
}

TEST(CandumpLine, DotsBetweenBytesAndLowerCase) {
    const Parsed parsed = parse("(1.000000) can0 5aA#11.2b.33.44");
    ASSERT_EQ(parsed.line.kind, LineKind::frame);
    EXPECT_EQ(parsed.frame.id, 0x5AAu);
    EXPECT_EQ(parsed.frame.length, 4);
    EXPECT_EQ(parsed.frame.data[1], 0x2B);
}

TEST(CandumpLine, OtherLinesAreToldApart) {
    EXPECT_EQ(parse("").line.kind, LineKind::blank);
    EXPECT_EQ(parse(" \t\r").line.kind, LineKind::blank);
    EXPECT_EQ(parse("# a comment").line.kind, LineKind::other);
    EXPECT_EQ(parse("DROPCOUNT: dropped many").line.kind, LineKind::other);
    const Parsed drop = parse("DROPCOUNT: dropped 17 CAN frames on 'can0' socket (total drops 42)");
    EXPECT_EQ(drop.line.kind, LineKind::drop_report);
    EXPECT_EQ(drop.line.dropped, 17u);
}

struct BrokenLine {
    const char* text;
    LineFault fault;
};

TEST(CandumpLine, BrokenLinesNameTheirFault) {
    const BrokenLine broken[] = {
        {"(", LineFault::time_stamp},
        {"(1.5) can0 123#", LineFault::time_stamp},
        {"(1.0000000) can0 123#", LineFault::time_stamp},
        {"(-1.000000) can0 123#", LineFault::time_stamp},
        {"(9000000000.000000) can0 123#", LineFault::time_stamp},
        {"(99999999999999999999.000000) can0 123#", LineFault::time_stamp},
        {"(1.000000)", LineFault::interface_name},
        {"(1.000000) can0", LineFault::interface_name},
        {"(1.000000)can0 123#", LineFault::interface_name},
        {"(1.000000) abcdefghijklmnop 123#", LineFault::interface_name},
        {"(1.000000) can0 12#", LineFault::identifier},
        {"(1.000000) can0 800#", LineFault::identifier},
        {"(1.000000) can0 1234#", LineFault::identifier},
        {"(1.000000) can0 40000000#", LineFault::identifier},
        {"(1.000000) can0 123456789#", LineFault::identifier},
        {"(1.000000) can0 123", LineFault::identifier},
        {"(1.000000) can0 123#1", LineFault::data},
        {"(1.000000) can0 123#1G", LineFault::data},
        {"(1.000000) can0 123#GG", LineFault::data},
        {"(1.000000) can0 123#001122334455667788", LineFault::length},
        {"(1.000000) can0 45123#81:00:12345678#1122", LineFault::can_xl},
    };
    for (const BrokenLine& line : broken) {
        const Parsed parsed = parse(line.text);
        EXPECT_EQ(parsed.line.kind, LineKind::malformed) << line.text;
        EXPECT_EQ(parsed.line.fault, line.fault) << line.text << ": " << describe(parsed.line.fault);
    }
}

CanFrame random_frame(std::mt19937_64& random) {
    const auto draw = [&](std::uint64_t limit) { return random() % limit; };
    CanFrame frame;
    frame.time.ns = static_cast<std::int64_t>(draw(9000000000000000000u));
    frame.kind = static_cast<FrameKind>(draw(4));
    frame.extended = frame.kind != FrameKind::error && draw(2) == 1;
    frame.id = static_cast<std::uint32_t>(draw(frame.extended || frame.kind == FrameKind::error ? 0x20000000u : 0x800u));
    constexpr std::uint8_t kFdLengths[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};
    frame.length = frame.kind == FrameKind::fd ? kFdLengths[draw(16)] : static_cast<std::uint8_t>(draw(9));
    if (frame.kind == FrameKind::fd)
        frame.fd_flags = static_cast<std::uint8_t>(draw(16));
    else if (frame.length == 8 && draw(2) == 1)
        frame.raw_dlc = static_cast<std::uint8_t>(9 + draw(7));
    if (frame.kind != FrameKind::remote)
        for (std::size_t i = 0; i < frame.length; ++i) frame.data[i] = static_cast<std::uint8_t>(random());
    frame.transmitted = draw(2) == 1;
    return frame;
}

TEST(CandumpLine, EveryFrameSurvivesWritingAndReading) {
    std::mt19937_64 random(1830);
    for (int i = 0; i < 20000; ++i) {
        const CanFrame frame = random_frame(random);
        const std::string text = format(frame, StampDigits::nano, true);
        ASSERT_FALSE(text.empty());
        ASSERT_EQ(text.back(), '\n');
        const Parsed parsed = parse(std::string_view(text).substr(0, text.size() - 1));
        ASSERT_EQ(parsed.line.kind, LineKind::frame) << text << describe(parsed.line.fault);
        ASSERT_EQ(parsed.frame.time.ns, frame.time.ns);
        ASSERT_EQ(parsed.frame.id, frame.id) << text;
        ASSERT_EQ(parsed.frame.extended, frame.extended);
        ASSERT_EQ(parsed.frame.kind, frame.kind);
        ASSERT_EQ(parsed.frame.length, frame.length) << text;
        ASSERT_EQ(parsed.frame.raw_dlc, frame.raw_dlc);
        ASSERT_EQ(parsed.frame.fd_flags, frame.fd_flags);
        ASSERT_EQ(parsed.frame.data, frame.data) << text;
        ASSERT_EQ(parsed.frame.transmitted, frame.transmitted);
    }
}

TEST(CandumpLine, WritesWhatCandumpWrites) {
    CanFrame frame;
    frame.time.ns = 1436509052249713123;
    frame.id = 0x138;
    frame.length = 2;
    frame.data[0] = 0xC1;
    frame.data[1] = 0x48;
    EXPECT_EQ(format(frame, StampDigits::micro), "(1436509052.249713) can0 138#C148\n");
    EXPECT_EQ(format(frame), "(1436509052.249713123) can0 138#C148\n");
    frame.time.ns = 5;
    EXPECT_EQ(format(frame, StampDigits::nano, true), "(0000000000.000000005) can0 138#C148 R\n");
}

TEST(CandumpLine, RefusesToWriteWhatIsNoLine) {
    char out[kMaxCandumpLine];
    CanFrame frame;
    EXPECT_EQ(format_candump_line(frame, "can0", StampDigits::micro, false, {out, kMaxCandumpLine - 1}), 0u);
    EXPECT_EQ(format_candump_line(frame, "", StampDigits::micro, false, out), 0u);
    EXPECT_EQ(format_candump_line(frame, "abcdefghijklmnop", StampDigits::micro, false, out), 0u);
    frame.time.ns = -1;
    EXPECT_EQ(format_candump_line(frame, "can0", StampDigits::micro, false, out), 0u);
    frame.time.ns = 0;
    frame.length = 9;
    EXPECT_EQ(format_candump_line(frame, "can0", StampDigits::micro, false, out), 0u);
}

/// Mutated and random text: never a crash (sanitizer builds), and what is accepted can be written and read again.
TEST(CandumpLine, RandomTextIsHarmless) {
    constexpr std::string_view kSeeds[] = {"(1436509052.249713) can0 137#0102002A40A00000",
                                           "(1.000000000) can0 12345678##5001122 T",
                                           "DROPCOUNT: dropped 1 CAN frames on 'can0' socket (total drops 1)",
                                           "(1.000000) can0 20000004#0001000000000000", "(1.000000) can0 123#R8_F R"};
    std::mt19937_64 random(1831);
    for (int i = 0; i < 200000; ++i) {
        std::string text(kSeeds[random() % 5]);
        for (std::uint64_t edits = random() % 4; edits > 0; --edits) {
            if (text.empty()) break;
            const std::size_t place = random() % text.size();
            switch (random() % 3) {
                case 0: text[place] = static_cast<char>(random()); break;
                case 1: text.erase(place, 1 + random() % 5); break;
                default: text.insert(place, 1, "0123456789ABCDEF#_.R T()"[random() % 24]); break;
            }
        }
        const Parsed parsed = parse(text);
        ASSERT_EQ(parsed.line.kind == LineKind::malformed, parsed.line.fault != LineFault::none) << text;
        if (parsed.line.kind != LineKind::frame) continue;
        const std::string written = format(parsed.frame, StampDigits::nano, true);
        const Parsed again = parse(std::string_view(written).substr(0, written.size() - 1));
        ASSERT_EQ(again.line.kind, LineKind::frame) << text;
        ASSERT_EQ(again.frame.data, parsed.frame.data) << text;
        ASSERT_EQ(again.frame.id, parsed.frame.id) << text;
    }
}

}  // namespace
}  // namespace tedavis::bus::test_candump_line
