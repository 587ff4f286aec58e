#include "host_sim/accuracy/governor_choice.hpp"

#include "host_sim/input_file.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/display/preroll.hpp"

namespace tedavis::host_sim {
namespace {

void count_frame(const effects::BudgetReport& report, GovernorChoice& choice) {
    ++choice.frames[report.quality_level];
    choice.missed += report.is_missed ? 1 : 0;
}

}  // namespace

effects::Calibration read_costs(const std::string& path) {
    auto read = effects::read_calibration(read_file(path), path);
    if (!read.ok()) throw UserError(std::string(read.error().message.view()));
    return read.value();
}

GovernorChoice governor_choice(const std::string& costs, const PictureOptions& picture, const KnobFlight& flight,
                               const GovernorChoicePlan& plan) {
    const effects::Calibration calibration = read_costs(costs);
    GovernorChoice choice;
    choice.costs = costs;
    choice.device = calibration.subject.device.view();
    choice.renderer = calibration.subject.renderer.view();
    choice.flight = flight.name();
    choice.levels = calibration.quality;
    PictureOptions options = picture;
    options.device = choice.device;
    options.costs = costs;
    options.size = PictureSize{calibration.subject.width_px, calibration.subject.height_px};
    DisplaySession session(options, true);
    display::Display& display = session.display();
    choice.deadline_ms = plan.deadline_ms.value_or(1000 / session.device().frame_rate_hz);
    display.memory().budget.hold(choice.deadline_ms, calibration.costs, calibration.quality);
    const auto total = static_cast<std::size_t>(flight.duration_s() * plan.rate_hz);
    const std::vector<AircraftPose> poses = flight.poses(total);
    for (std::size_t n = 0; n < total; ++n) {
        const AircraftPose& pose = poses[n];
        const flight::AircraftState state = posed_aircraft(pose, display);
        display::preroll(display, {state, phase_of(pose), pose.time});
        if (display.memory().must_be_drawn()) session.draw();
        count_frame(display.memory().budget.report(), choice);
        if (plan.progress && n % (total / 10 + 1) == 0) plan.progress(n, total);
    }
    return choice;
}

}  // namespace tedavis::host_sim
