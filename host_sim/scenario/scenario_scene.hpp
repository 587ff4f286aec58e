/// The spatial data around a generated flight: the layers of the scene file that the scenario names, the planned flight, and the
/// random weather of the seed.
///
/// Generated layers ("flight"; with a section [weather] also "wind", "storm", "radar" and "gusts") replace those of the same
/// names in the scene file. Where the scene has a layer "wind" of wind, the flight's points have "wind_speed", "head_wind" and
/// "cross_wind" from it, with its uncertainty. Wind and storm have independent random numbers, so that neither changes the other
/// or the flight.
#pragma once

#include "host_sim/scenario/scenario.hpp"
#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/scene_builder/scene_build.hpp"

namespace tedavis::host_sim {

/// `flight` is the scenario's, flown with the same seed. Throws UserError.
[[nodiscard]] MadeScene make_scenario_scene(const Scenario& scenario, const ScenarioFlight& flight, std::uint64_t seed,
                                            const SceneProgress& progress);

}  // namespace tedavis::host_sim
