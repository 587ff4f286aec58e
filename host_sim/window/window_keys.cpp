#include "host_sim/window/window_keys.hpp"

#include <sstream>

namespace tedavis::host_sim {
namespace {

using platform::Key;

enum class Shift : std::uint8_t { any, up, down };

struct KeyRow {
    Key key;
    char character;
    Shift shift;
    WindowAction action;
    const char* name;     ///< null: named by the row before
    const char* purpose;  ///< null: told by the row before
};

constexpr KeyRow kRows[] = {
    {Key::space, '\0', Shift::any, WindowAction::play_or_pause, "space", "play or pause"},
    {Key::character, 'r', Shift::any, WindowAction::reverse, "r", "play the other way"},
    {Key::character, '.', Shift::any, WindowAction::step_forward, ". ,", "one frame forward, back"},
    {Key::character, ',', Shift::any, WindowAction::step_back, nullptr, nullptr},
    {Key::right, '\0', Shift::up, WindowAction::seek_forward, "right left", "5 s forward, back; with shift 60 s"},
    {Key::left, '\0', Shift::up, WindowAction::seek_back, nullptr, nullptr},
    {Key::right, '\0', Shift::down, WindowAction::seek_far_forward, nullptr, nullptr},
    {Key::left, '\0', Shift::down, WindowAction::seek_far_back, nullptr, nullptr},
    {Key::home, '\0', Shift::any, WindowAction::to_start, "home end", "to the first, last frame"},
    {Key::end, '\0', Shift::any, WindowAction::to_end, nullptr, nullptr},
    {Key::up, '\0', Shift::any, WindowAction::faster, "up down", "double, halve the speed"},
    {Key::down, '\0', Shift::any, WindowAction::slower, nullptr, nullptr},
    {Key::backspace, '\0', Shift::any, WindowAction::normal_speed, "backspace", "the flight's own speed"},
    {Key::character, ']', Shift::any, WindowAction::next_pattern, "] [", "next, previous pattern of the panel"},
    {Key::character, '[', Shift::any, WindowAction::previous_pattern, nullptr, nullptr},
    {Key::character, 'l', Shift::any, WindowAction::next_legend, "l", "legend: key, whole, none"},
    {Key::character, 'c', Shift::any, WindowAction::free_camera, "c", "free camera on or off"},
    {Key::character, 't', Shift::any, WindowAction::tour, "t", "camera along the path of --tour on or off"},
    {Key::character, 'i', Shift::any, WindowAction::show_accuracy, "i",
     "requested and proven error, time of the frame on or off"},
    {Key::character, 'm', Shift::any, WindowAction::error_map, "m", "measured error of the ground in colors on or off"},
    {Key::character, 'n', Shift::any, WindowAction::light, "n", "symbology by night or by day"},
    {Key::character, 'w', Shift::any, WindowAction::fly_forward, "w s a d e q",
     "free camera forward, back, left, right, up, down"},
    {Key::character, 's', Shift::any, WindowAction::fly_back, nullptr, nullptr},
    {Key::character, 'a', Shift::any, WindowAction::fly_left, nullptr, nullptr},
    {Key::character, 'd', Shift::any, WindowAction::fly_right, nullptr, nullptr},
    {Key::character, 'e', Shift::any, WindowAction::fly_up, nullptr, nullptr},
    {Key::character, 'q', Shift::any, WindowAction::fly_down, nullptr, nullptr},
    {Key::character, 'o', Shift::any, WindowAction::head_up, "o", "line with time, speed and phase on or off"},
    {Key::character, 'p', Shift::any, WindowAction::screenshot, "p",
     "the display's frame to OUT/screenshot_TIME.png; s too, without the free camera"},
    {Key::character, 'h', Shift::any, WindowAction::help, "h ?", "this list on or off"},
    {Key::character, '?', Shift::any, WindowAction::help, nullptr, nullptr},
    {Key::character, '/', Shift::down, WindowAction::help, nullptr, nullptr},
    {Key::escape, '\0', Shift::any, WindowAction::close, "escape", "end"},
};

constexpr std::uint32_t kDigitKeys = 10;

bool fits(const KeyRow& row, const platform::WindowEvent& event) {
    const bool shift_fits = row.shift == Shift::any || event.shift == (row.shift == Shift::down);
    return row.key == event.key && shift_fits && (row.key != Key::character || row.character == event.character);
}

/// 1 is the first pattern, 0 the tenth; shift goes on from there.
KeyMeaning digit_key(const platform::WindowEvent& event) {
    const auto digit = static_cast<std::uint32_t>(event.character - '0');
    const std::uint32_t place = digit == 0 ? kDigitKeys - 1 : digit - 1;
    return {WindowAction::switch_pattern, place + (event.shift ? kDigitKeys : 0)};
}

std::string help_line(const std::string& name, const std::string& purpose) {
    constexpr std::size_t kColumn = 14;
    std::string line = "  " + name;
    line.resize(line.size() < kColumn ? kColumn : line.size() + 1, ' ');
    return line + purpose + "\n";
}

}  // namespace

KeyMeaning meaning_of_key(const platform::WindowEvent& event) {
    if (event.key == Key::character && event.character >= '0' && event.character <= '9') return digit_key(event);
    for (const KeyRow& row : kRows)
        if (fits(row, event)) return {row.action, 0};
    return {};
}

std::string window_keys_help() {
    std::string text = "Keys of the window:\n";
    for (const KeyRow& row : kRows)
        if (row.name != nullptr) text += help_line(row.name, row.purpose);
    text +=
        help_line("1 .. 9 0", "phase switch: pattern 1 to 10 of the panel, with shift 11 to 20; recorded in OUT/window.switches");
    text += help_line("mouse", "drag: the free camera looks around; wheel: its speed");
    return text;
}

std::vector<std::string> window_keys_lines() {
    std::vector<std::string> lines;
    std::istringstream text(window_keys_help());
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

}  // namespace tedavis::host_sim
