#include "bus/canaerospace/message_decoder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render_core/base/units.hpp"
#include "tests/bus/golden_frames.hpp"

namespace tedavis::bus::test_message_decoder {
namespace {

using base::radians;
using flight::Signal;

constexpr std::int64_t kMs = 1'000'000;

DecodedMessage decode_one(const std::string& content, const BusSettings& settings = BusSettings()) {
    MessageDecoder decoder(settings);
    return decoder.decode(frame_of(content));
}

void expect_signal(const std::string& content, Signal signal, double value, double tolerance = 1e-9) {
    const DecodedMessage message = decode_one(content);
    ASSERT_EQ(message.kind, MessageKind::signal) << content;
    EXPECT_TRUE(message.healthy) << content;
    EXPECT_EQ(message.signal, signal) << content;
    EXPECT_NEAR(message.value, value, tolerance) << content;
}

TEST(MessageDecoder, GoldenFrames) {
    expect_signal("137#0102002A40A00000", Signal::pitch, radians(5.0));
    expect_signal("138#0102002BC1480000", Signal::roll, radians(-12.5));
    expect_signal("141#0102002CC2B40000", Signal::true_heading, radians(270));
    expect_signal("40C#09020001423D0A3D", Signal::latitude, radians(47.26), radians(2e-6));
    expect_signal("40C#090300041C2B5590", Signal::latitude, radians(47.2602));
    expect_signal("00010138#02020005C1480000", Signal::roll, radians(-12.5));
    EXPECT_EQ(decode_one("00010138#02020005C1480000").channel, 1);
    EXPECT_EQ(decode_one("137#0102002A40A00000").header.node, 1);
    const DecodedMessage utc = decode_one("4B0#090F00060D2B1600");
    EXPECT_EQ(utc.kind, MessageKind::utc);
    EXPECT_EQ(utc.clock, (std::array<std::uint8_t, 4>{13, 43, 22, 0}));
    const DecodedMessage date = decode_one("4B6#090F00070C061357");
    EXPECT_EQ(date.kind, MessageKind::date);
    EXPECT_EQ(date.clock, (std::array<std::uint8_t, 4>{12, 6, 19, 87}));
    EXPECT_EQ(decode_one("208#7C0C004A400005DC").kind, MessageKind::alien) << "engine temperature: not this display's";
}

TEST(MessageDecoder, DoubleHalvesInEitherOrder) {
    for (const bool high_first : {true, false}) {
        MessageDecoder decoder{BusSettings()};
        const CanFrame high = frame_of(high_first ? "40C#091E00024047A14E" : "40C#091E00034047A14E", 0);
        const CanFrame low = frame_of(high_first ? "40C#091F00033BCD35A8" : "40C#091F00023BCD35A8", 2 * kMs);
        EXPECT_EQ(decoder.decode(high_first ? high : low).kind, MessageKind::half);
        const DecodedMessage message = decoder.decode(high_first ? low : high);
        ASSERT_EQ(message.kind, MessageKind::signal);
        EXPECT_NEAR(message.value, radians(47.2602), 1e-14);
    }
}

TEST(MessageDecoder, HalvesThatDoNotBelongTogetherAreDropped) {
    struct Pair {
        const char* first;
        const char* second;
        std::int64_t apart;
    };
    const Pair strangers[] = {
        {"40C#091E00024047A14E", "40C#091F00043BCD35A8", 2 * kMs},       // a message between them was lost
        {"40C#091E00024047A14E", "40C#091F00033BCD35A8", 21 * kMs},      // too far apart
        {"40C#091E00024047A14E", "40C#0A1F00033BCD35A8", 2 * kMs},       // another node
        {"40C#091E00024047A14E", "0001040C#091F00033BCD35A8", 2 * kMs},  // another channel
        {"40C#091E00024047A14E", "40D#091F00033BCD35A8", 2 * kMs},       // another identifier
        {"40C#091E00024047A14E", "40C#091E00034047A14E", 2 * kMs},       // two high halves
    };
    for (const Pair& pair : strangers) {
        MessageDecoder decoder{BusSettings()};
        (void)decoder.decode(frame_of(pair.first, 0));
        EXPECT_EQ(decoder.decode(frame_of(pair.second, pair.apart)).kind, MessageKind::half) << pair.second;
    }
}

TEST(MessageDecoder, LongPositionsOnlyWhereTheDialectHasThem) {
    BusSettings strict;
    strict.dialect.accept_long_position = false;
    EXPECT_EQ(decode_one("40C#090300041C2B5590", strict).kind, MessageKind::alien);
    EXPECT_EQ(decode_one("40E#0903000400000010").kind, MessageKind::alien) << "LONG has no meaning for a height";
}

TEST(MessageDecoder, Short2IsAccepted) {
    // 45 degrees of full scale 90: 16383.5, rounded up.
    expect_signal("137#010C00004000005A", Signal::pitch, radians(16384.0 * 90 / 32767));
}

TEST(MessageDecoder, ImplausibleValuesAreRefusedAndCounted) {
    const char* implausible[] = {
        "137#0102000042B60000",  // pitch 91
        "137#010200007FC00000",  // NaN
        "137#010200007F800000",  // infinity
        "40C#0902000042B50000",  // latitude 90.5
        "13F#0102000047C5E680",  // 101325 hPa: the sender means Pa
        "14F#0102000041700000",  // 15 K: the sender means Celsius
        "40F#01020000C0000000",  // ground speed -2
    };
    for (const char* content : implausible) {
        MessageDecoder decoder{BusSettings()};
        const DecodedMessage message = decoder.decode(frame_of(content));
        EXPECT_EQ(message.kind, MessageKind::signal) << content;
        EXPECT_FALSE(message.healthy) << content;
        EXPECT_EQ(decoder.counts().out_of_range, 1u) << content;
    }
    expect_signal("40C#0902000042B40000", Signal::latitude, radians(90), 1e-6);
    expect_signal("40D#09020000C3340000", Signal::longitude, -base::kPi, 1e-6);
    expect_signal("13F#01020000447D5000", Signal::baro_setting, 101325, 1e-6);
}

TEST(MessageDecoder, CodesThatAreNoPhaseAreCountedApart) {
    MessageDecoder decoder{BusSettings()};
    EXPECT_TRUE(decoder.decode(frame_of("726#011000011E0002FF")).healthy) << "30: cruise";
    EXPECT_FALSE(decoder.decode(frame_of("726#011000021E0002C8")).healthy) << "a confidence of 200 %";
    EXPECT_EQ(decoder.counts().impossible_phases, 0u);
    EXPECT_FALSE(decoder.decode(frame_of("726#01100003630002FF")).healthy) << "99";
    EXPECT_FALSE(decoder.decode(frame_of("726#01100004070002FF")).healthy) << "7";
    EXPECT_EQ(decoder.counts().impossible_phases, 2u);
    EXPECT_EQ(decoder.counts().first_impossible_phase, 99);
    EXPECT_EQ(decoder.counts().out_of_range, 3u);
}

TEST(MessageDecoder, ServiceCodeSaysInvalidUnlessTheDialectIgnoresIt) {
    EXPECT_FALSE(decode_one("137#0102012A40A00000").healthy);
    BusSettings ignoring;
    ignoring.dialect.service_code = ServiceCodeMeaning::ignored;
    EXPECT_TRUE(decode_one("137#0102012A40A00000", ignoring).healthy);
    EXPECT_TRUE(decode_one("3F9#0102052A423D0A3D").healthy) << "waypoint 5: the code is its number";
}

TEST(MessageDecoder, PaddedFramesAreTakenAndCounted) {
    MessageDecoder decoder{BusSettings()};
    EXPECT_EQ(decoder.decode(frame_of("418#0906000100030000")).kind, MessageKind::known);
    EXPECT_EQ(decoder.counts().padded, 1u);
    EXPECT_EQ(decoder.decode(frame_of("418#090600020003")).kind, MessageKind::known);
    EXPECT_EQ(decoder.counts().padded, 1u);
}

TEST(MessageDecoder, ForeignTrafficChangesOnlyCounters) {
    const char* foreign[] = {
        "137#01FF002A40A00000",  // reserved type
        "137#0103002A40A00000",  // LONG pitch
        "137#0102002A40A000",    // too short
        "137#010200",            // no header
        "137#R4",
        "137##00102002A40A00000",
        "20000137#0102002A40A00000",
        "00000937#0102002A40A00000",  // bits 11..15
        "00020137#0102002A40A00000",  // channel 2 of 2
        "154#0102002A40A00000",       // glider profile, off
        "7FF#0102002A40A00000",
        "082#00000000",
    };
    MessageDecoder decoder{BusSettings()};
    std::uint64_t count = 0;
    for (const char* content : foreign) {
        EXPECT_EQ(decoder.decode(frame_of(content)).kind, MessageKind::alien) << content;
        EXPECT_EQ(decoder.counts().alien, ++count);
    }
    EXPECT_EQ(decoder.counts().decoded, 0u);
    BusSettings glider;
    glider.dialect.glider_identifiers = true;
    EXPECT_EQ(decode_one("154#0102002A40A00000", glider).kind, MessageKind::known);
}

CanFrame pitch_frame(std::uint8_t code, std::int64_t ms, std::uint8_t node = 1) {
    CanFrame frame = frame_of("137#0102002A40A00000", ms * kMs);
    frame.data[0] = node;
    frame.data[3] = code;
    return frame;
}

TEST(MessageDecoder, MessageCodesFindLossDuplicatesAndOrder) {
    MessageDecoder decoder{BusSettings()};
    EXPECT_TRUE(decoder.decode(pitch_frame(250, 0)).restarted);
    EXPECT_FALSE(decoder.decode(pitch_frame(251, 10)).restarted);
    EXPECT_EQ(decoder.decode(pitch_frame(251, 11)).kind, MessageKind::repeated);
    EXPECT_EQ(decoder.decode(pitch_frame(2, 60)).kind, MessageKind::signal) << "wraps; six were lost";
    EXPECT_EQ(decoder.counts().lost, 6u);
    EXPECT_EQ(decoder.decode(pitch_frame(1, 61)).kind, MessageKind::repeated) << "older";
    EXPECT_EQ(decoder.decode(pitch_frame(3, 70)).kind, MessageKind::signal);
    EXPECT_EQ(decoder.counts().repeated, 2u);
    EXPECT_EQ(decoder.counts().restarts, 0u);
    EXPECT_EQ(decoder.counts().lost, 6u);
}

TEST(MessageDecoder, RestartedSendersAreBelievedAgain) {
    MessageDecoder decoder{BusSettings()};
    (void)decoder.decode(pitch_frame(100, 0));
    EXPECT_TRUE(decoder.decode(pitch_frame(90, 2001)).restarted) << "after the timeout any code";
    EXPECT_TRUE(decoder.decode(pitch_frame(10, 2010, 2)).restarted) << "another node";
    EXPECT_EQ(decoder.decode(pitch_frame(0, 2020, 2)).kind, MessageKind::repeated);
    EXPECT_EQ(decoder.decode(pitch_frame(1, 2030, 2)).kind, MessageKind::repeated);
    EXPECT_TRUE(decoder.decode(pitch_frame(2, 2040, 2)).restarted) << "third older code in a row";
    EXPECT_EQ(decoder.decode(pitch_frame(3, 2050, 2)).kind, MessageKind::signal);
    EXPECT_EQ(decoder.counts().restarts, 3u);
    EXPECT_EQ(decoder.counts().lost, 0u);
}

TEST(MessageDecoder, SendersThatDoNotNumberAreHeardAndSayNothingAboutLoss) {
    MessageDecoder decoder{BusSettings()};
    int heard = 0;
    for (int i = 0; i < 100; ++i) {
        const DecodedMessage message = decoder.decode(pitch_frame(0, 10 * i));
        heard += message.kind == MessageKind::signal ? 1 : 0;
        EXPECT_TRUE(i <= 5 || !message.numbered) << i;
    }
    EXPECT_GE(heard, 97);
    EXPECT_EQ(decoder.counts().lost, 0u);
}

TEST(MessageDecoder, PhaseMessages) {
    const DecodedMessage status = decode_one("726#011000001600015A");
    ASSERT_EQ(status.kind, MessageKind::phase);
    EXPECT_TRUE(status.healthy);
    EXPECT_EQ(status.phase, flight::kTakeoffFirstClimb);
    EXPECT_EQ(status.phase_origin, 1);
    EXPECT_EQ(status.confidence, 90);
    EXPECT_EQ(decode_one("727#011000001E000200").kind, MessageKind::phase_request);
    EXPECT_FALSE(decode_one("726#011001001600015A").healthy) << "service code: invalid";
    EXPECT_FALSE(decode_one("726#011000000000015A").healthy) << "zeros claim nothing";
    EXPECT_FALSE(decode_one("726#011000001900015A").healthy) << "no such phase";
    EXPECT_FALSE(decode_one("726#0110000016000165").healthy) << "101 percent";
    EXPECT_EQ(decode_one("726#010200001600015A").kind, MessageKind::alien);
    BusSettings moved;
    moved.phase.status_identifier = 1850;
    EXPECT_EQ(decode_one("726#011000001600015A", moved).kind, MessageKind::alien);
    EXPECT_EQ(decode_one("73A#011000001600015A", moved).kind, MessageKind::phase);
}

TEST(MessageDecoder, LegendRequests) {
    BusSettings settings;
    EXPECT_EQ(decode_one("73C#010A000002", settings).kind, MessageKind::alien) << "this bus carries no request";
    settings.display.legend_identifier = 1852;
    const DecodedMessage whole = decode_one("73C#010A000002", settings);
    ASSERT_EQ(whole.kind, MessageKind::legend_request);
    EXPECT_TRUE(whole.healthy);
    EXPECT_EQ(whole.legend, flight::LegendShow::whole);
    EXPECT_EQ(decode_one("73C#010A000000", settings).legend, flight::LegendShow::none);
    EXPECT_FALSE(decode_one("73C#010A000003", settings).healthy) << "there is no fourth";
    EXPECT_FALSE(decode_one("73C#010A010002", settings).healthy) << "service code: invalid";
    EXPECT_EQ(decode_one("73C#0102000000000002", settings).kind, MessageKind::alien) << "a code is an integer";
    const DecodedMessage withdrawn = decode_one("73C#01000000", settings);
    EXPECT_TRUE(withdrawn.healthy && withdrawn.nothing_selected);
}

TEST(MessageDecoder, ClocksInTheirDialects) {
    EXPECT_EQ(decode_one("4B0#091000060D2B1600").kind, MessageKind::utc) << "UCHAR4";
    EXPECT_EQ(decode_one("4B0#091B00060D2B16").kind, MessageKind::utc) << "UCHAR3";
    EXPECT_FALSE(decode_one("4B0#090F0006182B1600").healthy) << "24 h";
    EXPECT_FALSE(decode_one("4B6#090F00070C001357").healthy) << "month 0";
    BusSettings from_zero;
    from_zero.dialect.month_from_zero = true;
    EXPECT_EQ(decode_one("4B6#090F00070C001357", from_zero).clock[1], 1);
    EXPECT_FALSE(decode_one("4B6#090F00070C0C1357", from_zero).healthy);
    EXPECT_FALSE(decode_one("4B0#090F01060D2B1600").healthy) << "the sender says that it does not know";
    BusSettings heedless;
    heedless.dialect.service_code = ServiceCodeMeaning::ignored;
    EXPECT_TRUE(decode_one("4B0#090F01060D2B1600", heedless).healthy);
}

TEST(MessageDecoder, IdentificationRequestsAreRecognised) {
    EXPECT_EQ(decode_one("080#00000000").kind, MessageKind::identification_request);
    EXPECT_EQ(decode_one("080#00010000").kind, MessageKind::alien);
}

TEST(MessageDecoder, WhatIsSelectedOutOfRangeIsRefused) {
    BusSettings settings;
    settings.guidance.first_identifier = 1832;
    MessageDecoder decoder(settings);
    std::uint8_t code = 0;
    const auto decode = [&](std::uint16_t identifier, TypedValue value) {
        CanFrame frame;
        set_message_id(frame, identifier, 0);
        write_header(frame, {9, static_cast<std::uint8_t>(value.type), 0, ++code});
        frame.length = static_cast<std::uint8_t>(4 + encode_value(value, frame.data.data() + 4));
        return decoder.decode(frame);
    };
    EXPECT_EQ(decode(1832, {DataType::uchar8, 1, 0, {3}}).value, 3);
    EXPECT_FALSE(decode(1832, {DataType::uchar8, 1, 0, {4}}).healthy) << "there is no fourth source";
    EXPECT_EQ(decode(1832, {DataType::float32, 1, 1.0f, {}}).kind, MessageKind::alien) << "a code is an integer";
    EXPECT_FALSE(decode(1833, {DataType::float32, 1, 40000.0f, {}}).healthy);
    EXPECT_FALSE(decode(1099, {DataType::float32, 1, -50.0f, {}}).healthy) << "a minimum below ground";
    EXPECT_EQ(decode(1840, {DataType::float32, 1, 1.0f, {}}).kind, MessageKind::alien) << "behind the last of the eight";
}

/// Any bytes at all: every value that comes out healthy is finite and in its range.
TEST(MessageDecoder, RandomFramesNeverGiveWildValues) {
    BusSettings settings;
    settings.dialect.redundancy_channels = kMaxRedundancyChannels;
    settings.dialect.glider_identifiers = true;
    settings.guidance.first_identifier = 1832;
    MessageDecoder decoder(settings);
    std::mt19937_64 random(99);
    std::uint64_t healthy = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        CanFrame frame;
        frame.time.ns = static_cast<std::int64_t>(random() % 1000) * 10 * kMs;
        frame.kind = random() % 50 == 0 ? static_cast<FrameKind>(random() % 4) : FrameKind::data;
        const bool known = random() % 4 != 0;
        const IdentifierEntry& row = entry_at(static_cast<std::uint16_t>(random() % place_count()));
        const bool is_guidance = row.identifier < kGuidanceIdentifiers;
        frame.id = known ? std::uint32_t{row.identifier} + (is_guidance ? settings.guidance.first_identifier : 0u)
                         : static_cast<std::uint32_t>(random() & 0x1FFFFFFF);
        frame.extended = !known || random() % 8 == 0;
        frame.length = static_cast<std::uint8_t>(random() % 9);
        for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random());
        if (random() % 2 == 0) frame.data[1] &= 0x1F;
        if (random() % 2 == 0) frame.data[2] = 0;
        const DecodedMessage message = decoder.decode(frame);
        const bool valued = message.kind == MessageKind::signal || message.kind == MessageKind::known;
        if (!valued || !message.healthy) continue;
        ++healthy;
        ASSERT_TRUE(std::isfinite(message.value));
        ASSERT_LT(message.channel, kMaxRedundancyChannels);
        const IdentifierEntry& entry = entry_at(place_of(message.identifier, settings.guidance));
        ASSERT_LE(std::fabs(message.value), std::fmax(std::fabs(entry.low), std::fabs(entry.high)) * 1.001 + 0.01) << entry.name;
    }
    EXPECT_GT(healthy, 1000u);
}

}  // namespace
}  // namespace tedavis::bus::test_message_decoder
