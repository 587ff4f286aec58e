#include "bus/canaerospace/message_header.hpp"

#include <gtest/gtest.h>

#include "tests/bus/golden_frames.hpp"

namespace tedavis::bus::test_message_header {
namespace {

TEST(MessageHeader, RedundancyChannelsAreMultiplesOf65536) {
    // The standard's example: body roll rate 304 on channels 0..3.
    EXPECT_EQ(message_id(0x130, false).identifier, 304);
    EXPECT_EQ(message_id(65840, true).identifier, 304);
    EXPECT_EQ(message_id(65840, true).channel, 1);
    EXPECT_EQ(message_id(0x30130, true).channel, 3);
    EXPECT_EQ(message_id(0x130, true).channel, 0) << "a 29-bit identifier below 65536 is channel 0";
    EXPECT_TRUE(message_id(0xFF0130, true).valid);
}

TEST(MessageHeader, OtherIdentifiersAreNoMessages) {
    EXPECT_FALSE(message_id(0x1000130, true).valid) << "channel above 255";
    EXPECT_FALSE(message_id(0x930, true).valid) << "bit 11 set";
    EXPECT_FALSE(message_id(2032, false).valid);
    EXPECT_TRUE(message_id(2031, false).valid);
}

TEST(MessageHeader, IdentifiersGoOutAsTheyComeIn) {
    for (std::uint16_t identifier = 0; identifier <= 2031; ++identifier)
        for (const std::uint8_t channel : {0, 1, 3, 255}) {
            CanFrame frame;
            set_message_id(frame, identifier, channel);
            const MessageId id = message_id(frame.id, frame.extended);
            ASSERT_TRUE(id.valid);
            ASSERT_EQ(id.identifier, identifier);
            ASSERT_EQ(id.channel, channel);
            ASSERT_EQ(frame.extended, channel != 0);
        }
}

TEST(MessageHeader, FourBytes) {
    const MessageHeader header = read_header(frame_of("137#0102032A40A00000"));
    EXPECT_EQ(header.node, 1);
    EXPECT_EQ(header.data_type, 2);
    EXPECT_EQ(header.service_code, 3);
    EXPECT_EQ(header.message_code, 0x2A);
    CanFrame frame;
    write_header(frame, header);
    EXPECT_EQ(read_header(frame).message_code, 0x2A);
    EXPECT_EQ(read_header(frame).service_code, 3);
}

TEST(MessageHeader, CodesGoRound) {
    for (int before = 0; before < 256; ++before)
        for (int step = -128; step < 128; ++step)
            ASSERT_EQ(code_step(static_cast<std::uint8_t>(before + step), static_cast<std::uint8_t>(before)), step);
}

}  // namespace
}  // namespace tedavis::bus::test_message_header
