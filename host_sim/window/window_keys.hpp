/// The table of keys of the live window, used by the window and by its help.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "platform/window/window_events.hpp"

namespace tedavis::host_sim {

enum class WindowAction : std::uint8_t {
    none,
    close,
    help,
    play_or_pause,
    reverse,
    step_forward,
    step_back,
    seek_forward,
    seek_back,
    seek_far_forward,
    seek_far_back,
    to_start,
    to_end,
    faster,
    slower,
    normal_speed,
    switch_pattern,
    next_pattern,
    previous_pattern,
    next_legend,
    free_camera,
    tour,
    show_accuracy,
    error_map,
    light,
    head_up,
    screenshot,
    fly_forward,
    fly_back,
    fly_left,
    fly_right,
    fly_up,
    fly_down,
};

struct KeyMeaning {
    WindowAction action = WindowAction::none;
    std::uint32_t pattern = 0;  ///< of switch_pattern: index in the panel's list
};

/// Returns the action of a pressed or released key. The actions fly_... last while their key is held.
[[nodiscard]] KeyMeaning meaning_of_key(const platform::WindowEvent& event);

/// Returns a title and one line for each key.
[[nodiscard]] std::string window_keys_help();
/// The same lines, for a panel.
[[nodiscard]] std::vector<std::string> window_keys_lines();

}  // namespace tedavis::host_sim
