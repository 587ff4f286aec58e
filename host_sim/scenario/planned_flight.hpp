/// The planned path of a generated flight: the layer "flight", one line with a point every kPlanStep_s with its time, heights
/// above mean sea level.
///
/// The plan is less certain farther ahead, but every flight passes the strip: 95 % of flights are within
///     position_accuracy = kPlanPosition_m + the less of (kPlanPositionShare x distance flown since the start,
///                                                        kStripPositionShare x distance from the strip's middle)
/// and within height_accuracy, which is made in the same way. These are attributes of the points (m) and state no uncertainty of
/// their own. "height" (m), "ground_speed" and "vertical_speed" (m/s) have standard deviations: of heights their accuracy as that
/// of a normal distribution, of speeds kPlanSpeedSigma_mps and kPlanClimbSigma_mps.
#pragma once

#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

inline constexpr int kPlanStep_s = 2;
inline constexpr double kPlanPosition_m = 20, kPlanPositionShare = 0.01, kStripPositionShare = 0.03;
inline constexpr double kPlanHeight_m = 10, kPlanHeightShare = 0.0025, kStripHeightShare = 0.01;
inline constexpr double kPlanSpeedSigma_mps = 2, kPlanClimbSigma_mps = 1;

[[nodiscard]] LayerDraft make_flight_layer(const ScenarioFlight& flight, const LandingStrip& strip);

}  // namespace tedavis::host_sim
