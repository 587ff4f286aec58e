/// Depth cues of elements above the ground: vertical lines, projections onto the ground, and curtains down to it (thesis,
/// 4.4.3). They are allowed for the techniques tube, space_time and ribbon; a ribbon lies on the ground, so its cues are those
/// of the path above it, and it has no projection.
///
///     [data.element.cues]
///     line_spacing_m = 1000    vertical lines so far apart along the way over the ground, or
///     line_spacing_nm = 1
///     lines_to_ground = true   down to the terrain, not only across the way
///     lines_move = "along"     the way with the speed below; "away" from the viewer; "still" (default)
///     line_speed_mps = 100
///     projection = 0.6         opacity of a strip on the ground below the way; 0: none
///     curtain = 0.3            opacity of a surface from the way to the ground; 0: none
#pragma once

#include <array>

#include "render_core/base/config_reader.hpp"

namespace tedavis::design {

enum class LineMotion : std::uint8_t { still, along, away };

inline constexpr double kMinLineSpacing_m = 50;

struct ElementCues {
    double line_spacing_m = 0;  ///< 0: no lines
    bool lines_to_ground = false;
    LineMotion lines_move = LineMotion::still;
    double line_speed_mps = 0;
    double projection = 0;
    double curtain = 0;

    [[nodiscard]] bool is_any() const { return line_spacing_m > 0 || projection > 0 || curtain > 0; }
};

void read_element_cues(base::ConfigSection section, ElementCues& cues);

}  // namespace tedavis::design
