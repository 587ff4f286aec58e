/// Measures the pictures of a run, and draws the views of its moments.
#pragma once

#include <string>
#include <vector>

#include "host_sim/evaluation/evaluated_flight.hpp"
#include "host_sim/evaluation/evaluation_work.hpp"
#include "host_sim/evaluation/fixation_file.hpp"

namespace tedavis::host_sim {

/// Fixations of each frame: the one that was shown last. Throws UserError where the file has no column time_s.
[[nodiscard]] std::vector<std::vector<const Fixation*>> gaze_of_flight(const FixationFile& file, const FlightRun& run);

/// `gaze` may be null. Without moments. Where the work is stopped, the flight has the frames so far and says so; throws
/// Interrupted where there are none.
[[nodiscard]] EvaluatedFlight measure_flight(FlightRun run, const FixationFile* gaze, const EvaluationWork& work);

/// A moment to be drawn: whose, and where its views go.
struct MomentToDraw {
    const EvaluatedFlight* flight = nullptr;
    std::size_t index = 0;
    std::string name;   ///< of its files, without an ending; a folder before it is there
    std::string title;  ///< of its sheet
    PlanLines* plan = nullptr;
    MomentViews* views = nullptr;
    ClutterOpinions* opinions = nullptr;
};
/// Draws all views into the folder, and fills plans, views and opinions. Is not stopped: there are a dozen at most.
void draw_moments(const std::vector<MomentToDraw>& moments, const std::string& folder, const EvaluationWork& work);

}  // namespace tedavis::host_sim
