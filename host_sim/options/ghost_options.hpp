/// Other flights that a replay shows beside its own, for comparison: what is asked for, and what the replay made of it.
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

/// Which moment of the other flight is shown at a moment of the own one.
enum class GhostAlign : std::uint8_t {
    time,     ///< of the same UTC; where neither log knows the date, equally long after each began
    place,    ///< when it was nearest to the own ship's place
    takeoff,  ///< equally long after take-off
};
/// Their names, in the same order.
inline constexpr std::array<std::string_view, 3> kGhostAlignNames = {"time", "place", "takeoff"};
[[nodiscard]] constexpr std::string_view name_of(GhostAlign align) { return kGhostAlignNames[static_cast<std::size_t>(align)]; }

/// A ghost as it is shown. Times are seconds since the first frame of the own log.
struct ShownGhost {
    struct Place {
        double time_s = 0, latitude_deg = 0, longitude_deg = 0;
        bool joins_next = true;  ///< false: between it and the next one it is not shown
    };
    std::string log, name;  ///< the file; what the picture calls it: "other"
    GhostAlign align = GhostAlign::time;
    std::optional<double> shift_s;  ///< by which its time (UTC where it is known) was moved; nothing by place: it varies
    std::vector<Place> places;      ///< in the order of time; at least two
};

/// The scene that a picture is drawn with in place of the named one: the same with a layer of ghosts. Empty: there are none.
struct ShownGhosts {
    std::string scene;  ///< scene database
    std::vector<ShownGhost> flights;
};

}  // namespace tedavis::host_sim
