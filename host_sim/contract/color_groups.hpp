/// The colours of a design's pictures in groups that must be distinguishable.
///
///   ground        of the palette: its stops and eight steps between two; of a plain texture the plain colour
///   sea, unknown  as the design states them
///   warnings      the warning bands as they are displayed: each with its strength over every colour of the ground; the two
///                 colors of the terrain alert where the design has no bands
///   a role        such as obstacle: of the elements of this role that have one plain colour
///
/// Every colour of one group is compared with every colour of the other, a band over a ground only with what lies over the same
/// one. If `warnings` is the only group, its colours are compared with each other where their hues differ; two densities of one
/// hue mean more or less of the same. Differences are CIEDE2000 (design/color_difference.hpp), in normal vision and without each
/// of the three kinds of cones (measure/color_vision.hpp). With `light` below 1, the encoded values are multiplied by it, as when
/// the terrain is drawn.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render_core/design/design_settings.hpp"

namespace tedavis::host_sim {

inline constexpr std::string_view kWarningsGroup = "warnings";

[[nodiscard]] bool is_color_group(std::string_view name);

struct ColorGap {
    double difference = 0;  ///< the least one
    std::string words;      ///< which colours, and in which vision
};
/// Returns the least difference; nothing where no two colours of the design are compared. `groups` has two or more groups, or
/// warnings alone; `light` is 0..1.
[[nodiscard]] std::optional<ColorGap> least_color_gap(const design::DesignSettings& design,
                                                      const std::vector<std::string>& groups, double light);

}  // namespace tedavis::host_sim
