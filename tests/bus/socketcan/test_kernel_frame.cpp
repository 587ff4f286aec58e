#include "bus/socketcan/kernel_frame.hpp"

#include <gtest/gtest.h>
#include <linux/can.h>
#include <linux/can/error.h>

#include <cstring>
#include <random>

namespace tedavis::bus::test_kernel_frame {
namespace {

template <class Record>
base::Span<const unsigned char> bytes_of(const Record& record) {
    const void* plain = &record;
    return {static_cast<const unsigned char*>(plain), sizeof record};
}

TEST(KernelFrame, ReadsTheKernelsOwnStructures) {
    can_frame classic{};
    classic.can_id = 0x137;
    classic.can_dlc = 4;
    classic.data[3] = 9;
    CanFrame frame;
    frame.time.ns = 5;
    frame.channel = 2;
    ASSERT_TRUE(frame_from_kernel(bytes_of(classic), frame));
    EXPECT_EQ(frame.id, 0x137u);
    EXPECT_FALSE(frame.extended);
    EXPECT_EQ(frame.length, 4);
    EXPECT_EQ(frame.data[3], 9);
    EXPECT_EQ(frame.time.ns, 5);
    EXPECT_EQ(frame.channel, 2);
    classic.can_id = 0x10138 | CAN_EFF_FLAG;
    ASSERT_TRUE(frame_from_kernel(bytes_of(classic), frame));
    EXPECT_TRUE(frame.extended);
    EXPECT_EQ(frame.id, 0x10138u);
    classic.can_id = 0x137 | CAN_RTR_FLAG;
    ASSERT_TRUE(frame_from_kernel(bytes_of(classic), frame));
    EXPECT_EQ(frame.kind, FrameKind::remote);
    EXPECT_EQ(frame.data[3], 0);
    canfd_frame fd{};
    fd.can_id = 0x137;
    fd.len = 12;
    fd.flags = CANFD_BRS;
    fd.data[11] = 7;
    ASSERT_TRUE(frame_from_kernel(bytes_of(fd), frame));
    EXPECT_EQ(frame.kind, FrameKind::fd);
    EXPECT_EQ(frame.fd_flags, 1);
    EXPECT_EQ(frame.data[11], 7);
}

TEST(KernelFrame, RefusesBrokenRecords) {
    can_frame classic{};
    classic.can_dlc = 9;
    CanFrame frame;
    EXPECT_FALSE(frame_from_kernel(bytes_of(classic), frame));
    canfd_frame fd{};
    fd.len = 9;
    EXPECT_FALSE(frame_from_kernel(bytes_of(fd), frame));
    fd.len = 8;
    fd.can_id = CAN_RTR_FLAG;
    EXPECT_FALSE(frame_from_kernel(bytes_of(fd), frame));
    const unsigned char other[17] = {};
    EXPECT_FALSE(frame_from_kernel({other, 17}, frame));
    EXPECT_FALSE(frame_from_kernel({other, 0}, frame));
}

TEST(KernelFrame, GoesRound) {
    std::mt19937 random(1);
    for (int i = 0; i < 5000; ++i) {
        CanFrame frame;
        frame.kind = i % 3 == 0 ? FrameKind::fd : i % 3 == 1 ? FrameKind::data : FrameKind::remote;
        frame.extended = random() % 2 == 0;
        frame.id = random() & (frame.extended ? 0x1FFFFFFFu : 0x7FFu);
        frame.length = static_cast<std::uint8_t>(frame.kind == FrameKind::fd && random() % 2 == 0 ? 64 : random() % 9);
        if (frame.kind == FrameKind::fd) frame.fd_flags = static_cast<std::uint8_t>(random() % 8);
        if (frame.kind != FrameKind::fd && frame.length == 8) frame.raw_dlc = 0xC;
        for (std::size_t k = 0; frame.kind != FrameKind::remote && k < frame.length; ++k)
            frame.data[k] = static_cast<std::uint8_t>(random());
        unsigned char record[kKernelFdFrameBytes];
        const std::size_t size = frame_to_kernel(frame, record);
        ASSERT_EQ(size, frame.kind == FrameKind::fd ? sizeof(canfd_frame) : sizeof(can_frame));
        CanFrame back;
        ASSERT_TRUE(frame_from_kernel({record, size}, back));
        ASSERT_EQ(back.id, frame.id);
        ASSERT_EQ(back.extended, frame.extended);
        ASSERT_EQ(back.kind, frame.kind);
        ASSERT_EQ(back.length, frame.length);
        ASSERT_EQ(back.raw_dlc, frame.raw_dlc);
        ASSERT_EQ(back.fd_flags, frame.fd_flags);
        ASSERT_EQ(back.data, frame.data);
    }
}

TEST(KernelFrame, WhatCannotBeSent) {
    unsigned char record[kKernelFdFrameBytes];
    CanFrame frame;
    frame.kind = FrameKind::error;
    EXPECT_EQ(frame_to_kernel(frame, record), 0u);
    frame.kind = FrameKind::data;
    frame.length = 9;
    EXPECT_EQ(frame_to_kernel(frame, record), 0u);
    frame.length = 8;
    frame.id = 0x800;
    EXPECT_EQ(frame_to_kernel(frame, record), 0u);
    frame.id = 0x7FF;
    EXPECT_EQ(frame_to_kernel(frame, {record, 15}), 0u);
    EXPECT_EQ(frame_to_kernel(frame, record), 16u);
}

TEST(KernelFrame, ControllerEvents) {
    CanFrame frame;
    frame.kind = FrameKind::error;
    frame.id = CAN_ERR_BUSOFF;
    EXPECT_EQ(controller_event(frame), ControllerEvent::bus_off);
    frame.id = CAN_ERR_RESTARTED;
    EXPECT_EQ(controller_event(frame), ControllerEvent::restarted);
    frame.id = CAN_ERR_CRTL;
    frame.data[1] = CAN_ERR_CRTL_RX_OVERFLOW;
    EXPECT_EQ(controller_event(frame), ControllerEvent::overflow);
    frame.data[1] = CAN_ERR_CRTL_TX_PASSIVE;
    EXPECT_EQ(controller_event(frame), ControllerEvent::warning);
    frame.id = CAN_ERR_ACK;
    EXPECT_EQ(controller_event(frame), ControllerEvent::none);
}

}  // namespace
}  // namespace tedavis::bus::test_kernel_frame
