/// Other flights ("ghosts") that a replay shows beside its own, for comparison: the options, and the flights as they are shown.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tedavis::host_sim {

inline constexpr std::size_t kMaxGhosts = 4;

/// The rule by which each time of the own flight is paired with a time of the other one.
enum class GhostAlign : std::uint8_t {
    time,     ///< the same UTC; where neither log knows the date, the same time since its begin
    place,    ///< the time at which it was nearest to the own ship's position
    takeoff,  ///< the same time since take-off
};
/// Names of the values of GhostAlign, in their order.
inline constexpr std::array<std::string_view, 3> kGhostAlignNames = {"time", "place", "takeoff"};
[[nodiscard]] constexpr std::string_view name_of(GhostAlign align) { return kGhostAlignNames[static_cast<std::size_t>(align)]; }

/// A ghost as it is shown. Times are seconds since the first frame of the own log.
struct ShownGhost {
    struct Place {
        double time_s = 0, latitude_deg = 0, longitude_deg = 0;
        bool joins_next = true;  ///< false: the ghost is not shown between this place and the next one
    };
    std::string log, name;  ///< path of the log; the name in the picture: "other"
    GhostAlign align = GhostAlign::time;
    /// Shift of its time (of UTC where that is known); nothing with GhostAlign::place, where the shift varies.
    std::optional<double> shift_s;
    std::vector<Place> places;  ///< ascending in time; at least two
};

/// The ghosts of a replay, and the scene database that is drawn instead of the one in the options: the same with a layer of
/// ghosts. Both members are empty where there are no ghosts.
struct ShownGhosts {
    std::string scene;  ///< scene database
    std::vector<ShownGhost> flights;
};

}  // namespace tedavis::host_sim
