/// Colours of flight phases in reports: one per scenario, light enough for dark text.
#pragma once

#include <array>
#include <string>
#include <utility>

namespace tedavis::host_sim {

/// "#d98c1f" of "takeoff.first_climb". Reports always state the phase's name as well.
[[nodiscard]] inline std::string phase_color(const std::string& phase) {
    constexpr std::array<std::pair<const char*, const char*>, 6> kColors = {{{"ground", "#9a9a9a"},
                                                                             {"takeoff", "#d98c1f"},
                                                                             {"cruise", "#5c97dd"},
                                                                             {"approach", "#4fae6b"},
                                                                             {"go_around", "#e0707f"},
                                                                             {"unknown", "#b9a7c9"}}};
    for (const auto& [name, color] : kColors) {
        if (phase.rfind(name, 0) == 0) return color;
    }
    return "#b9a7c9";
}

}  // namespace tedavis::host_sim
