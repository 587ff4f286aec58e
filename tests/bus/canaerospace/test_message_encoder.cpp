#include "bus/canaerospace/message_encoder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bus/canaerospace/message_decoder.hpp"
#include "render_core/base/units.hpp"
#include "tests/bus/golden_frames.hpp"

namespace tedavis::bus::test_message_encoder {
namespace {

using base::radians;

std::string encoded(MessageEncoder& encoder, std::uint16_t identifier, double si, DataType type, std::uint8_t channel = 0) {
    CanFrame frames[2];
    const std::size_t count = encoder.encode(identifier, si, type, {}, frames, channel);
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? " " : "") + text_of(frames[i]);
    return text;
}

TEST(MessageEncoder, GoldenFrames) {
    MessageEncoder encoder(BusSettings(), 1);
    EXPECT_EQ(encoded(encoder, 311, radians(5), DataType::float32), "137#0102000040A00000");
    EXPECT_EQ(encoded(encoder, 311, radians(5), DataType::float32), "137#0102000140A00000") << "the message code counts";
    EXPECT_EQ(encoded(encoder, 321, radians(270), DataType::float32), "141#01020000C2B40000") << "+-180";
    EXPECT_EQ(encoded(encoder, 312, radians(-12.5), DataType::float32, 1), "00010138#01020000C1480000");
    EXPECT_EQ(encoded(encoder, 1036, radians(47.2602), DataType::long32), "40C#010300001C2B5590");
    MessageEncoder gps(BusSettings(), 9);
    EXPECT_EQ(encoded(gps, 1036, radians(47.2602), DataType::double_high), "40C#091E00004047A14E 40C#091F00013BCD35A8");
    CanFrame frame[1];
    ASSERT_EQ(gps.encode_utc(13, 43, 22, {}, frame), 1u);
    EXPECT_EQ(text_of(frame[0]), "4B0#090F00000D2B1600");
    ASSERT_EQ(gps.encode_date(12, 6, 1987, {}, frame), 1u);
    EXPECT_EQ(text_of(frame[0]), "4B6#090F00000C061357");
    ASSERT_EQ(gps.encode_phase(flight::kTakeoffFirstClimb, PhaseOrigin::fms, 90, true, {}, frame), 1u);
    EXPECT_EQ(text_of(frame[0]), "726#091000001600015A");
}

TEST(MessageEncoder, RefusesWhatTheTableDoesNotAllow) {
    MessageEncoder encoder(BusSettings(), 1);
    CanFrame frames[2];
    EXPECT_EQ(encoder.encode(310, 0, DataType::float32, {}, frames), 0u);
    EXPECT_EQ(encoder.encode(311, 0, DataType::long32, {}, frames), 0u);
    EXPECT_EQ(encoder.encode(1036, 0, DataType::double_low, {}, frames), 0u);
    EXPECT_EQ(encoder.encode(1200, 0, DataType::char8x4, {}, frames), 0u);
    EXPECT_EQ(encoder.encode(311, std::numeric_limits<double>::quiet_NaN(), DataType::float32, {}, frames), 0u);
    EXPECT_EQ(encoder.encode(1036, 1, DataType::double_high, {}, {frames, 1}), 0u);
    EXPECT_EQ(encoder.encode(311, 0, DataType::float32, {}, {}), 0u);
    EXPECT_EQ(encoder.encode(311, 0, DataType::float32, {}, frames, kMaxRedundancyChannels), 0u);
    EXPECT_EQ(encoder.encode_utc(24, 0, 0, {}, frames), 0u);
    EXPECT_EQ(encoder.encode_date(1, 13, 2000, {}, frames), 0u);
}

/// What a type cannot hold of a number: half a step of the wire format, or the number's own rounding.
double tolerance_of(DataType type, double number, bool position) {
    if (type == DataType::float32) return 1e-7 * (1 + std::fabs(number));
    if (type == DataType::short16x2) return std::fabs(number) / 32767 + 1e-4;
    if (type == DataType::double_high) return 1e-13 * (1 + std::fabs(number));
    return type == DataType::long32 && position ? 6e-8 : 0.5;
}

/// Every identifier in every type it may have, in every dialect: what goes in comes out.
TEST(MessageEncoder, EveryIdentifierAndTypeGoesRound) {
    BusSettings other;
    other.dialect.acceleration = AccelerationUnit::mps2;
    other.dialect.pressure = PressureUnit::pa;
    other.dialect.wind = WindDirection::to;
    other.dialect.variation = VariationSign::west_positive;
    other.dialect.heading = HeadingReference::magnetic;
    other.dialect.deviation = DeviationSign::path;
    for (BusSettings settings : {BusSettings(), other}) {
        settings.dialect.glider_identifiers = true;
        settings.guidance.first_identifier = 1832;
        MessageEncoder encoder(settings, 3);
        MessageDecoder decoder(settings);
        int round_trips = 0;
        for (std::uint16_t identifier = 0; identifier < 2048; ++identifier)
            for (std::uint8_t code = 0; code < kDataTypeCount; ++code)
                for (const double part : {0.0, 0.25, 0.6, 0.999}) {
                    const std::uint16_t place = place_of(identifier, settings.guidance);
                    if (place == kNotInTable) continue;
                    const IdentifierEntry& entry = entry_at(place);
                    const auto type = static_cast<DataType>(code);
                    const bool clock = entry.unit == BusUnit::time_of_day || entry.unit == BusUnit::date;
                    if ((entry.types & type_bit(type)) == 0 || type == DataType::double_low || clock) continue;
                    if (type == DataType::nodata) continue;  // no number
                    const SignalBinding binding = bind(entry, settings.dialect);
                    const TypeLayout layout = type_layout(code);
                    const bool real = type == DataType::float32 || type == DataType::short16x2 || type == DataType::double_high;
                    const bool integer = !real && !(type == DataType::long32 && is_position(entry));
                    const bool limited = integer || type == DataType::short16x2;
                    const double most = limited ? std::ldexp(1.0, 8 * layout.bytes / layout.count - 1) - 1 : 1e300;
                    const double factor = std::fabs(binding.factor);
                    const double high = std::fmin(entry.high / factor, most);
                    const double low = std::fmax(entry.low / factor, integer && !layout.is_signed ? 0 : -most);
                    if (low > high) continue;  // the dialect's unit does not fit the type
                    const double number = low + part * (high - low);
                    CanFrame frames[2];
                    const std::size_t count = encoder.encode(identifier, to_si(binding, number), type, {}, frames);
                    ASSERT_GE(count, 1u) << entry.name << ' ' << int{code} << ' ' << number;
                    DecodedMessage message;
                    for (std::size_t i = 0; i < count; ++i) message = decoder.decode(frames[i]);
                    ASSERT_TRUE(message.kind == MessageKind::signal || message.kind == MessageKind::known) << entry.name;
                    ASSERT_TRUE(message.healthy) << entry.name << ' ' << int{code} << ' ' << number;
                    const double expected = to_si(binding, number);
                    const double tolerance = tolerance_of(type, number, is_position(entry)) * std::fabs(binding.factor);
                    const bool angle = binding.range != AngleRange::as_is;
                    const double error =
                        angle ? std::remainder(message.value - expected, 2 * base::kPi) : message.value - expected;
                    ASSERT_NEAR(error, 0, tolerance) << entry.name << ' ' << int{code} << ' ' << number;
                    ++round_trips;
                }
        EXPECT_GT(round_trips, 600);
        EXPECT_EQ(decoder.counts().out_of_range + decoder.counts().alien + decoder.counts().lost, 0u);
    }
}

TEST(MessageEncoder, EveryPhaseGoesRoundAndInvalidIsSaid) {
    MessageEncoder encoder(BusSettings(), 3);
    MessageDecoder decoder{BusSettings()};
    CanFrame frame[1];
    for (int code = 0; code < 256; ++code) {
        const flight::ParsedPhase parsed = flight::phase_from_code(static_cast<std::uint8_t>(code));
        if (!parsed.ok) continue;
        ASSERT_EQ(encoder.encode_phase(parsed.phase, PhaseOrigin::simulator, kConfidenceNotStated, true, {}, frame), 1u);
        DecodedMessage message = decoder.decode(frame[0]);
        EXPECT_EQ(message.phase, parsed.phase);
        EXPECT_TRUE(message.healthy);
        EXPECT_EQ(message.confidence, 255);
        ASSERT_EQ(encoder.encode_phase(parsed.phase, PhaseOrigin::fms, 50, false, {}, frame), 1u);
        EXPECT_FALSE(decoder.decode(frame[0]).healthy);
        ASSERT_EQ(encoder.encode_phase_request(parsed.phase, {}, frame), 1u);
        message = decoder.decode(frame[0]);
        EXPECT_EQ(message.kind, MessageKind::phase_request);
        EXPECT_EQ(message.phase_origin, 2);
    }
}

TEST(MessageEncoder, EveryLegendRequestGoesRound) {
    CanFrame frame[1];
    MessageEncoder without(BusSettings(), 3);
    EXPECT_EQ(without.encode_legend_request(flight::LegendShow::whole, {}, frame), 0u) << "this bus carries no request";
    BusSettings settings;
    settings.display.legend_identifier = 1852;
    MessageEncoder encoder(settings, 3);
    MessageDecoder decoder(settings);
    for (const flight::LegendShow show : {flight::LegendShow::none, flight::LegendShow::key, flight::LegendShow::whole}) {
        ASSERT_EQ(encoder.encode_legend_request(show, {}, frame), 1u);
        const DecodedMessage message = decoder.decode(frame[0]);
        EXPECT_EQ(message.kind, MessageKind::legend_request);
        EXPECT_EQ(message.legend, show);
    }
    ASSERT_EQ(encoder.encode_legend_request({}, {}, frame), 1u);
    EXPECT_TRUE(decoder.decode(frame[0]).nothing_selected);
}

TEST(MessageEncoder, DatesCountMonthsAsTheDialectDoes) {
    BusSettings settings;
    settings.dialect.month_from_zero = true;
    MessageEncoder encoder(settings, 3);
    MessageDecoder decoder(settings);
    CanFrame frame[1];
    ASSERT_EQ(encoder.encode_date(31, 12, 2026, {}, frame), 1u);
    EXPECT_EQ(frame[0].data[5], 11);
    EXPECT_EQ(decoder.decode(frame[0]).clock, (std::array<std::uint8_t, 4>{31, 12, 20, 26}));
}

TEST(MessageEncoder, NothingSelectedIsAMessageWithoutData) {
    BusSettings settings;
    MessageEncoder without(settings, 3);
    CanFrame frame;
    EXPECT_EQ(without.encode_nothing_selected(1833, {}, {&frame, 1}), 0u) << "this bus carries no guidance";
    settings.guidance.first_identifier = 1832;
    MessageEncoder encoder(settings, 3);
    EXPECT_EQ(encoder.encode_nothing_selected(1832, {}, {&frame, 1}), 0u) << "the navigation source has a code for it";
    EXPECT_EQ(encoder.encode_nothing_selected(320, {}, {&frame, 1}), 0u) << "a measurement is not selected";
    ASSERT_EQ(encoder.encode_nothing_selected(1833, {}, {&frame, 1}), 1u);
    EXPECT_EQ(frame.length, 4);
    const DecodedMessage message = MessageDecoder(settings).decode(frame);
    EXPECT_EQ(message.kind, MessageKind::signal);
    EXPECT_EQ(message.signal, flight::Signal::selected_altitude);
    EXPECT_TRUE(message.nothing_selected && message.healthy);
}

TEST(MessageEncoder, MagneticDirectionsNeedTheVariation) {
    BusSettings settings;
    settings.dialect.directions = HeadingReference::magnetic;
    MessageEncoder encoder(settings, 3);
    CanFrame frame;
    constexpr std::uint16_t kSelectedCourse = 1125;
    EXPECT_EQ(encoder.encode(kSelectedCourse, 1, DataType::float32, {}, {&frame, 1}), 0u);
    encoder.set_variation(0.1);
    ASSERT_EQ(encoder.encode(kSelectedCourse, 1, DataType::float32, {}, {&frame, 1}), 1u);
    const DecodedMessage message = MessageDecoder(settings).decode(frame);
    EXPECT_TRUE(message.is_magnetic);
    EXPECT_NEAR(message.value, 0.9, 1e-6);
}

}  // namespace
}  // namespace tedavis::bus::test_message_encoder
