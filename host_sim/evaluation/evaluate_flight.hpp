/// Measures the pictures of a run, and draws the views of its moments.
#pragma once

#include <string>
#include <vector>

#include "host_sim/evaluation/evaluated_flight.hpp"
#include "host_sim/evaluation/evaluation_work.hpp"
#include "host_sim/evaluation/fixation_file.hpp"

namespace tedavis::host_sim {

/// Assigns each fixation to the frame that was shown at its time. Throws UserError where the file has no column time_s.
[[nodiscard]] std::vector<std::vector<const Fixation*>> gaze_of_flight(const FixationFile& file, const FlightRun& run);

/// Measures the pictures of a run; moments are added later. `gaze` may be null. If the work is stopped, the flight has the frames
/// so far and `interrupted` is set; throws Interrupted where there are none.
[[nodiscard]] EvaluatedFlight measure_flight(FlightRun run, const FixationFile* gaze, const EvaluationWork& work);

/// A moment to be drawn, and the objects that receive its views.
struct MomentToDraw {
    const EvaluatedFlight* flight = nullptr;
    std::size_t index = 0;
    std::string name;   ///< of its files, without extension; a folder in it must exist
    std::string title;  ///< of its sheet
    PlanLines* plan = nullptr;
    MomentViews* views = nullptr;
    ClutterOpinions* opinions = nullptr;
};
/// Draws all views into the folder, and fills in plans, views and opinions. Does not query the stop flag, since there are at most
/// a dozen moments.
void draw_moments(const std::vector<MomentToDraw>& moments, const std::string& folder, const EvaluationWork& work);

}  // namespace tedavis::host_sim
