#include "platform/egl_kms/seat.hpp"

#include <gtest/gtest.h>

#include "tests/platform/egl_kms/fake_seat.hpp"

namespace tedavis::platform::test_seat {
namespace {

using Says = FakeManager::Says;
// No result depends on how fast this machine is: the limit that is not meant is never reached.
constexpr base::Duration kNever = base::Duration::seconds(600), kShort = base::Duration::milliseconds(50);
constexpr SeatLimits kLong{kNever, kNever}, kShortEnabling{kShort, kNever}, kShortInAll{{}, kShort};

bool is_open_file(int descriptor) { return ::fcntl(descriptor, F_GETFD) >= 0; }

struct OpenSeat {
    OpenSeat() { EXPECT_EQ(seat.open(manager.port(), "/dev/dri/card0", kLong), SeatAccess::open); }
    FakeManager manager;
    Seat seat;
};

TEST(Seat, HandsOutTheCardAndGivesAllBackOnce) {
    FakeManager manager;
    {
        Seat seat;
        ASSERT_EQ(seat.open(manager.port(), "/dev/dri/card0", kLong), SeatAccess::open);
        EXPECT_EQ(manager.calls, "open device:/dev/dri/card0 ");
        EXPECT_EQ(seat.manager(), "seatd");
        EXPECT_EQ(seat.descriptor(), manager.descriptor);
        EXPECT_TRUE(seat.is_open() && seat.is_enabled() && is_open_file(manager.descriptor));
        EXPECT_EQ(seat.take_request(), TerminalRequest::none) << "being enabled at the start asks for nothing";
        seat.close();
        EXPECT_FALSE(seat.is_open() || is_open_file(manager.descriptor));
        EXPECT_EQ(seat.descriptor(), -1);
    }
    EXPECT_EQ(manager.calls, "open device:/dev/dri/card0 close:7 close ");
}

TEST(Seat, ASeatThatIsNeverEnabledIsWaitedForWithinTheLimit) {
    FakeManager manager;
    manager.says.clear();
    Seat seat;
    EXPECT_EQ(seat.open(manager.port(), "/dev/dri/card0", kShortEnabling), SeatAccess::not_enabled);
    EXPECT_EQ(manager.calls, "open close ") << "no device is asked for, and the seat is given back";
    EXPECT_LE(manager.longest_wait_ms, 50);
    EXPECT_FALSE(seat.is_open());
    EXPECT_EQ(seat.manager(), "seatd") << "for the sentence";
}

TEST(Seat, AManagerThatStandsStillHoldsUpNobody) {
    FakeManager manager;
    manager.stands_still = true;
    {
        Seat seat;
        EXPECT_EQ(seat.open(manager.port(), "/dev/dri/card0", kShortInAll), SeatAccess::no_answer);
        EXPECT_FALSE(seat.is_open());
        EXPECT_EQ(seat.take_request(), TerminalRequest::none);
    }
    sem_post(&manager.may_answer);
    sem_wait(&manager.has_closed);
    EXPECT_EQ(manager.calls, "open close ") << "an answer that comes too late leaves nothing open";
}

TEST(Seat, AManagerThatStandsStillWhereItRefusedHoldsUpNobody) {
    FakeManager manager;
    manager.device_fault = EPERM;
    manager.stands_still_at_close = true;
    {
        Seat seat;
        EXPECT_EQ(seat.open(manager.port(), "card", {kShort, kShort}), SeatAccess::no_answer);
        EXPECT_FALSE(seat.is_open());
    }
    sem_post(&manager.may_answer);
    sem_wait(&manager.has_closed);
}

TEST(Seat, AManagerThatStandsStillAtTheEndHoldsUpNobody) {
    FakeManager manager;
    {
        Seat seat;
        // Opening has the limit that is not reached, closing the short one.
        ASSERT_EQ(seat.open(manager.port(), "/dev/dri/card0", {kNever, kShort}), SeatAccess::open);
        manager.stands_still_at_close = true;
        seat.close();
        EXPECT_FALSE(seat.is_open());
        EXPECT_EQ(seat.descriptor(), -1);
    }
    sem_post(&manager.may_answer);
    sem_wait(&manager.has_closed);
    EXPECT_EQ(manager.calls, "open device:/dev/dri/card0 close:7 close ");
}

TEST(Seat, AManagerThatEndsDuringTheStartIsNoAnswer) {
    FakeManager manager;
    manager.is_gone = true;
    Seat seat;
    EXPECT_EQ(seat.open(manager.port(), "card", kLong), SeatAccess::no_answer);
    EXPECT_EQ(manager.calls, "open close ");
}

TEST(Seat, DisablingIsAnsweredOnceAndEnablingAsksForTheScreen) {
    OpenSeat open;
    open.manager.says = {Says::disable};
    EXPECT_EQ(open.seat.take_request(), TerminalRequest::release);
    EXPECT_FALSE(open.seat.is_enabled());
    EXPECT_EQ(open.seat.take_request(), TerminalRequest::none);
    EXPECT_TRUE(open.seat.answer(TerminalRequest::release));
    EXPECT_FALSE(open.seat.answer(TerminalRequest::release)) << "answered already";
    EXPECT_FALSE(open.seat.answer(TerminalRequest::acquire)) << "not enabled";
    open.manager.says = {Says::enable};
    EXPECT_EQ(open.seat.take_request(), TerminalRequest::acquire);
    EXPECT_TRUE(open.seat.answer(TerminalRequest::acquire));
    EXPECT_TRUE(open.seat.is_enabled());
    EXPECT_EQ(open.manager.calls, "open device:/dev/dri/card0 disable ");
}

TEST(Seat, OfBothRequestsAtOnceSeatdStillWaitsForTheAnswerInEachOrder) {
    for (const bool is_newest_first : {false, true}) {
        OpenSeat open;
        open.manager.says = {Says::disable};
        EXPECT_EQ(open.seat.take_request(), TerminalRequest::release);
        EXPECT_TRUE(open.seat.answer(TerminalRequest::release));
        open.manager.says = {Says::enable, Says::disable};
        if (is_newest_first) open.manager.says = {Says::disable, Says::enable};
        EXPECT_EQ(open.seat.take_request(), TerminalRequest::release);
        EXPECT_FALSE(open.seat.is_enabled());
        EXPECT_TRUE(open.seat.answer(TerminalRequest::release));
        open.manager.says = {Says::enable};
        EXPECT_EQ(open.seat.take_request(), TerminalRequest::acquire) << "it is alone in this frame";
        EXPECT_TRUE(open.seat.is_enabled());
    }
}

TEST(Seat, LogindsNewestRequestCounts) {
    FakeManager manager;
    manager.name = "logind";
    Seat seat;
    ASSERT_EQ(seat.open(manager.port(), "card", kLong), SeatAccess::open);
    manager.says = {Says::disable, Says::enable};
    EXPECT_EQ(seat.take_request(), TerminalRequest::acquire);
    EXPECT_FALSE(seat.answer(TerminalRequest::release)) << "the manager waits for nothing any more";
    EXPECT_EQ(manager.calls.find("disable"), std::string::npos);
    manager.says = {Says::enable, Says::disable};
    EXPECT_EQ(seat.take_request(), TerminalRequest::release);
}

TEST(Seat, BeingDisabledDuringTheStartIsToldAfterIt) {
    FakeManager manager;
    manager.disables_while_it_opens = true;
    Seat seat;
    ASSERT_EQ(seat.open(manager.port(), "card", kLong), SeatAccess::open);
    EXPECT_FALSE(seat.is_enabled());
    EXPECT_EQ(seat.take_request(), TerminalRequest::release);
    EXPECT_TRUE(seat.answer(TerminalRequest::release));
}

TEST(Seat, AFrameWaitsForNoManager) {
    OpenSeat open;
    EXPECT_GT(open.manager.longest_wait_ms, 0);
    open.manager.longest_wait_ms = 0;
    EXPECT_EQ(open.seat.take_request(), TerminalRequest::none);
    EXPECT_EQ(open.manager.longest_wait_ms, 0);
}

TEST(Seat, AManagerThatWentAwayIsLostForGood) {
    OpenSeat open;
    open.manager.is_gone = true;
    EXPECT_EQ(open.seat.take_request(), TerminalRequest::lost);
    open.manager.is_gone = false;
    EXPECT_EQ(open.seat.take_request(), TerminalRequest::lost);
    EXPECT_FALSE(open.seat.answer(TerminalRequest::release));
}

TEST(Seat, WhatTheManagerRefusesIsTold) {
    FakeManager manager;
    manager.gives_seat = false;
    Seat without;
    EXPECT_EQ(without.open(manager.port(), "card", kLong), SeatAccess::no_seat);
    EXPECT_EQ(manager.calls, "open ") << "what was not opened is not closed";
    EXPECT_TRUE(without.manager().empty());

    FakeManager other;
    other.device_fault = EPERM;
    Seat seat;
    EXPECT_EQ(seat.open(other.port(), "card", kLong), SeatAccess::no_device);
    EXPECT_EQ(seat.reason(), EPERM);
    EXPECT_EQ(other.calls, "open device:card close ");

    Seat none;
    EXPECT_EQ(none.open(nullptr, "card", kLong), SeatAccess::no_seat);
    EXPECT_FALSE(none.is_open() || none.is_enabled() || none.answer(TerminalRequest::acquire));
}

}  // namespace
}  // namespace tedavis::platform::test_seat
