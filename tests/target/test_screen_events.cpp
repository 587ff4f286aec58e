#include "target/screen_events.hpp"

#include <gtest/gtest.h>

#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_screen_events {
namespace {

TEST(ScreenEvents, EachChangeIsOneLine) {
    LogLines lines;
    const EventLog log = lines.log();
    ScreenEvents events(log);
    platform::ScreenReport screen;
    screen.connector = "DSI-1";
    const auto frames = [&] {
        for (int n = 0; n < 3; ++n) events.report(screen);
    };
    frames();
    EXPECT_EQ(lines.lines(), 0u);
    screen.is_plugged = false;
    frames();
    screen.is_master = false;
    frames();
    screen.is_plugged = screen.is_master = true;
    frames();
    EXPECT_EQ(lines.str(),
              "tedavis-display: screen DSI-1: is not connected any more; it is used again when it is\n"
              "tedavis-display: screen DSI-1: another program or terminal has it; it is used again when it is free\n"
              "tedavis-display: screen DSI-1: is connected again\n"
              "tedavis-display: screen DSI-1: is ours again\n");
}

TEST(ScreenEvents, TheEndOfTheManagerIsOneLine) {
    LogLines lines;
    const EventLog log = lines.log();
    ScreenEvents events(log);
    platform::ScreenReport screen;
    screen.connector = "DSI-1";
    screen.seat_manager = "seatd";
    events.report(screen);
    screen.manager_end = platform::ManagerEnd::left_the_card;
    events.report(screen);
    events.report(screen);
    screen.manager_end = platform::ManagerEnd::took_the_card;
    screen.is_master = false;
    events.report(screen);
    EXPECT_EQ(lines.str(),
              "tedavis-display: screen DSI-1: seatd ended and left the card; the display goes on without it, and the program "
              "itself answers the console\n"
              "tedavis-display: screen DSI-1: seatd ended and took the card away; start the program again, which the service "
              "manager does by itself\n");
}

TEST(ScreenEvents, TheStartSaysWhichWayTheScreenWasOpened) {
    LogLines lines;
    const EventLog log = lines.log();
    ScreenEvents events(log);
    platform::ScreenReport screen;
    screen.connector = "DSI-1";
    events.started(screen);
    screen.seat_note = "seatd runs, but this user may not reach it";
    events.started(screen);
    screen.seat_manager = "seatd";
    events.started(screen);
    EXPECT_EQ(lines.str(),
              "tedavis-display: screen DSI-1: opened without a seat manager\n"
              "tedavis-display: screen DSI-1: opened without a seat manager (seatd runs, but this user may not reach it)\n"
              "tedavis-display: screen DSI-1: opened through seatd\n");
}

}  // namespace
}  // namespace tedavis::target::test_screen_events
