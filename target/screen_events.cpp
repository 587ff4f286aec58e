#include "target/screen_events.hpp"

namespace tedavis::target {

void ScreenEvents::started(const platform::ScreenReport& screen) {
    if (!screen.seat_manager.empty())
        log_.write({"screen ", screen.connector.view(), ": opened through ", screen.seat_manager.view()});
    else
        log_.write({"screen ", screen.connector.view(), ": opened without a seat manager", screen.seat_note.empty() ? "" : " (",
                    screen.seat_note.view(), screen.seat_note.empty() ? "" : ")"});
}

void ScreenEvents::report(const platform::ScreenReport& screen) {
    if (screen.is_plugged != was_plugged_)
        log_.write({"screen ", screen.connector.view(),
                    screen.is_plugged ? ": is connected again" : ": is not connected any more; it is used again when it is"});
    if (screen.is_master != was_master_)
        log_.write(
            {"screen ", screen.connector.view(),
             screen.is_master ? ": is ours again" : ": another program or terminal has it; it is used again when it is free"});
    if (screen.is_stuck != was_stuck_)
        log_.write(
            {"screen ", screen.connector.view(),
             screen.is_stuck ? ": confirms no frame and shows an old picture; its mode is set anew" : ": confirms frames again"});
    was_stuck_ = screen.is_stuck;
    was_plugged_ = screen.is_plugged;
    was_master_ = screen.is_master;
}

}  // namespace tedavis::target
