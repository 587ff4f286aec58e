#include "target/screen_events.hpp"

#include <string_view>

namespace tedavis::target {
namespace {

std::string_view text_of(platform::ManagerEnd end) {
    switch (end) {
        case platform::ManagerEnd::none: return "";
        case platform::ManagerEnd::left_the_card:
            return " ended and left the card; the display goes on without it, and the program itself answers the console";
        case platform::ManagerEnd::took_the_card:
            return " ended and took the card away; start the program again, which the service manager does by itself";
        case platform::ManagerEnd::kept_the_card:
            return " ended and cannot give the card to another terminal any more, so that the run ends; start the program again";
    }
    return "";
}

}  // namespace

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
    if (screen.manager_end != manager_end_)
        log_.write({"screen ", screen.connector.view(), ": ", screen.seat_manager.view(), text_of(screen.manager_end)});
    const bool is_gone = screen.manager_end > platform::ManagerEnd::left_the_card;
    if (screen.is_master != was_master_ && !is_gone)
        log_.write(
            {"screen ", screen.connector.view(),
             screen.is_master ? ": is ours again" : ": another program or terminal has it; it is used again when it is free"});
    if (screen.is_stuck != was_stuck_)
        log_.write(
            {"screen ", screen.connector.view(),
             screen.is_stuck ? ": confirms no frame and shows an old picture; its mode is set anew" : ": confirms frames again"});
    manager_end_ = screen.manager_end;
    was_stuck_ = screen.is_stuck;
    was_plugged_ = screen.is_plugged;
    was_master_ = screen.is_master;
}

}  // namespace tedavis::target
