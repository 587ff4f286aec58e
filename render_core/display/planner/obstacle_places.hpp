/// Where in the picture the obstacles ahead are, for evaluations of whether they are noticed.
///
/// Obstacles ahead are features of the scene's layers with the role obstacle that are valid at the time and that HazardWatch
/// (hazard_watch.hpp) finds on the predicted track within the design's hazard_ahead_s, independent of weights. The
/// kMaxObstaclePlaces that are reached first are returned.
///
/// `drawn`: its sign stands in the picture, and the box is the sign's; else, where the design shows the layer as solids and no
/// terrain stands before its top, the box goes from its top down to the ground, at least as wide as the display's text is high.
/// `left_out`: it would be seen in the picture, and nothing is shown of it. `hidden`: terrain stands before it, as signs are
/// judged. `out_of_view`: its top is beside the picture or behind the eye.
///
/// Bounded by the points of the layers. Nothing is computed without a call. Thread  the display's.
#pragma once

#include <array>
#include <string_view>

#include "render_core/display/planner/element_labels.hpp"
#include "render_core/policy/hazard_watch.hpp"
#include "render_core/terrain/line_of_sight.hpp"

namespace tedavis::display {

enum class ObstacleState : std::uint8_t { drawn, left_out, hidden, out_of_view };
inline constexpr std::array<std::string_view, 4> kObstacleStateNames{"drawn", "left_out", "hidden", "out_of_view"};

struct ObstaclePlace {
    base::FixedString<31> name;  ///< the scene's, or the layer's
    std::uint32_t feature = 0;   ///< of its layer
    ObstacleState state = ObstacleState::out_of_view;
    double ahead_s = 0;  ///< of flight, until it is reached
    draw::Rect box{};    ///< in the picture, pixels; of what is drawn or left out
};
inline constexpr std::size_t kMaxObstaclePlaces = 8;
using ObstaclePlaces = base::FixedVector<ObstaclePlace, kMaxObstaclePlaces>;

/// The input from one frame, drawn or planned.
struct ObstacleFrame {
    const scene::Scene& scene;
    flight::FlightTime time;
    scene::Ground& ground;
    draw::SignView eye;
    terrain::LineOfSight* sight = nullptr;  ///< null: nothing stands in the way
    const ElementReports& reports;
    const ElementLabels& labels;
};

/// Returns the obstacles in the order in which they are reached; at the same instant by layer and feature.
[[nodiscard]] ObstaclePlaces obstacle_places(const ObstacleFrame& frame, policy::HazardWatch& watch);

}  // namespace tedavis::display
