/// The way that a generated flight flies, as it was planned at its start: the layer "flight", one line, a point every
/// kPlanStep_s with its time, heights above mean sea level.
///
/// The plan is the less sure the farther ahead: 95 % of flights are within kPlanPosition_m and kPlanPositionShare of the distance
/// flown since the start, and within kPlanHeight_m and kPlanHeightShare of it in height. That is what the attributes
/// "position_accuracy" and "height_accuracy" (m) say of each point; they state no uncertainty of their own. "height" (m),
/// "ground_speed" and "vertical_speed" (m/s) have standard deviations: of heights their accuracy as that of a normal
/// distribution, of speeds kPlanSpeedSigma_mps and kPlanClimbSigma_mps.
#pragma once

#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

inline constexpr int kPlanStep_s = 2;
inline constexpr double kPlanPosition_m = 20, kPlanPositionShare = 0.01;
inline constexpr double kPlanHeight_m = 10, kPlanHeightShare = 0.0025;
inline constexpr double kPlanSpeedSigma_mps = 2, kPlanClimbSigma_mps = 1;

[[nodiscard]] LayerDraft make_flight_layer(const ScenarioFlight& flight);

}  // namespace tedavis::host_sim
