#include "host_sim/accuracy/flight_errors.hpp"

#include <algorithm>

#include "host_sim/accuracy/knobs/flown_knob.hpp"
#include "host_sim/accuracy/knobs/seen_ground.hpp"
#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"
#include "host_sim/replay/load_design.hpp"
#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kKnownTo_px = 2e-3;  ///< what terrain_error_px() may be wrong by
constexpr double kTolerances_px[] = {16, 8, 4, 2, 1, 0.5};

/// The places that each pose shows, and displays at some tolerances.
class ErrorFlight {
public:
    ErrorFlight(const TracedGround& ground, const KnobFlight& flight, const std::vector<double>& tolerances_px, std::size_t poses)
        : begin_(flight.pose_at(0).time),
          tolerances_px_(tolerances_px),
          seen_(seen_poses(ground, flight.poses(poses))),
          pictures_(levels(ground.path(), tolerances_px_), poses_of(seen_)) {}

    [[nodiscard]] std::size_t poses() const { return seen_.size(); }

    [[nodiscard]] MeasuredMoment moment(std::size_t level, std::size_t pose, std::uint64_t& broken) {
        MeasuredMoment moment;
        pictures_.show(level, pose);
        const base::Time begun = platform::monotonic_now();
        pictures_.draw(level, pose);
        moment.ms = (platform::monotonic_now() - begun).to_seconds() * 1000;
        display::Display& display = pictures_.display(level, pose);
        moment.proven_px = display.record().terrain.worst_error_px;
        for (const SeenPlace& place : seen_[pose].places)
            if (const auto error = terrain_error_px(display, place)) {
                ++moment.samples;
                broken += *error > moment.proven_px + kKnownTo_px ? 1 : 0;
                moment.measured_px = std::max(moment.measured_px, *error);
            }
        moment.pose = pose_text(seen_[pose].pose);
        moment.time_s = (seen_[pose].pose.time - begin_).to_seconds();
        return moment;
    }

    [[nodiscard]] ToleranceLine line(std::size_t level) {
        ToleranceLine line;
        line.asked_px = tolerances_px_[level];
        for (std::size_t pose = 0; pose < poses(); ++pose) {
            const MeasuredMoment at = moment(level, pose, line.broken);
            line.proven_px = std::max(line.proven_px, at.proven_px);
            line.measured_px = std::max(line.measured_px, at.measured_px);
            line.samples += at.samples;
        }
        return line;
    }

private:
    static std::vector<FlownLevel> levels(const std::string& terrain, const std::vector<double>& tolerances_px) {
        std::vector<FlownLevel> levels;
        for (const double tau_px : tolerances_px) levels.push_back(terrain_level(terrain, tau_px, kFlownSize));
        return levels;
    }

    base::Time begin_;
    std::vector<double> tolerances_px_;
    std::vector<SeenPose> seen_;
    FlownPictures pictures_;
};

}  // namespace

bool FlightErrors::holds() const {
    return std::all_of(lines.begin(), lines.end(), [](const ToleranceLine& line) { return line.broken == 0; }) &&
           std::all_of(moments.begin(), moments.end(),
                       [](const MeasuredMoment& moment) { return moment.measured_px <= moment.proven_px + kKnownTo_px; });
}

FlightErrors measure_flight_errors(const TracedGround& ground, const KnobFlight& flight, const FlightErrorsPlan& plan) {
    FlightErrors measured;
    measured.flight = flight.is_moved() ? "the shipped flight, moved to the terrain" : "the shipped flight";
    measured.terrain = ground.path();
    measured.asked_px = load_design({}).terrain.tau_px;
    std::uint64_t broken = 0;
    {
        ErrorFlight along(ground, flight, {measured.asked_px}, plan.moments);
        for (std::size_t n = 0; n < along.poses(); ++n) {
            plan.progress(n, along.poses() + std::size(kTolerances_px));
            measured.moments.push_back(along.moment(0, n, broken));
        }
    }
    ErrorFlight lines(ground, flight, {std::begin(kTolerances_px), std::end(kTolerances_px)}, plan.line_poses);
    for (std::size_t level = 0; level < std::size(kTolerances_px); ++level) {
        plan.progress(measured.moments.size() + level, measured.moments.size() + std::size(kTolerances_px));
        measured.lines.push_back(lines.line(level));
    }
    return measured;
}

}  // namespace tedavis::host_sim
